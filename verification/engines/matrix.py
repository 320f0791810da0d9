#!/usr/bin/env python3
"""Cases by engines: a table of the verdicts that furrow judge --json has left in a folder, one file an engine.

usage: matrix.py FOLDER [--keep FILE --by FURROW --since SECONDS]
  --keep FILE   also writes all verdicts to one sealed file, which `furrow report --judgements FILE` shows: with what made
                them, as the program FURROW says, which has judged. Verdicts that were left before SECONDS (since 1970) are
                not of that program, and are an error"""

import argparse
import json
import pathlib
import subprocess
import sys

SIGN = {"right": "+", "lower order": "o", "another law": "X", "failed": "!", "cannot": "."}
FIRST = ["independent", "lammps", "lammps_material_walls", "liggghts", "yade", "furrow_pece"]  # the columns that a reader looks for


def place(name):
    return (FIRST.index(name) if name in FIRST else len(FIRST), name)


def seal_of(kept):
    """64-bit FNV-1a over the compact text, as src/report/seal.h has it."""
    value = 0xCBF29CE484222325
    for byte in json.dumps(kept, ensure_ascii=False, separators=(",", ":")).encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def kind_of(name):
    return "judged_furrow" if name.startswith("furrow_") else "judged_independent" if name == "independent" else "judged_others"


def made_by(furrow, kinds):
    return [json.loads(subprocess.run([furrow, "study", "--made-by", kind], check=True, capture_output=True, text=True).stdout)
            for kind in kinds]  # fmt: skip


def inputs_of(verdicts):
    """A hash of each case; ValueError if two engines were not given the same."""
    inputs = {}
    for of_engine in verdicts.values():
        for case, j in of_engine.items():
            if inputs.setdefault(case, j["input"]) != j["input"]:
                raise ValueError(f"engines were given {case} in two forms")
    return dict(sorted(inputs.items()))


def kept(verdicts, furrow):
    kinds = sorted({kind_of(name) for name in verdicts})
    titles = {j["case"]: j["title"] for of_engine in verdicts.values() for j in of_engine.values()}
    engines = []
    for name, of_engine in verdicts.items():
        one = next((j for j in of_engine.values() if j["engine"]), {"engine": name, "method": ""})
        said = {case: [j["verdict"], "" if j["verdict"] == "right" else j["words"]] for case, j in sorted(of_engine.items())}
        engines.append({"engine": one["engine"], "method": one["method"], "command": one.get("command", ""),
                        "foreign": kind_of(name) == "judged_others", "maker": kinds.index(kind_of(name)), "verdicts": said})  # fmt: skip
    return {"makers": made_by(furrow, kinds), "cases": dict(sorted(titles.items())), "inputs": inputs_of(verdicts),
            "engines": engines}  # fmt: skip


def keep(verdicts, file, furrow):
    one = kept(verdicts, furrow)
    one["seal"] = seal_of(one)
    pathlib.Path(file).write_text(json.dumps(one, ensure_ascii=False, indent=0) + "\n")


def show(verdicts):
    cases = sorted({case for of_engine in verdicts.values() for case in of_engine})
    for k, (engine, of_engine) in enumerate(verdicts.items()):
        one = next(iter(of_engine.values()), {})
        print(f"{' ' * 34}{' ' * k}{chr(97 + k % 26)}{' ' * (len(verdicts) - k)}{engine}: {one.get('engine', '')} {one.get('method', '')}")
    print(" " * 34 + "".join(chr(97 + k % 26) for k in range(len(verdicts))))
    for case in cases:
        print(f"{case:34}" + "".join(SIGN[of_engine[case]["verdict"]] if case in of_engine else " " for of_engine in verdicts.values()))
    print("\n+ right   o of lower order   X another law   ! failed   . cannot, by its own word")


def main(folder, file, furrow, since):
    files = sorted(pathlib.Path(folder).glob("*.json"), key=lambda f: place(f.stem))
    verdicts = {found.stem: {j["case"]: j for j in json.loads(found.read_text())} for found in files}
    if not verdicts:
        return fault(f"{folder} has no verdicts")
    show(verdicts)
    partial = [f"{name} ({j['partial']})" for name, of_engine in verdicts.items() for j in list(of_engine.values())[:1] if "partial" in j]
    if partial:
        return fault(f"interrupted: {', '.join(partial)}; nothing is kept of it")
    if not file:
        return 0
    earlier = [found.stem for found in files if found.stat().st_mtime < since]
    if earlier:
        return fault(f"left by an earlier judge: {', '.join(earlier)}; judge again, or remove them; nothing is kept")
    try:
        keep(verdicts, file, furrow)
    except (KeyError, ValueError) as error:
        return fault(f"{error}; judge again; nothing is kept")
    return 0


def fault(words):
    print(f"matrix.py: {words}", file=sys.stderr)
    return 4


if __name__ == "__main__":
    parser = argparse.ArgumentParser(usage=__doc__.partition("usage: ")[2], add_help=False)
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--keep")
    parser.add_argument("--by")
    parser.add_argument("--since", type=float)
    parser.add_argument("-h", "--help", action="store_true")
    asked = parser.parse_args()
    if asked.help or not asked.folder or (asked.keep and (not asked.by or asked.since is None)):
        print(__doc__)
        sys.exit(0 if asked.help else 2)
    sys.exit(main(asked.folder, asked.keep, asked.by, asked.since))
