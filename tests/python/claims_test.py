"""What the pages claim, held against what it comes from: numbers against the kept studies, labels against ctest, versions, drawings."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from pages import blocks_of, source, text_of

sys.path.insert(0, str(source / "src/python"))
import furrow

program = pathlib.Path(os.environ["FURROW"])


def one_line(text):
    return " ".join(text.split())


def section_of(page, heading):
    return re.search(rf"^## {re.escape(heading)}\n\n((?:(?!## ).*\n)*)", text_of(page), re.MULTILINE)[1]


def words_of(study):
    return subprocess.run([program, "study", study, "--words", "--out", source / "reference_data/studies"],
                          capture_output=True, text=True, check=True).stdout


class Readme(unittest.TestCase):

    def setUp(self):
        self.page = one_line(text_of("README.md"))

    def test_its_size_is_that_of_a_page(self):
        self.assertLessEqual(text_of("README.md").count("\n"), 130)
        lines = {what: text.count("\n") for what, text in blocks_of("README.md")}
        self.assertLessEqual(lines["toml src/python/stem.toml"], 15)
        self.assertLessEqual(lines["python"], 6)
        self.assertEqual(text_of("README.md").count("\n### "), 7, "readers")
        for section in section_of("README.md", "For you").split("### ")[1:]:
            self.assertIn("](", section)
            self.assertEqual(len(section.split("\n\n")[0].strip().splitlines()), 4, f"a heading and three lines: {section}")

    def test_the_finding_is_three_sentences_and_a_figure(self):
        words, figure, *more = section_of("README.md", "The finding").strip().split("\n\n")
        self.assertEqual((len(re.findall(r"\.(?=\s|$)", words)), more), (3, []))
        self.assertRegex(figure, r"^!\[.*\]\(validation/figures/readme_finding\.svg\)$")

    def test_the_finding_is_what_the_study_says(self):
        said = re.findall(r"^Scene ([23]), (discs|spheres): the largest force is ([\d.]+) N at the paper's step and ([\d.]+) N at 0.002 ms\.",
                          words_of("convergence"), re.MULTILINE)
        at = {(scene, what): (papers, finest) for scene, what, papers, finest in said}
        self.assertEqual(len(at), 4)
        (d2, f2), (d3, f3) = at["2", "discs"], at["3", "discs"]
        off = max(abs(float(d2) / float(f2) - 1), abs(float(d3) / float(f3) - 1))
        made = dict(re.findall(r"^Scene ([23]), discs: .* The method makes ([\d.]+) % of all the energy that the scene was given at the paper's step",
                               words_of("convergence"), re.MULTILINE))
        self.assertIn(f"are {d2} N and {d3} N at the paper's time step of 0.1 ms, within {100 * off:.0f} % of those at 0.002 ms, though the method "
                      f"then makes {float(made['2']):.0f} % and {float(made['3']):.0f} % of all the energy there.", self.page)
        (s2, f2), (s3, f3) = at["2", "spheres"], at["3", "spheres"]
        self.assertIn(f"it is {s2} N and {s3} N at the paper's step, {f2} N and {f3} N at 0.002 ms.", self.page)

    def test_its_figure_is_drawn_from_the_kept_numbers(self):
        """scripts/readme keeps in the figure the hash of the numbers that it shows."""
        numbers = subprocess.run([source / "scripts/readme", "--numbers"], capture_output=True, text=True, check=True).stdout.strip()
        self.assertRegex(numbers, "^[0-9a-f]{8}$")
        self.assertIn(f"<!-- convergence.json {numbers} -->", text_of("validation/figures/readme_finding.svg"),
                      "the figure is not of these numbers: scripts/readme makes it again")

    def test_what_was_found_is_what_the_studies_say(self):
        for study, words in (("statements", r"Of \d+ statements, judged [^.]*\."), ("geometry", r"No setting tried .*")):
            said = re.findall(rf"^(?:- )?(?:.*?: )?({words})(?: .*)?$", words_of(study), re.MULTILINE)
            self.assertEqual(len(said), 1, said)
            self.assertIn(said[0], self.page)
        count = re.search(r"Of (\d+) statements", self.page)[1]
        self.assertIn(f"is kept as {count} statements", self.page)

    def test_the_best_reading_is_that_of_the_search(self):
        told = words_of("readings")
        best, literal = re.search(r"^- (\d+ of \d+) \(aim: more than the literal one\): .*; the literal one (\d+)\.$", told, re.MULTILINE).groups()
        tried = re.search(r"^(\d+ readings) were run", told, re.MULTILINE)[1]
        held_out = re.search(r"on the third for (\d of \d) scenes", told)[1]
        self.assertIn(f"{tried} were tried. The best that `furrow run` brings to its end reproduces {best} sentences of the paper, the literal "
                      f"one, which the scene files have, {literal}. Of the best readings of two scenes each, {held_out} is better on the third.", self.page)


class Decisions(unittest.TestCase):

    def test_what_the_papers_step_does_is_what_a_run_says(self):
        """Of the two rows of the table the one that takes seconds; the other has a fifth of the step."""
        command, *said = re.search(r"^\| `(--dt 1e-4)`, the paper's \| (\S+) \| (\S+) \| (\S+) \| (\S+) \|$",
                                   text_of("validation/decisions.md"), re.MULTILINE).groups()
        with tempfile.TemporaryDirectory() as place:
            subprocess.run([program, "run", source / "validation/scenes/scenario_2.toml", *command.split(), "--out", place],
                           check=True, capture_output=True)
            run = furrow.read(place)
            last = [run.energy[name][-1] for name in ("rolling", "residual", "plate work")]
            self.assertEqual([f"{number:.3g}" for number in [*last, run.json["largest_force"][0]["F"]]], said)


class Tree(unittest.TestCase):

    def test_one_version_stands_everywhere(self):
        """That of the last release. What comes next has its number in CHANGELOG.md, and nowhere else before it is released."""
        version = re.search(r"project\(furrow VERSION (\S+)", text_of("CMakeLists.txt"))[1]
        headings = re.findall(r"^## (\d\S*?)(, not released yet)?$", text_of("CHANGELOG.md"), re.MULTILINE)
        self.assertEqual([number for number, coming in headings if not coming][0], version)
        for number, coming in headings:
            if coming:
                self.assertGreater(tuple(map(int, number.split("."))), tuple(map(int, version.split("."))))
        self.assertNotIn("## Unreleased", text_of("CHANGELOG.md"), "give it the number that the policy asks for")
        self.assertIn(f"\nversion: {version}\n", text_of("CITATION.cff"))
        said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertTrue(said.startswith(f"furrow {version} ("), said)

    def test_nobody_is_invented_in_the_citation(self):
        self.assertNotIn("anonymous", text_of("CITATION.cff"))
        title = re.search(r'^    title: "(.*)"$', text_of("CITATION.cff"), re.MULTILINE)[1]
        self.assertIn(f"*{title}*", one_line(text_of("README.md")))

    def test_the_drawing_is_that_of_the_includes(self):
        drawn = subprocess.run([source / "scripts/arrows", "--drawing"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(drawn, text_of("src/architecture.svg"), "make it again: scripts/arrows --drawing >src/architecture.svg")

    def test_the_labels_are_those_of_ctest(self):
        rows = re.findall(r"^\| `(\w+)` \| .* \| ([\w, ]+) \|$", text_of("tests/README.md"), re.MULTILINE)
        presets = {label: said.split(", ") for label, said in rows}
        self.assertGreater(len(presets), 20)
        for preset in json.loads(text_of("CMakePresets.json"))["testPresets"]:
            chosen = preset.get("filter", {}).get("include", {}).get("label")
            if chosen:
                said = {label for label, names in presets.items() if preset["name"] in names}
                self.assertEqual(said, {label for label in presets if re.search(chosen, label)}, preset["name"])
        build = program.parent
        if not (build / "CTestTestfile.cmake").exists() or "CMAKE_BUILD_TYPE:STRING=Release" not in (build / "CMakeCache.txt").read_text():
            self.skipTest("the program is not in a build directory of the preset release")
        listed = subprocess.run(["ctest", "--test-dir", build, "--print-labels"], capture_output=True, text=True, check=True).stdout
        labels = set(re.findall(r"^  (\w+)$", listed, re.MULTILINE))
        self.assertEqual({label for label, names in presets.items() if "release" in names}, labels)

    def test_the_workflow_for_others_runs_what_there_is(self):
        said = text_of("tests/ci/github_workflow.yml")
        runs = re.findall(r"run: (scripts/\w+) (--\w+)", said)
        self.assertEqual(len(runs), 1)
        for script, option in runs:
            self.assertIn(option, text_of(script))
        shown = [text.strip() for what, text in blocks_of("tests/README.md") if "--junit" in text]
        self.assertIn(f"run: {shown[0]}\n", said)


if __name__ == "__main__":
    unittest.main()
