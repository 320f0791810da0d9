"""Tests of src/python/furrow.py, against the program that the variable FURROW names. With -S there is no numpy."""

import contextlib
import csv
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zlib

source = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("FURROW_PYTHON", str(source / "src/python")))
import furrow

FIRST = source / "validation/scenes/scenario_1.toml"
DISC = source / "validation/scenes/disc_on_wall.toml"
PACKED = source / "tests/property/scenes/packing.toml"
SCENES = sorted([*source.glob("validation/scenes/**/*.toml"), *source.glob("tests/property/scenes/*.toml")])
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

    def test_what_has_no_order_or_is_no_list_is_an_error_that_names_the_key(self):
        for value in ({0, 0.02}, frozenset((1, 2)), b"ab", bytearray(b"ab"), iter([1, 2]), {1: 2}.keys(), (k for k in (1, 2))):
            word = re.escape(type(value).__name__)
            for key, made in (("disc[0].position", lambda: furrow.run(DISC, {"disc[0].position": value})),
                              ("plate.at", lambda: furrow.to_toml({"plate": {"at": [value]}})),
                              ("time.step", lambda: list(furrow.ensemble(DISC, {"time.step": value}))),
                              ("seeds", lambda: list(furrow.ensemble(PACKED, seeds=value)))):
                with self.subTest(key, type=word), self.assertRaisesRegex(TypeError, f"^{re.escape(key)} is no list but a {word}"):
                    made()
        with self.assertRaisesRegex(TypeError, "^a.b: a scene cannot hold a complex"):
            furrow.to_toml({"a": [{"b": 1j}]})
        self.assertEqual(tomllib.loads(furrow.to_toml({"a": (1, 2), "b": range(3), "c": [(1, 2), [3]]})),
                         {"a": [1, 2], "b": [0, 1, 2], "c": [[1, 2], [3]]})

    def test_a_text_that_no_file_holds_is_an_error(self):
        for scene in ({"title": "a \ud800"}, {"\udc80": 1}, {"a": {"b": ["\udfff"]}}, {"a": [{"\ud800": {"b": 1}}]}):
            with self.subTest(scene), self.assertRaisesRegex(furrow.Error, "a text that UTF-8 cannot"):
                furrow.check(scene)

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

    def test_of_a_file_that_is_not_there_the_true_reason_is_said(self):
        run = furrow.run(DISC, {"output.frames": []}, out=self.place / "run")
        for name, wanted in (("drive_force.csv", "its scene drives no nodes of a lattice"),
                             ("frames/discs_000.csv", "the run has 0 pictures; output.frames asks for them"),
                             ("forces.csv", "a run writes no such file; its files are energy.csv, .*wall_force.csv")):
            with self.subTest(name), self.assertRaisesRegex(furrow.Error, f"has no {name}: {wanted}"):
                run.table(name)
        with self.assertRaisesRegex(furrow.Error, "has no frames/discs_003.csv: the run has 3 pictures, 0 to 2"):
            furrow.run(DISC).frame(3)
        (run.directory / "motion.csv").unlink()
        with self.assertRaisesRegex(furrow.Error, "has no motion.csv: it was written and is gone"):
            run.motion
        with self.assertRaises(furrow.RunFailed):
            furrow.run(FIRST, {"time.step": 0.01}, out=self.place / "failed")
        with self.assertRaisesRegex(furrow.Error, "has no drive_force.csv: its scene drives no nodes"):
            furrow.read(self.place / "failed").drive_force

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

    def test_where_compares_names_as_texts(self):
        columns = {"plate": ["0", "1", "0"], "kind": ["shear"] * 3, "F": [1.0, 2.0, 3.0]}
        if furrow.numpy:
            columns = {name: furrow.numpy.array(cells) for name, cells in columns.items()}
        table = furrow.Table(columns, {"plate": "", "kind": "", "F": "N"})
        self.assertEqual(list(table.where(plate=0)["F"]), [1, 3])
        self.assertEqual(list(table.where(plate="1", F=2)["F"]), [2])
        self.assertEqual(len(table.where(plate="1").where(plate="0")), 0)  # no row, but there is such a plate
        with self.assertRaises(furrow.Error):
            table.where(F=99).where(plate="nope")
        self.assertEqual(len(table.where(kind="structural")), 0)  # none of that kind is an answer
        for plate in (2, "tool", 0.0):
            with self.subTest(plate), self.assertRaisesRegex(furrow.Error, "no plate is named .*; there are '0', '1'"):
                table.where(plate=plate)
        for number in ("0", "", None, [1]):
            with self.assertRaisesRegex(furrow.Error, "the column 'F' holds numbers: give one, not "):
                table.where(F=number)

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

    def test_an_empty_name_of_a_directory_is_an_error(self):
        for made in (lambda: furrow.run(FIRST, SHORT, out=""), lambda: list(furrow.ensemble(FIRST, out=""))):
            with self.assertRaisesRegex(furrow.Error, "out names no directory"):
                made()

    def test_a_file_whose_name_begins_with_a_dash_is_no_option(self):
        (self.place / "-x.toml").write_bytes(pathlib.Path(FIRST).read_bytes())
        with contextlib.chdir(self.place):
            self.assertEqual(furrow.check("-x.toml"), furrow.check(FIRST))
            self.assertEqual(furrow.run(pathlib.Path("-x.toml"), SHORT).json["ended"], "finished")
            for file in (b"-x.toml", os.path.join(".", "-x.toml")):
                self.assertEqual(furrow.check(file), furrow.check(FIRST))

    def test_a_directory_whose_name_begins_with_a_dash_is_no_option(self):
        with contextlib.chdir(self.place):
            for out in ("-x", pathlib.Path("-y"), "--out"):
                with self.subTest(out):
                    self.assertEqual(furrow.run(FIRST, SHORT, out=out).directory, pathlib.Path(out))
                    self.assertEqual(furrow.run(FIRST, out=out, resume=True, until=0.11).json["end"], 0.11)
                    self.assertEqual(furrow.read(out).json["end"], 0.11)
            member, = furrow.ensemble(FIRST, {"time.end": [0.1]}, out="-e")
            self.assertEqual(member.run.directory, pathlib.Path("-e/000"))
            with self.assertRaises(furrow.RunFailed) as caught:
                furrow.run(FIRST, {"time.step": 0.02}, out="-failed")
            self.assertEqual(caught.exception.directory, "-failed")
        for pattern in ("-x", "--json", "--"):
            with self.subTest(pattern), self.assertRaisesRegex(furrow.RunFailed, f'no key has "{pattern}" in its name'):
                furrow.keys(pattern)

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

    def test_a_call_that_is_wrong_leaves_no_temporary_directory(self):
        before = tempfile.tempdir
        self.addCleanup(lambda: setattr(tempfile, "tempdir", before))
        tempfile.tempdir = str(self.place)
        for given in ([("time.end", 0.1)], {3: 1}, {"title=x": "y"}, {"time.end ": 0.1}, {"time.end": object()}, {"time.end": 0.1, "time.end.": 0.1}, {"title": "\ud800"}, {"title": "a\0"},
                      {"time.stp": 1}):
            with self.subTest(given), self.assertRaises(furrow.Error):
                furrow.run(FIRST, given)
        self.assertEqual(list(self.place.iterdir()), [])

    def test_a_key_that_is_no_key_does_not_become_another_one(self):
        with self.assertRaisesRegex(furrow.Error, "no key of a scene is spelt so"):
            furrow.to_toml({"time": {"end = 0.01 #": 0.5}})

    def test_blanks_around_a_title_are_the_titles(self):
        self.assertEqual(furrow._settings({"title": "  a  ", "time.method": "rk4"}), ["--set", 'title="  a  "', "--set", "time.method=rk4"])


