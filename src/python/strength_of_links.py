"""An example of furrow.py: the paper's first scene with links of three strengths, and the force on the plate in each.

usage: strength_of_links.py FIGURE.svg        needs matplotlib; takes a second
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # no window
import matplotlib.pyplot as plt

import furrow

scenes = pathlib.Path(__file__).resolve().parents[2] / "validation/scenes"


def with_strength(newtons):
    scene = furrow.load(scenes / "scenario_1.toml")
    for kind in ("structural", "shear", "bending"):
        scene["lattice"][0][kind]["strength"] = newtons
    return furrow.run(scene)


def main(figure):
    strengths = [30, 40, 60]  # N
    runs = [with_strength(newtons) for newtons in strengths]
    for newtons, run in zip(strengths, runs):
        print(f"{newtons} N: {len(run.events)} links torn, largest force {run.json['largest_force'][0]['F']:.0f} N")
    plt.rcParams["svg.hashsalt"] = "furrow"  # the same file each time
    axes = furrow.plot_force(runs, plt.subplots(figsize=(7, 3.2))[1], labels=[f"{n} N" for n in strengths])
    axes.set_title("First scene: force on the plate, by the strength of the links")
    plt.tight_layout()
    plt.savefig(figure, metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
