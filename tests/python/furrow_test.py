"""Tests of src/python/furrow.py, against the program that the variable FURROW names. With -S there is no numpy."""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

source = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("FURROW_PYTHON", str(source / "src/python")))
import furrow

FIRST = source / "validation/scenes/scenario_1.toml"
DISC = source / "validation/scenes/disc_on_wall.toml"
PACKED = source / "tests/property/scenes/packing.toml"
SCENES = sorted([*source.glob("validation/scenes/*.toml"), *source.glob("tests/property/scenes/*.toml")])
SHORT = {"time.end": 0.1}


def rows_of(file):
    with open(file, newline="") as stream:
        return list(csv.reader(stream))


class Scenes(unittest.TestCase):

    def test_a_scene_as_dict_and_as_toml_again_is_the_same(self):
        self.assertGreater(len(SCENES), 8)
        for file in SCENES:
            scene = furrow.load(file)
            self.assertEqual(tomllib.loads(furrow.to_toml(scene)), scene, file)

    def test_a_value_that_is_none_is_left_out_and_one_that_no_scene_holds_is_an_error(self):
        self.assertEqual(furrow.to_toml({"a": None, "b": 1}), "b = 1\n")
        with self.assertRaisesRegex(furrow.Error, "cannot hold a object"):
            furrow.to_toml({"a": object()})

    def test_infinity_and_names_with_quotes_survive(self):
        scene = {"title": 'a "b" \\ ü', "x": math.inf}
        self.assertEqual(tomllib.loads(furrow.to_toml(scene)), scene)

    def test_check_returns_warnings_and_raises_what_is_wrong(self):
        scene = furrow.load(DISC)
        self.assertEqual(furrow.check(scene), [])
        scene["material"].append({"name": "nobody", "rigid": True})
        self.assertRegex(" ".join(furrow.check(scene)), "scene: warning: material.2.: no part is of it")
        scene["time"]["stp"] = 1
        with self.assertRaises(furrow.RunFailed) as caught:
            furrow.check(scene)
        self.assertEqual(caught.exception.code, 2)
        self.assertRegex(caught.exception.message, r'^scene:\d+:\d+: error: time.stp: .*did you mean "step"')

    def test_keys_are_those_of_the_program(self):
        step, = furrow.keys("time.step")
        self.assertEqual((step["key"], step["unit"], step["required"]), ("time.step", "s", True))
        self.assertGreater(len(furrow.keys()), 100)


class Program(unittest.TestCase):

    def test_that_is_missing_is_named(self):
        before = os.environ.get("FURROW")
        self.addCleanup(lambda: os.environ.__setitem__("FURROW", before) if before else os.environ.pop("FURROW"))
        os.environ["FURROW"] = "/no/such/furrow"
        with self.assertRaisesRegex(furrow.ProgramNotFound, "FURROW names '/no/such/furrow', which is no program"):
            furrow.run(DISC)


