#!/usr/bin/env python3
"""Cases by engines: a table of the verdicts that furrow judge --json has left in a folder.

usage: matrix.py FOLDER"""

import json
import pathlib
import sys

SIGN = {"right": "+", "lower order": "o", "another law": "X", "failed": "!", "cannot": "."}


def main(folder):
    files = sorted(pathlib.Path(folder).glob("*.json"))
    verdicts = {file.stem: {j["case"]: j for j in json.loads(file.read_text())} for file in files}
    if not verdicts:
        print(f"matrix.py: {folder} has no verdicts", file=sys.stderr)
        return 4
    cases = sorted({case for of_engine in verdicts.values() for case in of_engine})
    for k, (engine, of_engine) in enumerate(verdicts.items()):
        one = next(iter(of_engine.values()), {})
        print(f"{' ' * 34}{' ' * k}{chr(97 + k % 26)}{' ' * (len(verdicts) - k)}{engine}: {one.get('engine', '')} {one.get('method', '')}")
    print(" " * 34 + "".join(chr(97 + k % 26) for k in range(len(verdicts))))
    for case in cases:
        print(f"{case:34}" + "".join(SIGN[of_engine[case]["verdict"]] if case in of_engine else " " for of_engine in verdicts.values()))
    print("\n+ right   o of lower order   X another law   ! failed   . cannot, by its own word")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print(__doc__)
        sys.exit(0 if sys.argv[1:] in (["-h"], ["--help"]) else 2)
    sys.exit(main(sys.argv[1]))
