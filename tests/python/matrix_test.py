"""verification/engines/matrix.py: what is kept of verdicts names what made them, and old verdicts are not kept as new."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import tree

MATRIX = tree.source / "verification/engines/matrix.py"


class Kept(unittest.TestCase):

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)
        self.verdicts = self.place / "verdicts"
        self.verdicts.mkdir()
        for name in ("furrow_pece", "independent", "lammps"):
            self.left(name)
        self.furrow = self.place / "furrow"  # says what it was asked for
        self.furrow.write_text("#!/bin/sh\necho \"{\\\"commit\\\": \\\"$3\\\"}\"\n")
        self.furrow.chmod(0o755)

    def left(self, name, given="1"):
        judged = {"case": "spring", "title": "A spring", "engine": name, "method": "", "verdict": "right", "words": "", "input": given}
        (self.verdicts / f"{name}.json").write_text(json.dumps([judged]))

    def keep(self, since=0.0):
        self.file = self.place / "judgements.json"
        words = [sys.executable, MATRIX, self.verdicts, "--keep", self.file, "--by", self.furrow, "--since", str(since)]
        return subprocess.run(words, capture_output=True, text=True)

    def test_each_engine_names_what_made_its_verdicts(self):
        self.assertEqual(self.keep().returncode, 0)
        kept = json.loads(self.file.read_text())
        made = {one["engine"]: kept["makers"][one["maker"]]["commit"] for one in kept["engines"]}
        self.assertEqual(made, {"furrow_pece": "judged_furrow", "independent": "judged_independent", "lammps": "judged_others"})
        self.assertEqual(kept["inputs"], {"spring": "1"})
        self.assertEqual([one["engine"] for one in kept["engines"] if one["foreign"]], ["lammps"])

    def test_verdicts_of_an_earlier_judge_are_not_kept(self):
        os.utime(self.verdicts / "lammps.json", (1000, 1000))
        done = self.keep(since=2000)
        self.assertEqual((done.returncode, self.file.exists()), (4, False))
        self.assertIn("left by an earlier judge: lammps;", done.stderr)

    def test_verdicts_on_another_form_of_a_case_are_not_kept(self):
        self.left("lammps", given="2")
        done = self.keep()
        self.assertEqual((done.returncode, self.file.exists()), (4, False))
        self.assertIn("engines were given spring in two forms", done.stderr)

    def test_what_made_them_must_be_asked_for(self):
        done = subprocess.run([sys.executable, MATRIX, self.verdicts, "--keep", self.place / "a.json"], capture_output=True)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
