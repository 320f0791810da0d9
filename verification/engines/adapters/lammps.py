#!/usr/bin/env python3
"""LAMMPS as an engine (PROTOCOL.md): velocity Verlet, pair style granular, bonds.

   furrow judge --engine verification/engines/adapters/lammps.py

Constants go in as numbers, walls too: the material words of its walls take E* too high by 1 + nu (29 Sep 2021; later versions are
right), and `--walls material` shows that. The damping is Tsuji's; its restitution is solved for the beta of the case."""

import math
import os
import sys

import common

LAMMPS = os.environ.get("LAMMPS", "lmp")
GRAINS = {"hertz", "wall", "pair", "damping", "pull", "no_pull", "friction", "tangential_damping", "no_tangential_damping",
          "gravity", "arm_radius", "linear", "load", "rolling_spring", "plate"}
NET = {"spring", "tear", "load", "gravity"}
# Smoothed rolling friction, an arm of its own choice, a force shared by two nodes, dampers along bonds: not in this version.
LACKING = {"rolling", "arm_contact_point", "outline", "point", "spring_damping"}


def exact(value):
    return repr(float(value))


def granular(case, modulus, shear):
    """The words of pair style granular, and of walls of that style."""
    contact, beta = case.contact, case.beta()
    if contact["law"] == "linear":
        if contact["kt"] or contact["friction"]:
            raise common.Untaken("a linear tangential spring")
        limit = "" if contact["pull"] or not contact["cn"] else " limit_damping"
        return f"hooke {exact(contact['kn'])} {exact(contact['cn'])} tangential linear_nohistory 0 0 damping velocity{limit}"
    e = common.tsuji_restitution(beta)
    damped = beta > 0
    normal = f"hertz {exact(4 / 3 * modulus)} {exact(e if damped else 0)}"
    both = 2 * math.sqrt(shear / modulus) if damped and contact["tangential_damping"] else 0
    mu = min(contact["friction"], 1e6)
    tangent = f"mindlin {exact(8 * shear)} {exact(both)} {exact(mu)}" if mu else "linear_nohistory 0 0"
    limit = "" if contact["pull"] or not damped else " limit_damping"
    if "rolling_spring" in case.needs:  # its spring is one of length at R
        square = case.body[0]["radius"]**2
        tangent += (f" rolling sds {exact(contact['rolling_stiffness'] / square)} {exact(contact['rolling_damping'] / square)}"
                    f" {exact(contact['rolling_friction'])}")
    return f"{normal} tangential {tangent} damping {'tsuji' if damped else 'velocity'}{limit}"


def material_wall(case, wall):
    """By the words for materials, which this version gets wrong."""
    own = next(m for m in case.material if m["name"] == wall["material"])
    if own.get("rigid") or case.contact["law"] != "hertz" or case.beta() or case.contact["friction"]:
        raise common.Untaken("a wall by its material unless both are elastic, without friction and of one material")
    return f"granular hertz/material {exact(own['young'])} 0 {exact(own['poisson'])} tangential linear_nohistory 0 0 damping velocity"


def met_by(case, face, types):
    """The groups of bodies that meet a wall as one pair of materials each: the words for the group, and its moduli. A wall of one kind
    acts on all."""
    kinds = {}
    for number, name in enumerate(types, 1):
        kinds.setdefault(case.moduli(name, face["material"]), []).append(str(number))
    if len(kinds) == 1:
        return [([], "all", *kinds)]
    return [([f"group meets_{face['name']}_{k} type {' '.join(numbers)}"], f"meets_{face['name']}_{k}", moduli)
            for k, (moduli, numbers) in enumerate(kinds.items())]


def wall_lines(case, types):
    lines = []
    for k, wall in enumerate(case.wall):
        normal, point = wall["normal"], wall["point"]
        axis = [abs(part) > 1 - 1e-12 for part in normal]
        if not any(axis):
            lines.append(f"region wall{k} plane {exact(point[0])} {exact(point[1])} 0 {exact(normal[0])} {exact(normal[1])} 0")
        for part, (groups, group, moduli) in enumerate(met_by(case, wall, types)):
            words = material_wall(case, wall) if "--walls" in sys.argv else f"granular {granular(case, *moduli)}"
            lines += groups
            if any(axis):
                place = exact(point[0] if axis[0] else point[1])
                side = f"{place} NULL" if sum(normal) > 0 else f"NULL {place}"
                lines.append(f"fix wall{k}_{part} {group} wall/gran {words} {'xplane' if axis[0] else 'yplane'} {side}")
            else:
                lines.append(f"fix wall{k}_{part} {group} wall/gran/region {words} region wall{k}")
    return lines


