"""Shares of mutants that were noticed, by room and by kind of edit."""

import math

ROOMS = {  # what src/ is divided into; the first ones get most of the draws
    "output": ["src/output/"],
    "program": ["src/program/"],
    "observers": ["src/run/observe.", "src/run/stiffness.", "src/physics/stress."],
    "preparation and scene": ["src/run/prepare.", "src/scene/"],
    "run and events": ["src/run/", "src/system/survey."],
    "methods": ["src/methods/"],
    "kernel": [f"src/kernel/{name}." for name in ("loops", "law_loops", "lanes", "rates", "jump", "touches", "kernel", "survey")],
    "search": ["src/kernel/", "src/scene/grid."],
    "reference": ["src/reference/"],
    "geometry and parts": ["src/physics/geometry.", "src/system/parts."],
    "physics": ["src/physics/"],
    "system": ["src/"],
}
WELL_TRIED = list(ROOMS)[:7]  # each gets an equal share of four fifths
GOALS = {"raw": 0.88, "adjusted": 0.95, "adjusted, of each room": 0.90}


def room_of(file):
    return next(room for room, begins in ROOMS.items() if any(file.startswith(begin) for begin in begins))


def evenly(count, rooms):
    return {room: count // len(rooms) + (k < count % len(rooms)) for k, room in enumerate(rooms)}


def quotas(count):
    most = round(0.8 * count)
    return evenly(most, WELL_TRIED) | evenly(count - most, [room for room in ROOMS if room not in WELL_TRIED])


def wilson(hits, tried, z=1.96):
    """The 95 % interval of a share."""
    if tried == 0:
        return 0.0, 1.0
    share, spread = hits / tried, z * z / tried
    middle, half = share + spread / 2, z * math.sqrt(share * (1 - share) / tried + spread / tried / 4)
    return (middle - half) / (1 + spread), (middle + half) / (1 + spread)


def row(name, mutants):
    tried, noticed = len(mutants), sum(m["verdict"] == "noticed" for m in mutants)
    judged = sum(m["verdict"] in ("equivalent", "same program") for m in mutants)
    result = {"name": name, "tried": tried, "noticed": noticed, "equivalent": judged}
    for share, of in (("raw", tried), ("adjusted", tried - judged)):
        low, high = wilson(noticed, of)
        result[share] = {"share": round(noticed / of, 4) if of else None, "low": round(low, 4), "high": round(high, 4)}
    return result


def summary(mutants):
    kinds = sorted({m["kind"] for m in mutants})
    return {
        "all": row("all", mutants),
        "rooms": [row(room, [m for m in mutants if m["room"] == room]) for room in ROOMS],
        "kinds": [row(kind, [m for m in mutants if m["kind"] == kind]) for kind in kinds],
    }


def missed_goals(found):
    """One line for each share that is below its goal."""
    asked = [("all", "raw", found["all"], GOALS["raw"]), ("all", "adjusted", found["all"], GOALS["adjusted"])]
    asked += [(one["name"], "adjusted", one, GOALS["adjusted, of each room"]) for one in found["rooms"]]
    return [
        f"below the goal: {name}, {which}: {100 * one[which]['share']:.1f} % of {one['tried']}, wanted {100 * goal:.0f} %"
        for name, which, one, goal in asked
        if one[which]["share"] is not None and one[which]["share"] < goal
    ]


def table(found):
    def cell(share):
        return "      -          " if share["share"] is None else f"{100 * share['share']:5.1f} % [{100 * share['low']:3.0f}, {100 * share['high']:3.0f}]"

    lines = [f"{'':24} tried noticed equivalent   raw                adjusted"]
    for one in [*found["rooms"], None, *found["kinds"], None, found["all"]]:
        lines.append("" if one is None else f"{one['name']:24} {one['tried']:5} {one['noticed']:7} {one['equivalent']:10}   "
                     f"{cell(one['raw'])}  {cell(one['adjusted'])}")  # fmt: skip
    return "\n".join(lines)
