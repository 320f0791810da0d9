"""The JSON Schemas of reference_data/schemas: every scene of the repository and every real output passes, and each of them
with one field missing, unknown or of another type fails. Needs python3-jsonschema.

Variables: FURROW, VERIFICATION_TESTS and GATHER are the programs that make the outputs.
"""

import copy
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import jsonschema

import tree

source = tree.source
sys.path.insert(0, str(source / "src/python"))
import furrow

# TOML that is no scene, and why. Every other file is one.
NO_SCENE = {
    "tests/bad_input/": "wrong on purpose",
    "tests/bad_requirements/": "requirements, wrong on purpose",
    "tests/fuzz/corpus/all_wrong.toml": "wrong on purpose",
    "tests/mutants/equivalent.toml": "mutants",
    "validation/calibration/example/bent_stem.toml": "targets of a calibration",
    "validation/readings.toml": "readings of the paper",
    "validation/sentences.toml": "sentences of the paper",
    "validation/statements.toml": "statements of the paper",
    "verification/cases/": "cases for engines, which have keys of their own",
    "verification/faults.toml": "faults",
    "verification/published/": "numbers of others, with their cases",
    "verification/requirements/": "requirements",
}
TOML = tree.files(".toml")
SCENES = [source / name for name in TOML if not name.startswith(tuple(NO_SCENE))]
FIRST = source / "validation/scenes/scenario_1.toml"


