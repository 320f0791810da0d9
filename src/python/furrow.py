"""Runs furrow and reads what it writes.

    import furrow
    run = furrow.run("scene.toml", set={"time.end": 0.5})   # a file or a dict, with keys set to other values
    force = run.plate_force.where(plate="tool")             # any output is a table
    force["F"], force.unit("F")                             # a column by its name, and its unit: "N"
    for member in furrow.ensemble("scene.toml", seeds=range(8)):
        print(member.parameters, max(member.run.plate_force["F"]))
    furrow.plot_force(run)

One file. It needs Python 3.11 and its standard library alone; columns are arrays where numpy is installed and lists where
it is not, Table.to_pandas needs pandas, plot_force and plot_frame need matplotlib. The program is found by the variable FURROW, in PATH,
beside an installed copy of this file, or in build/release of the sources.
"""

import concurrent.futures
import csv
import io
import itertools
import json
import math
import numbers
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading
import tomllib
import weakref
import zlib

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Error", "WrongType", "ProgramNotFound", "RunFailed", "Table", "Run", "Member", "program", "load", "to_toml", "run", "read",
           "check", "keys", "ensemble", "plot_force", "plot_frame"]


class Error(Exception):
    """All errors of this module."""


class WrongType(Error, TypeError):
    """A value is of a type that its key cannot take."""


class ProgramNotFound(Error):
    """There is no program furrow to be started."""


class RunFailed(Error):
    """The program ended with an exit code that is not 0.

    code       2 usage or scene, 3 diverged or invalid, 4 input or output, 130 interrupted
    message    what it said on standard error
    directory  where the files of the run are, as far as it came; None if there are none
    """

    def __init__(self, code, message, directory=None):
        super().__init__(f"furrow ended with exit code {code}: {message}")
        self.code, self.message, self.directory = code, message, directory


def program():
    """The path of the program."""
    named = os.environ.get("FURROW")
    here = pathlib.Path(__file__).resolve()
    beside = [here.parents[2] / "build/release/furrow"]
    if len(here.parents) > 3:
        beside.insert(0, here.parents[3] / "bin/furrow")  # PREFIX/lib/python3/dist-packages/furrow.py
    found = shutil.which(named or "furrow")
    if not found and not named:
        found = next((str(path) for path in beside if os.access(path, os.X_OK)), None)
    if found:
        return found
    what = f"the variable FURROW names {named!r}, which is no program" if named else "there is no program furrow in PATH"
    raise ProgramNotFound(what + "; build it (scripts/test) or set the variable FURROW to its path")


def _path(name):
    """As a word for the program: one that begins with a dash would be an option."""
    name = os.fsdecode(name)
    return f"./{name}" if name.startswith("-") else name


def _stamp(directory):
    """Tells the run.json of one run from that of the next; None if there is none."""
    try:
        kept = os.stat(pathlib.Path(directory) / "run.json")
    except OSError:
        return None
    return kept.st_ino, kept.st_mtime_ns


