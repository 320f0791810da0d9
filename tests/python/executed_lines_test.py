"""scripts/executed_lines counts the lines that ran, once each, of the folders that it is for."""

import pathlib
import subprocess
import tempfile
import unittest

source = pathlib.Path(__file__).resolve().parents[2]

LAW = """inline int law(int x) {
  if (x > 0)
    return 1;
  return 2;
}
"""
USER = '#include "src/physics/law.h"\nint other(int x);\nint main() { return law(1) + other(1) - 2; }\n'
OTHER = '#include "src/physics/law.h"\nint other(int x) { return law(x); }\n'


class ExecutedLines(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.root = pathlib.Path(self.place.name)
        (self.root / "src/physics").mkdir(parents=True)
        (self.root / "src/physics/law.h").write_text(LAW)
        (self.root / "user.cpp").write_text(USER)
        (self.root / "other.cpp").write_text(OTHER)

    def build(self):
        for name in ("user", "other"):
            command = ["g++", "-O0", "--coverage", "-I.", "-c", f"{name}.cpp", "-o", f"{name}.o"]
            subprocess.run(command, cwd=self.root, check=True)
        subprocess.run(["g++", "--coverage", "user.o", "other.o", "-o", "user"], cwd=self.root, check=True)
        subprocess.run(["./user"], cwd=self.root, check=True)

    def count(self, *options):
        command = [source / "scripts/executed_lines", "--count", self.root, *options]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_a_line_counts_once_and_a_line_that_did_not_run_does_not(self):
        self.build()
        got = self.count()
        self.assertEqual(got.returncode, 0, got.stderr)
        self.assertIn("3  src/physics/law.h", got.stdout)  # its head, the question and the first answer
        self.assertNotIn("user.cpp", got.stdout)

    def test_more_than_the_limit_fails(self):
        self.build()
        self.assertEqual(self.count("--limit", "3").returncode, 0)
        self.assertEqual(self.count("--limit", "2").returncode, 1)

    def test_nothing_that_ran_is_no_success(self):
        self.assertEqual(self.count().returncode, 4)

    def test_a_wrong_option(self):
        self.assertEqual(self.count("--limits", "x").returncode, 2)


if __name__ == "__main__":
    unittest.main()
