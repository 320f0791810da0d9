# The bed and the plate for YADE. Arguments as in lammps.in, NAME=VALUE. Three dimensions, held in the plane; mass and inertia of a
# disc. Walls count with the radius of the disc, R* = R/2 instead of R: softer by a factor sqrt(2).
import math
import sys

given = dict(word.split('=', 1) for word in sys.argv[1:] if '=' in word)
value = {name: float(text) for name, text in given.items() if name != 'bed'}
radius, mass = value['radius'], value['mass']

stuff = O.materials.append(FrictMat(young=value['young'], poisson=value['poisson'],
                                    frictionAngle=math.atan(value['friction']), density=1000))
discs = []
for line in open(given['bed']):
    numbers = line.split()
    if len(numbers) != 7:
        continue
    body = utils.sphere((float(numbers[4]), float(numbers[5]), 0), radius, material=stuff)
    body.state.mass = mass
    body.state.inertia = Vector3(1, 1, 1) * mass * radius**2 / 2
    body.state.blockedDOFs = 'zXY'
    discs.append(O.bodies.append(body))
for place, axis, sense in ((0, 1, 1), (0, 0, 1), (value['width'], 0, -1)):
    O.bodies.append(utils.wall(place, axis=axis, sense=sense, material=stuff))
x0, x1, y0, y1 = (value[name] for name in ('x0', 'x1', 'y0', 'y1'))
tool = O.bodies.append(utils.box(((x0 + x1) / 2, (y0 + y1) / 2, 0), ((x1 - x0) / 2, (y1 - y0) / 2, 0.05), fixed=True, material=stuff))
O.bodies[tool].state.vel = (value['speed'], 0, 0)

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Box_Aabb()], verletDist=0.002),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_MindlinPhys(betan=value['betan'], betas=value['betan'])],
                    [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(gravity=(0, -value['gravity'], 0), damping=0),
]
if value['look']:
    forces = open('force.txt', 'w')
    O.engines = O.engines[:3] + [PyRunner(command='forces.write("%d %.9g\\n" % (O.iter, O.forces.f(tool)[0]))', iterPeriod=100)] + O.engines[3:]
O.dt = value['step']
O.run(int(value['steps']), True)
if value['look']:
    forces.close()
    with open('end.txt', 'w') as out:
        for k in discs:
            out.write('%d %.17g %.17g\n' % (k, O.bodies[k].state.pos[0], O.bodies[k].state.pos[1]))