def _call(arguments, directory=None, made=None):
    words = [program(), *map(str, arguments)]
    if any("\0" in word for word in words):
        raise Error(f"a word for furrow holds a zero byte: {next(word for word in words if chr(0) in word)!r}; leave it out")
    before = _stamp(directory) if directory and "--resume" not in words else None
    done = subprocess.run(words, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    done.stderr = done.stderr.replace(made, "scene") if made else done.stderr
    if done.returncode != 0:
        message = done.stderr.strip() or f"ended by signal {-done.returncode}"
        kept = directory if directory and _stamp(directory) not in (None, before) else None
        raise RunFailed(done.returncode, message, kept)
    return done


# ---- scenes ----


def load(file):
    """A scene file as a dict."""
    with open(file, "rb") as stream:
        try:
            return tomllib.load(stream)
        except ValueError as wrong:
            raise Error(f"{file} is no TOML: {wrong}") from None


def _text(text):
    """The text, if a file can hold it: half of a pair of surrogates is no character."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        raise Error(f"a scene cannot hold a text that UTF-8 cannot: {text!r}; leave out what is no character") from None
    return text


def _items(key, value):
    """The values of a list, tuple, range or array. What else can be gone through may have no order, or be no list of values."""
    is_array = all(hasattr(value, name) for name in ("__array__", "tolist", "ndim")) and value.ndim > 0
    if is_array or isinstance(value, (list, tuple, range)):
        return list(value)
    raise WrongType(f"{key} is no list but a {type(value).__name__}: {value!r}; give a list, a tuple, a range or an array")


def _value(value, key="a key"):
    if isinstance(value, str):
        return json.dumps(_text(value), ensure_ascii=False)
    if isinstance(value, bool) or numpy and isinstance(value, numpy.bool_):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if hasattr(value, "__iter__") and not isinstance(value, dict):
        return "[" + ", ".join(_value(item, key) for item in _items(key, value)) + "]"
    raise WrongType(f"{key}: a scene cannot hold a {type(value).__name__}: {value!r}")


def _is_table_list(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def to_toml(scene, _path=""):
    """A scene that is a dict, as TOML. Keys whose value is None are left out."""
    values, tables = "", ""
    for key, value in scene.items():
        path = _text(f"{_path}.{key}" if _path else str(key))
        if not re.fullmatch("[A-Za-z0-9_-]+", str(key)):
            raise Error(f"{path!r}: no key of a scene is spelt so; keys are letters, digits and _, a table is a dict of its own")
        if isinstance(value, dict):
            tables += f"\n[{path}]\n" + to_toml(value, path)
        elif _is_table_list(value):
            tables += "".join(f"\n[[{path}]]\n" + to_toml(item, path) for item in value)
        elif value is not None:
            values += f"{key} = {_value(value, path)}\n"
    return values + tables


def _call_with(scene, before, after=(), directory=None):
    """The program with a scene between its words; one that is a dict gets a file for the time, named "scene" in messages."""
    if not isinstance(scene, dict):
        return _call([*before, _path(scene), *after], directory)
    with tempfile.NamedTemporaryFile("w", prefix="scene_", suffix=".toml", encoding="utf-8") as file:
        file.write(to_toml(scene))
        file.flush()
        return _call([*before, file.name, *after], directory, file.name)


def check(scene):
    """The warnings of a scene; RunFailed with all that is wrong with it."""
    return _call_with(scene, ["check"]).stderr.splitlines()


def keys(*patterns):
    """The keys of scenes: a list of dicts with key, meaning, unit, minimum, maximum, default, example."""
    return json.loads(_call(["keys", "--json", "--", *patterns]).stdout)


# ---- outputs ----

_AGAIN = "run the scene again, or copy the file again from where it was made"
_WORDS = ("plate", "wall", "kind", "lattice", "body")  # columns of names, which may look like numbers
_OF_DISCS = ("spin", "radius", "von Mises")  # a node has none of them: its cells in state.csv are empty


def _number(cell):
    try:
        return float(cell)
    except ValueError:
        return None


def _column(name, cells):
    if name in _WORDS:
        return numpy.array(cells, dtype=str) if numpy else cells
    values = [float(cell) if cell else math.nan for cell in cells]
    return numpy.array(values, dtype=float) if numpy else values


def _rows(file):
    """The rows of a CSV file, each with the number of its last line."""
    with open(file, newline="", encoding="utf-8") as stream:
        text = stream.read()
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    rows = [(reader.line_num, row) for row in reader]
    if rows and not text.endswith("\n"):
        raise Error(f"{file}, row {rows[-1][0]}: it has no end, the file was cut; {_AGAIN}")
    return rows


def _units(file, headings):
    """The unit of each column by its name."""
    units = {}
    for heading in headings:
        name, _, unit = heading.partition(" [")
        if not name or name in units:
            what = f"two columns are named {name!r}" if name else "a column has no name"
            raise Error(f"{file}, row 1: {what}; {_AGAIN}")
        units[name] = unit.removesuffix("]")
    return units


def _require_cells(file, line, names, row):
    if len(row) != len(names):
        raise Error(f"{file}, row {line}: it has {len(row)} cells, the heading {len(names)}; {_AGAIN}")
    node = "body" in names and row[names.index("body")].endswith("node")
    for name, cell in zip(names, row):
        if cell == "" and not (node and name in _OF_DISCS):
            raise Error(f"{file}, row {line}: the cell of {name!r} is empty; {_AGAIN}")
        if cell and name not in _WORDS and _number(cell) is None:
            raise Error(f"{file}, row {line}: the cell of {name!r} is no number: {cell!r}; {_AGAIN}")


class Table:
    """Columns of one length, each with a name and a unit ("" if it has none)."""

    def __init__(self, columns, units, parts=None):
        self._columns, self._units = columns, units
        # The plates and walls that there are: a choice of rows has those of the whole table.
        self._parts = parts or {n: list(dict.fromkeys(map(str, columns[n]))) for n in ("plate", "wall") if n in columns}

    @classmethod
    def from_csv(cls, file):
        """A CSV file of furrow's. Rows are counted as lines, the heading is row 1."""
        try:
            rows = _rows(file)
        except (OSError, ValueError, csv.Error) as wrong:
            raise Error(f"{file} cannot be read as CSV: {wrong}; {_AGAIN}") from None
        if not rows:
            raise Error(f"{file}, row 1: there is no heading, the file is empty; {_AGAIN}")
        units = _units(file, rows[0][1])
        names = list(units)
        for line, row in rows[1:]:
            _require_cells(file, line, names, row)
        return cls({name: _column(name, [row[k] for _, row in rows[1:]]) for k, name in enumerate(names)}, units)

    @property
    def names(self):
        return list(self._columns)

    def _known(self, name):
        bare = name.partition(" [")[0]
        if bare in self._columns and name in (bare, f"{bare} [{self._units[bare]}]"):
            return bare
        headings = [f"{name} [{unit}]" if unit else name for name, unit in self._units.items()]
        raise KeyError(f"no column {name!r}; there are {', '.join(headings)}")

    def unit(self, name):
        return self._units[self._known(name)]

    def __getitem__(self, name):
        """The column of this name, with its unit or without: table["F"], table["F [N]"]."""
        return self._columns[self._known(name)]

    def __len__(self):
        return len(next(iter(self._columns.values()), ()))

    def __repr__(self):
        return f"Table of {len(self)} rows: " + ", ".join(f"{n} [{u}]" if u else n for n, u in self._units.items())

    def _wanted(self, name, value):
        """As the cells of that column are: names are texts, those that are numbers too, as plate 0."""
        if self._known(name) not in _WORDS:
            if not isinstance(value, numbers.Real):
                raise Error(f"the column {name!r} holds numbers: give one, not {value!r}")
            return value
        text, known = str(value), self._parts.get(name)
        if known and text not in known:  # of a kind or a body there may be none
            raise Error(f"no {name} is named {text!r}; there are {', '.join(map(repr, known))}")
        return text

    def where(self, **wanted):
        """The rows in which each named column has this value. A plate and a wall must be one that the table has."""
        wanted = {name: self._wanted(name, value) for name, value in wanted.items()}
        chosen = [k for k in range(len(self)) if all(self[name][k] == value for name, value in wanted.items())]
        columns = {n: c[chosen] if numpy else [c[k] for k in chosen] for n, c in self._columns.items()}
        return Table(columns, self._units, self._parts)

    def to_pandas(self):
        """A DataFrame, its columns with their units as in the file."""
        import pandas
        return pandas.DataFrame({f"{n} [{u}]" if u else n: self._columns[n] for n, u in self._units.items()})


_ENDINGS = ("finished", "interrupted", "diverged", "invalid")
_FIELDS = {"title": str, "method": str, "ended": str, "step": numbers.Real, "end": numbers.Real, "ended_at": numbers.Real}
_COUNTS = {"discs": int, "nodes": int, "links": int, "steps": int}  # none if it ended while the scene settled

# Methods that choose their steps end one where a row is due. The others take the nearest step.
_CONTROLLED = ("pece_adaptive", "rkc", "odeint_cash_karp54", "odeint_dopri5", "odeint_fehlberg78", "odeint_bulirsch_stoer",
               "odeint_rosenbrock4")


def _crc(data):
    return f"{zlib.crc32(data):08x}"


def _json_in(file):
    """Its contents, and whether they are what was sealed; None if they bear no seal."""
    try:
        text = file.read_bytes()
        json_of = json.loads(text.decode("utf-8"))
    except (OSError, ValueError, RecursionError) as wrong:
        raise Error(f"{file} cannot be read as JSON: {wrong}; {_AGAIN}") from None
    if not isinstance(json_of, dict):
        raise Error(f"{file} holds no JSON object; {_AGAIN}")
    sealed = text[:max(0, text.rfind(b',\n  "seal": "'))]
    return json_of, json_of["seal"] == _crc(sealed) if "seal" in json_of else None


def _fault_of_run(run):
    """What is wrong with a run.json; nothing if it is right."""
    settled = run.get("ended") == "finished" or any(name in run for name in _COUNTS)
    for name, kind in (_FIELDS | (_COUNTS if settled else {})).items():
        value = run.get(name)
        if not isinstance(value, kind) or isinstance(value, bool) or kind is not str and not 0 <= value < math.inf:
            return f"its field {name!r} is {value!r}" if name in run else f"it has no field {name!r}"
    if not isinstance(run.get("files", {}), dict):
        return f"its field 'files' is {run['files']!r}"
    if run["ended"] not in _ENDINGS:
        return f"its field 'ended' is {run['ended']!r}, none of {', '.join(_ENDINGS)}"
    if run["ended"] == "finished" and not math.isclose(run["ended_at"], run["end"], rel_tol=1e-6):
        return f"it says finished, but at {run['ended_at']} s of {run['end']} s"
    return None


class Run:
    """The files of one run. What a run is known by stands in `json`, the contents of run.json."""

    def __init__(self, directory, partial=False):
        self.directory, self._partial = pathlib.Path(directory), partial
        file, marker = self.directory / "run.json", self.directory / ".furrow.json"
        standing = _json_in(marker)[0].get("standing") if marker.exists() else None
        if not file.exists():
            why = "" if standing is None else "; its run is under way or was killed: wait for it, or furrow run --resume"
            raise Error(f"{self.directory} holds no run: there is no run.json in it{why}")
        self.json, as_sealed = _json_in(file)
        fault = _fault_of_run(self.json)
        if not fault and standing not in (None, self.json["ended"]):
            fault = f"it says {self.json['ended']}, but .furrow.json {standing}: wait for the run, or furrow run --resume"
        if not fault and not as_sealed:
            fault = "it bears no seal" if as_sealed is None else "its text and its seal differ"
        if fault:
            raise Error(f"{file} is not what a run writes: {fault}; {_AGAIN}")

    def __repr__(self):
        return f"Run in {self.directory}: {self.json['title']!r} {self.json['ended']}"

    def table(self, name):
        """A CSV file by its name below the directory: "energy.csv", "frames/discs_000.csv"."""
        file, ended = self.directory / name, self.json["ended"]
        part = file.with_name(file.name + ".partial")  # of a run that was interrupted
        if part.exists() and not file.exists():
            if ended == "finished":
                raise Error(f"{part} is not complete, but run.json says finished; {_AGAIN}")
            if not self._partial:
                raise Error(f"{part} is not complete: the run ended as {ended!r} at {self.json['ended_at']} s; "
                            "resume it, or read it as far as it came with furrow.read(..., partial=True)")
            file = part
        if not file.exists():
            raise Error(f"{self.directory} has no {name}: {self._why_missing(name)}")
        table = Table.from_csv(file)
        self._require_whole(name, file, table)
        if file is not part:
            self._require_as_written(name)
        return table

    def _why_missing(self, name):
        ended, pictures = self.json["ended"], re.fullmatch(r"frames/[a-z]+_(\d+)\.(?:csv|vtp)", name)
        if name in self.json.get("files", {}):
            return f"it was written and is gone; {_AGAIN}"
        if name == "drive_force.csv" and not any("drive" in lattice for lattice in self.scene.get("lattice", ())):
            return "its scene drives no nodes of a lattice; [[lattice.drive]] does"
        if ended != "finished":
            return f"the run ended as {ended!r} at {self.json['ended_at']} s"
        if pictures:
            count = len(self.frames)
            return f"the run has {count} pictures" + (f", 0 to {count - 1}" if count else "; output.frames asks for them")
        return f"a run writes no such file; its files are {', '.join(sorted(f for f in self.json['files'] if '/' not in f))}"

    def _require_as_written(self, name):
        """The file has the length and the CRC-32 that run.json has of it."""
        wanted = self.json.get("files", {}).get(name)
        if wanted is None:
            return
        data = (self.directory / name).read_bytes()
        if wanted != f"{len(data)} {_crc(data)}":
            raise Error(f"{self.directory / name} is not what the run wrote: its length or CRC-32 is not that in run.json; "
                        f"{_AGAIN}")

    def _require_whole(self, name, file, table):
        """The rows are all that run.json, scene.toml and the picture beside say there are."""
        due, parts = self._due(name)
        if due is not None:
            self._require_times(name, file, table, due, parts)
        rows = self._count(name)
        if rows is not None and rows != len(table):
            raise Error(f"{file}: it ends with row {len(table) + 1}, but the run wrote {rows + 1} rows; {_AGAIN}")

    def _due(self, name):
        """When a series has rows, and how many at each time; None for what is no series."""
        series = ("plate_force.csv", "wall_force.csv", "drive_force.csv", "energy.csv", "motion.csv", "frames/frames.csv")
        if name not in series:
            return None, 0
        try:
            scene = self.scene
            output, slack = scene["output"], self._slack()
            interval, last = output["interval"], self.json["ended_at"]
            drives = sum(len(lattice.get("drive", ())) for lattice in scene.get("lattice", ()))
            parts = {"plate_force.csv": len(scene.get("plate", ())), "wall_force.csv": len(scene.get("wall", ())),
                     "drive_force.csv": drives, "energy.csv": int(output["energy"])}.get(name, 1)
            if name == "frames/frames.csv":
                times = output["frames"]
            else:
                times = [k * interval for k in range(math.floor((last + slack) / interval) + 2)]
            due = [t for t in times if last >= t - slack]
        except (KeyError, TypeError, ValueError, AttributeError, ArithmeticError) as wrong:
            raise Error(f"{self.directory / 'scene.toml'} is not what the run wrote: {wrong!r}; {_AGAIN}") from None
        may_be_none = self.json["ended"] != "finished" and self.json["steps"] == 0  # it ended before its first row
        return (None if may_be_none else due), parts

    def _slack(self):
        return 0 if self.json["method"] in _CONTROLLED else 0.5 * self.json["step"]

    def _require_times(self, name, file, table, due, parts):
        times = table["t"]
        for k, t in enumerate(times[:len(due) * parts]):
            wanted = due[k // parts]
            if not abs(t - wanted) <= self._slack() + 1e-9 * max(wanted, self.json["step"]):
                raise Error(f"{file}, row {k + 2}: it is of {t} s where {wanted} s is due, so rows are missing or doubled; "
                            f"{_AGAIN}")
        rows = len(due) * parts
        ended = self.json["ended_at"]
        if name != "frames/frames.csv" and rows and len(times) >= rows and times[rows - 1] != ended:  # its last state
            rows += parts
            if any(t != ended for t in times[len(due) * parts:]):
                raise Error(f"{file}: its last row is of {times[-1]} s, but the run ended at {ended} s; {_AGAIN}")
        if len(times) != rows:
            last = f"row {len(times) + 1}" + (f" of {times[-1]} s" if len(times) else ", the heading")
            raise Error(f"{file}: it ends with {last}, but the run ended as {self.json['ended']!r} at "
                        f"{self.json['ended_at']} s and wrote {rows + 1} rows; {_AGAIN}")

    def _count(self, name):
        """How many rows a state or a picture has; None if nothing says so."""
        if name == "state.csv" and "discs" in self.json:
            return self.json["discs"] + self.json["nodes"]
        picture = (self.directory / name).with_suffix(".vtp")  # the same parts, with their number in its third line
        if not name.startswith("frames/") or not picture.exists():
            return None
        with open(picture, encoding="utf-8", errors="replace") as stream:
            found = re.search(r' NumberOf(?:Verts|Lines|Polys)="(\d+)"', stream.read(1000))
        return int(found[1]) if found else None

    plate_force = property(lambda self: self.table("plate_force.csv"))
    drive_force = property(lambda self: self.table("drive_force.csv"))  # of a scene that drives nodes
    wall_force = property(lambda self: self.table("wall_force.csv"))
    energy = property(lambda self: self.table("energy.csv"))
    motion = property(lambda self: self.table("motion.csv"))
    events = property(lambda self: self.table("events.csv"))
    state = property(lambda self: self.table("state.csv"))
    frames = property(lambda self: self.table("frames/frames.csv"))

    def frame(self, index):
        """The discs, links and plates of one picture, each a table."""
        return {part: self.table(f"frames/{part}_{index:03d}.csv") for part in ("discs", "links", "plates")}

    @property
    def scene(self):
        """The scene that was run, every key with its value."""
        if not (self.directory / "scene.toml").exists():
            raise Error(f"{self.directory} has no scene.toml, which every run writes; {_AGAIN}")
        self._require_as_written("scene.toml")
        return load(self.directory / "scene.toml")


def read(directory, partial=False):
    """A run that was made earlier. With `partial` the series of one that was interrupted are read as far as they came."""
    return Run(directory, partial)


# ---- runs ----


def _steps(key):
    """A key in its parts, however it is spelled: "disc[00].position.x" is disc, 0, position, x."""
    return tuple(part.lstrip("0") or "0" if part.isdigit() else part for part in re.split(r"[.\[\]]+", key) if part)


def _require_once(keys):
    """Of two that set one key, or a key and a part of it, one would be dropped without a word."""
    said = {}
    for key in keys:
        said.setdefault(_steps(key), []).append(key)
    for steps, spelled in said.items():
        for k in range(1, len(steps) + 1):
            others = said.get(steps[:k], []) if k < len(steps) else spelled[:-1]
            if others:
                same = others[0] == spelled[-1]
                raise Error(f"{spelled[-1]} is given twice; give it once" if same else
                            f"{others[0]} and {spelled[-1]} set the same key; give one of them")


def _settings(set):
    if not isinstance(set or {}, dict) or not all(isinstance(key, str) and "=" not in key and key == key.strip() for key in set or {}):
        raise Error(f"set is {set!r}: it is a dict of keys, without blanks or '=', and their values: {{\"time.end\": 0.1}}")
    _require_once(set or {})
    raw = lambda value: isinstance(value, str) and value == value.strip()  # TOML, or a word; blanks around a text are the text's
    return [word for key, value in (set or {}).items()
            for word in ("--set", _text(f"{key}={value if raw(value) else _value(value, key)}"))]


def _require_name(out):
    if out is not None and not os.fspath(out):
        raise Error("out names no directory: give its name, or leave it out for a temporary one")


def run(scene, set=None, out=None, resume=False, until=None):
    """Runs a scene, a file or a dict, and returns its Run.

    set     keys with other values: {"time.step": 1e-4, "disc[0].position": [0, 1]}
    out     directory for the files; without it a temporary one, which goes with the Run
    resume  continue the run in `out` from its last checkpoint, `until` this time in s
    """
    _require_name(out)
    if resume and not out:
        raise Error("a run is resumed in its directory: give out")
    settings = _settings(set)  # before there is a directory: it may be wrong
    directory = out or tempfile.mkdtemp(prefix="furrow_run_")
    options = [*settings, "--resume" if resume else "--out", _path(directory)]
    options += [] if until is None else ["--until", until]
    try:
        _call_with(scene, ["run"], options, out)
    except BaseException:
        if not out:
            shutil.rmtree(directory, ignore_errors=True)
        raise
    made = Run(directory)
    if not out:
        weakref.finalize(made, shutil.rmtree, directory, ignore_errors=True)
    return made


class Member:
    """One run of an ensemble: its parameters and its run, or the error by which it failed."""

    def __init__(self, parameters, run=None, error=None):
        self.parameters, self.run, self.error = parameters, run, error

    def __repr__(self):
        return f"Member {self.parameters}: {self.run or self.error}"


def _values(key, values):
    if isinstance(values, str) or not hasattr(values, "__iter__"):
        raise WrongType(f"{key} is not varied over a list: {values!r}; give a list of values")
    values = _items(key, values)
    if not values:
        raise Error(f"the list of {key} is empty, so there is nothing to run; give it a value, or leave it out")
    return values


def _combinations(vary):
    return [dict(zip(vary, values)) for values in itertools.product(*vary.values())]


class _Members:
    """The list of an ensemble in its directory: which member is which, and whether its run is of this ensemble.

    A member is "planned" until its run has "finished" or "failed": what stands in its directory before is of an earlier one.
    """

    NAME, MADE_BY = "ensemble.json", "furrow.py ensemble"

    def __init__(self, out, members):
        self.directory, self.lock = pathlib.Path(out), threading.Lock()
        self.members = [{"directory": f"{index:03d}", "parameters": parameters, "state": "planned"}
                        for index, parameters in enumerate(members)]
        self._refuse_others(self._earlier())
        try:
            self.directory.mkdir(parents=True, exist_ok=True)
        except OSError as wrong:
            raise Error(f"cannot make {out}: {wrong.strerror}; choose another out") from None
        self._write()

    def __getitem__(self, index):
        return self.directory / self.members[index]["directory"]

    def say(self, index, state):
        with self.lock:
            self.members[index]["state"] = state
            self._write()

    def _earlier(self):
        """The names of the directories of an earlier ensemble here."""
        file = self.directory / self.NAME
        if not os.path.lexists(file):
            return []
        try:
            kept = json.loads(file.read_bytes())
            names = [member["directory"] for member in kept["members"]]
            if kept["made_by"] == self.MADE_BY and not file.is_symlink() and all(re.fullmatch(r"\d{3,}", name) for name in names):
                return names
        except (OSError, ValueError, RecursionError, KeyError, TypeError):
            pass
        raise Error(f"{file} is in the way: it is no list of an ensemble; move it away, or choose another out")

    def _refuse_others(self, earlier):
        """Nothing of an earlier ensemble that this one does not replace stays among its members."""
        wanted = {member["directory"] for member in self.members}
        left = [name for name in earlier if name not in wanted and
                any((self.directory / name / marker).exists() for marker in (".furrow.json", ".furrow.made"))]
        if left:
            names = ", ".join(left[:8] + ["..."] * (len(left) > 8))
            raise Error(f"{self.directory} holds members of an earlier ensemble that this one has not: {names}; "
                        "remove them, or choose another out")

    def _write(self):
        text = json.dumps({"made_by": self.MADE_BY, "members": self.members}, indent=2, ensure_ascii=False) + "\n"
        half = self.directory / f".{self.NAME}.{os.getpid()}"
        try:
            with open(half, "x", encoding="utf-8") as file:
                file.write(text)
            os.replace(half, self.directory / self.NAME)
        except OSError as wrong:
            half.unlink(missing_ok=True)
            raise Error(f"cannot write {self.directory / self.NAME}: {wrong.strerror}") from None


def ensemble(scene, vary=None, seeds=None, set=None, out=None, jobs=None, keep_failures=False):
    """Runs a scene over lists of parameters, side by side, and yields a Member for each in their order.

    vary   {"time.step": [1e-4, 5e-5], "contact.friction": [0.3, 0.5]}: every combination is run
    seeds  seeds of its packings; each combination is run with each
    out    directory in which each member gets one of its own, 000, 001, ..., and ensemble.json is the list of them
    jobs   runs at once; without it as many as there are processors
    keep_failures  a run that fails is a Member with its error; without this it ends the ensemble
    """
    if jobs is not None and (not isinstance(jobs, numbers.Integral) or isinstance(jobs, bool) or jobs < 1):
        raise Error(f"jobs must be a whole number from 1, not {jobs!r}; leave it out for one a processor")
    _require_name(out)
    scene = scene if isinstance(scene, dict) else load(scene)
    packings = len(scene.get("packing", []))
    if seeds is not None and not packings:
        raise Error("seeds are for scenes with a packing; this one has none")
    vary = {key: _values(key, values) for key, values in (vary or {}).items()}
    if "seed" in vary:
        raise Error("vary has no key seed; give the seeds of packings as seeds")
    seeds = None if seeds is None else _values("seeds", seeds)
    seeded = [] if seeds is None else [f"packing[{k}].seed" for k in range(packings)]
    _require_once([*(set or {}), *vary, *seeded])
    members = [({} if seeds is None else {"seed": seed}) | parameters
               for parameters in _combinations(vary) for seed in ([None] if seeds is None else seeds)]

    def one(index, parameters):
        changes = dict(set or {}) | {key: value for key, value in parameters.items() if key != "seed"}
        changes |= {key: parameters["seed"] for key in seeded}
        if not kept:
            return run(scene, changes)
        state = "failed"
        try:
            made = run(scene, changes, kept[index])
            state = "finished"
            return made
        finally:
            kept.say(index, state)

    kept = _Members(out, [{_text(key): _text(value if isinstance(value, str) else _value(value, key))
                           for key, value in parameters.items()} for parameters in members]) if out else None
    with concurrent.futures.ThreadPoolExecutor(int(jobs or os.cpu_count() or 1)) as pool:
        futures = [pool.submit(one, index, parameters) for index, parameters in enumerate(members)]
        try:
            for parameters, future in zip(members, futures):
                try:
                    yield Member(parameters, future.result())
                except RunFailed as failure:
                    if not keep_failures:
                        raise
                    yield Member(parameters, error=failure)
        finally:
            for future in futures:
                future.cancel()


def _run_of(each):
    """The run of a member of an ensemble; a run itself."""
    if isinstance(each, Member):
        if each.run is None:
            raise Error(f"the member {each.parameters} has no run to draw: {each.error}")
        return each.run
    if not isinstance(each, Run):
        raise Error(f"a {type(each).__name__} is no run: give what run, read or ensemble return, or a list of them")
    return each


def _label_of(member):
    return ", ".join(f"{key} = {value}" for key, value in member.parameters.items())


def _abscissa(against, curves):
    """The column for the horizontal axis, and what its label says of it: over a displacement that stays, a curve is a vertical line."""
    if against == "displacement" and any(len(c) > 1 and min(c[against]) == max(c[against]) for c in curves):
        return "t", (", in some runs" if len(curves) > 1 else ",") + " the displacement does not change"
    return ("t" if against == "time" else against), ""


def plot_force(runs, axes=None, against="displacement", component="F", plate=None, labels=None):
    """Draws the force on a plate (the first one, or the one of this name) of one run, of many, or of an ensemble; returns the axes.

    against  "displacement", "time" or another column; the time also where a plate stays at rest
    labels   one for each; those of an ensemble are its parameters where none are given
    """
    import matplotlib.pyplot
    if isinstance(runs, (set, frozenset, dict)):
        raise WrongType(f"the curves of a {type(runs).__name__} have no order: give a list of runs")
    runs = [runs] if isinstance(runs, (Run, Member)) else list(runs)
    if not runs:
        raise Error("there is no run to draw")
    if labels is None and all(isinstance(each, Member) and each.parameters for each in runs):
        labels = [_label_of(each) for each in runs]
    tables = [_run_of(each).plate_force for each in runs]
    for each, table in zip(runs, tables):
        if not len(table):
            raise Error(f"no plate, no force: {each}")
    curves = [table.where(plate=plate or table["plate"][0]) for table in tables]
    against, why = _abscissa(against, curves)
    axes = axes or matplotlib.pyplot.subplots()[1]
    for k, curve in enumerate(curves):
        axes.plot(curve[against], curve[component], label=labels[k] if labels else None, linewidth=1)
    axes.set_xlabel(f"{against} [{curve.unit(against)}]{why}")
    axes.set_ylabel(f"{component} [{curve.unit(component)}]")
    if labels:
        axes.legend()
    return axes


def plot_frame(run, index, axes=None, shift=0.0):
    """Draws one picture of a run: discs, links that are not torn, plates; all moved by `shift` [m] along x. Returns the axes."""
    import matplotlib.patches
    import matplotlib.pyplot
    axes = axes or matplotlib.pyplot.subplots()[1]
    frame = run.frame(index)
    discs, links, plates = frame["discs"], frame["links"], frame["plates"]
    for k in range(len(discs)):
        axes.add_patch(matplotlib.patches.Circle((discs["x"][k] + shift, discs["y"][k]), discs["radius"][k], fill=False))
    for k in range(len(links)):
        axes.plot([links["x1"][k] + shift, links["x2"][k] + shift], [links["y1"][k], links["y2"][k]], "k", linewidth=0.5)
    for k in range(len(plates)):
        corner = (plates["left"][k] + shift, plates["lower"][k])
        axes.add_patch(matplotlib.patches.Rectangle(corner, plates["width"][k], plates["height"][k]))
    axes.set_aspect("equal")
    axes.autoscale_view()
    return axes
