"""Tries one edit at a time: compiles what it changes, links that before a sound build, and runs the tests in a sandbox.

The sound build stays as it is. An edited source replaces its object. An edited header is seen by the objects of src/ that
include it; the tests are compiled so that they call its inline functions, and find them in an object that holds them all.
"""

import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import time
import tomllib

OUT_OF_STATE = re.compile(r'"(\w*cpu_seconds|wall_seconds|commit|seal|pid|process_start|host|began|run\.json)":')
GTEST = ["--gtest_brief=1", "--gtest_fail_fast"]
CALLS = ["-fno-inline", "-fno-ipa-pure-const", "-fno-ipa-reference", "-fno-ipa-modref"]
# In the order of how soon they notice: what is run, and the binaries for it.
SUITES = [
    ("unit", ["{home}/tests/unit_tests", *GTEST], ["tests/unit_tests"]),
    ("unit, no vectors", ["FURROW_VECTORS=none", "{home}/tests/unit_tests", *GTEST], ["tests/unit_tests"]),
    ("command line", ["{home}/tests/command_line_tests", *GTEST], ["furrow", "tests/command_line_tests"]),
    ("determinism", ["{home}/tests/determinism/state_hashes", "{tree}/validation/scenes"], ["tests/determinism/state_hashes"]),
    ("kernel is reference", ["{home}/tests/property_tests", *GTEST, "--gtest_filter=KernelIsReference.*:*PapersScenes*"], ["tests/property_tests"]),
    ("verification", ["{home}/verification/verification_tests", *GTEST], ["verification/verification_tests"]),
]  # fmt: skip
# Where no test noticed, the files of all scenes of the tree are compared, and furrow's answers to all cases. A run that takes
# longer than this, s of CPU time, is cut to a quarter of its length until it does not.
LONGEST = 10
SHARES = (1, 1 / 4, 1 / 16, 1 / 64)


def scenes_of(tree, is_scene):
    """The paths from the top of every TOML file of the tree that is a scene; `is_scene` is asked of each."""
    files = (file.relative_to(tree) for file in sorted(tree.rglob("*.toml")))
    return [str(file) for file in files if file.parts[0] != "build" and is_scene(str(file))]


def cases_of(tree):
    """Name and fewest steps of each case that engines are given; a view of another case has those of that one."""
    cases = {file.stem: tomllib.loads(file.read_text()) for file in sorted(tree.glob("verification/cases/*.toml"))}
    return {name: min(cases[case["view"]["of"] if "view" in case else name]["steps"]) for name, case in cases.items()}


def state_in(text):
    """A text that the program wrote, without what differs from run to run by itself: times, the process, sums of these."""
    return "\n".join(line for line in text.split("\n") if not OUT_OF_STATE.search(line))


OF_LIBRARY, OF_PROGRAM = "CMakeFiles/furrow.dir/", "CMakeFiles/furrow_program.dir/"


class NotBuilt(Exception):
    pass


