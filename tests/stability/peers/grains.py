"""grains.py -- the cases without a fluid, 01 to 23: each a scene (scene.py) that every code runs,
and the criterion of ../NN_name/check.py on the frames returned.

A case is a function of c: c.run(scene, name) -> Run, or None after a row with the cause of the
failure; c.below, c.near, c.holds: rows.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import random

from scene import Scene, Sway, size

G, R, D = 9.81, 1e-3, 2e-3
MASS = 2500.0*math.pi/6.0*D**3
MODULUS, SHEAR = 1e7/(2.0*0.91), 1e7/(4.0*1.7*1.3)           # E*, G* of glass on glass
CODES = ("liggghts", "lammps", "yade", "suna")


def rest(mass=MASS, radius=R, modulus=MODULUS):
    """Overlap on a plane under its weight, Hertz [m]."""
    return (mass*G/(4.0/3.0*modulus*radius**0.5))**(2.0/3.0)


def size_ratio(c):
    """A grain of 1 mm radius falls 20 mm onto a sphere of 20 mm that rests."""
    mass = 2500.0*math.pi/6.0*0.04**3
    z = 0.02 - rest(mass, 0.02)
    s = Scene(step=5e-6, end=0.068, every=1e-4, gravity=(0, 0, -G))
    s.grain(40e-3, (0, 0, z))
    s.grain(D, (0, 0, z + 0.041))
    s.plane("z", 0.0, 1)
    run = c.run(s)
    if not run:
        return
    frames = run.frames
    gaps = [f.grains[1].x[2] - f.grains[0].x[2] - 0.021 for f in frames]
    touch = next(k for k, gap in enumerate(gaps) if gap <= 0.0)
    part = next(k for k in range(touch, len(gaps)) if gaps[k] > 0.0)
    speed = [((frames[k].grains[1].v[2] - frames[k].grains[0].v[2])**2 + 2.0*G*gaps[k])**0.5
             for k in (touch - 1, part)]
    e = speed[1]/speed[0]
    c.near("restitution of the first bounce", e, 0.9, 0.01)
    kick = frames[touch - 1].grains[0].v[2] - frames[part].grains[0].v[2]
    c.near("velocity the large one gets, over m/M (1 + e) v with this e",
           kick/(MASS/mass*(1.0 + e)*speed[0]), 1.0, 0.01)


def groove(c):
    """A grain in a groove of 90 degrees inclined by 10 rolls on two lines."""
    sine, cosine = math.sin(math.radians(10.0)), math.cos(math.radians(10.0))
    s = Scene(step=1e-5, end=0.36, every=0.004, friction=0.5,
              gravity=(G*sine, -G*cosine/2**0.5, -G*cosine/2**0.5))
    s.grain(D, (0, R, R))
    s.plane("y", 0.0, 1)
    s.plane("z", 0.0, 1)
    run = c.run(s, "groove")
    if not run:
        return
    way, frames = 0.05, run.frames
    wanted = (2.0*way/(G*sine/(1.0 + 2.0/5.0*2.0)))**0.5
    late = next((k for k, f in enumerate(frames) if f.grains[0].x[0] > way), None)
    if not late:
        return c.holds("groove: it leaves", False, "it hangs at %.3g m" % run.last.grains[0].x[0])
    a, b = frames[late - 1], frames[late]
    share = (way**0.5 - a.grains[0].x[0]**0.5)/(b.grains[0].x[0]**0.5 - a.grains[0].x[0]**0.5)
    c.near("groove: time over analytic time", (a.time + share*(b.time - a.time))/wanted, 1.0, 0.05)


def pocket(c):
    """A grain on a shaking floor between three spheres twenty times as large that do not move; 10^6
    steps."""
    s = Scene(step=1e-5, end=10.0, every=0.0123, friction=0.5, gravity=(0, 0, -G),
              box=((-10, -10, -10), (10, 10, 10)),
              more={"bins": " binsize 0.5"})
    for x, y in ((0.023094010767585, 0.0), (-0.0115470053837925, 0.02),
                 (-0.0115470053837925, -0.02)):
        s.grain(40e-3, (x, y, 0), fixed=True)
    s.grain(D, (0.0003, 0.0002, 0), w=(100, 50, -200))
    s.plane("z", -0.004, 1, sway=Sway((0.0002, 0.0001, 0.001), 50.0))
    run = c.run(s, "pocket")
    if not run:
        return
    grain = [f.grains[3] for f in run.frames[1:]]
    weight = (0.0, 0.0, -MASS*G)
    hang = sum(size(g.v) < 1e-6 and size([a - b for a, b in zip(g.f, weight)]) < 1e-12*MASS*G
               for g in grain)
    still = most = 0
    for a, b in zip(grain, grain[1:]):
        still = still + 1 if math.dist(a.x, b.x) < 1e-6 else 0
        most = max(most, still)
    c.below("pocket: looks at which it hangs without a force", hang, 0)
    c.below("pocket: looks in a row with it in one place", most, 1)
    c.below("pocket: largest speed, m/s", max(size(g.v) for g in grain), 5.0)


def gap(c):
    groove(c)
    pocket(c)


STEEL = dict(young=208e9, restitution=1.0, impact=500.0)
V = 500.0
CONTACT = 2.8683*((7850.0*math.pi/6.0*D**3)**2/(R*(208e9/(2.0*0.91))**2*V))**0.2


def impact(c, name, step, phases, more=None):
    """Spheres side by side hit a plane at 500 m/s, each at a different phase of the step."""
    s = Scene(step=step, end=600*CONTACT/50 if phases == 8 else 250*step, every=step,
              more=more or {}, box=((-0.05, -0.01, -0.01), (0.3, 0.01, 0.05)), **STEEL)
    for k in range(phases):
        s.grain(D, (0.01*k, 0, 1.05e-3 + V*step*k/phases), v=(0, 0, -V), density=7850.0)
    s.plane("z", 0.0, 1)
    return c.start(s, name)


# how each code handles a step that is too long
GUARDS = {"liggghts": [("check/timestep/gran",
                        {"liggghts": ["fix guard all check/timestep/gran 1 0.2 0.2 error yes"]})],
          "lammps": [("dt/reset of R/20",
                      {"lmp": ["fix guard all dt/reset 1 NULL NULL 5e-5 units box"]})],
          "yade": [("GlobalStiffnessTimeStepper",
              {"yade": {"code": "O.engines = O.engines[:3] + [GlobalStiffnessTimeStepper(timeStepUpdateInterval=1)] + O.engines[3:]"}}),
                   ("0.5 PWaveTimeStep()", {"yade": {"code": "n = O.dt; O.dt = 0.5*PWaveTimeStep(); job['steps'] = int(job['steps']*n/O.dt)"}})],
          "suna": [("forced, time/maxSpeed", {"suna": {"time": "force yes; maxSpeed 505;"}})]}


def fast(c):
    run = impact(c, "right", CONTACT/50.0, 16)
    if c.ended(run):
        e = [g.v[2]/V for g in run.last.grains.values()]
        c.near("t_c/50: restitution farthest from 1, of 16 phases",
               max(e, key=lambda x: abs(x - 1.0)), 1.0, 0.01)
    long = 20.0*CONTACT/50.0
    for what, guard in [("as it is", {})] + GUARDS[c.peer]:
        run = impact(c, what.split()[0].replace("/", "_"), long, 8, guard)
        if run.status:
            c.holds("20 times that, %s: stopped with a word, or no restitution above 1.01" % what,
                    True, "stopped: " + run.complaint())
        else:
            e = [g.v[2]/V for g in run.last.grains.values()]
            c.below("20 times that, %s: stopped with a word, or no restitution above 1.01" % what,
                    max(e), 1.01)


def cup(s, x, y, z):
    for axis, top in (("x", x), ("y", y), ("z", z)):
        s.plane(axis, 0.0, 1)
        if top:
            s.plane(axis, top, -1)


def overlap(c):
    """Spheres with initial overlaps of half a radius and more."""
    draw = random.Random(4)
    crowd = [tuple(draw.uniform(1e-3, 0.015) for _ in range(3)) for _ in range(1000)]
    for what, places in (("a pair, R/2 into each other",
            [(0.01, 0.01, 0.01), (0.0115, 0.01, 0.01)]), ("1000 at random places", crowd)):
        s = Scene(step=1e-6, end=0.01, every=1e-4, box=((-0.02, -0.02, -0.02), (0.05, 0.05, 0.05)),
                  impact=10.0)
        for x in places:
            s.grain(D, x)
        cup(s, 0.03, 0.03, 0.03)
        run = c.start(s, what.split()[1].strip(","))
        if run.status and len(run.frames) < 2:
            c.holds(what + ": refused", True, "refused: " + run.complaint())
            continue
        how = run.complaint() if run.status else ""
        c.below(what + ": refused, or largest speed, m/s",
                max(size(g.v) for f in run.frames for g in f.grains.values()), 10.0, how)
        c.below(what + ": refused, or spheres no longer in the box",
            len(places) - sum(all(0.0 < x < 0.03 for x in g.x) for g in run.last.grains.values()),
            0, how)


def same_place(c):
    """Two centres at one point."""
    s = Scene(step=1e-6, end=1e-3, every=1e-4, box=((-0.05, -0.05, -0.05), (0.05, 0.05, 0.05)))
    s.grain(D, (0.001, 0.001, 0.001))
    s.grain(D, (0.001, 0.001, 0.001))
    run = c.start(s)
    if run.status and not run.frames[1:]:
        return c.holds("refused with a word, or they part with finite speeds",
                       "nan" not in run.said.lower(), "refused: " + run.complaint())
    if not run.finite():
        return c.holds("refused with a word, or they part with finite speeds", False,
            "not a number in place or speed" + (", then: " + run.complaint() if run.status
                                                else ", and runs on"))
    apart = math.dist(run.last.grains[0].x, run.last.grains[1].x)
    c.holds("refused with a word, or they part with finite speeds", apart > D,
            "%.3g m apart after 1 ms: no force" % apart)


def ends(c):
    """Restitution 0 and 1."""
    s = Scene(step=2.6e-7, end=0.005, every=2e-5, restitution=0.0,
              box=((-0.02, -0.02, -0.02), (0.02, 0.02, 0.05)))
    s.grain(D, (0, 0, 1.05e-3), v=(0, 0, -1))
    s.plane("z", 0.0, 1)
    run = c.run(s, "zero")
    if run:
        c.below("e = 0: rebound speed over impact speed", abs(run.last.grains[0].v[2]),
                0.02)
    for what, fit in (("", False), (", damping by its fit", True))[:2 if c.peer == "lammps" else 1]:
        s = Scene(step=2e-6, end=5.0, every=0.02, restitution=1.0, friction=0.0,
                  box=((-0.002, -0.002, -0.002), (0.005, 0.005, 0.005)), more={"lammps fit": fit})
        s.grain(D, (0.00105, 0.0011, 0.0012), v=(0.6, -0.4, 0.3))
        cup(s, 0.00221, 0.00223, 0.00227)
        run = c.run(s, "fit" if fit else "one")
        if run:
            start = run.frames[0].kinetic(s)
            free = [f for f in run.frames[1:] if all(R < x < top - R
                for x, top in zip(f.grains[0].x, (0.00221, 0.00223, 0.00227)))]
            c.below("e = 1, 10^4 bounces%s: largest drift of kinetic energy" % what,
                    max(abs(f.kinetic(s)/start - 1.0) for f in free), 1e-4)


def corner(c):
    """A sphere rolls into a corner of three planes and rests, 10^6 steps."""
    g = (-3.0, -4.0, -8.45)
    s = Scene(step=1e-5, end=10.0, every=0.5, gravity=g,
              box=((-0.01, -0.01, -0.01), (0.1, 0.1, 0.1)))
    s.grain(D, (0.011, 0.009, 0.00099999), v=(-0.7071, -0.7071, 0), w=(707.1, -707.1, 0))
    cup(s, None, None, None)
    run = c.run(s)
    if run:
        last = run.last.grains[0]
        c.below("kinetic energy at last, J", run.last.kinetic(s), 1e-16)
        c.below("sum of contacts and weight, over the weight", size(last.f)/(MASS*size(g)), 1e-8)
        c.below("distance from a wall it does not touch, m", max(x - R for x in last.x), 0.0)


def pile(c):
    """500 spheres settle in a cup, then rest for 30000 steps."""
    draw = random.Random(11)
    s = Scene(step=1e-5, end=0.9, every=0.03, friction=0.5, restitution=0.2, gravity=(0, 0, -G),
              box=((-0.005, -0.005, -0.005), (0.025, 0.025, 0.06)),
              rolling={"share": 0.05, "stiffness": 300.0, "viscous": 0.02},
              more={"yade": {"krot": 2e-4, "ktwist": 2e-4, "damping": 0.2}})
    for k in range(500):
        s.grain(D, [1.2e-3 + 2.2e-3*i + draw.uniform(-5e-5, 5e-5)
                    for i in (k % 8, k//8 % 8, k//64)])
    cup(s, 0.02, 0.02, None)
    run = c.run(s)
    if not run:
        return
    still = [f for f in run.frames if f.time > 0.5999]
    heights = [sum(g.x[2] for g in f.grains.values())/500 for f in still]
    c.below("way of the centre of mass in 0.3 s, R", max(abs(h - heights[0]) for h in heights)/R,
            1e-6)
    c.below("largest speed in that time, m/s", max(size(g.v) for f in still
        for g in f.grains.values()), 1e-8)


def ratchet(c):
    """A sphere between two plates with a normal force of 0.5 to 1.5 times the mean at 25 Hz, loaded
    by half the friction limit."""
    depth = 1e-5
    force = 4.0/3.0*MODULUS*R**0.5*depth**1.5
    slip = 0.3*force/(8.0*SHEAR*(R*depth)**0.5)
    swing = depth*(1.0 - 0.5**(2.0/3.0))
    variants = {"lammps": ("mindlin", "mindlin_rescale", "mindlin/force", "mindlin_rescale/force"),
                "suna": ("mindlin", "mindlinIncremental")}
    for law in variants.get(c.peer, ("",)):
        s = Scene(step=1e-5, end=10.0, every=0.4, gravity=(2.0*0.5*0.3*force/MASS, 0, 0),
                  box=((-0.02, -0.02, -0.02), (0.02, 0.02, 0.02)),
                  more={"lammps tangential": law, "suna law": law})
        s.grain(D, (0, 0, 0.00099))
        s.plane("z", 0.0, 1, sway=Sway((0, 0, swing), 25.0))
        s.plane("z", 0.00198, -1, sway=Sway((0, 0, -swing), 25.0))
        run = c.run(s, law.replace("/", "_") or "run")
        if run:
            late = [f for f in run.frames if f.time > 0.399]
            drift = abs(late[-1].grains[0].x[0] - late[0].grains[0].x[0])/((late[-1].time -
                late[0].time)*25.0)
            c.below((law + ": " if law else "") + "drift per cycle over mu F_n/k_t, 250 cycles",
                    drift/slip, 1e-4)


def column(c):
    """200 spheres, one on the other, come to rest on a rigid floor."""
    s = Scene(step=1e-5, end=1.0, every=0.1, restitution=0.5, gravity=(0, 0, -9.80665),
              viscous=6.0*math.pi*0.06*R, box=((-0.01, -0.01, -0.01), (0.01, 0.01, 0.42)),
              impact=0.1, more={"suna": {"effects": "stokesDrag { }",
                  "top": "fluid { density 1e-9; viscosity 0.06; }"}, "yade": {"damping": 0.4}})
    for k in range(200):
        s.grain(D, (0, 0, R + D*k))
    s.plane("z", 0.0, 1, rigid=True)
    run = c.run(s)
    if run:
        last = run.last.grains
        c.near("overlap on the floor over 1.25253e-5 m", (R - last[0].x[2])/1.25253e-5, 1.0, 1e-5)
        c.near("sinking of the top over the reference",
               (0.399 - last[199].x[2])/(0.399 - 0.39599403592), 1.0, 1e-5)
        c.below("largest sum of forces on one, over the weight of all",
                max(size(g.f) for g in last.values())/(200*MASS*9.80665), 1e-5)


LEAVE = {3: (-0.07095, 0.0764, 0.99455), 5: (-0.071083, -0.030273, -0.014463, 0.12704, 0.988778),
         10: (-0.071083, -0.030273, -0.015833, -0.008885, -0.005126, -0.002986, -0.001738, 0.002671,
              0.147385, 0.985867)}


def cradle(c):
    """Rows of 3, 5 and 10 spheres in contact are hit by one; Hertz, no loss."""
    s = Scene(step=5e-7, end=0.01, every=0.01, restitution=1.0, friction=0.0,
              box=((-0.03, -0.01, -0.01), (0.05, 0.05, 0.01)))
    for row, n in enumerate(LEAVE):
        s.grain(D, (-0.002000001, 0.01*row, 0), v=(1, 0, 0))
        for k in range(n - 1):
            s.grain(D, (D*k, 0.01*row, 0))
    run = c.run(s)
    at = 0
    for n, speeds in LEAVE.items():
        if run:
            c.below("%d spheres: largest deviation of a speed, of the one that hit" % n,
                    max(abs(run.last.grains[at + k].v[0] - v) for k, v in enumerate(speeds)), 0.005)
        at += n


def reversal(c):
    """A plate oscillates in its plane under a sphere too heavy to follow."""
    depth, cycle = 1e-5, 0.01
    force = 4.0/3.0*MODULUS*R**0.5*depth**1.5
    slip = 0.3*force/(8.0*SHEAR*(R*depth)**0.5)
    swing = 5.0*slip
    s = Scene(step=2e-6, end=0.03, every=2e-5, restitution=1.0,
              box=((-0.02, -0.02, -0.02), (0.02, 0.02, 0.02)))
    s.grain(D, (0, 0, R - depth), fixed=c.peer != "suna",
            density=1e20 if c.peer == "suna" else 2500.0)
    s.plane("z", 0.0, 1, sway=Sway((swing, 0, 0), 1.0/cycle))
    run = c.run(s)
    if not run:
        return
    rows = [(f.time, f.grains[0].f) for f in run.frames[1:]]
    c.below("largest |F_t|/(mu F_n) - 1", max(math.hypot(f[0], f[1])/(0.3*abs(f[2])) - 1.0
                                              for _, f in rows), 1e-9)
    loop = [(swing*math.sin(2.0*math.pi*t/cycle), -f[0]) for t, f in rows if t > 2.0*cycle - 1e-9]
    area = sum(0.5*(f + g)*(x - y) for (x, f), (y, g) in zip(loop, loop[1:]))
    c.near("area of the loop over 4 mu F_n (A - mu F_n/k_t)",
           abs(area)/(4.0*0.3*force*(swing - slip)), 1.0, 0.01)


def spin(c):
    """A sphere slides along x on a floor until it rolls."""
    s = Scene(step=2e-6, end=0.05, every=0.005, gravity=(0, 0, -G),
              box=((-0.02, -0.02, -0.02), (0.02, 0.02, 0.02)))
    s.grain(D, (0, 0, R - rest()), v=(0.1, 0, 0))
    s.plane("z", 0.0, 1)
    run = c.run(s)
    if run:
        first, last = run.frames[1], run.last.grains[0]
        c.near("spin about y after 5 ms over 5/2 mu g t/R",
               first.grains[0].w[1]/(2.5*0.3*G*first.time/R), 1.0, 0.01)
        c.near("velocity at last over 5/7 of the first", last.v[0]/(5.0/7.0*0.1), 1.0, 0.005)
        c.near("R w_y over v", R*last.w[1]/last.v[0], 1.0, 0.005)
