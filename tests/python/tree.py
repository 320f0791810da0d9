"""The files of the tree, found, so that a new one is tested without a word."""

import pathlib
import subprocess

source = pathlib.Path(__file__).resolve().parents[2]
MADE = ("build", "report", "runs")  # folders at the top that commands leave


def files(ending):
    """Paths below the top of all files with this ending: those that git tracks or would track, all there are if there is no git."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z", "--cached", "--others", "--exclude-standard", f"*{ending}"],
                            capture_output=True, text=True) if (source / ".git").exists() else None
    if listed and listed.returncode == 0:
        names = [name for name in listed.stdout.split("\0") if name and (source / name).exists()]
    else:
        names = [str(path.relative_to(source)) for path in source.rglob(f"*{ending}")]
    return sorted(n for n in names if n.split("/")[0] not in MADE and not any(part.startswith(".") for part in n.split("/")))
