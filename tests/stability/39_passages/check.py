"""Particles enter and leave with the fluid; a restarted run has the results of the uninterrupted
one (tests/coupled/flows).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import fluid                                                 # noqa: E402
HARD = "particles that enter and leave, and a restart between"


def check(c):
    if not fluid.there():
        return c.skip("passages", "no demPimpleFoam")
    case = fluid.from_folder(c, "duct", "flows")
    if not case.run():
        return c.holds("runs", False, case.log)
    rows = [r for r in case.table("flows.csv") if abs(r["time"] - 0.2) < 1e-9]
    there = case.particles("0.2")
    way, number = list(rows[0])[2:4]                         # in or out; particles
    count = sum((1 if r[way] == "in" else -1)*r[number] for r in rows)
    c.equal("particles present are those inserted less those removed", len(there), int(count))
    c.below("exchange error, with particles that enter and leave", case.worst("exchange error"),
            1e-12)
    straight = there
    hash_of = c.command([c.dem, "hash", os.path.join(case.folder,
        "0.2/uniform/dem.snapshot")]).out.strip()
    os.rename(os.path.join(case.folder, "0.2"), os.path.join(case.folder, "straight"))
    case.set("system/controlDict", "startFrom", "latestTime")
    if not case.command("demPimpleFoam"):
        return c.holds("continues from halfway", False, case.log)
    again = case.particles("0.2")
    c.below("restarted halfway: largest difference of positions and velocities",
            max(max(abs(a - b) for p, q in zip(straight[k], again[k]) for a, b in zip(p, q))
                for k in straight) if set(again) == set(straight) else float("nan"), 1e-12)
    c.equal("... fingerprint of particles and contacts",
        c.command([c.dem, "hash", os.path.join(case.folder,
                                               "0.2/uniform/dem.snapshot")]).out.strip(), hash_of)
