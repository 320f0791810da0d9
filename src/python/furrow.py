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
import itertools
import json
import math
import numbers
import os
import pathlib
import shutil
import subprocess
import tempfile
import tomllib
import weakref

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Error", "ProgramNotFound", "RunFailed", "Table", "Run", "Member", "program", "load", "to_toml", "run", "read",
           "check", "keys", "ensemble", "plot_force", "plot_frame"]


class Error(Exception):
    """All errors of this module."""


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


def _call(arguments, directory=None, made=None):
    done = subprocess.run([program(), *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    done.stderr = done.stderr.replace(made, "scene") if made else done.stderr
    if done.returncode != 0:
        message = done.stderr.strip() or f"ended by signal {-done.returncode}"
        kept = directory if directory and (pathlib.Path(directory) / "run.json").exists() else None
        raise RunFailed(done.returncode, message, kept)
    return done


# ---- scenes ----


def load(file):
    """A scene file as a dict."""
    with open(file, "rb") as stream:
        return tomllib.load(stream)


def _value(value):
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool) or numpy and isinstance(value, numpy.bool_):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if hasattr(value, "__iter__") and not isinstance(value, dict):
        return "[" + ", ".join(map(_value, value)) + "]"
    raise Error(f"a scene cannot hold a {type(value).__name__}: {value!r}")


def _is_table_list(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(item, dict) for item in value)


def to_toml(scene, _path=""):
    """A scene that is a dict, as TOML. Keys whose value is None are left out."""
    values, tables = "", ""
    for key, value in scene.items():
        path = f"{_path}.{key}" if _path else key
        if isinstance(value, dict):
            tables += f"\n[{path}]\n" + to_toml(value, path)
        elif _is_table_list(value):
            tables += "".join(f"\n[[{path}]]\n" + to_toml(item, path) for item in value)
        elif value is not None:
            values += f"{key} = {_value(value)}\n"
    return values + tables


def _call_with(scene, before, after=(), directory=None):
    """The program with a scene between its words; one that is a dict gets a file for the time, named "scene" in messages."""
    if not isinstance(scene, dict):
        return _call([*before, os.fspath(scene), *after], directory)
    with tempfile.NamedTemporaryFile("w", prefix="scene_", suffix=".toml", encoding="utf-8") as file:
        file.write(to_toml(scene))
        file.flush()
        return _call([*before, file.name, *after], directory, file.name)


def check(scene):
    """The warnings of a scene; RunFailed with all that is wrong with it."""
    return _call_with(scene, ["check"]).stderr.splitlines()


def keys(*patterns):
    """The keys of scenes: a list of dicts with key, meaning, unit, minimum, maximum, default, example."""
    return json.loads(_call(["keys", "--json", *patterns]).stdout)


# ---- outputs ----

_WORDS = ("plate", "kind", "lattice", "body")  # columns of names, which may look like numbers


def _column(name, cells):
    if name in _WORDS:
        return numpy.array(cells, dtype=str) if numpy else cells
    values = [float(cell) if cell else math.nan for cell in cells]
    return numpy.array(values, dtype=float) if numpy else values


class Table:
    """Columns of one length, each with a name and a unit ("" if it has none)."""

    def __init__(self, columns, units):
        self._columns, self._units = columns, units

    @classmethod
    def from_csv(cls, file):
        with open(file, newline="", encoding="utf-8") as stream:
            rows = list(csv.reader(stream))
        if rows and len(rows[-1]) < len(rows[0]):
            del rows[-1]  # of a run that was stopped while it wrote
        columns, units = {}, {}
        for k, heading in enumerate(rows[0]):
            name, _, unit = heading.partition(" [")
            units[name] = unit.rstrip("]")
            columns[name] = _column(name, [row[k] for row in rows[1:]])
        return cls(columns, units)

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

    def where(self, **wanted):
        """The rows in which each named column has this value."""
        chosen = [k for k in range(len(self)) if all(self[name][k] == value for name, value in wanted.items())]
        columns = {n: c[chosen] if numpy else [c[k] for k in chosen] for n, c in self._columns.items()}
        return Table(columns, self._units)

    def to_pandas(self):
        """A DataFrame, its columns with their units as in the file."""
        import pandas
        return pandas.DataFrame({f"{n} [{u}]" if u else n: self._columns[n] for n, u in self._units.items()})


class Run:
    """The files of one run. What a run is known by stands in `json`, the contents of run.json."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        file = self.directory / "run.json"
        if not file.exists():
            raise Error(f"{self.directory} holds no run: there is no run.json in it")
        self.json = json.loads(file.read_text(encoding="utf-8"))

    def __repr__(self):
        return f"Run in {self.directory}: {self.json['title']!r} {self.json['ended']}"

    def table(self, name):
        """A CSV file by its name below the directory: "energy.csv", "frames/discs_000.csv"."""
        file = self.directory / name
        part = file.with_name(file.name + ".partial")  # of a run that did not come to its end
        if not file.exists() and part.exists():
            file = part
        if not file.exists():
            raise Error(f"{self.directory} has no {name}: the run ended as {self.json['ended']!r}")
        return Table.from_csv(file)

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
        return load(self.directory / "scene.toml")


def read(directory):
    """A run that was made earlier."""
    return Run(directory)


# ---- runs ----


def _settings(set):
    return [word for key, value in (set or {}).items()
            for word in ("--set", f"{key}={value if isinstance(value, str) else _value(value)}")]


def run(scene, set=None, out=None, resume=False, until=None):
    """Runs a scene, a file or a dict, and returns its Run.

    set     keys with other values: {"time.step": 1e-4, "disc[0].position": [0, 1]}
    out     directory for the files; without it a temporary one, which goes with the Run
    resume  continue the run in `out` from its last checkpoint, `until` this time in s
    """
    if resume and not out:
        raise Error("a run is resumed in its directory: give out")
    directory = out or tempfile.mkdtemp(prefix="furrow_run_")
    options = [*_settings(set), "--resume" if resume else "--out", directory]
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


def _combinations(vary):
    return [dict(zip(vary, values)) for values in itertools.product(*vary.values())]


def ensemble(scene, vary=None, seeds=None, set=None, out=None, jobs=None, keep_failures=False):
    """Runs a scene over lists of parameters, side by side, and yields a Member for each in their order.

    vary   {"time.step": [1e-4, 5e-5], "contact.friction": [0.3, 0.5]}: every combination is run
    seeds  seeds of its packings; each combination is run with each
    out    directory in which each member gets one of its own, 000, 001, ...
    jobs   runs at once; without it as many as there are processors
    keep_failures  a run that fails is a Member with its error; without this it ends the ensemble
    """
    scene = scene if isinstance(scene, dict) else load(scene)
    packings = len(scene.get("packing", []))
    if seeds is not None and not packings:
        raise Error("seeds are for scenes with a packing; this one has none")
    members = [({} if seeds is None else {"seed": seed}) | parameters
               for parameters in _combinations(vary or {}) for seed in ([None] if seeds is None else seeds)]

    def one(index, parameters):
        changes = dict(set or {}) | {key: value for key, value in parameters.items() if key != "seed"}
        changes |= {f"packing[{k}].seed": parameters["seed"] for k in range(packings) if "seed" in parameters}
        return run(scene, changes, pathlib.Path(out) / f"{index:03d}" if out else None)

    with concurrent.futures.ThreadPoolExecutor(jobs or os.cpu_count()) as pool:
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


def plot_force(runs, axes=None, against="displacement", component="F", plate=None, labels=None):
    """Draws the force on a plate (the first one, or the one of this name) of one run or of many; returns the axes."""
    import matplotlib.pyplot
    axes = axes or matplotlib.pyplot.subplots()[1]
    runs = [runs] if isinstance(runs, Run) else list(runs)
    for k, each in enumerate(runs):
        table = each.plate_force
        if not len(table):
            raise Error(f"no plate, no force: {each}")
        curve = table.where(plate=plate or table["plate"][0])
        axes.plot(curve[against], curve[component], label=labels[k] if labels else None, linewidth=1)
    axes.set_xlabel(f"{against} [{table.unit(against)}]")
    axes.set_ylabel(f"{component} [{table.unit(component)}]")
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
