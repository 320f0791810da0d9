"""What the adapters share: the request, what can be done of it, and what is observed on an engine's output (PROTOCOL.md)."""

import json
import math
import shutil
import subprocess
import sys
import tempfile


def tsuji_restitution(beta):
    """The e whose polynomial of Tsuji 1992, which some engines take in place of beta, damps as beta does: alpha(e) = sqrt(5) beta.
    Beyond alpha(0) it is negative."""
    def alpha(e):
        return 1.2728 - 4.2783 * e + 11.087 * e**2 - 22.348 * e**3 + 27.467 * e**4 - 18.022 * e**5 + 4.8218 * e**6
    low, high = -1.0, 1.01  # it falls between them, and is negative at the latter
    while alpha(low) < math.sqrt(5) * beta:
        low *= 2
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if alpha(middle) > math.sqrt(5) * beta else (low, middle)
    return low


class Refusal(Exception):
    """The engine cannot do this case: it has no such law, by the word that is given."""


class Untaken(Refusal):
    """The engine may well do this case; the adapter has no way to ask it. `words` name what it does not take."""

    def __init__(self, words):
        super().__init__(f"this adapter does not take {words}")


# Forces of these depend on velocities, of which a leapfrog has those of half a step before: order 1.
OF_ORDER_1 = {"damping", "friction", "spring_damping", "rolling", "rolling_spring"}


def leapfrog_order(case):
    """What leapfrog and velocity Verlet, as engines of particles have them, may claim: 2 where all forces are those of positions."""
    damped = OF_ORDER_1 & set(case.needs) or case.contact.get("cn") or case.contact.get("ct")
    return 1 if damped else 2


class Case:
    def __init__(self, request):
        self.__dict__.update(request["case"])
        self.step, self.count = request["step"], request["count"]
        self.bodies = {body["name"]: body for body in self.body}
        self.number = {body["name"]: k + 1 for k, body in enumerate(self.body)}  # as engines count

    def refuse_beyond(self, abilities, lacking):
        """`abilities` are the needs that the adapter can ask for, `lacking` those that the engine itself has no law for."""
        beyond = [need for need in self.needs if need not in abilities]
        never = [need for need in beyond if need in lacking]
        if never:
            raise Refusal(", ".join(never))
        if beyond:
            raise Untaken(", ".join(beyond))

    def moduli(self, a, b):
        """E* and G* of a pair of materials; nothing for two rigid ones."""
        return next(((pair["modulus"], pair["shear_modulus"]) for pair in self.pair if sorted(pair["materials"]) == sorted([a, b])), None)

    def beta(self):
        return self.contact["beta"]

    def sphere(self, body):
        return body["inertia"] < 0.45 * body["mass"] * body["radius"]**2

    def sees_every_step(self):
        return any(seen["what"].startswith(("greatest", "contact time", "time of", "mean push")) for seen in self.observe)


class Frame:
    """One moment of an engine's run: by name of the body (x, y), (vx, vy), spin and the force on it; how many springs have torn; by name
    of the plate the force on it."""

    def __init__(self, t):
        self.t, self.place, self.speed, self.spin, self.force, self.torn, self.push = t, {}, {}, {}, {}, 0, {}


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def line_of(case, frame, a, b):
    """Overlap of body a with b, and the direction that pushes a away."""
    radius, place = case.bodies[a]["radius"], frame.place[a]
    if b in case.bodies:
        apart = (place[0] - frame.place[b][0], place[1] - frame.place[b][1])
        distance = math.hypot(*apart)
        return radius + case.bodies[b]["radius"] - distance, (apart[0] / distance, apart[1] / distance)
    wall = next(wall for wall in case.wall if wall["name"] == b)
    return radius - dot((place[0] - wall["point"][0], place[1] - wall["point"][1]), wall["normal"]), wall["normal"]