def plate_lines(case, types):
    """Blocks that move by variables of the time; the force on one is the sum of what its contacts give to the grains."""
    lines = []
    for k, plate in enumerate(case.plate):
        kinds = {case.moduli(name, plate["material"]) for name in types}
        if len(kinds) != 1:
            raise common.Untaken("a plate that meets several materials")
        (x0, y0), (x1, y1) = plate["lower_left"], plate["upper_right"]
        lines += [f"variable way{axis}{k} equal {exact(v)}*step*dt" for axis, v in zip("xy", plate["velocity"])]
        lines += [f"region plate{k} block {exact(x0)} {exact(x1)} {exact(y0)} {exact(y1)} EDGE EDGE side out move v_wayx{k} v_wayy{k} NULL",
                  f"fix plate{k} all wall/gran/region granular {granular(case, *kinds.pop())} region plate{k} contacts",
                  f"compute push{k} all reduce sum f_plate{k}[2] f_plate{k}[3]"]
    return lines


def box(case):
    xs = [p for b in case.body for p in (b["position"][0] - 50 * b["radius"], b["position"][0] + 50 * b["radius"])]
    ys = [p for b in case.body for p in (b["position"][1] - 50 * b["radius"], b["position"][1] + 50 * b["radius"])]
    wide = max(max(xs) - min(xs), max(ys) - min(ys))
    if case.spring:  # points have no radius, and may go far from where they start
        wide += case.end * max(math.hypot(*b["velocity"]) for b in case.body)
    return min(xs) - wide, max(xs) + wide, min(ys) - wide, max(ys) + wide


def neighbours(case):
    """Few bodies are searched for without bins, which would fill the wide box; a wide skin, so that a list lasts."""
    return f"neighbor {exact(max(0.001, *(0.5 * b['radius'] for b in case.body)))} {'nsq' if len(case.body) < 50 else 'bin'}"