class Runs(unittest.TestCase):

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.place = pathlib.Path(kept.name)

    def test_a_file_and_its_dict_give_the_same_bits(self):
        hashes = {furrow.run(scene, SHORT).json["state_hash"] for scene in (FIRST, str(FIRST), furrow.load(FIRST))}
        self.assertEqual(len(hashes), 1)

    def test_a_key_that_is_set_is_the_same_as_one_in_the_scene(self):
        scene = furrow.load(FIRST)
        scene["time"]["end"], scene["plate"][0]["velocity"] = 0.1, [0.2, 0.0]
        scene["output"]["frames"] = [0.0]
        scene["lattice"][0]["damper"] = "full"
        changed = {"plate[0].velocity": [0.2, 0.0], "lattice[0].damper": "full"} | SHORT
        self.assertEqual(furrow.run(FIRST, changed).scene, furrow.run(scene).scene)

    def test_every_output_is_a_table_with_names_and_units(self):
        run = furrow.run(FIRST, {"time.end": 0.6}, out=self.place / "a")
        for name in ("plate_force", "energy", "motion", "events", "state", "frames"):
            table = getattr(run, name)
            file = self.place / "a" / ("frames/frames.csv" if name == "frames" else name + ".csv")
            headings, *rows = rows_of(file)
            self.assertEqual([f"{n} [{table.unit(n)}]" if table.unit(n) else n for n in table.names], headings)
            self.assertEqual(len(table), len(rows))
            self.assertGreater(len(table), 0)
            for k, heading in enumerate(headings):
                for got, cell in zip(table[heading], [row[k] for row in rows]):
                    if isinstance(got, str):
                        self.assertEqual(got, cell)
                    else:
                        self.assertTrue(got == float(cell or "nan") or (not cell and math.isnan(got)))
        self.assertEqual(run.plate_force.unit("F"), "N")
        self.assertEqual(run.json["ended"], "finished")
        self.assertEqual(len(run.frame(0)["links"]), run.json["links"])
        self.assertEqual(furrow.read(self.place / "a").json, run.json)

    def test_columns_are_arrays_where_there_is_numpy(self):
        column = furrow.run(FIRST, SHORT).plate_force["F"]
        without = os.environ.get("FURROW_WITHOUT_NUMPY")
        self.assertEqual(type(column).__module__, "builtins" if without else "numpy")

    def test_where_keeps_the_rows_asked_for(self):
        state = furrow.run(FIRST, SHORT).state
        fixed, free = state.where(body="fixed node"), state.where(body="node")
        self.assertEqual((len(fixed), len(free)), (6, 24))
        self.assertEqual(max(abs(v) for v in fixed["vx"]), 0)

    def test_a_wrong_column_names_those_that_there_are(self):
        force = furrow.run(FIRST, SHORT).plate_force
        for name in ("F [kN]", "force"):
            with self.assertRaisesRegex(KeyError, r"no column .*; there are t \[s\], plate, .*F \[N\]"):
                force[name]

    def test_a_run_that_diverges_raises_its_code_and_keeps_its_files(self):
        with self.assertRaises(furrow.RunFailed) as caught:
            furrow.run(FIRST, {"time.step": 0.02}, out=self.place / "a")  # beyond the largest stable one
        self.assertEqual(caught.exception.code, 3)
        self.assertEqual(caught.exception.directory, self.place / "a")
        self.assertIn(furrow.read(self.place / "a").json["ended"], ("diverged", "invalid"))
        self.assertGreater(len(furrow.read(self.place / "a").motion), 0)

    def test_a_directory_without_a_run_is_an_error(self):
        with self.assertRaisesRegex(furrow.Error, "there is no run.json in it"):
            furrow.read(self.place)

    def test_resumed_it_ends_with_the_same_bits(self):
        whole = furrow.run(FIRST, {"time.end": 0.2})
        furrow.run(FIRST, SHORT, out=self.place / "a")
        self.assertEqual(furrow.run(FIRST, out=self.place / "a", resume=True, until=0.2).json["state_hash"],
                         whole.json["state_hash"])

    def test_to_be_resumed_a_run_needs_its_directory(self):
        with self.assertRaisesRegex(furrow.Error, "give out"):
            furrow.run(FIRST, resume=True)

    def test_a_temporary_directory_goes_with_its_run(self):
        run = furrow.run(FIRST, SHORT)
        directory = run.directory
        self.assertTrue(directory.exists())
        del run
        self.assertFalse(directory.exists())