def digest(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def call(command, environment, directory):
    done = subprocess.run([str(w) for w in command], cwd=directory, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        raise NotBuilt(done.stdout[-2000:] + done.stderr[-2000:])
    return done.stdout


class SoundBuild:
    """A copy of the tree, built without an edit; all tests must pass on it."""

    def __init__(self, source, home, suites, jobs):
        self.source, self.tree, self.build = source, home / "tree", home / "build"
        self.suites = [suite for suite in SUITES if suite[0] in suites]
        self.environment = dict(os.environ, CCACHE_BASEDIR=str(home), CCACHE_NOHASHDIR="1")
        self.copy()
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        call(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
              "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w", "-DFURROW_TEST_OPTIONS=" + ";".join(CALLS),
              "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *launcher], self.environment, home)  # fmt: skip
        binaries = sorted({binary for _, _, of in self.suites for binary in of})
        targets = ["furrow_program" if binary == "furrow" else binary.split("/")[-1] for binary in binaries]
        call(["cmake", "--build", self.build, "-j", str(jobs), "--target", *targets], self.environment, home)
        self.compiling = {}  # by source, from the top of the tree: command and object
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            words = shlex.split(entry["command"])
            self.compiling[os.path.relpath(entry["file"], self.tree)] = (words, words[words.index("-o") + 1])
        self.linking = {binary: self.link_command(target) for binary, target in zip(binaries, targets)}
        self.including = self.dependents()

    def copy(self):
        names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=self.source,
                               check=True, capture_output=True, text=True).stdout.split("\0")  # fmt: skip
        wanted = {name for name in names if name and (self.source / name).is_file()}
        for old in list(self.tree.rglob("*")):
            if old.is_file() and str(old.relative_to(self.tree)) not in wanted:
                old.unlink()
        for name in wanted:
            target = self.tree / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != (self.source / name).read_bytes():
                shutil.copy(self.source / name, target)

    def link_command(self, target):
        last = call(["ninja", "-t", "commands", target], self.environment, self.build).strip().split("\n")[-1]
        return shlex.split(last.removeprefix(": && ").removesuffix(" && :"))

    def dependents(self):
        """By header of src/: the sources of src/ that include it."""
        found, source_of = {}, {object_: source for source, (_, object_) in self.compiling.items()}
        source = None
        for line in call(["ninja", "-t", "deps"], self.environment, self.build).split("\n"):
            if line and not line.startswith(" "):
                source = source_of.get(line.split(":")[0], "")
            elif source and source.startswith("src/") and line.strip():
                path = os.path.relpath(os.path.join(self.build, line.strip()), self.tree)
                if path.startswith("src/") and path != source:
                    found.setdefault(path, set()).add(source)
        return found


class Workshop:
    def __init__(self, sound, home):
        self.base, self.home = sound, home
        self.overlay, self.tmp, self.records = home / "overlay", home / "tmp", home / "records"
        self.sound = {}  # by suite: output, seconds
        self.environment = dict(sound.environment, TMPDIR=str(self.tmp), FURROW_RECORDS_IN=str(self.records))

    def prepare(self):
        """Runs all tests without an edit; they must pass. Returns the time of each suite, s."""
        shutil.rmtree(self.home, ignore_errors=True)
        self.records.mkdir(parents=True)
        (self.home / "objects").mkdir()
        self.sound_inlined = digest(self.inlined())
        self.link({}, [binary for _, _, of in self.base.suites for binary in of])
        for name, command, _ in self.base.suites:
            began = time.monotonic()
            code, text = self.run(command, cpu=3600, wall=7200)
            if code != 0:
                raise SystemExit(f"the {name} tests fail without any edit:\n{text[-3000:]}")
            self.sound[name] = (text, time.monotonic() - began)
        if "command line" in self.sound:
            self.find_scenes()
        self.files = self.written() if "command line" in self.sound else {}
        return {name: round(seconds, 1) for name, (_, seconds) in self.sound.items()}

    def compile(self, source, extra=()):
        words, _ = self.base.compiling[source]
        words = list(words)
        target = self.home / "objects" / (source.replace("/", "_") + ".o")
        words[words.index("-o") + 1] = target
        edited = self.overlay / source
        words[words.index("-c") + 1] = edited if edited.exists() else self.base.tree / source
        words[1:1] = ["-I", self.overlay / "src", *extra]
        call(words, self.environment, self.base.build)
        return target

    def inlined(self):
        """An object with every inline function of the headers, of which the linker takes what is called."""
        headers = sorted(file.relative_to(self.base.tree / "src") for file in (self.base.tree / "src").rglob("*.h"))
        source = self.home / "inlined.cpp"
        source.write_text("".join(f'#include "{h}"\n' for h in headers if "program" not in h.parts and "odeint" not in h.name))
        words, _ = self.base.compiling["src/run/system.cpp"]
        words = list(words)
        words[words.index("-o") + 1] = self.home / "objects/inlined.o"
        words[words.index("-c") + 1] = source
        words[1:1] = ["-I", self.overlay / "src", "-fkeep-inline-functions", "-ffunction-sections"]
        call([*words, "-O0"], self.environment, self.base.build)
        return self.home / "objects/inlined.o"

    def link(self, objects, binaries, first=()):
        """Binaries with these objects in the place of the sound ones, or before the archives that hold those."""
        for binary in binaries:
            words = [str(objects.get(word, word)) for word in self.base.linking[binary]]
            target = self.home / binary
            target.parent.mkdir(parents=True, exist_ok=True)
            at = words.index("-o")
            words[at + 1] = str(target)
            last_object = max(k for k, word in enumerate(words) if word.endswith(".o"))
            words[last_object + 1 : last_object + 1] = [o for place, o in objects.items() if place.startswith(OF_LIBRARY)]
            words[at:at] = ["-Wl,--gc-sections", *first] if first else []
            call(words, self.environment, self.base.build)

    def run(self, command, cpu, wall):
        """Exit code and output; whoever takes longer than the limits, or more than 4 GB, is killed."""
        shutil.rmtree(self.tmp, ignore_errors=True)
        self.tmp.mkdir(parents=True)
        words = [word.format(tree=self.base.tree, home=self.home) for word in command]
        box = ["bwrap", "--ro-bind", "/", "/", "--bind", self.home, self.home, "--dev", "/dev", "--proc", "/proc",
               "--unshare-pid", "--die-with-parent", "--bind-try", self.home / "furrow", self.base.build / "furrow",
               "prlimit", f"--cpu={round(cpu)}", "--as=4000000000", "--fsize=1000000000", "--core=0",
               "env", "-C", self.tmp, *words]  # fmt: skip
        try:
            done = subprocess.run([str(word) for word in box], env=self.environment, capture_output=True, text=True,
                                  timeout=wall, errors="replace", stdin=subprocess.DEVNULL)  # fmt: skip
        except subprocess.TimeoutExpired:
            return -1, "hangs"
        return done.returncode, done.stdout + done.stderr if done.returncode else done.stdout

    def share_of(self, scene, end):
        """How much of its run is compared; None if even the shortest takes too long."""
        for share in SHARES:
            if self.run_scene(scene, end, share) in (0, 3):  # 3: it has an end, and files
                return share
        print(f"too long to be compared: {scene}", flush=True)
        return None

    def run_scene(self, scene, end, share):
        until = [] if share == 1 else ["--until", repr(end * share)]
        return self.run(["{home}/furrow", "run", "{tree}/" + scene, *until, "--out", "out"], LONGEST, 20 * LONGEST)[0]

    def find_scenes(self):
        """By scene how much of its run is compared."""
        is_scene = lambda file: self.run(["{home}/furrow", "check", "{tree}/" + file], 60, 600)[0] == 0  # noqa: E731
        self.ends = {file: tomllib.loads((self.base.tree / file).read_text())["time"]["end"] for file in scenes_of(self.base.tree, is_scene)}
        self.shares = {file: self.share_of(file, end) for file, end in self.ends.items()}

    def written(self):
        """A digest of each file and output that the program makes of scenes and cases, without times and commit."""
        found = {}

        def note(name, text):
            found[name] = hashlib.sha256(state_in(text).encode()).hexdigest()

        for scene, share in self.shares.items():
            note(f"explain {scene}", self.run(["{home}/furrow", "explain", "{tree}/" + scene], 60, 600)[1])
            if share is None:
                continue
            self.run_scene(scene, self.ends[scene], share)
            for file in sorted((self.tmp / "out").rglob("*")):
                if file.is_file():
                    note(f"{scene}/{file.relative_to(self.tmp / 'out')}", file.read_text(errors="replace"))
        for case, steps in cases_of(self.base.tree).items():
            ask = f"{self.home}/furrow cases {case} --request {steps} | {self.home}/furrow engine"
            note(f"case {case}", self.run(["sh", "-c", ask], LONGEST, 20 * LONGEST)[1])
        for command in (["methods"], ["keys"], ["check", "{tree}/validation/scenes/scenario_3.toml"]):
            note("furrow " + command[0], self.run(["{home}/furrow", *command], 60, 600)[1])
        return found

    def try_edit(self, edit, text):
        """What notices the edit: {"verdict": noticed, survived, same program or not built, ...}."""
        shutil.rmtree(self.overlay, ignore_errors=True)
        (self.overlay / edit.file).parent.mkdir(parents=True)
        (self.overlay / edit.file).write_text(edit.applied(text))
        try:
            return self.judged(edit.file)
        except NotBuilt:
            return {"verdict": "not built"}

    def judged(self, file):
        header = file.endswith(".h")
        sources = sorted(self.base.including.get(file, ())) if header else [file]
        objects = {}
        for source in sources:
            place = self.base.compiling[source][1]
            compiled = self.compile(source)
            if digest(compiled) != digest(self.base.build / place):
                objects[place] = compiled
        first = [self.inlined()] if header else []
        if not objects and not (first and digest(first[0]) != self.sound_inlined):
            return {"verdict": "same program"}
        of_program = all(place.startswith(OF_PROGRAM) for place in objects)
        for name, command, binaries in self.base.suites:
            if of_program and not first and "furrow" not in binaries:
                continue
            self.link(objects, binaries, first)
            red = self.notice(name, command)
            if red:
                return {"verdict": "noticed", "by": name, "test": red}
        if not self.files:
            return {"verdict": "survived", "files": None}  # not compared: the program was not built
        files = self.written()
        changed = [name for name in sorted(files.keys() | self.files.keys()) if files.get(name) != self.files.get(name)]
        return {"verdict": "survived", "files": changed[:6]}

    def notice(self, name, command):
        """The test that fails, twice: what fails once may be the machine's fault."""
        sound_text, seconds = self.sound[name]
        for _ in (1, 2):
            code, text = self.run(command, cpu=5 * seconds + 10, wall=20 * seconds + 60)
            if code == 0 and (name != "determinism" or text == sound_text):
                return None
            if code == -1:
                return "hangs"
        failed = re.findall(r"\[  FAILED  \] ([\w/]+\.[\w/]+)", text)
        return failed[0] if failed else "hashes" if code == 0 else f"exit code {code}"
