"""Restitution is 1 at any contact phase; a step 20 times too long is refused, and stopped where
forced.

SPDX-License-Identifier: GPL-3.0-or-later
"""
HARD = "500 m/s, and a step 20 times too long"
M, V = 7850.0*4.18879020478639e-9, 500.0
# s, Hertz: 2.87 (m^2/(R E*^2 v))^(1/5)
CONTACT = 2.8683*(M*M/(1e-3*(208e9/(2.0*0.91))**2*V))**0.2


def check(c):
    dt, out = CONTACT/50.0, []
    for phase in range(16):
        run = c.run("scene.dem", {"time/step": dt, "time/end": 250*dt, "write/interval": 250*dt,
                                  "insert/ball/positions": "((0 0 %.17g))" %
                                  (1.05e-3 + V*dt*phase/16.0)}, name="phase%d" % phase)
        if not c.runs_to_end(run):
            return
        out.append(run.snapshots()[-1][0].v[2]/V)
    c.near("restitution, lowest of 16 phases", min(out), 1.0, 0.01)
    c.near("restitution, highest", max(out), 1.0, 0.01)
    long = {"time/step": 20.0*dt, "time/end": 600*dt, "write/interval": 600*dt}
    run = c.run("scene.dem", long, name="long")
    c.holds("a step 20 times too long is refused by name",
            run.status != 0 and "exceeds" in run.err and "contact time" in run.err, run.err)
    # forced: a run that passes the limits check gains no energy
    forced = dict(long, **{"time/force": "yes"})
    for watches, extra in (("maxCreated 0.05", {"time/maxCreated": 0.05, "write/energy": 30*dt}),
                           ("maxSpeed 505", {"time/maxSpeed": 505.0})):
        best, stopped, said = 0.0, 0, ""
        for phase in range(8):
            run = c.run("scene.dem", dict(forced, **extra,
                **{"insert/ball/positions": "((0 0 %.17g))" % (1.05e-3 + V*20*dt*phase/8.0)}),
                        name="%s_%d" % (watches.split()[0], phase))
            if run.status == 0:
                best = max(best, run.snapshots()[-1][0].v[2]/V)
            else:
                stopped, said = stopped + 1, run.err
        # energy of 0.05, speed of its root; 505 m/s
        c.below("forced, %s: highest restitution of those that end" % watches, best,
                1.05**0.5 if "Created" in watches else 1.01)
        c.holds("... %d of 8 stopped; particle, position and limit named, last good state written" %
                stopped,
                stopped > 0 and "particle 0" in said and "(0 0 " in said
                and watches.split()[0] in said and "lastGood.dem" in said, said)