class Ensembles(unittest.TestCase):

    def test_every_combination_is_run_in_order_with_its_seeds(self):
        members = list(furrow.ensemble(PACKED, vary={"time.step": [1e-4, 5e-5]}, seeds=(1, 2), set={"time.end": 0.01}))
        self.assertEqual([m.parameters for m in members],
                         [{"seed": s, "time.step": h} for h in (1e-4, 5e-5) for s in (1, 2)])
        self.assertEqual(len({m.run.json["state_hash"] for m in members}), 4)
        self.assertEqual([m.run.json["seed"][0] for m in members], [1, 2, 1, 2])
        self.assertEqual([m.run.json["step"] for m in members], [1e-4, 1e-4, 5e-5, 5e-5])

    def test_side_by_side_the_bits_are_those_of_one_after_the_other(self):
        hashes = [[m.run.json["state_hash"] for m in furrow.ensemble(PACKED, seeds=range(4), set={"time.end": 0.01}, jobs=n)]
                  for n in (1, 4)]
        self.assertEqual(*hashes)

    def test_a_failure_ends_it_or_is_kept(self):
        steps = {"time.step": [1e-4, -1]}
        with self.assertRaises(furrow.RunFailed):
            list(furrow.ensemble(FIRST, steps, set=SHORT))
        good, bad = furrow.ensemble(FIRST, steps, set=SHORT, keep_failures=True)
        self.assertIsNone(good.error)
        self.assertEqual((bad.run, bad.error.code), (None, 2))

    def test_seeds_need_a_packing(self):
        with self.assertRaisesRegex(furrow.Error, "this one has none"):
            list(furrow.ensemble(FIRST, seeds=[1]))


@unittest.skipIf(os.environ.get("FURROW_WITHOUT_NUMPY"), "they need numpy")
class WithOtherPackages(unittest.TestCase):

    def test_a_table_becomes_a_data_frame(self):
        run = furrow.run(FIRST, {"time.end": 0.3})
        frame = run.plate_force.to_pandas()
        self.assertEqual(list(frame.columns), rows_of(run.directory / "plate_force.csv")[0])
        self.assertEqual(frame["F [N]"].max(), run.plate_force["F"].max())

    def test_the_curve_of_the_force_is_that_of_the_table(self):
        import matplotlib
        matplotlib.use("Agg")
        run = furrow.run(FIRST, {"time.end": 0.3})
        axes = furrow.plot_force([run, run], labels=["a", "b"], component="Fx")
        force = run.plate_force.where(plate="tool")
        self.assertEqual(len(axes.lines), 2)
        self.assertTrue((axes.lines[0].get_xdata() == force["displacement"]).all())
        self.assertTrue((axes.lines[0].get_ydata() == force["Fx"]).all())
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("displacement [m]", "Fx [N]"))
        with self.assertRaisesRegex(furrow.Error, "no plate, no force"):
            furrow.plot_force(furrow.run(DISC))

    def test_a_picture_has_every_disc_link_and_plate_where_it_is(self):
        import matplotlib
        matplotlib.use("Agg")
        scene = source / "tests/property/scenes/lattice_hit.toml"
        run = furrow.run(scene)
        frame = run.frame(0)
        axes = furrow.plot_frame(run, 0, shift=0.5)
        self.assertEqual(len(axes.lines), len(frame["links"]))
        self.assertEqual(len(axes.patches), len(frame["discs"]) + len(frame["plates"]))
        self.assertEqual(axes.patches[0].center, (frame["discs"]["x"][0] + 0.5, frame["discs"]["y"][0]))
        self.assertEqual(list(axes.lines[0].get_xdata()), [frame["links"]["x1"][0] + 0.5, frame["links"]["x2"][0] + 0.5])
        self.assertEqual(axes.patches[-1].get_xy(), (frame["plates"]["left"][0] + 0.5, frame["plates"]["lower"][0]))

    def test_numbers_of_numpy_may_stand_in_a_scene(self):
        import numpy
        scene = {"a": numpy.float64(0.1), "b": numpy.int32(3), "c": numpy.array([1.5, 2.0]), "d": numpy.bool_(True)}
        self.assertEqual(tomllib.loads(furrow.to_toml(scene)), {"a": 0.1, "b": 3, "c": [1.5, 2.0], "d": True})


if __name__ == "__main__":
    unittest.main()
