#!/usr/bin/env python3
"""The smallest engine that furrow judge can ask: one body that meets one rigid wall head-on, without damping.
   furrow judge --engine verification/engines/example.py --cases hertz_wall"""
import json, sys

request = json.load(sys.stdin)
case, h = request["case"], request["step"]
if set(case["needs"]) != {"hertz", "wall"}:
    sys.exit(print(json.dumps({"engine": "example", "cannot": "more than a body and a wall"})))
body, wall = case["body"][0], case["wall"][0]
wanted = {body["material"], wall["material"]}
modulus = next(pair["modulus"] for pair in case["pair"] if set(pair["materials"]) == wanted)
along = lambda v: v[0] * wall["normal"][0] + v[1] * wall["normal"][1]  # distance from the wall is all that moves
d = body["radius"] - along(body["position"]) + along(wall["point"])
v, seen, force = -along(body["velocity"]), [(0.0, d)], lambda d: 4 / 3 * modulus * body["radius"]**0.5 * max(d, 0.0)**1.5
for n in range(request["count"]):  # velocity Verlet
    v -= h / 2 * force(d) / body["mass"]
    d += h * v
    v -= h / 2 * force(d) / body["mass"]
    seen.append(((n + 1) * h, d))
left = next((t - h * d / (d - before) for (_, before), (t, d) in zip(seen, seen[1:]) if before > 0 >= d), float("nan"))
deepest = max(d for _, d in seen)
answers = {"greatest overlap": deepest, "greatest force": force(deepest), "contact time": left, "velocity": -v}
print(json.dumps({"engine": "example", "order": 2, "observables": {o["name"]: answers[o["what"]] for o in case["observe"]}}))
