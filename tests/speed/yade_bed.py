# yade_bed.py -- a bed of spheres in YADE, for speed.py: `yade -j1 -n -x yade_bed.py` in a folder
# with job.json and data.txt.
#
# Particles: data.txt, a line each: id, diameter, position, velocity, spin. Timing starts after one
# step of zero length, in which contacts (and bonds) are found, so the first sort, of order N^2 at
# worst, does not count. Prints
# done SECONDS KINETIC BONDS        processor time of the steps [s], kinetic energy [J], bonds made
# and writes the final positions to end.txt: id, diameter, position.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import time

with open("job.json") as text:
    job = json.load(text)
with open("data.txt") as text:
    particles = [[float(word) for word in line.split()]
                 for line in text] if job["particles"] else []

# YADE's cells are periodic along z, too: high enough that the bed does not touch its image, the
# floor slightly above z = 0
LIFT = 5e-3
O.periodic = True
O.cell.setBox(job["x"], job["y"], max([p[4] + p[1] for p in particles], default=0.01) + 3.0*LIFT)

bonded = "bond" in job
if bonded:
    material = CohFrictMat(young=job["young"], poisson=job["ratio"], density=job["density"],
                           frictionAngle=math.atan(job["friction"]),
                           isCohesive=True, momentRotationLaw=True, normalCohesion=1e30,
                           shearCohesion=1e30)
    touch = Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=job["bond"]["reach"])
    bounds = Bo1_Sphere_Aabb(aabbEnlargeFactor=job["bond"]["reach"])
    physics = Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)
    laws = [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]
    base = Ig2_Box_Sphere_ScGeom6D()
else:
    material = FrictMat(young=job["young"], poisson=job["poisson"], density=job["density"],
                        frictionAngle=math.atan(job["friction"]))
    touch = Ig2_Sphere_Sphere_ScGeom()
    bounds = Bo1_Sphere_Aabb()
    physics = Ip2_FrictMat_FrictMat_MindlinPhys(betan=job["damping"], betas=job["damping"])
    laws = [Law2_ScGeom_MindlinPhys_Mindlin()]
    base = Ig2_Box_Sphere_ScGeom()
O.materials.append(material)
below = material
if not bonded:
    # YADE treats a flat body as a sphere of its partner's size, half the reduced radius: with E*
    # and G* larger by sqrt(2), by its means
    # (sum of compliances; halves of G and nu, k_t ~ G/(2 - nu)), the contact with the floor behaves
    # as with a plane
    nu, less = job["poisson"], 2.0**0.5 - 1.0
    a, b = (1.0 + nu)/(less*(1.0 - nu**2)), 2.0*2.0**0.5/(2.0 - nu)
    other = (1.0 + a - b*(2.0 - 0.5*nu))/(a - 0.5*b)
    below = FrictMat(young=job["young"]*(1.0 - other**2)/(less*(1.0 - nu**2)), poisson=other,
                     density=job["density"],
                     frictionAngle=math.atan(job["friction"]))
    O.materials.append(below)

for p in particles:
    b = O.bodies[O.bodies.append(sphere((p[2], p[3], p[4] + LIFT), 0.5*p[1], material=material))]
    b.state.vel, b.state.angVel = Vector3(p[5:8]), Vector3(p[8:11])
# a plane's bounds are infinite, which ends YADE in a periodic cell: a box wider than the cell,
# which only a search along z finds
O.bodies.append(box((0.5*job["x"], 0.5*job["y"], LIFT - 1e-3), (job["x"], job["y"], 1e-3),
                    fixed=True, material=below))
floor = len(O.bodies) - 1

O.engines = [
    ForceResetter(),
    InsertionSortCollider([bounds, Bo1_Box_Aabb()], verletDist=job["verlet"], sortAxis=2,
                          allowBiggerThanPeriod=True),
    InteractionLoop([touch, base], [physics], laws),
    NewtonIntegrator(damping=0, gravity=(0, 0, -9.81)),
]

O.dt = 1e-30
O.step()
bonds = 0
if bonded:
    bond = job["bond"]
    for i in O.interactions:
        if not i.isReal:
            continue
        f = i.phys
        if floor in (i.id1, i.id2):
            f.normalAdhesion = f.shearAdhesion = 0.0
            f.momentRotationLaw, f.cohesionBroken = False, True
            continue
        f.kn, f.ks, f.kr, f.ktw = bond["kn"], bond["ks"], bond["kr"], bond["ktw"]
        f.unp = i.geom.penetrationDepth                   # at rest as they are
        f.normalForce = f.shearForce = Vector3(0, 0, 0)
        f.normalAdhesion = f.shearAdhesion = 1e30
        f.maxRollPl = f.maxTwistPl = -1.0
        f.momentRotationLaw, f.cohesionBroken = True, False
        bonds += 1
    touch.interactionDetectionFactor = 1.0                # of what meets from now on
O.dt = job["step"]

begin = time.process_time()
if job["steps"] > 0:
    O.run(job["steps"], wait=True)
seconds = time.process_time() - begin

kinetic = sum(0.5*b.state.mass*b.state.vel.squaredNorm() +
              0.5*b.state.inertia[0]*b.state.angVel.squaredNorm()
              for b in O.bodies if isinstance(b.shape, Sphere))
with open("end.txt", "w") as out:
    for b in O.bodies:
        if isinstance(b.shape, Sphere):
            x = b.state.pos
            out.write(f"{b.id} {2.0*b.shape.radius!r} {x[0]!r} {x[1]!r} {x[2] - LIFT!r}\n")
print(f"\ndone {seconds:.6f} {kinetic:.10g} {bonds}", flush=True)
