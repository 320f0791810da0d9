#!/usr/bin/env python3
"""The paper's first scene on LAMMPS's bonds: whether it is the same, then how fast, in turn with furrow.

usage: bonds.py FURROW DIRECTORY RESULT [ROUNDS]

Exported is exactly what can be had: LAMMPS's bonds have no dampers, and its rule after a slip is another; the corners of its plate are
round, so there is no verdict. Run by lmp at the scene's step and at a tenth of it and compared by furrow export --compare. Timed is then
the scene's step, rows of output left out on both sides: furrow by the paper's method and with one evaluation a step, LAMMPS with
fix bond/break and without it, so that nothing tears. CPU time, of LAMMPS that of its loop, of furrow that of the whole run, which also
writes its end: some tenth of a microsecond a step more. Exit code 77 without lmp."""

import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

EARLY = 0.1  # s: up to there no link has torn
LINKS = ("structural", "shear", "bending")
OUTPUT = r"fix (forces|torn) |compute links |dump|variable torn |write_dump |thermo "


def call(words, folder="."):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          env=os.environ | {"OMP_NUM_THREADS": "1"}, check=False)
    if done.returncode != 0:
        sys.exit(f"bonds.py: {' '.join(map(str, words))} ended with {done.returncode}:\n{(done.stdout + done.stderr)[-800:]}")
    return done.stdout


def lammps_us(folder, deck):
    """CPU time of a step in microseconds."""
    said = call(["lmp", "-in", deck, "-log", "none"], folder)
    loop, use = (re.search(pattern, said) for pattern in (r"Loop time of ([0-9.e+-]+) on 1 procs for (\d+) steps", r"([0-9.]+)% CPU use"))
    if not loop or not use:
        sys.exit(f"bonds.py: lmp failed by {deck}:\n{said[-800:]}")
    return 1e6 * float(loop[1]) / int(loop[2]) * float(use[1]) / 100


def furrow_us(furrow, folder, method):
    call([furrow, "run", folder / "scene.toml", "--out", folder / method, "--method", method,
          "--set", "output.energy=false", "--set", "output.interval=1.0", "--set", "output.frames=[]"])
    run = json.loads((folder / method / "run.json").read_text())
    return 1e6 * run["cpu_seconds"] / run["steps"]


def main():
    if len(sys.argv) not in (4, 5) or not all(re.fullmatch("[1-9][0-9]*", rounds) for rounds in sys.argv[4:]):
        print(__doc__, file=sys.stderr)
        return 2
    if not shutil.which("lmp"):
        print("bonds.py: SKIPPED: lmp is not installed (Debian's package lammps)")
        return 77
    furrow, folder, result = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    rounds = int(sys.argv[4]) if len(sys.argv) == 5 else 15
    undamped = [word for kind in LINKS for word in ("--set", f"lattice[0].{kind}.damping=0.0")]
    call([furrow, "export", "validation/scenes/scenario_1.toml", "--to", "lammps", "--out", folder, *undamped, "--method", "verlet",
          "--set", 'model.after_slip="less_viscous"', "--allow", "lattice.contact_radius", "--allow", "allow.through_plates",
          "--allow", "model.tight_plates"])
    for refine in (1, 10):
        call(["lmp", "-in", "in.lammps", "-log", "none", "-screen", "none", "-var", "refine", refine], folder)
    print(call([furrow, "export", "--compare", folder, "--early", EARLY]), end="")
    compared = json.loads((folder / "compared.json").read_text())

    deck = [line for line in (folder / "in.lammps").read_text().splitlines() if not re.match(OUTPUT, line)]
    whole = [line for line in deck if not line.startswith("fix tear")]
    (folder / "in.timed").write_text("\n".join(deck) + "\n")
    (folder / "in.whole").write_text("\n".join(whole) + "\n")
    if len(deck) - len(whole) != len(LINKS):
        sys.exit("bonds.py: the deck does not tear by three lines 'fix tear...' any more")
    engines = {"furrow, PECE": lambda: furrow_us(furrow, folder, "pece"),
               "furrow, symplectic Euler": lambda: furrow_us(furrow, folder, "symplectic_euler"),
               "LAMMPS, fix bond/break": lambda: lammps_us(folder, "in.timed"),
               "LAMMPS, nothing tears": lambda: lammps_us(folder, "in.whole")}
    times = {name: [] for name in engines}
    for _ in range(rounds):
        for name, run in engines.items():
            times[name].append(run())
    for name, all_times in times.items():
        print(f"{name}: {statistics.median(all_times):.3g} us of CPU time a step, median of {rounds}; {min(all_times):.3g} to {max(all_times):.3g}")
    made_by = json.loads(call([furrow, "study", "--made-by", "times"]))
    engine = re.search(r"Simulator - (.+)", call(["lmp", "-h"]))[1].strip()
    result.write_text(json.dumps({"context": {"made_by": made_by}, "engine": "LAMMPS, " + engine, "compared": compared,
                                  "us_a_step": {name: [round(t, 4) for t in all_times] for name, all_times in times.items()}}, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
