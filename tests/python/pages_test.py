"""The markdown pages of the tree, all that are found: what they show runs, what they quote stands in the files, what they name exists.

Blocks of a page run in its order, in a copy of the sources: ```sh line by line, but for pages.TOO_LONG; ```python as one program a page;
```toml NAME becomes that file, and ```toml alone is a part of a scene; ```json is the answer of an engine to the case hertz_wall.
```cpp FILE and ```python FILE must be a piece of that file, which tests of its own run. ```text is formulas and holds no command. There is
no other kind, and no block without its marks.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

import jsonschema

from pages import PAGES, TOO_LONG, blocks_of, commands_of, prose_of, sections_of, source, spans_of, text_of

program = pathlib.Path(os.environ["FURROW"])
ROOMS = ["src", "src/scene", "src/output", "src/export", "src/python", "verification", "verification/engines",
         "validation", "benchmarks", "tests"]
TOP = [entry.name for entry in source.iterdir() if entry.is_dir() and not entry.name.startswith(".")]


def schema_of_parts():
    """The schema of scenes, with nothing required: of a part of one."""
    def optional(schema):
        if isinstance(schema, list):
            return [optional(each) for each in schema]
        if not isinstance(schema, dict):
            return schema
        return {key: value if key == "if" else optional(value) for key, value in schema.items()
                if not (key == "required" and isinstance(value, list))}
    return jsonschema.Draft202012Validator(
        optional(json.loads((source / "reference_data/schemas/scene.schema.json").read_text())))


def part_of_scene(text):
    """[lattice.stem] stands on its own on a page: in a scene it is of the last [[lattice]]."""
    part = tomllib.loads(text)
    return {key: [value] if key in ("lattice", "plate", "disc") and isinstance(value, dict) else value for key, value in part.items()}


class Pages(unittest.TestCase):

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.copy = pathlib.Path(place.name) / "furrow"
        shutil.copytree(source, self.copy, ignore=self.ignored)
        (self.copy / "build").mkdir()
        (self.copy / "build/release").symlink_to(program.parent)
        shutil.copy(source / "verification/engines/example.py", self.copy / "my_engine")  # that of a reader
        path = f"{program.parent}:{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
        self.environment = os.environ | {"PATH": path, "PYTHONPATH": str(self.copy / "src/python"), "MPLBACKEND": "Agg",
                                         "FURROW_RECORDS_IN": str(self.copy / "records")}

    @staticmethod
    def ignored(directory, names):
        top = {".git", "build", "report", "runs"} if pathlib.Path(directory) == source else set()
        return top | {"__pycache__"}

    def runs(self, page, command):
        done = subprocess.run(command, cwd=self.copy, env=self.environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{page}: {command[-1]}\n{done.stdout[-500:]}\n{done.stderr}")
        return done.stdout

    def explains_itself(self, page, command):
        """In place of a command that takes too long: it can be started, and its help names its options."""
        words = command.split()
        start = words[:2] if words[0] == "furrow" else words[:1]
        said = self.runs(page, ["bash", "-euc", " ".join([*start, "-h"])])
        for option in [word for word in words if word.startswith("--")]:
            self.assertIn(option, said, f"{page}: {command}")

    def judges_as_an_answer(self, page):
        """An engine that gives answer.json whatever it is asked: the answer is understood."""
        engine = self.copy / "toy"
        engine.write_text("#!/bin/sh\ncat >/dev/null\ncat answer.json\n")
        engine.chmod(0o755)
        judged = subprocess.run([program, "judge", "--engine", "./toy", "--cases", "hertz_wall"], cwd=self.copy, capture_output=True, text=True)
        self.assertIn(" 0 failed", judged.stdout, f"{page}: {judged.stdout}{judged.stderr}")

    def runs_block(self, page, kind, name, text, written):
        if kind == "sh":
            for command in commands_of(text):
                if command in TOO_LONG:
                    self.explains_itself(page, command)
                else:
                    self.runs(page, ["bash", "-euc", command])
        elif kind in ("cpp", "python") and name:
            self.assertIn(text, (source / name).read_text(), f"{page} shows what is not in {name}")
        elif kind == "python":
            written.append(text)
            self.runs(page, [sys.executable, "-c", "".join(written)])
        elif kind == "toml" and name:
            if (source / name).exists():
                self.assertEqual(text, (source / name).read_text(), f"{page} shows another {name}")
            (self.copy / name).write_text(text)
        elif kind == "toml":
            faults = [fault.message for fault in schema_of_parts().iter_errors(part_of_scene(text))]
            self.assertEqual(faults, [], f"{page}: {text}")
        elif kind == "json":
            (self.copy / "answer.json").write_text(text)
            self.judges_as_an_answer(page)
        elif kind == "text":
            self.assertNotRegex(text, r"(?m)^\s*(?:furrow|ctest|cmake|cpack|python3|scripts/|tests/|build/)", f"{page}: a command as text")
        else:
            self.fail(f"{page}: a block of kind {kind!r} is tested by nothing")

    def test_every_room_has_one_and_every_page_a_title(self):
        self.assertGreaterEqual(set(PAGES), {"README.md", "CHANGELOG.md", *(f"{room}/README.md" for room in ROOMS)})
        self.assertGreaterEqual(len(PAGES), 16, "pages that were found")
        for page in PAGES:
            self.assertTrue(text_of(page).startswith("# "), page)

    def test_every_block_runs_or_stands_in_its_file(self):
        kinds, seen = set(), set()
        for page in PAGES:
            written = []
            for what, text in blocks_of(page):
                kind, _, name = what.partition(" ")
                kinds.add(kind)
                seen.update(commands_of(text) if kind == "sh" else ())
                self.runs_block(page, kind, name, text, written)
        self.assertEqual(kinds, {"sh", "python", "toml", "cpp", "json", "text"})
        self.assertGreaterEqual(seen, set(TOO_LONG), "what is too long to be run and stands on no page")

    def test_no_block_is_without_its_marks(self):
        for page in PAGES:
            self.assertNotRegex(prose_of(page), r"\n\n(?: {4}|\t)\S", f"{page}: an indented block runs nowhere")

    def test_what_the_blocks_make_again_is_what_is_in_the_repository(self):
        for line in [line for what, text in blocks_of("src/scene/README.md") for line in text.splitlines() if ">" in line]:
            self.runs("src/scene/README.md", ["bash", "-euc", line])
            made = line.partition(">")[2]
            self.assertEqual((self.copy / made).read_text(), (source / made).read_text(), f"make it again: {line}")

    def test_links_and_paths_lead_somewhere(self):
        checked = 0
        for page in PAGES:
            for link in re.findall(r"\]\(([^):]+)\)", text_of(page)):
                target, _, section = link.partition("#")
                file = (source / page).parent.joinpath(target) if target else source / page
                self.assertTrue(file.exists(), f"{page}: {link}")
                if section:
                    self.assertIn(section, sections_of(file.resolve().relative_to(source)), f"{page}: {link}")
                checked += 1
            for span in spans_of(page):
                if re.fullmatch(rf"(?:{'|'.join(TOP)})/[\w./*-]*", span) and not span.startswith(("build", "runs", "report/")):
                    self.assertTrue(list(source.glob(span.rstrip("/"))), f"{page}: {span}")
                    checked += 1
        self.assertGreater(checked, 60)

    def test_commands_in_sentences_have_the_options_that_are_named(self):
        checked = 0
        for page in PAGES:
            for span in spans_of(page):
                words = span.replace("[", " ").replace("]", " ").split() or [""]
                if words[0] == "furrow" and len(words) > 1 and re.fullmatch("[a-z]+", words[1]):
                    helped = subprocess.run([program, words[1], "--help"], capture_output=True, text=True)
                    self.assertEqual(helped.returncode, 0, f"{page}: {span}")
                    known = helped.stdout
                elif words[0].startswith("scripts/"):
                    self.assertTrue(os.access(source / words[0], os.X_OK), f"{page}: {span}")
                    known = (source / words[0]).read_text()
                else:
                    continue
                checked += 1
                for option in [word for word in words if word.startswith("--")]:
                    self.assertIn(option, known, f"{page}: {span}")
        self.assertGreater(checked, 40)


if __name__ == "__main__":
    unittest.main()
