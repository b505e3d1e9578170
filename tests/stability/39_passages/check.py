"""Particles enter and leave with the fluid; a restarted run has the results of the uninterrupted
one (tests/coupled/flows).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import fluid
HARD = "particles that enter and leave, and a restart between"


def check(c):
    if not fluid.there():
        return c.skip("passages", "no demPimpleFoam")
    case = fluid.Folder(c, "duct", "flows")
    if not case.ends(c, "duct"):
        return
    flows = case.table("postProcessing/dem/0/flows.csv")
    count = sum((1 if way == "in" else -1)*n for time, way, n in zip(flows["time"], flows["way"], flows["particles"])
                if abs(time - 0.2) < 1e-9)
    straight = case.particles("0.2", "positions", "U")
    c.equal("particles present are those inserted less those removed", len(straight), int(count))
    c.below("exchange error, with particles that enter and leave", case.worst("exchange error"), 1e-12)
    state = fluid.coupled.snapshot_hash(case/"0.2/uniform/dem.snapshot")
    (case/"0.2").rename(case/"straight")
    case.edit("system/controlDict", startFrom="latestTime")
    if case.ends(c, "from halfway"):
        c.below("restarted halfway: largest difference of positions and velocities",
                fluid.coupled.difference(straight, case.particles("0.2", "positions", "U")), 1e-12)
        c.equal("... fingerprint of particles and contacts",
                fluid.coupled.snapshot_hash(case/"0.2/uniform/dem.snapshot"), state)
