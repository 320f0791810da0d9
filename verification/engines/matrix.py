#!/usr/bin/env python3
"""Cases by engines: a table of the verdicts that furrow judge --json has left in a folder, one file an engine.

usage: matrix.py FOLDER [--keep FILE]
  --keep FILE   also writes all verdicts to one sealed file, which `furrow report --judgements FILE` shows"""

import datetime
import json
import pathlib
import platform
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


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.machine()


def kept(verdicts):
    titles = {j["case"]: j["title"] for of_engine in verdicts.values() for j in of_engine.values()}
    engines = []
    for name, of_engine in verdicts.items():
        one = next((j for j in of_engine.values() if j["engine"]), {"engine": name, "method": ""})
        said = {case: [j["verdict"], "" if j["verdict"] == "right" else j["words"]] for case, j in sorted(of_engine.items())}
        engines.append({"engine": one["engine"], "method": one["method"], "command": one.get("command", ""),
                        "foreign": not name.startswith("furrow_") and name != "independent", "verdicts": said})  # fmt: skip
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    now = datetime.datetime.now(datetime.timezone.utc)
    return {"commit": commit, "when": now.strftime("%Y-%m-%dT%H:%M:%SZ"), "machine": machine(),
            "cases": dict(sorted(titles.items())), "engines": engines}  # fmt: skip


def keep(verdicts, file):
    one = kept(verdicts)
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


def main(folder, file=None):
    files = sorted(pathlib.Path(folder).glob("*.json"), key=lambda f: place(f.stem))
    verdicts = {found.stem: {j["case"]: j for j in json.loads(found.read_text())} for found in files}
    if not verdicts:
        print(f"matrix.py: {folder} has no verdicts", file=sys.stderr)
        return 4
    show(verdicts)
    partial = [f"{name} ({j['partial']})" for name, of_engine in verdicts.items() for j in list(of_engine.values())[:1] if "partial" in j]
    if partial:
        print(f"matrix.py: interrupted: {', '.join(partial)}; nothing is kept of it", file=sys.stderr)
        return 4
    if file:
        keep(verdicts, file)
    return 0


if __name__ == "__main__":
    asked = sys.argv[1:]
    if len(asked) not in (1, 3) or asked[0] in ("-h", "--help") or (len(asked) == 3 and asked[1] != "--keep"):
        print(__doc__)
        sys.exit(0 if asked in (["-h"], ["--help"]) else 2)
    sys.exit(main(asked[0], asked[2] if len(asked) == 3 else None))
