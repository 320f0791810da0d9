#!/usr/bin/env python3
"""LIGGGHTS as an engine (PROTOCOL.md): velocity Verlet, model hertz tangential history, whose damping is the law of the cases.

   furrow judge --engine verification/engines/adapters/liggghts.py

Spheres only: the moment of inertia is 2/5 m R^2. A rigid material is one with a modulus of 1e24 Pa. Its moment arm at walls is its own
and cannot be chosen."""

import math
import os

import common

LIGGGHTS = os.environ.get("LIGGGHTS", "liggghts")
ABILITIES = {"hertz", "wall", "pair", "damping", "pull", "no_pull", "friction", "tangential_damping", "no_tangential_damping",
             "gravity", "arm_radius"}
# It has no bonds and no arm of its own choice; its rolling friction is not smoothed.
LACKING = {"spring", "tear", "spring_damping", "outline", "point", "rolling", "arm_contact_point"}
RIGID = 1e24  # Pa


def exact(value):
    return repr(float(value))


def restitution(beta):
    if beta >= 1:
        raise common.Refusal("damping without a restitution")
    e = math.exp(-math.pi * beta / math.sqrt(1 - beta**2))
    if e < 0.05:
        raise common.Refusal("a restitution below 0.05")
    return e


def properties(case):
    young = [RIGID if m.get("rigid") else m["young"] for m in case.material]
    poisson = [m.get("poisson", 0.3) for m in case.material]
    if min(young) < 5e6:
        raise common.Refusal("a modulus below 5e6 Pa")
    if min(poisson) < 0:
        raise common.Refusal("a negative ratio of Poisson")
    count = len(young)
    table = lambda value: " ".join([exact(value)] * count**2)
    each = lambda values: " ".join(exact(value) for value in values)
    return [f"fix young all property/global youngsModulus peratomtype {each(young)}",
            f"fix poisson all property/global poissonsRatio peratomtype {each(poisson)}",
            f"fix restitution all property/global coefficientRestitution peratomtypepair {count} {table(restitution(case.beta()))}",
            f"fix friction all property/global coefficientFriction peratomtypepair {count} {table(min(case.contact['friction'], 1e6))}"]


def model(case):
    damped = "on" if case.contact["tangential_damping"] else "off"
    tangent = f" tangential history" if case.contact["friction"] else ""
    settings = f" tangential_damping {damped}" if tangent else ""
    return f"model hertz{tangent}", settings + ("" if case.contact["pull"] or not case.beta() else " limitForce on")


def walls(case, types):
    lines = []
    law, settings = model(case)
    for k, wall in enumerate(case.wall):
        across = [abs(part) > 1 - 1e-12 for part in wall["normal"]]
        if not any(across):
            raise common.Untaken("a wall that leans")
        axis = 0 if across[0] else 1
        lines.append(f"fix wall{k} all wall/gran {law} primitive type {types.index(wall['material']) + 1} "
                     f"{'xy'[axis]}plane {exact(wall['point'][axis])}{settings}")
    return lines


def write_atoms(case, folder, types):
    reach = max(math.hypot(*body["position"]) + 20 * body["radius"] for body in case.body)
    lines = ["", "", f"{len(case.body)} atoms", f"{len(types)} atom types",
             *(f"{exact(-reach)} {exact(reach)} {axis}lo {axis}hi" for axis in "xyz"), "", "Atoms", ""]
    for name, body in case.bodies.items():
        density = body["mass"] / (4 / 3 * math.pi * body["radius"]**3)
        x, y = body["position"]
        lines.append(f"{case.number[name]} {types.index(body['material']) + 1} {exact(2 * body['radius'])} {exact(density)} {exact(x)} {exact(y)} 0.0")
    lines += ["", "Velocities", ""]
    for name, body in case.bodies.items():
        vx, vy = body["velocity"]
        lines.append(f"{case.number[name]} {exact(vx)} {exact(vy)} 0.0 0.0 0.0 {exact(body['spin'])}")
    with open(f"{folder}/atoms", "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")


def read_frames(case, folder):
    names = {number: name for name, number in case.number.items()}
    frames = []
    with open(f"{folder}/dump", encoding="utf-8") as dump:
        for line in dump:
            if line.startswith("ITEM: TIMESTEP"):
                frames.append(common.Frame(int(next(dump)) * case.step))
            elif not line.startswith("ITEM") and len(line.split()) == 8:
                k, x, y, vx, vy, spin, fx, fy = map(float, line.split())
                frame, name = frames[-1], names[int(k)]
                frame.place[name], frame.speed[name], frame.spin[name], frame.force[name] = (x, y), (vx, vy), spin, (fx, fy)
    return frames


def run(case, folder):
    case.refuse_beyond(ABILITIES, LACKING)
    if case.contact["friction"] and not all(case.sphere(body) for body in case.body):
        raise common.Refusal("the inertia of a disc")
    types = [m["name"] for m in case.material]
    write_atoms(case, folder, types)
    every = 1 if case.sees_every_step() else case.count
    law, settings = model(case)
    gravity = math.hypot(*case.gravity)
    lines = ["units si", "atom_style granular", "atom_modify map array", "hard_particles yes", "boundary f f f", "newton off", "communicate single vel yes",
             "read_data atoms", "neighbor 0.001 bin", "neigh_modify delay 0", f"timestep {exact(case.step)}", *properties(case),
             f"pair_style gran {law}{settings}", "pair_coeff * *", "fix move all nve/sphere", *walls(case, types)]
    if gravity:
        lines.append(f"fix weight all gravity {exact(gravity)} vector {exact(case.gravity[0])} {exact(case.gravity[1])} 0.0")
    lines += ["thermo_modify lost error", f"thermo {case.count}", f"dump all all custom {every} dump id x y vx vy omegaz fx fy",
              "dump_modify all sort id format '%d" + " %.17g" * 7 + "'", f"run {case.count}"]
    with open(f"{folder}/in", "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    common.call([LIGGGHTS, "-in", "in", "-log", "none"], folder, env=os.environ | {"OMP_NUM_THREADS": "1"})
    return read_frames(case, folder)


def name():
    found = common.version([LIGGGHTS, "-h"], lambda line: line.split("(Version ")[1].split(",")[0] if "(Version " in line else "")
    return f"LIGGGHTS {found.removeprefix('LIGGGHTS-')}".strip()


if __name__ == "__main__":
    common.serve(name(), common.leapfrog_order, run)