def crest(values):
    """The greatest of a series, by the parabola through the highest three."""
    k = max(range(len(values)), key=values.__getitem__)
    if not 0 < k < len(values) - 1 or values[k - 1] - 2 * values[k] + values[k + 1] == 0:
        return values[k]
    rise = values[k + 1] - values[k - 1]
    return values[k] - rise**2 / (8 * (values[k - 1] - 2 * values[k] + values[k + 1]))


def contact_time(depths):
    rounding = 1e-9 * max(depth for _, depth in depths)  # bodies that touch at the start do so but for round-off
    first = next(t for t, depth in depths if depth >= -rounding)
    for (t0, before), (t1, after) in zip(depths, depths[1:]):
        if before > 0 >= after:
            return t0 + (t1 - t0) * before / (before - after) - first
    return None


def observable(case, seen, frames):
    what, of, last = seen["what"], seen["of"], frames[-1]
    along = lambda vector: dot(vector, seen["direction"])
    total = lambda part: sum(part(name, body) for name, body in case.bodies.items())
    if what == "velocity":
        return along(last.speed[of[0]])
    if what == "displacement":
        start = case.bodies[of[0]]["position"]
        return along((last.place[of[0]][0] - start[0], last.place[of[0]][1] - start[1]))
    if what == "spin":
        return last.spin[of[0]]
    if what == "overlap":
        return line_of(case, last, *of)[0]
    if what == "greatest overlap":
        return crest([line_of(case, frame, *of)[0] for frame in frames])
    if what == "greatest force":
        return crest([dot(frame.force[of[0]], line_of(case, frame, *of)[1]) for frame in frames])
    if what == "contact time":
        return contact_time([(frame.t, line_of(case, frame, *of)[0]) for frame in frames])
    if what == "torn springs":
        return last.torn
    if what == "time of tear":
        return next((frame.t for frame in frames if frame.torn), None)
    if what == "momentum":
        return total(lambda name, body: body["mass"] * along(last.speed[name]))
    if what == "angular momentum":
        moment = lambda p, v: p[0] * v[1] - p[1] * v[0]
        return total(lambda name, body: body["mass"] * moment(last.place[name], last.speed[name]) + body["inertia"] * last.spin[name])
    if what == "push":
        return along(last.push[of[0]])
    if what == "greatest push":
        return crest([along(frame.push[of[0]]) for frame in frames])
    if what == "mean push":
        late = [along(frame.push[of[0]]) for frame in frames if frame.t >= seen["from"]]
        return sum(late) / len(late)
    if what == "mean height":
        heights = [last.place[name][1] for name, body in case.bodies.items() if body["radius"] > 0]
        return sum(heights) / len(heights)
    raise Untaken(f"the observable {what}")


def serve(engine, order, run):
    """`run(case, folder)` returns frames, in the order of time, the last one at the end of the case; `order(case)` is what the engine
    claims for it."""
    case = Case(json.load(sys.stdin))
    try:
        with tempfile.TemporaryDirectory() as folder:
            frames = run(case, folder)
        found = {seen["name"]: observable(case, seen, frames) for seen in case.observe}
        print(json.dumps({"engine": engine, "order": order(case), "observables": found}))
    except Refusal as reason:
        print(json.dumps({"engine": engine, "cannot": str(reason)}))


def call(words, folder, **more):
    """Runs a program; if it ends badly, what it calls an error is said, else what it said last."""
    if shutil.which(words[0]) is None:
        sys.exit(f"{words[0]} is not installed")
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        said = done.stdout + done.stderr
        errors = [line for line in said.splitlines() if "error" in line.lower()]
        sys.exit(f"{words[0]} ended with {done.returncode}: {' '.join(errors) or said[-600:]}")
    return done.stdout


def version(words, pick):
    """What a program calls itself, or nothing if it is not there."""
    if shutil.which(words[0]) is None:
        return ""
    with tempfile.TemporaryDirectory() as folder:  # some leave a log where they run
        done = subprocess.run(words, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL, cwd=folder)
    return next((pick(line) for line in (done.stdout + done.stderr).splitlines() if pick(line)), "")
