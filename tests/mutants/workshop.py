"""A copy of the tree in which one edit at a time is built and tried, in a sandbox that can write nothing but the copy."""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import time

OUT_OF_STATE = re.compile(r'"(\w*cpu_seconds|wall_seconds|commit)"')
GTEST = ["--gtest_brief=1", "--gtest_fail_fast"]
# In the order of how soon they notice. What is built, what is run; the binaries whose bits decide whether it must run.
SUITES = [
    ("unit", ["unit_tests"], ["{build}/tests/unit_tests", *GTEST], ["tests/unit_tests"]),
    ("unit, no vectors", ["unit_tests"], ["FURROW_VECTORS=none", "{build}/tests/unit_tests", *GTEST], ["tests/unit_tests"]),
    ("command line", ["furrow_program", "command_line_tests"], ["{build}/tests/command_line_tests", *GTEST],
     ["furrow", "tests/command_line_tests"]),
    ("determinism", ["state_hashes"], ["{build}/tests/determinism/state_hashes", "{tree}/validation/scenes"],
     ["tests/determinism/state_hashes"]),
    ("verification", ["verification_tests"], ["{build}/verification/verification_tests", *GTEST], ["verification/verification_tests"]),
]  # fmt: skip
# Scenes whose files are compared where no test noticed, and until when they run, s.
SCENES = {"scenario_1": 1.2, "scenario_2": 0.2, "scenario_3": 0.2, "single_spring": 1, "disc_on_wall": 0.1, "cantilever": 1}


class NotBuilt(Exception):
    pass


def digest(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


class Workshop:
    def __init__(self, source, home, suites):
        self.source, self.home = source, home
        self.suites = [suite for suite in SUITES if suite[0] in suites]
        self.tree, self.build_dir, self.tmp = home / "tree", home / "build", home / "tmp"
        self.sound = {}  # by suite: digests of its binaries, output, seconds
        self.environment = dict(os.environ, CCACHE_BASEDIR=str(home), CCACHE_NOHASHDIR="1", TMPDIR=str(self.tmp))

    def prepare(self):
        """Copies and builds the tree without an edit; all suites must pass on it. Returns the time of each, s."""
        names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=self.source,
                               check=True, capture_output=True, text=True).stdout.split("\0")  # fmt: skip
        wanted = {name for name in names if name and (self.source / name).is_file()}
        if self.tree.exists():
            for old in self.tree.rglob("*"):
                if old.is_file() and str(old.relative_to(self.tree)) not in wanted:
                    old.unlink()
        for name in wanted:
            target = self.tree / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != (self.source / name).read_bytes():
                shutil.copy(self.source / name, target)
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        self.quiet(["cmake", "-S", self.tree, "-B", self.build_dir, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w", *launcher])  # fmt: skip
        for name, targets, command, binaries in self.suites:
            self.build(targets)
            began = time.monotonic()
            code, text = self.run(command, cpu=3600, wall=7200)
            if code != 0:
                raise SystemExit(f"the {name} tests fail without any edit:\n{text[-3000:]}")
            bits = [digest(self.build_dir / binary) for binary in binaries]
            self.sound[name] = (bits, text, time.monotonic() - began)
        self.files = self.written() if "command line" in self.sound else {}
        return {name: round(seconds, 1) for name, (_, _, seconds) in self.sound.items()}

    def quiet(self, command):
        done = subprocess.run([str(word) for word in command], env=self.environment, capture_output=True, text=True)
        if done.returncode != 0:
            raise NotBuilt(done.stdout[-3000:] + done.stderr[-1000:])

    def build(self, targets):
        self.quiet(["cmake", "--build", self.build_dir, "-j", "1", "--target", *targets])

    def run(self, command, cpu, wall):
        """Exit code and output; whoever takes longer than the limits, or more than 4 GB, is killed."""
        shutil.rmtree(self.tmp, ignore_errors=True)
        self.tmp.mkdir(parents=True)
        words = [word.format(tree=self.tree, build=self.build_dir) for word in command]
        box = ["bwrap", "--ro-bind", "/", "/", "--bind", self.home, self.home, "--dev", "/dev", "--proc", "/proc",
               "--unshare-pid", "--die-with-parent",
               "prlimit", f"--cpu={round(cpu)}", "--as=4000000000", "--fsize=1000000000", "--core=0",
               "env", "-C", self.tmp, *words]  # fmt: skip
        try:
            done = subprocess.run([str(word) for word in box], env=self.environment, capture_output=True, text=True,
                                  timeout=wall, errors="replace", stdin=subprocess.DEVNULL)  # fmt: skip
        except subprocess.TimeoutExpired:
            return -1, "hangs"
        return done.returncode, done.stdout + done.stderr if done.returncode else done.stdout

    def written(self):
        """A digest of each file and output that the program makes of the scenes, without times and commit."""
        found = {}
        for name, until in SCENES.items():
            scene = str(self.tree / "validation/scenes" / f"{name}.toml")
            _, text = self.run(["{build}/furrow", "explain", scene], 60, 600)
            found[f"explain {name}"] = hashlib.sha256(text.encode()).hexdigest()
            self.run(["{build}/furrow", "run", scene, "--until", str(until), "--out", "out"], 120, 1200)
            for file in sorted((self.tmp / "out").rglob("*")):
                if file.is_file():
                    lines = [line for line in file.read_text(errors="replace").split("\n") if not OUT_OF_STATE.search(line)]
                    found[f"{name}/{file.relative_to(self.tmp / 'out')}"] = hashlib.sha256("\n".join(lines).encode()).hexdigest()
        for command in (["methods"], ["check", str(self.tree / "validation/scenes/scenario_3.toml")]):
            found["furrow " + command[0]] = hashlib.sha256(self.run(["{build}/furrow", *command], 60, 600)[1].encode()).hexdigest()
        return found

    def try_edit(self, edit):
        """What notices the edit: {"verdict": noticed, survived, same program or not built, ...}."""
        file = self.tree / edit.file
        text = file.read_text()
        file.write_text(edit.applied(text))
        try:
            return self.judged()
        except NotBuilt:
            return {"verdict": "not built"}
        finally:
            file.write_text(text)

    def judged(self):
        changed = False
        for name, targets, command, binaries in self.suites:
            self.build(targets)
            bits, sound_text, seconds = self.sound[name]
            if [digest(self.build_dir / binary) for binary in binaries] == bits:
                continue
            changed = True
            red = self.notice(command, sound_text if name == "determinism" else None, seconds)
            if red:
                return {"verdict": "noticed", "by": name, "test": red}
        if not changed:
            return {"verdict": "same program"}
        files = self.written() if self.files else {}
        return {"verdict": "survived", "files": sorted(k for k in files.keys() | self.files.keys() if files.get(k) != self.files.get(k))[:6]}

    def notice(self, command, sound_text, seconds):
        """The test that fails, twice: what fails once may be the machine's fault."""
        for attempt in (1, 2):
            code, text = self.run(command, cpu=5 * seconds + 10, wall=20 * seconds + 60)
            if code == 0 and (sound_text is None or text == sound_text):
                return None
            if code == -1:
                return "hangs"
        failed = re.findall(r"\[  FAILED  \] (\w+\.\w+)", text)
        return failed[0] if failed else "hashes" if code == 0 else f"exit code {code}"
