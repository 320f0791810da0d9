#!/usr/bin/env python3
"""YADE as an engine (PROTOCOL.md): leapfrog, Law2_ScGeom_MindlinPhys_Mindlin.

   furrow judge --engine verification/engines/adapters/yade.py

Against a wall it takes R* = R/2 in place of R, which softens the contact by sqrt(2): materials go in with a modulus that makes up for
that, and `--walls material` shows what happens if they do not. It never pulls."""

import json
import math
import os
import sys

import common

YADE = os.environ.get("YADE", "yade")
ABILITIES = {"hertz", "wall", "pair", "damping", "no_pull", "friction", "tangential_damping", "no_tangential_damping", "gravity", "arm_radius"}

LACKING = {"pull", "outline", "point", "rolling", "arm_contact_point"}  # of the law above

# Runs inside YADE. Velocities are those of half a step before; the last half step is added with the force at the end.
SCRIPT = '''
import json, math, sys
task = json.load(open(sys.argv[-1]))
stuff = [O.materials.append(FrictMat(young=m["young"], poisson=m["poisson"], frictionAngle=math.atan(task["friction"]), density=1000)) for m in task["materials"]]
ids = []
for b in task["bodies"]:
    body = utils.sphere((b["x"], b["y"], 0), b["radius"], material=O.materials[stuff[b["material"]]])
    body.state.mass, body.state.inertia = b["mass"], Vector3(1, 1, 1) * b["inertia"]
    body.state.vel, body.state.angVel, body.state.blockedDOFs = (b["vx"], b["vy"], 0), (0, 0, b["spin"]), "zXY"
    ids.append(O.bodies.append(body))
for w in task["walls"]:
    O.bodies.append(utils.wall(w["place"], axis=w["axis"], sense=w["sense"], material=O.materials[stuff[w["material"]]]))
rows = []
def note():
    h = O.dt
    row = []
    for k in ids:
        s, f, t = O.bodies[k].state, O.forces.f(k), O.forces.t(k)
        g = Vector3(*task["gravity"], 0)
        v, w = s.vel + (f / s.mass + g) * h / 2, s.angVel[2] + t[2] / s.inertia[2] * h / 2
        row.append([s.pos[0], s.pos[1], v[0], v[1], w, f[0], f[1]])
    rows.append([O.time, row])
O.engines = [ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_MindlinPhys(betan=task["betan"], betas=task["betas"])], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    PyRunner(command="note()", iterPeriod=task["every"]),
    NewtonIntegrator(gravity=(*task["gravity"], 0), damping=0)]
O.dt = task["step"]
# The first forces give half a step, so that velocities belong to half steps.
O.run(task["count"] + 1, True)
json.dump(rows, open(task["out"], "w"))
'''


def materials(case):
    """As the case has them; with walls, two of which make up for R/2 in place of R."""
    made = {}
    bodies = {body["material"] for body in case.body}
    if not case.wall:
        return {m["name"]: (m["young"], m["poisson"]) for m in case.material}
    if "--walls" in sys.argv:
        return {m["name"]: (1e24 if m.get("rigid") else m["young"], m.get("poisson", 0.3)) for m in case.material}
    if len(case.body) > 1:
        raise common.Untaken("walls and pairs together")
    for wall in case.wall:
        own = next(m for m in case.material if m["name"] in bodies)
        modulus = case.moduli(own["name"], wall["material"])[0]
        other = next(m for m in case.material if m["name"] == wall["material"])
        if not other.get("rigid") and other["name"] != own["name"]:
            raise common.Untaken("a wall of another material")
        made[own["name"]] = made[other["name"]] = (2 * (1 - own["poisson"]**2) * math.sqrt(2) * modulus, own["poisson"])
    return made


def task_of(case, folder):
    made = materials(case)
    names = list(made)
    walls = []
    for wall in case.wall:
        axis = 0 if abs(wall["normal"][0]) > 1 - 1e-12 else 1
        if abs(wall["normal"][axis]) < 1 - 1e-12:
            raise common.Untaken("a wall that leans")
        walls.append({"place": wall["point"][axis], "axis": axis, "sense": round(wall["normal"][axis]), "material": names.index(wall["material"])})
    beta = math.sqrt(5 / 6) * case.beta()
    h = case.step
    bodies = []
    for body in case.body:
        x, y = body["position"]
        (vx, vy), (gx, gy) = body["velocity"], case.gravity
        bodies.append({"x": x, "y": y, "vx": vx - gx * h / 2, "vy": vy - gy * h / 2, "spin": body["spin"], "radius": body["radius"],
                       "mass": body["mass"], "inertia": body["inertia"], "material": names.index(body["material"])})
    return {"materials": [{"young": made[name][0], "poisson": made[name][1]} for name in names], "bodies": bodies, "walls": walls,
            "friction": min(case.contact["friction"], 1e6), "gravity": case.gravity, "betan": beta,
            "betas": beta if case.contact["tangential_damping"] else 0.0, "step": h, "count": case.count,
            "every": 1 if case.sees_every_step() else case.count, "out": f"{folder}/rows.json"}


def run(case, folder):
    case.refuse_beyond(ABILITIES, LACKING)
    with open(f"{folder}/task.json", "w", encoding="utf-8") as out:
        json.dump(task_of(case, folder), out)
    with open(f"{folder}/script.py", "w", encoding="utf-8") as out:
        out.write(SCRIPT)
    common.call([YADE, "-n", "-x", "-j1", "script.py", "task.json"], folder, env=os.environ | {"OMP_NUM_THREADS": "1", "DISPLAY": ""}, stdin=-3)
    start = common.Frame(0.0)  # of iteration 0 YADE notes nothing
    for name, body in case.bodies.items():
        start.place[name], start.speed[name], start.spin[name], start.force[name] = body["position"], body["velocity"], body["spin"], (0.0, 0.0)
    frames = [start]
    with open(f"{folder}/rows.json", encoding="utf-8") as rows:
        for t, row in json.load(rows):
            frame = common.Frame(t)
            for name, (x, y, vx, vy, spin, fx, fy) in zip(case.bodies, row):
                frame.place[name], frame.speed[name], frame.spin[name], frame.force[name] = (x, y), (vx, vy), spin, (fx, fy)
            frames.append(frame)
    return frames


def name():
    return f"YADE {common.version([YADE, '--version'], lambda line: line.split('version: ')[1].strip() if 'version: ' in line else '')}".strip()


if __name__ == "__main__":
    common.serve(name(), common.leapfrog_order, run)
