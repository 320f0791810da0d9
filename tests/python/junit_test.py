"""scripts/junit: what ctest and the verification checks say, in one file that any CI reads."""

import json
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

source = pathlib.Path(__file__).resolve().parents[2]

CTEST = """<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="(empty)" tests="2" failures="1">
  <testcase name="Disc.Falls" classname="Disc.Falls" time="0.1" status="run"/>
  <testcase name="Disc.Flies" classname="Disc.Flies" time="0.1" status="fail"><failure message="Failed"/></testcase>
</testsuite>"""
CHECK = {"name": "speed <v> & \"spin\" [m/s]", "want": 1.0, "got": 1.5, "error": 0.5, "kind": "absolute", "tolerance": 0.1,
         "of_limit": 5.0, "reason": "round-off", "file": "page.cpp", "line": 7, "good": False, "test": "Disc.Falls",
         "requirement": "disc.falls", "sentence": "It falls."}


class Junit(unittest.TestCase):

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.build = pathlib.Path(kept.name)
        (self.build / "records").mkdir()

    def made(self, missing=()):
        (self.build / "junit.xml").write_text(CTEST)
        checks = [CHECK, CHECK | {"name": "time [s]", "good": True}]
        (self.build / "records/checks.json").write_text(json.dumps({"tests": 2, "missing": list(missing), "checks": checks}))
        subprocess.run([source / "scripts/junit", self.build, self.build / "all.xml"], check=True)
        return xml.parse(self.build / "all.xml").getroot()

    def test_it_holds_the_tests_as_ctest_has_them(self):
        suite = self.made().findall("testsuite")[0]
        self.assertEqual([case.get("name") for case in suite], ["Disc.Falls", "Disc.Flies"])
        self.assertEqual(len(suite.findall("testcase/failure")), 1)

    def test_each_check_is_a_case_with_its_numbers(self):
        suite = self.made().findall("testsuite")[1]
        bad, good = suite
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("2", "1"))
        self.assertEqual((bad.get("classname"), bad.get("name"), bad.get("file")), ("Disc.Falls", CHECK["name"], "verification/page.cpp"))
        said = {p.get("name"): p.get("value") for p in bad.find("properties")}
        self.assertEqual({name: said[name] for name in ("want", "got", "tolerance", "requirement", "reason")},
                         {"want": "1.0", "got": "1.5", "tolerance": "0.1", "requirement": "disc.falls", "reason": "round-off"})
        self.assertEqual(bad.find("failure").get("message"), "got 1.5, expected 1.0")
        self.assertIsNone(good.find("failure"))

    def test_what_is_missing_is_a_failure(self):
        suite = self.made(["Disc.Rolls left no record"]).findall("testsuite")[1]
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("3", "2"))
        self.assertEqual(suite[2].find("failure").get("message"), "Disc.Rolls left no record")

    def test_tests_that_did_not_run_are_no_result(self):
        done = subprocess.run([source / "scripts/junit", self.build, self.build / "all.xml"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 4)
        self.assertIn("run the tests first", done.stderr)
        self.assertFalse((self.build / "all.xml").exists())


if __name__ == "__main__":
    unittest.main()