def validator(name):
    schema = json.loads((source / f"reference_data/schemas/{name}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def places(value, path=()):
    """The path of the value and of all that is in it."""
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from places(inner, (*path, key))


def at(value, path):
    for key in path:
        value = value[key]
    return value


def with_changed(value, path, change):
    changed = copy.deepcopy(value)
    change(at(changed, path[:-1]), path[-1])
    return changed


class Schemas(unittest.TestCase):

    def passes(self, schema, value, what):
        faults = [f"{'.'.join(map(str, e.absolute_path))}: {e.message}" for e in schema.iter_errors(value)]
        self.assertEqual(faults, [], what)

    def fails_where_it_is_wrong(self, schema, value, may_be_missing=lambda path: False):
        """Every field of the value in turn: of another type, beside an unknown one, missing."""

        def make_strange(holder, key):
            holder[key] = {"strange": []}

        def delete(holder, key):
            del holder[key]

        for path in places(value):
            if isinstance(at(value, path), dict):
                changed = copy.deepcopy(value)
                at(changed, path)["unknown_field"] = 1
                self.assertFalse(schema.is_valid(changed), f"an unknown field in {path}")
            if path:
                self.assertFalse(schema.is_valid(with_changed(value, path, make_strange)), f"another type of {path}")
            if path and isinstance(path[-1], str) and not may_be_missing(path):
                self.assertFalse(schema.is_valid(with_changed(value, path, delete)), f"without {path}")


class OfScenes(Schemas):

    def setUp(self):
        self.schema = validator("scene")

    def test_every_scene_of_the_repository_passes(self):
        self.assertGreaterEqual(len(SCENES), 21, "scenes that were found")
        for file in SCENES:
            self.passes(self.schema, furrow.load(file), file)

    def test_the_scenes_are_what_the_reader_accepts(self):
        said = subprocess.run([furrow.program(), "check", *TOML], cwd=source, capture_output=True, text=True).stderr
        refused = set(re.findall(r"^(\S+?\.toml)(?::\d+)*: error:", said, re.MULTILINE))
        self.assertEqual(sorted(map(str, SCENES)), [str(source / name) for name in TOML if name not in refused])
        for what in NO_SCENE:
            self.assertTrue(any(name.startswith(what) for name in TOML), f"{what} is excluded, but is not there")

    def test_every_scene_with_a_wrong_or_unknown_key_fails(self):
        required = {key["key"] for key in furrow.keys() if key["required"]}
        for file in SCENES:
            name = lambda path: ".".join(key for key in path if isinstance(key, str))
            self.fails_where_it_is_wrong(self.schema, furrow.load(file), lambda path: name(path) not in required)

    def test_what_no_reader_accepts_fails(self):
        for name in ("missing_key", "misspelt_key", "out_of_range", "table_or_list", "unknown_word", "wrong_type"):
            scene = furrow.load(source / f"tests/bad_input/{name}.toml")
            self.assertFalse(self.schema.is_valid(scene), name)

    def test_a_number_passes_where_the_reader_accepts_it(self):
        """Each number of each scene becomes others; the reader's word is what check says of ranges and types. Whole ones stay
        integers where one stood: to JSON Schema 1.0 is one, to the reader it is not. The paper's scenes once, not in each of
        their readings, which have the same keys."""
        tried = []
        for file in SCENES:
            if file.parent.name in ("literal", "best_reading"):
                continue
            scene = furrow.load(file)
            for path in places(scene):
                kind = type(at(scene, path))
                if kind in (int, float):
                    tried += [with_changed(scene, path, lambda holder, key: holder.__setitem__(key, number))
                              for number in (kind(-1), kind(0), 0.5, kind(1), kind(3e9))]
        with tempfile.TemporaryDirectory() as place:
            for k, scene in enumerate(tried):
                (pathlib.Path(place) / f"{k}.toml").write_text(furrow.to_toml(scene))
            names = [f"{k}.toml" for k in range(len(tried))]
            said = subprocess.run([furrow.program(), "check", *names], cwd=place, capture_output=True, text=True).stderr
        out_of_range = re.compile(r": (-?[0-9.e+]+ is outside \S+ <|must be an integer)")
        refused = {int(line.split(".toml")[0]) for line in said.splitlines() if out_of_range.search(line)}
        self.assertGreater(len(tried), 500)
        self.assertGreater(len(refused), 50)
        for k, scene in enumerate(tried):
            self.assertEqual(self.schema.is_valid(scene), k not in refused, f"{said.splitlines()[:3]} {furrow.to_toml(scene)}")


class OfRuns(Schemas):

    def setUp(self):
        self.schema = validator("run")

    def outputs(self):
        """Runs that end in every way."""
        yield furrow.run(FIRST).json
        yield furrow.run(FIRST, {"time.end": 0.1, "time.locate": "all", "output.energy": False}).json
        yield furrow.run(source / "tests/property/scenes/packing.toml").json
        yield furrow.run(source / "tests/property/scenes/lattice_hit.toml", {"time.method": "odeint_dopri5"}).json
        for changes in ({"time.step": 0.01}, {"time.step": 0.5, "time.end": 1.0, "output.frames": []}):
            yield self.failed(FIRST, changes)
        yield self.failed(source / "tests/property/scenes/packing.toml", {"settle.step": 0.05})
        yield self.interrupted()

    def failed(self, scene, changes):
        with tempfile.TemporaryDirectory() as place:
            with self.assertRaises(furrow.RunFailed):
                furrow.run(scene, changes, out=place)
            return furrow.read(place).json

    def interrupted(self):
        with tempfile.TemporaryDirectory() as place:
            command = [furrow.program(), "run", str(source / "validation/scenes/scenario_2.toml"), "--out", place]
            with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as running:
                while not (pathlib.Path(place) / "scene.toml").exists() and running.poll() is None:
                    time.sleep(0.01)
                running.send_signal(signal.SIGINT)
                self.assertEqual(running.wait(), 130)
            return furrow.read(place).json

    def test_every_output_passes_and_none_with_a_wrong_field_does(self):
        endings = set()
        for run in self.outputs():
            endings.add((run["ended"], "steps" in run))
            self.passes(self.schema, run, run["title"])
            self.fails_where_it_is_wrong(self.schema, run, lambda path: path == ("events",) or path[:1] == ("files",) and len(path) > 1)
        self.assertGreaterEqual({ended for ended, _ in endings}, {"finished", "invalid", "diverged", "interrupted"})
        self.assertIn(False, {began for _, began in endings}, "one that ended while its scene settled")


class OfChecks(Schemas):

    def test_gathered_checks_pass_and_none_with_a_wrong_field_do(self):
        tests, gather = os.environ["VERIFICATION_TESTS"], os.environ["GATHER"]
        with tempfile.TemporaryDirectory() as place:
            environment = os.environ | {"FURROW_RECORDS_IN": place}
            subprocess.run([tests, "--gtest_filter=SlideToRoll.*"], env=environment, check=True, capture_output=True)
            listed = subprocess.run([tests, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
            (pathlib.Path(place) / "tests.txt").write_text(listed)
            gathered = subprocess.run([gather, place, source / "verification/requirements", f"{place}/tests.txt"],
                                      capture_output=True)
            self.assertEqual(gathered.returncode, 1, "most tests did not run, and it says so")
            checks = json.loads((pathlib.Path(place) / "checks.json").read_text())
        self.assertGreater(len(checks["checks"]), 0)
        self.assertGreater(len(checks["missing"]), 0)
        schema = validator("checks")
        self.passes(schema, checks, "checks.json")
        checks["missing"] = checks["missing"][:1]
        sources = checks["made_by"]["sources"]
        self.assertGreater(len(sources), 100)
        checks["made_by"]["sources"] = dict(list(sources.items())[:1])
        self.fails_where_it_is_wrong(schema, checks, lambda path: "sources" in path[:-1])  # which files there are is not asked


class OfStudies(Schemas):

    STUDIES = sorted((source / "reference_data/studies").glob("*.json"))

    def setUp(self):
        self.schema = validator("study")

    def kept(self):
        for file in self.STUDIES:
            yield file.name, json.loads(file.read_text())

    def test_all_kept_numbers_pass(self):
        seen = set()
        for name, study in self.kept():
            self.passes(self.schema, study, name)
            self.assertEqual(f"{study['study']}.json", name)
            for result in study["results"]:
                seen |= {key for key in result if key in ("timed", "maker", "input", "names")}
                own = list(result["value"]) if isinstance(result["value"], dict) else []
                seen |= {"failed"} & {*own, *self.names_of(study, result)}
        self.assertEqual(seen, {"timed", "maker", "input", "names", "failed"}, "what the kept numbers show of the schema")

    def names_of(self, study, result):
        return study["names"][result["names"]] if "names" in result else []

    def test_each_result_names_a_maker_and_names_that_are_there_and_no_other_result(self):
        for name, study in self.kept():
            keys = [result["key"] for result in study["results"]]
            self.assertEqual(len(set(keys)), len(keys), name)
            for result in study["results"]:
                self.assertLess(result.get("maker", 0), len(study["makers"]), f"{name}: {result['key']}")
                if "names" in result:
                    self.assertEqual(len(result["value"]), len(self.names_of(study, result)), f"{name}: {result['key']}")

    def test_what_no_study_writes_fails(self):
        sources = {"src/run/run.cpp": "0123abcd"}
        maker = {"commit": "63b8b18", "when": "2026-01-31T12:00:00Z", "compiler": "GNU 12.2.0", "flags": "-O3", "machine": "AMD EPYC",
                 "load": 0.5, "sources": sources}
        results = [{"key": "a", "input": "0123456789abcdef", "timed": True, "cpu": 0.1, "maker": 1, "value": [1.5], "names": 0},
                   {"key": "b", "cpu": 0.1, "value": {"failed": "diverged"}}]
        study = {"study": "s", "form": "full", "schema": 2, "makers": [maker, maker], "names": [["x"]], "results": results, "seal": "0123456789abcdef"}
        self.passes(self.schema, study, "a sound one")
        first, second = ("results", 0), ("results", 1)
        for *path, value in ((*first, "value", 1.5), (*first, "cpu", -1), (*first, "cpu", "0.1"), (*first, "timed", False), (*first, "maker", 0.5),
                             (*first, "maker", -1), (*first, "input", "xyz"), (*first, "names", -1), (*first, "key", ""), (*first, "words", "x"),
                             (*second, "value", "failed", ""), (*second, "value", "failed", 1), ("makers", []), ("makers", 0, "load", -1),
                             ("makers", 0, "when", "today"), ("makers", 0, "commit", ""), ("makers", 0, "sources", {"a.txt": "0123abcd"}),
                             ("makers", 0, "sources", {"src/run/run.cpp": "0123"}), ("form", "short"), ("schema", 3), ("seal", "x"),
                             ("names", [[]]), ("results", []), ("study", "S"), ("words", "x")):
            changed = with_changed(study, path, lambda holder, key, value=value: holder.__setitem__(key, value))
            self.assertFalse(self.schema.is_valid(changed), f"{path} = {value}")
        may_be_missing = {"names", "input", "timed", "maker", "failed"}
        for path in places(study):
            if path and isinstance(path[-1], str) and path[-1] not in may_be_missing | set(sources):
                self.assertFalse(self.schema.is_valid(with_changed(study, path, lambda holder, key: holder.__delitem__(key))), f"without {path}")


if __name__ == "__main__":
    unittest.main()
