# yade_scene.py -- a scene of scene.py in YADE: `yade -j1 -n -x yade_scene.py` in a folder with
# job.json; writes frames.dump, and says "done". Velocities of a frame are half a step old: YADE's
# are mid-step velocities.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math

with open("job.json") as text:
    job = json.load(text)
hysteresis, moment = job["law"] == "hysteresis", bool(job["rolling"])
low, high = job["box"]
if job["periodic"]:
    O.periodic = True
    O.cell.setBox(*(h - l for l, h in zip(low, high)))


def material(density, rigid=False):
    if hysteresis:
        s = job["spring"]
        k = s["stiffness"]
        return LudingMat(density=density, frictionAngle=math.atan(job["friction"]), k1=k,
                         kp=k*s["unloading"], kc=k*s["adhesion"], ks=k, PhiF=s["depth"], G0=0.0)
    return FrictMat(density=density, young=1e30 if rigid else job["young"], poisson=job["poisson"],
                    frictionAngle=math.atan(job["friction"]))


kinds, sways = {}, []
for g in job["grains"]:
    if g["density"] not in kinds:
        kinds[g["density"]] = O.materials.append(material(g["density"]))
    b = O.bodies[O.bodies.append(sphere([c - l for c, l in zip(g["x"],
        low if job["periodic"] else (0, 0, 0))], 0.5*g["diameter"], fixed=g["fixed"],
                                        material=kinds[g["density"]]))]
    b.state.vel, b.state.angVel = Vector3(g["v"]), Vector3(g["w"])
count = len(O.bodies)
first = next(iter(kinds.values()))
for p in job["planes"]:
    axis = "xyz".index(p["axis"])
    at = [0.0, 0.0, 0.0]
    at[axis] = p["at"]
    O.materials.append(material(2500.0, p["rigid"]))
    n = O.bodies.append(wall(at, axis, sense=int(p["side"]), material=O.materials[-1]))
    if p["sway"]:
        sways.append((n, p["sway"]))
for t in job["triangles"]:
    O.bodies.append(facet(t, fixed=True, material=first))

if hysteresis:
    physics, law = Ip2_LudingMat_LudingMat_LudingPhys(), Law2_ScGeom_LudingPhys_Basic()
else:
    words = dict(en=job["restitution"], es=job["restitution"]) if job["restitution"] < 1.0 else {}
    if moment:
        words.update(krot=job["more"]["krot"], ktwist=job["more"]["ktwist"],
                     eta=job["rolling"]["share"])
    words.update(job["more"].get("physics", {}))
    physics, law = Ip2_FrictMat_FrictMat_MindlinPhys(**words), Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=moment)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb()],
                          allowBiggerThanPeriod=True, verletDist=job["more"].get("verlet", -0.5)),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=not hysteresis
        and not moment), Ig2_Facet_Sphere_ScGeom(hertzian=not hysteresis and not moment)],
        [physics], [law]),
]
for n, s in sways:
    O.engines += [HarmonicMotionEngine(ids=[n], A=Vector3(s["amplitude"]),
                                       f=Vector3(3*[s["frequency"]]), fi=Vector3(3*[-0.5*math.pi]))]
O.engines += [NewtonIntegrator(damping=job["more"].get("damping", 0.0),
                               gravity=Vector3(job["gravity"])),
              PyRunner(command="look(O.iter + 1)", iterPeriod=job["looks"],
                       firstIterRun=job["looks"] - 1)]
out = open("frames.dump", "w")


def look(step):
    """Positions at the end of the step, forces at its start; weight is added, which its table of
    forces lacks."""
    out.write("ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: ATOMS\n" % (step, count))
    for k in range(count):
        b = O.bodies[k]
        f = O.forces.f(k) + (Vector3(0, 0, 0) if job["grains"][k]["fixed"]
                             else b.state.mass*Vector3(job["gravity"]))
        x = b.state.pos + (Vector3(low) if job["periodic"] else Vector3(0, 0, 0))
        out.write("%d" % (k + 1) + "".join(" %.17g" % c for v in (x, b.state.vel, b.state.angVel, f)
                                           for c in v) + "\n")


O.dt = job["step"]
exec(job["more"].get("code", ""))
look(0)
O.run(job["steps"], wait=True)
out.close()
print("\ndone", O.iter, flush=True)
