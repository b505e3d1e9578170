"""Seams of a flat surface have no effect; a concave edge is two contacts, a convex edge one.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import sys
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import surfaces                                              # noqa: E402
HARD = "seams, slivers and edges of triangles"
G, MU, U = 9.81, 0.3, 1.0
MASS = 2500.0*4.18879020478639e-9
# overlap under the weight, Hertz
REST = (MASS*G/(4.0/3.0*1e7/(2.0*0.91)*1e-3**0.5))**(2.0/3.0)
EDGE = [((-0.01, 0, 0), (0.01, 0, 0), (0.01, 0.01, 0)), ((-0.01, 0, 0), (0.01, 0.01, 0),
    (-0.01, 0.01, 0)),
        ((-0.01, 0, 0), (0.01, 0, 0), (0.01, 0, 0.01)), ((-0.01, 0, 0), (0.01, 0, 0.01),
            (-0.01, 0, 0.01))]


def slide(c, scene, name, friction, end):
    os.makedirs(c.place(name), exist_ok=True)
    surfaces.write(os.path.join(c.place(name), "floor.stl"),
                   surfaces.flat((-0.05, -0.02), (0.15, 0.02), 9))
    start = "((-0.03 0.0003 %.17g))" % (1e-3 - REST)
    return c.run(scene, {"effects/mindlin/friction": friction, "insert/ball/positions": start,
                         "time/end": end}, name=name)


def slip_time(run):
    """Time at which the line of rising spin reaches the final spin."""
    frames = run.snapshots()
    last, early = frames[-1][0].w[1], frames[30]
    return last/(early[0].w[1]/early.time)


def edge(c, name, triangles, ball, gravity):
    os.makedirs(c.place(name), exist_ok=True)
    surfaces.write(os.path.join(c.place(name), "edge.stl"), triangles)
    run = c.run("edges.dem", {"insert/ball/positions": ball,
                              "effects/gravity/acceleration": gravity}, name=name)
    return int(re.findall(r"(\d+) contacts", run.out)[-1]) if run.status == 0 else run.err


def check(c):
    made = surfaces.flat((-0.05, -0.02), (0.15, 0.02), 9)
    c.above("largest aspect of a triangle", max(map(surfaces.aspect, made)), 50.0)
    run = slide(c, "scene.dem", "smooth", 0, 0.06)
    if c.runs_to_end(run):
        weight = MASS*G
        c.below("mu 0: force on the wall less m g, over it",
                max(abs(-row["fz_now"]/weight - 1.0) for row in run.wall("floor")), 1e-6)
        c.below("mu 0: largest vertical velocity, m/s", max(abs(f[0].v[2])
            for f in run.snapshots()), 1e-6)
        c.below("mu 0: velocity lost, m/s", abs(run.snapshots()[-1][0].v[0] - U), 1e-6)
    rough, plane = slide(c, "scene.dem", "rough", MU, 0.12), slide(c, "plane.dem", "plane", MU,
        0.12)
    if c.runs_to_end(rough) and c.runs_to_end(plane):
        wanted = 2.0*U/(7.0*MU*G)
        c.near("mu 0.3: time of slip over that on a plane", slip_time(rough)/slip_time(plane), 1.0,
               0.005)
        c.near("mu 0.3: time of slip over 2 u/(7 mu g)", slip_time(rough)/wanted, 1.0, 0.005)
    inside, g = "((0.0001 0.00099999 0.00099999))", 6.93671752
    c.equal("concave edge: contacts", edge(c, "inward", EDGE, inside, (0, -g, -g)), 2)
    c.equal("convex edge: contacts", edge(c, "outward", EDGE,
        "((0.0001 %.17g %.17g))" % (-0.70710678*0.99999e-3, -0.70710678*0.99999e-3), (0, g, g)), 1)
    # an overlap of a hundredth of a radius, so that both faces are nearer than a radius
    pressed = 0.01e-3
    c.equal("on a face, a twentieth of a radius from a convex edge: contacts",
            edge(c, "beside", EDGE, "((0.0001 0.00005 %.17g))" % (pressed - 1e-3),
            (0, 0, G*(pressed/REST)**1.5)), 1)
