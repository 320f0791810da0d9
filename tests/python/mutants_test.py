"""What scripts/mutants compares where no test noticed an edit: all scenes and cases of the tree, and of their files what the run decides."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import tree

sys.dont_write_bytecode = True
sys.path.insert(0, str(tree.source / "tests/mutants"))
import workshop  # noqa: E402

furrow = os.environ["FURROW"]


def is_scene_in(folder):
    return lambda file: subprocess.run([furrow, "check", folder / file], capture_output=True).returncode == 0


class Compared(unittest.TestCase):

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.place = pathlib.Path(kept.name)

    def test_every_scene_of_the_tree_is(self):
        found = workshop.scenes_of(tree.source, is_scene_in(tree.source))
        scenes = [f for f in tree.files(".toml") if f.startswith(("validation/scenes/", "tests/property/scenes/"))]
        self.assertGreater(len(scenes), 15)
        self.assertEqual([scene for scene in [*scenes, "src/python/stem.toml", "benchmarks/rivals/scene.toml"] if scene not in found], [])
        self.assertEqual([file for file in found if not (tree.source / file).is_file()], [])

    def test_a_new_scene_is_without_a_word(self):
        shutil.copy(tree.source / "src/python/stem.toml", self.place / "new.toml")
        (self.place / "none.toml").write_text("[of]\nanother = 1\n")
        (self.place / "build").mkdir()
        shutil.copy(tree.source / "src/python/stem.toml", self.place / "build/made.toml")
        self.assertEqual(workshop.scenes_of(self.place, is_scene_in(self.place)), ["new.toml"])

    def test_every_case_is_and_can_be_asked(self):
        cases = workshop.cases_of(tree.source)
        listed = subprocess.run([furrow, "cases"], capture_output=True, text=True, check=True).stdout.splitlines()
        self.assertEqual(sorted(cases), sorted(line.split()[0] for line in listed if not line.startswith(" ")))
        for case in ("hertz_pair", "turned_pair"):
            asked = subprocess.run([furrow, "cases", case, "--request", str(cases[case])], capture_output=True, text=True, check=True)
            answer = subprocess.run([furrow, "engine"], input=asked.stdout, capture_output=True, text=True, check=True)
            self.assertIn('"observables"', answer.stdout)

    def test_a_run_is_the_same_as_itself_and_another_as_another(self):

        def state(name, *changed):
            subprocess.run([furrow, "run", tree.source / "src/python/stem.toml", "--out", self.place / name, *changed],
                           capture_output=True, check=True)
            files = [f for f in sorted((self.place / name).rglob("*")) if f.is_file()]
            return {str(f.relative_to(self.place / name)): workshop.state_in(f.read_text(errors="replace")) for f in files}

        first, again, other = state("first"), state("again"), state("other", "--set", "lattice[0].node_mass=0.051")
        self.assertGreater(len(first), 10)
        self.assertEqual([name for name in first if first[name] != again.get(name)], [])
        self.assertNotEqual(first["run.json"], other["run.json"])
        self.assertNotEqual(first["state.csv"], other["state.csv"])


if __name__ == "__main__":
    unittest.main()
