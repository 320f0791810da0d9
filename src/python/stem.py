"""An example of furrow.py: a plate breaks a stem at the ground. Draws the stem at four times, and the force on the plate.

usage: stem.py FIGURE.svg        needs matplotlib; takes two seconds
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")  # no window
import matplotlib.pyplot as plt

import furrow


def main(figure):
    run = furrow.run(pathlib.Path(__file__).with_name("stem.toml"), set={"output.frames": [0.0, 0.4, 0.7, 1.0]})
    print(f"{run.json['ended']}: {len(run.events)} links torn, largest force {max(run.plate_force['F']):.1f} N")
    plt.rcParams["svg.hashsalt"] = "furrow"  # the same file each time
    picture, (above, below) = plt.subplots(2, 1, figsize=(7, 4.6), height_ratios=[2, 3])
    for k in range(len(run.frames)):
        furrow.plot_frame(run, k, above, shift=0.07 * k)
        above.text(0.07 * k, -0.015, f"{run.frames['t'][k]:.1f} s")
    above.set_axis_off()
    furrow.plot_force(run, below)
    picture.tight_layout()
    picture.savefig(figure, metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
