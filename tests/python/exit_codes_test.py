"""The exit codes of scripts/test and scripts/nightly. The scripts are the real ones; the build is a program that says what it was asked."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

source = pathlib.Path(__file__).resolve().parents[2]

# Leaves what ctest and the verification tests leave, and ends with the code that the variable of its preset names.
CMAKE = """#!/usr/bin/env bash
echo "cmake $*" >>"$ASKED"
if [[ $* == "--workflow --preset release" && -z ${NO_RESULTS-} ]]; then
  mkdir -p build/release/records
  echo '<testsuite name="all" tests="1"/>' >build/release/junit.xml
  echo '{"tests": 1, "missing": [], "checks": []}' >build/release/records/checks.json
fi
code=CODE_OF_${*: -1}
exit "${!code:-0}"
"""
STUB = """#!/usr/bin/env bash
echo "$(basename "$0") $*" >>"$ASKED"
code=CODE_OF_$(basename "$0" | tr - _)
exit "${!code:-0}"
"""


class ExitCodes(unittest.TestCase):

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.place = pathlib.Path(kept.name)
        for folder in ("scripts", "bin"):
            (self.place / folder).mkdir()
        for script in ("test", "nightly", "junit"):
            shutil.copy(source / "scripts" / script, self.place / "scripts")
        for name, text in (("bin/cmake", CMAKE), ("scripts/lint", STUB), ("scripts/install-packages", STUB)):
            (self.place / name).write_text(text)
            (self.place / name).chmod(0o755)

    def ended(self, script, *options, **codes):
        """The exit code, what it printed, and what it asked for."""
        asked = self.place / "asked"
        asked.write_text("")
        environment = os.environ | {"PATH": f"{self.place / 'bin'}:{os.environ['PATH']}", "ASKED": str(asked)} | codes
        done = subprocess.run([self.place / "scripts" / script, *options], env=environment, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr, asked.read_text()

    def test_0_only_if_every_step_passed(self):
        self.assertEqual(self.ended("test")[0], 0)
        self.assertEqual(self.ended("test", "--full")[0], 0)
        code, _, asked = self.ended("test", "--junit", self.place / "out.xml")
        self.assertEqual((code, asked), (0, "install-packages \ncmake --workflow --preset release\n"))
        self.assertIn("verification checks", (self.place / "out.xml").read_text())

    def test_1_if_a_test_failed_and_the_results_are_there_all_the_same(self):
        self.assertEqual(self.ended("test", CODE_OF_release="8")[0], 1)
        self.assertEqual(self.ended("test", "--junit", self.place / "out.xml", CODE_OF_release="8")[0], 1)
        self.assertTrue((self.place / "out.xml").exists())

    def test_1_if_a_step_before_it_failed_and_the_rest_runs(self):
        for options, failing in ((["--lint"], "lint"), (["--sanitizers"], "sanitizers"), (["--clang"], "clang"), (["--full"], "debug")):
            with self.subTest(failing):
                code, said, asked = self.ended("test", *options, **{f"CODE_OF_{failing}": "3"})
                self.assertEqual(code, 1)
                self.assertRegex(said, f"FAILED, see above: .*{failing}")
                self.assertIn("cmake --workflow --preset release\n", asked)

    def test_1_if_there_are_no_results_to_be_kept_or_packages_are_missing(self):
        code, said, _ = self.ended("test", "--junit", self.place / "out.xml", NO_RESULTS="1")
        self.assertEqual((code, "run the tests first" in said), (1, True))
        code, _, asked = self.ended("test", CODE_OF_install_packages="1")
        self.assertEqual((code, asked), (1, "install-packages \n"))

    def test_2_for_a_wrong_option_and_nothing_runs(self):
        for script, *options in (["test", "--jnit"], ["test", "--junit"], ["nightly", "--only", "nothing"], ["nightly", "-x"]):
            with self.subTest(options):
                self.assertEqual(self.ended(script, *options)[::2], (2, ""))

    def test_the_nightly_runs_every_build_that_has_tests(self):
        presets = json.loads((source / "CMakePresets.json").read_text())["workflowPresets"]
        listed = self.ended("nightly", "--list")[1]
        for name in [preset["name"] for preset in presets]:
            with self.subTest(name):
                self.assertRegex(listed, rf"cmake --workflow --preset {name}\b(?!_)")

    def test_the_nightly_ends_with_0_only_if_all_of_its_steps_passed(self):
        steps = ["--only", "release", "--only", "clang", "--only", "debug"]
        self.assertEqual(self.ended("nightly", *steps)[0], 0)
        code, said, asked = self.ended("nightly", *steps, CODE_OF_clang="8")
        self.assertEqual(code, 1)
        self.assertRegex(said, r"clang +FAILED \(8\)")
        self.assertIn("--preset debug", asked)


if __name__ == "__main__":
    unittest.main()
