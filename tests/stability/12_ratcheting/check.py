"""A contact under an oscillating normal force does not creep.

At the smallest normal force the friction limit equals the weight, so the force of inertia, in
proportion to the square of the frequency, slips: the motion is slow, and a faster one shows this
dependence.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "friction springs with an oscillating limit and stiffness"
MASS, MU = 2500.0*4.18879020478639e-9, 0.3
# E*, G* of glass on glass
MODULUS, SHEAR = 1e7/(2.0*0.91), 1e7/(4.0*1.7*1.3)
DEPTH, SWING = 1e-5, 5e-6


def laws():
    """name, scene, mean force [N], tangential stiffness there [N/m], amplitude that halves the
    force [m]"""
    yield "hooke and linear", "linear.dem", 1000.0*DEPTH, 1000.0*2.0/7.0, SWING
    force = 4.0/3.0*MODULUS*1e-3**0.5*DEPTH**1.5
    yield "hertz and mindlin", "mindlin.dem", force, 8.0*SHEAR*(1e-3*DEPTH)**0.5, DEPTH*(1.0 -
        0.5**(2.0/3.0))
    yield "hertz and mindlinIncremental", "incremental.dem", force, 8.0*SHEAR*(1e-3*DEPTH)**0.5, DEPTH*(1.0 - 0.5**(2.0/3.0))


def check(c):
    for law, scene, force, stiffness, swing in laws():
        pull = 2.0*0.5*MU*force/MASS                                             # on both plates
        # long form: laws that must not creep, with the slow motion
        cycles = {25: 10000 if c.long and "Incremental" not in law else 60, 50: 60}
        share = {f: drift(c, scene, f, cycles[f], pull, swing)/(MU*force/stiffness)
                 for f in ((25, 50) if "Incremental" not in law else (25,))}
        what = "%s: drift per cycle over mu F_n/k_t" % law
        if law.endswith("Incremental"):
            c.holds("%s: %.3g, a law that unloads in separation and does not reload (documented)" %
                    (what, share[25]), share[25] < 1.0)
        else:
            c.below(what, share[25], 1e-4)
            c.holds("%s: at twice the frequency it grows no faster than the inertia: %.2g" %
                    (what, share[50]), share[50] < 5.0*share[25] + 1e-6)


def drift(c, scene, frequency, cycles, pull, swing):
    """Drift in m a cycle, from the tenth cycle on."""
    entries = {"effects/gravity/acceleration": (pull, 0, 0), "time/end": 0.02 + cycles/frequency,
               "write/interval": 10.0/frequency}
    for plate, way in (("below", swing), ("above", -swing)):
        entries.update({"walls/%s/motion/amplitude" % plate: (0, 0, way),
                        "walls/%s/motion/frequency" % plate: frequency})
    run = c.run(scene, entries, name="%s%d" % (scene.split(".")[0], frequency))
    if not c.runs_to_end(run):
        return float("nan")
    frames = [f for f in run.snapshots() if f.time > 9.9/frequency][:-1]
    return abs(frames[-1][0].x[0] - frames[0][0].x[0])/((frames[-1].time -
        frames[0].time)*frequency)