class Broken(unittest.TestCase):
    """Files that are not what a run wrote: one error, which names the file and the row."""

    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.whole = pathlib.Path(kept.name) / "whole"
        furrow.run(FIRST, {"time.end": 0.1, "output.interval": 0.01}, out=cls.whole)

    def setUp(self):
        self.place = self.whole.with_name("a")
        shutil.copytree(self.whole, self.place)
        self.addCleanup(shutil.rmtree, self.place)

    def change(self, name, change):
        file = self.place / name
        file.write_text(change(file.read_text()))

    def change_json(self, **fields):
        """With other fields, sealed again."""
        kept = {key: value for key, value in json.loads((self.place / "run.json").read_text()).items() if key != "seal"}
        text = json.dumps(kept | fields, indent=2)[:-2]
        (self.place / "run.json").write_text(f'{text},\n  "seal": "{zlib.crc32(text.encode()):08x}"\n}}\n')

    def require_error(self, action, *words):
        with self.assertRaises(furrow.Error) as caught:
            action()
        for word in words:
            self.assertIn(word, str(caught.exception))

    def test_a_cell_a_row_or_a_column_that_is_wrong_is_named(self):
        table = self.place / "table.csv"
        for text, *words in (
                ("", "row 1", "empty"),
                ("a [m],b\n1,2\n3\n5,6\n", "row 3", "1 cells, the heading 2"),
                ("a [m],b\n1,2\n\n5,6\n", "row 3", "0 cells"),
                ("a [m],b\n1,2\n3,4,5\n", "row 3", "3 cells"),
                ("a [m],b\n1,2\n3\n", "row 3", "1 cells"),
                ("a [m],b\n1,2\n3,\n", "row 3", "'b' is empty"),
                ("a [m],b\n1,x\n", "row 2", "'b' is no number: 'x'"),
                ("plate,b\n,1\n", "row 2", "'plate' is empty"),
                ("a [m],b\n1,2\n3,4", "row 3", "was cut"),
                ("a [m],b,a [m]\n1,2,3\n", "row 1", "two columns are named 'a'"),
                ("a [m],a [mm]\n1,2\n", "row 1", "two columns are named 'a'"),
                ("a,,b\n1,2,3\n", "row 1", "no name"),
                ("body,radius [m]\ndisc,\n", "row 2", "'radius' is empty"),
                ('a,b\n1,"2\n', "cannot be read as CSV")):
            with self.subTest(text):
                table.write_text(text)
                self.require_error(lambda: furrow.Table.from_csv(table), str(table), *words)
        table.write_bytes(b"a\n\xff\n")
        self.require_error(lambda: furrow.Table.from_csv(table), str(table), "cannot be read")
        self.require_error(lambda: furrow.Table.from_csv(self.place / "none.csv"), "none.csv", "cannot be read")

    def test_a_node_has_no_radius(self):
        self.assertTrue(all(math.isnan(radius) for radius in furrow.read(self.place).state["radius"]))

    def test_rows_that_are_missing_or_doubled_are_named(self):
        def without(first, last=None):
            return lambda text: "".join(text.splitlines(True)[:first] + (text.splitlines(True)[last:] if last else []))

        def doubled(text):
            lines = text.splitlines(True)
            return "".join(lines[:5] + lines[4:])

        for name, change, *words in (
                ("plate_force.csv", without(4), "ends with row 4 of 0.02 s", "finished", "wrote 12 rows"),
                ("plate_force.csv", without(11), "ends with row 11 of 0.09"),
                ("motion.csv", without(1), "ends with row 1, the heading"),
                ("energy.csv", without(4, 5), "row 5", "s where 0.03 s is due"),
                ("energy.csv", doubled, "row 6", "s where 0.04 s is due"),
                ("wall_force.csv", lambda text: text + "0,floor,1,1,1\n", "wrote 1 rows"),
                ("state.csv", without(20), "ends with row 20", "wrote 31 rows"),
                ("frames/frames.csv", without(1), "ends with row 1", "wrote 2 rows"),
                ("frames/links_000.csv", without(50), "ends with row 50", "wrote 118 rows"),
                ("frames/plates_000.csv", without(1), "ends with row 1", "wrote 2 rows")):
            with self.subTest(name):
                before = (self.place / name).read_text()
                self.change(name, change)
                self.require_error(lambda: furrow.read(self.place).table(name), str(self.place / name), *words)
                (self.place / name).write_text(before)
                furrow.read(self.place).table(name)

    def test_whole_files_are_read_whatever_the_step_and_the_interval(self):
        names = ("plate_force.csv", "wall_force.csv", "energy.csv", "motion.csv", "events.csv", "state.csv",
                 "frames/frames.csv", "frames/discs_000.csv", "frames/links_000.csv", "frames/plates_000.csv",
                 "frames/contacts_000.csv")
        for scene, changes in (
                (FIRST, {"time.end": 0.3, "output.interval": 0.1}),
                (FIRST, {"time.end": 0.3, "output.interval": 0.1, "time.method": "odeint_dopri5"}),
                (FIRST, {"time.end": 0.1003, "output.interval": 0.00013}),
                (FIRST, {"time.end": 0.055, "output.interval": 0.02}),
                (FIRST, {"time.end": 0.1, "output.interval": 0.00015, "time.locate": "all", "output.energy": False}),
                (DISC, {})):
            run = furrow.run(scene, changes)
            for name in names:
                with self.subTest(name, **changes):
                    self.assertEqual(len(run.table(name)), len(rows_of(run.directory / name)) - 1)

    def test_methods_that_choose_their_steps_are_those_of_the_program(self):
        listed = subprocess.run([furrow.program(), "methods"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(set(re.findall(r"^(\S+) .*?  controlled  ", listed, re.MULTILINE)), set(furrow._CONTROLLED))

    def test_a_run_json_that_is_broken_is_named(self):
        whole = json.loads((self.place / "run.json").read_text())
        without = {key: value for key, value in whole.items() if key != "ended"}
        for text, word in (("", "JSON"), ("{", "JSON"), ("[]", "no JSON object"), ("null", "no JSON object"),
                           ("{}", "no field 'title'"), (json.dumps(without), "no field 'ended'"),
                           (json.dumps(whole | {"ended": ["x"]}), "'ended' is ['x']"),
                           (json.dumps(whole | {"ended": "well"}), "'ended' is 'well'"),
                           (json.dumps(whole | {"end": "1"}), "'end' is '1'"),
                           (json.dumps(whole | {"end": math.nan}), "'end' is nan"),
                           (json.dumps(whole | {"discs": None}), "'discs' is None"),
                           (json.dumps(whole | {"ended_at": 0.05}), "finished, but at 0.05 s of 0.1 s"),
                           (json.dumps(whole | {"ended": "diverged"}), "diverged, but .furrow.json finished")):
            with self.subTest(text[:20], word=word):
                (self.place / "run.json").write_text(text)
                self.require_error(lambda: furrow.read(self.place), str(self.place / "run.json"), word)

    def test_a_scene_that_is_broken_or_gone_is_named(self):
        for text in ("", "[output\n", "output = 1\n", None):
            with self.subTest(text):
                (self.place / "scene.toml").unlink() if text is None else (self.place / "scene.toml").write_text(text)
                self.require_error(lambda: furrow.read(self.place).energy, "scene.toml")

    def test_a_file_that_is_not_what_run_json_says_is_named(self):
        furrow.read(self.place).motion
        for name, change in (("energy.csv", lambda text: text[:-2] + ("1\n" if text[-2] != "1" else "2\n")),
                             ("frames/links_000.csv", lambda text: text.replace("structural", "diagonal", 1)),
                             ("events.csv", lambda text: text + "0.01,0,shear,stem,1,1,2,0,1,40\n")):
            with self.subTest(name):
                self.change(name, change)
                self.require_error(lambda: furrow.read(self.place).table(name), str(self.place / name), "CRC-32")
        self.change("scene.toml", lambda text: text + "\n")
        self.require_error(lambda: furrow.read(self.place).scene, str(self.place / "scene.toml"), "CRC-32")
        self.change("run.json", lambda text: text.replace('"links": 117', '"links": 118'))
        self.require_error(lambda: furrow.read(self.place), str(self.place / "run.json"), "its seal differ")

    def test_a_run_json_without_its_seal_is_none(self):
        whole = json.loads((self.place / "run.json").read_text())
        bare = {key: value for key, value in whole.items() if key != "seal"}
        for changed in (bare, bare | {"title": "another"}, whole | {"seal": None}, whole | {"seal": ""}):
            with self.subTest(changed.get("seal", "none"), title=changed["title"]):
                (self.place / "run.json").write_text(json.dumps(changed, indent=2) + "\n")
                self.require_error(lambda: furrow.read(self.place), str(self.place / "run.json"), "seal")

    def test_a_run_that_is_under_way_or_was_killed_is_no_run(self):
        self.change(".furrow.json", lambda text: text.replace('"finished"', '"running"'))
        self.require_error(lambda: furrow.read(self.place), "finished, but .furrow.json running")
        (self.place / "run.json").unlink()
        self.require_error(lambda: furrow.read(self.place), "there is no run.json in it", "under way or was killed")

    def test_a_partial_series_is_read_only_if_that_is_asked_for(self):
        file, part = self.place / "energy.csv", self.place / "energy.csv.partial"
        file.rename(part)
        for partial in (False, True):
            self.require_error(lambda: furrow.read(self.place, partial).energy, str(part), "run.json says finished")
        self.change_json(ended="interrupted", ended_at=0.05, files={})
        self.change(".furrow.json", lambda text: text.replace('"finished"', '"interrupted"'))
        part.write_text("".join(part.read_text().splitlines(True)[:7]))
        self.require_error(lambda: furrow.read(self.place).energy, str(part), "'interrupted' at 0.05 s", "partial=True")
        self.assertEqual(len(furrow.read(self.place, partial=True).energy), 6)
        part.write_text("".join(part.read_text().splitlines(True)[:6]))
        self.require_error(lambda: furrow.read(self.place, partial=True).energy, str(part), "row 6 of 0.04 s")


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

    def kept_in(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        return pathlib.Path(kept.name) / "E"

    def states_in(self, place):
        return [member["state"] for member in json.loads((place / "ensemble.json").read_text())["members"]]

    def test_its_directory_has_a_list_of_its_members(self):
        place = self.kept_in()
        list(furrow.ensemble(PACKED, {"time.method": ["pece", "verlet"]}, seeds=[3], set={"time.end": 0.01}, out=place))
        wanted = [{"directory": f"00{k}", "parameters": {"seed": "3", "time.method": method}, "state": "finished"}
                  for k, method in enumerate(("pece", "verlet"))]
        self.assertEqual(json.loads((place / "ensemble.json").read_text()),
                         {"made_by": "furrow.py ensemble", "members": wanted})
        self.assertEqual(sorted(os.listdir(place)), ["000", "001", "ensemble.json"])

    def test_no_member_of_an_earlier_one_stays_beside_its_own(self):
        place = self.kept_in()
        two, one = {"time.end": [0.1, 0.11]}, {"time.end": [0.12]}
        list(furrow.ensemble(FIRST, two, out=place))
        (place / "notes").write_text("mine")
        before = {file: file.read_bytes() for file in place.rglob("*") if file.is_file()}
        with self.assertRaisesRegex(furrow.Error, "members of an earlier ensemble that this one has not: 001; remove them"):
            list(furrow.ensemble(FIRST, one, out=place))
        self.assertEqual({file: file.read_bytes() for file in place.rglob("*") if file.is_file()}, before)
        list(furrow.ensemble(FIRST, two, out=place))  # the same again replaces them
        shutil.rmtree(place / "001")
        list(furrow.ensemble(FIRST, one, out=place))
        self.assertEqual(sorted(os.listdir(place)), ["000", "ensemble.json", "notes"])
        (place / "001").mkdir()
        (place / "001/mine").write_text("mine")  # of no ensemble
        list(furrow.ensemble(FIRST, one, out=place))
        self.assertEqual((place / "001/mine").read_text(), "mine")

    def test_what_an_earlier_one_left_in_the_place_of_a_member_is_not_called_its_run(self):
        place = self.kept_in()
        list(furrow.ensemble(FIRST, {"time.end": [0.1, 0.11, 0.12]}, out=place))
        members = list(furrow.ensemble(FIRST, {"time.step": [1e-4, -1, 0.02]}, set=SHORT, out=place, jobs=1, keep_failures=True))
        self.assertEqual(self.states_in(place), ["finished", "failed", "failed"])
        self.assertIsNone(members[1].error.directory)  # refused: what stands there is the earlier run
        self.assertEqual(members[2].error.directory, place / "002")
        with self.assertRaises(furrow.RunFailed):
            list(furrow.ensemble(FIRST, {"time.step": [-1, 1e-4, 1e-4]}, set=SHORT, out=place, jobs=1))
        self.assertEqual(self.states_in(place)[0], "failed")

    def test_a_file_that_is_no_list_of_an_ensemble_stays(self):
        for text in ("mine", "{}", '{"made_by": "me", "members": []}', '{"made_by": "furrow.py ensemble", "members": [{"directory": "../x"}]}'):
            place = self.kept_in()
            place.mkdir()
            (place / "ensemble.json").write_text(text)
            with self.subTest(text), self.assertRaisesRegex(furrow.Error, "ensemble.json is in the way"):
                list(furrow.ensemble(FIRST, {"time.end": [0.1]}, out=place))
            self.assertEqual((place / "ensemble.json").read_text(), text)
            self.assertEqual(os.listdir(place), ["ensemble.json"])
        with self.assertRaisesRegex(furrow.Error, "cannot make .*ensemble.json/in: Not a directory"):
            list(furrow.ensemble(FIRST, {"time.end": [0.1]}, out=place / "ensemble.json/in"))

    def test_seeds_need_a_packing(self):
        with self.assertRaisesRegex(furrow.Error, "this one has none"):
            list(furrow.ensemble(FIRST, seeds=[1]))

    def test_with_nothing_to_run_it_is_an_error(self):
        for words, given in (("the list of time.step is empty", {"vary": {"time.step": []}}),
                             ("the list of time.step is empty", {"vary": {"time.end": [0.1], "time.step": ()}}),
                             ("the list of seeds is empty", {"seeds": []}),
                             ("time.step is not varied over a list: 0.1", {"vary": {"time.step": 0.1}}),
                             ("time.method is not varied over a list: 'pece'", {"vary": {"time.method": "pece"}}),
                             ("vary has no key seed", {"vary": {"seed": [1, 2]}})):
            with self.subTest(words), self.assertRaisesRegex(furrow.Error, words):
                list(furrow.ensemble(PACKED, **given))

    def test_jobs_are_a_whole_number_from_1(self):
        for jobs in (-1, 0, 1.5, "2", True):
            with self.subTest(jobs), self.assertRaisesRegex(furrow.Error, "jobs must be a whole number from 1"):
                list(furrow.ensemble(PACKED, seeds=[1], jobs=jobs))

    def test_a_key_that_is_set_twice_is_an_error_that_names_both(self):
        def given(keys):
            return {key: [1] for key in keys}

        for one, other in (("disc[0].radius", "disc[00].radius"), ("disc[0].position", "disc[0].position.x"),
                           ("disc[0].position.x", "disc[00].position"), ("output.frames", "output.frames[1]"),
                           ("time.step", "time.step.")):
            a, b = re.escape(one), re.escape(other)
            wanted = f"^({a} and {b}|{b} and {a}) set the same key"
            with self.subTest(one), self.assertRaisesRegex(furrow.Error, wanted):
                furrow.run(DISC, given((one, other)))
            with self.subTest(one, vary=True), self.assertRaisesRegex(furrow.Error, wanted):
                list(furrow.ensemble(DISC, given((one, other))))
            with self.subTest(one, both=True), self.assertRaisesRegex(furrow.Error, wanted):
                list(furrow.ensemble(DISC, given((one,)), set={other: 1}))
        with self.assertRaisesRegex(furrow.Error, "time.step is given twice"):
            list(furrow.ensemble(DISC, {"time.step": [1e-6]}, set={"time.step": 1e-6}))
        with self.assertRaisesRegex(furrow.Error, r"packing.00..seed and packing.0..seed set the same key"):
            list(furrow.ensemble(PACKED, seeds=[1], set={"packing[00].seed": 2}))
        furrow.run(DISC, {"disc[0].position.x": 0.0, "disc[0].position.y": 0.1, "disc[0].velocity": [0, -0.2]})


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

    def test_the_curve_of_a_plate_at_rest_is_drawn_over_the_time(self):
        import matplotlib
        matplotlib.use("Agg")
        moving, resting = furrow.run(FIRST, SHORT), furrow.run(FIRST, SHORT | {"plate[0].velocity": [0.0, 0.0]})
        for runs, against, label in ((resting, "displacement", "t [s], the displacement does not change"),
                                     ([moving, resting], "displacement", "t [s], in some runs the displacement does not change"),
                                     (moving, "time", "t [s]"), (moving, "t", "t [s]"), (resting, "time", "t [s]")):
            with self.subTest(against=against, label=label):
                axes = furrow.plot_force(runs, against=against)
                self.assertEqual(axes.get_xlabel(), label)
                for line in axes.lines:
                    self.assertTrue((line.get_xdata() == moving.plate_force["t"]).all())
        with self.assertRaisesRegex(KeyError, "no column 'way'; there are t .s., plate, displacement"):
            furrow.plot_force(moving, against="way")

    def test_the_curves_of_an_ensemble_are_drawn_as_they_are_and_named_by_their_parameters(self):
        import matplotlib
        matplotlib.use("Agg")
        vary = {"plate[0].lower_edge": [0.06, 0.065]}
        members = list(furrow.ensemble(FIRST, vary, set={"time.end": 0.3}))
        axes = furrow.plot_force(members)
        for line, member in zip(axes.lines, members, strict=True):
            self.assertTrue((line.get_ydata() == member.run.plate_force["F"]).all())
        self.assertEqual([line.get_label() for line in axes.lines], ["plate[0].lower_edge = 0.06", "plate[0].lower_edge = 0.065"])
        self.assertEqual(len(furrow.plot_force(members[1]).lines), 1)
        self.assertEqual(furrow.plot_force(members, labels=["a", "b"]).lines[1].get_label(), "b")
        self.assertEqual(len(furrow.plot_force(furrow.ensemble(FIRST, vary, set={"time.end": 0.3})).lines), 2)

    def test_what_has_no_curve_is_named(self):
        failed = furrow.ensemble(FIRST, {"time.step": [0.01]}, keep_failures=True)
        for given, wanted in ((failed, r"the member \{'time.step': 0.01\} has no run to draw: furrow ended with exit code 3"),
                              ([], "no run to draw"), ({1}, "the curves of a set have no order"), (["scene.toml"], "a str is no run")):
            with self.assertRaisesRegex(furrow.Error, wanted):
                furrow.plot_force(given)

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

    def test_arrays_are_lists(self):
        import numpy
        import pandas
        for values in (numpy.array([1e-6, 2e-6]), pandas.Series([1e-6, 2e-6]), pandas.Index([1e-6, 2e-6])):
            with self.subTest(type(values).__name__):
                self.assertEqual(tomllib.loads(furrow.to_toml({"a": values})), {"a": [1e-6, 2e-6]})
                self.assertEqual(furrow._values("time.step", values), [1e-6, 2e-6])
        self.assertEqual(furrow._value(numpy.array([[0, 1], [2, 3]])), "[[0, 1], [2, 3]]")
        for value in (numpy.array(1j), pandas.DataFrame({"a": [1]}), numpy.bytes_(b"ab")):
            with self.subTest(type(value).__name__), self.assertRaisesRegex(TypeError, "^k: |^k is no list"):
                furrow._value(value, "k")


if __name__ == "__main__":
    unittest.main()
