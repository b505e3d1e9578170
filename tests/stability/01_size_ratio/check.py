"""The first bounce has the set restitution, and gives the large sphere the velocity m/M (1 + e) v.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "a step chosen by one sphere, a mass 8000 times that"
G = 9.81


def speed_at_touch(frame):
    """Relative speed where the gap closes, from the speed and the gap of a flight under gravity
    (the large one rests)."""
    large, grain = frame[0], frame[1]
    gap = grain.x[2] - large.x[2] - large.radius - grain.radius
    return ((grain.v[2] - large.v[2])**2 + 2.0*G*gap)**0.5


def check(c):
    e_asked = 0.9
    # resting overlap: (M g/(4/3 E* sqrt R))^(2/3), E* = E/(2 (1 - nu^2))
    mass, modulus = 2500.0*4.18879020478639*0.02**3, 1e7/(2.0*0.91)
    z = 0.02 - (mass*G/(4.0/3.0*modulus*0.02**0.5))**(2.0/3.0)
    run = c.run("scene.dem", {"insert/large/positions": "((0 0 %.17g))" % z,
                              "insert/grain/positions": "((0 0 %.17g))" % (z + 0.041)})
    if not c.runs_to_end(run):
        return
    frames = run.snapshots()
    apart = [f[1].x[2] - f[0].x[2] > f[0].radius + f[1].radius for f in frames]
    touch = apart.index(False)
    part = apart.index(True, touch)
    before, after = frames[touch - 1], frames[part]
    v = speed_at_touch(before)
    e = speed_at_touch(after)/v
    # round-off of a fall from rest, and z
    c.near("speed at touch, m/s", v, (2.0*G*0.02)**0.5, 1e-4*v)
    c.near("restitution of the first bounce", e, e_asked, 0.01)
    kick = before[0].v[2] - after[0].v[2]
    wanted = before[1].mass/before[0].mass*(1.0 + e)*v
    c.near("velocity of the large sphere over m/M (1 + e) v", kick/wanted, 1.0, 0.01)