def write_atoms(case, folder, types, bonds):
    x0, x1, y0, y1 = box(case)
    kinds = sorted({(s["stiffness"], s["length"], s.get("strength", math.inf)) for s in case.spring})
    lines = ["", "", f"{len(case.body)} atoms", f"{len(types)} atom types"]
    if bonds:
        lines += [f"{len(case.spring)} bonds", f"{len(kinds)} bond types", "30 extra bond per atom", "60 extra special per atom"]
    lines += [f"{exact(x0)} {exact(x1)} xlo xhi", f"{exact(y0)} {exact(y1)} ylo yhi", "-1 1 zlo zhi" if bonds else f"{exact(-x1 + x0)} {exact(x1 - x0)} zlo zhi", ""]
    if bonds:
        lines += ["Masses", "", *(f"{k + 1} {exact(case.body[0]['mass'])}" for k in range(len(types))), ""]
    lines += ["Atoms", ""]
    for name, body in case.bodies.items():
        x, y = body["position"]
        kind = types.index(body["material"]) + 1
        if bonds:
            lines.append(f"{case.number[name]} 1 {kind} {exact(x)} {exact(y)} 0")
        else:
            density = body["mass"] / (4 / 3 * math.pi * body["radius"]**3)
            lines.append(f"{case.number[name]} {kind} {exact(2 * body['radius'])} {exact(density)} {exact(x)} {exact(y)} 0")
    lines += ["", "Velocities", ""]
    for name, body in case.bodies.items():
        vx, vy = (0, 0) if body["fixed"] else body["velocity"]
        turn = "" if bonds else f" 0 0 {exact(body['spin'])}"
        lines.append(f"{case.number[name]} {exact(vx)} {exact(vy)} 0{turn}")
    if bonds:
        lines += ["", "Bonds", ""]
        for k, s in enumerate(case.spring):
            kind = kinds.index((s["stiffness"], s["length"], s.get("strength", math.inf))) + 1
            lines.append(f"{k + 1} {kind} {case.number[s['a']]} {case.number[s['b']]}")
    with open(f"{folder}/atoms", "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    return kinds


def net_lines(case, folder, types):
    """Bonds in place of grains; a bond type breaks at the length at which its spring reaches its strength."""
    kinds = write_atoms(case, folder, types, True)
    lines = ["atom_style bond", "bond_style harmonic", "special_bonds lj/coul 1 1 1", "read_data atoms", "comm_modify cutoff 100"]
    lines += [f"bond_coeff {k + 1} {exact(stiffness / 2)} {exact(length)}" for k, (stiffness, length, _) in enumerate(kinds)]
    lines += [f"fix tear{k} all bond/break 1 {k + 1} {exact(length + strength / stiffness)}"
              for k, (stiffness, length, strength) in enumerate(kinds) if strength < math.inf]
    fixed = [str(case.number[name]) for name, body in case.bodies.items() if body["fixed"]]
    if fixed:
        lines += [f"group held id {' '.join(fixed)}", "group free subtract all held"]
    lines.append(f"fix move {'free' if fixed else 'all'} nve")
    torn = "+".join(f"f_tear{k}[2]" for k, kind in enumerate(kinds) if kind[2] < math.inf)
    return lines + [f"variable torn equal {torn or 0}"]


def grain_lines(case, folder, types):
    write_atoms(case, folder, types, False)
    spheres = {case.sphere(body) for body in case.body}
    if len(spheres) > 1:
        raise common.Untaken("discs and spheres together")
    lines = ["atom_style sphere", "comm_modify vel yes", "read_data atoms", "pair_style granular"]
    for i, a in enumerate(types):
        for j in range(i, len(types)):
            lines.append(f"pair_coeff {i + 1} {j + 1} {granular(case, *case.moduli(a, types[j]))}")
    lines.append("fix move all nve/sphere" + ("" if spheres == {True} else " disc"))
    return lines + wall_lines(case, types) + plate_lines(case, types) + ["variable torn equal 0"]


def load_lines(case):
    lines = []
    gravity = math.hypot(*case.gravity)
    if gravity:
        lines.append(f"fix weight all gravity {exact(gravity)} vector {exact(case.gravity[0])} {exact(case.gravity[1])} 0")
    for name, body in case.bodies.items():
        if any(body["load"]):
            k = case.number[name]
            lines += [f"group loaded{k} id {k}", f"fix load{k} loaded{k} addforce {exact(body['load'][0])} {exact(body['load'][1])} 0"]
    return lines


def read_frames(case, folder):
    """dump custom: id x y vx vy omegaz fx fy; the torn springs and the forces on plates stand in a file of their own."""
    torn, pushes = {}, {}
    with open(f"{folder}/torn", encoding="utf-8") as lines:
        for line in lines:
            if not line.startswith("#"):
                step, count, *push = line.split()
                torn[int(step)] = int(float(count))
                pushes[int(step)] = [-float(part) for part in push]
    names = {number: name for name, number in case.number.items()}
    frames = []
    with open(f"{folder}/dump", encoding="utf-8") as dump:
        for line in dump:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(next(dump))
                frames.append(common.Frame(step * case.step))
                frames[-1].torn = torn.get(step, 0)
                frames[-1].push = {plate["name"]: tuple(pushes[step][2 * k:2 * k + 2]) for k, plate in enumerate(case.plate)}
            elif not line.startswith("ITEM") and len(line.split()) == 8:
                k, x, y, vx, vy, spin, fx, fy = map(float, line.split())
                frame, name = frames[-1], names[int(k)]
                frame.place[name], frame.speed[name], frame.spin[name], frame.force[name] = (x, y), (vx, vy), spin, (fx, fy)
    return frames


def run(case, folder):
    net = bool(case.spring)
    case.refuse_beyond(NET if net else GRAINS, LACKING)
    if "--walls" in sys.argv and not case.wall:
        raise common.Untaken("a case without walls, with --walls material")
    if "rolling_spring" in case.needs and len(case.body) > 1:
        raise common.Untaken("springs against rolling of several bodies")
    if not net and any(body["radius"] == 0 for body in case.body):
        raise common.Untaken("point masses that touch")
    types = sorted({body["material"] for body in case.body})
    flat = net or not case.sphere(case.body[0])
    every = 1 if case.sees_every_step() else case.count
    spin = "vz" if net else "omegaz"
    pushes = "".join(f" $(c_push{k}[{axis}]:%.17g)" for k in range(len(case.plate)) for axis in (1, 2))
    lines = ["units si", f"dimension {2 if flat else 3}", "boundary f f p" if flat else "boundary f f f", "newton off", neighbours(case)]
    lines += net_lines(case, folder, types) if net else grain_lines(case, folder, types)
    lines += load_lines(case)
    lines += ["neigh_modify delay 0 every 1 check yes", f"timestep {exact(case.step)}", *(["fix flat all enforce2d"] if flat else []),
              "thermo_modify lost error", f"thermo {case.count}",
              f"dump all all custom {every} dump id x y vx vy {spin} fx fy", "dump_modify all sort id format float %.17g",
              f'fix torn all print {every} "$(step) $(v_torn){pushes}" file torn screen no', f"run {case.count}"]
    with open(f"{folder}/in", "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    common.call([LAMMPS, "-in", "in", "-log", "none"], folder, env=os.environ | {"OMP_NUM_THREADS": "1"})
    return read_frames(case, folder)


def name():
    found = common.version([LAMMPS, "-h"], lambda line: line.removeprefix("Large-scale Atomic/Molecular Massively Parallel Simulator - ") if "Simulator -" in line else "")
    return f"LAMMPS {found}".strip() + (", fix wall/gran hertz/material" if "--walls" in sys.argv else "")


if __name__ == "__main__":
    common.serve(name(), common.leapfrog_order, run)
