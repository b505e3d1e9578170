"""Absorbing walls of a duct remove and count the particles that touch them.

- The balances of volume, mass and exchange close.
- A restarted run has the same bits, and two ranks have the same counts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def flows(folder):
    """The rows of flows.csv at the end: {name: (way, number, mass)}."""
    table = case.table(f"{folder}/flows.csv")
    rows = zip(*(table[name] for name in ("time", "name", "way", "particles", "mass")))
    return {name: row for time, name, *row in rows if time == 0.2}


def balance(k):
    """What came less what left: number (k = 1) or mass (2)."""
    return sum(row[k] if row[0] == "in" else -row[k] for row in flows("postProcessing/dem/0").values())


case = Case("duct", "flows")
case.sub("constant/demProperties", "^outlets", "walls { walls { material glass; absorb yes; } }\noutlets")
case.sub("constant/demProperties", "hertz {}", "gravity { acceleration (0 0 -9.81); } hertz {}")
claim_runs("runs", case)
way, number, mass = flows("postProcessing/dem/0")["walls"]
claim("the walls absorb some, counted under the name of the patch", way == "out" and number > 20)
claim("the exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("the fluid has the volume of the particles present", worst(case.log(), "volume error") < 1e-12)
masses = case.field("0.2/lagrangian/particles/mass")
claim("the particles present are those inserted less those removed", len(masses) == balance(1))
claim("the mass present is that inserted less that removed", close(masses.sum(), balance(2), 1e-8))

for name in ("0.1", "0.2", "postProcessing/dem/0/flows.csv"):
    case.copy(case/name, "straight/" + Path(name).name)
case.remove("0.2")
case.edit("system/controlDict", startFrom="latestTime")
claim_runs("continues from halfway", case)
for field in ("lagrangian/particles/positions", "lagrangian/particles/U", "U", "voidFraction"):
    claim(f"the same bits after a restart, {field}", agrees(case/"0.2"/field, case/"straight/0.2"/field))

case.remove("0.[12]*", "postProcessing")
case.edit("system/controlDict", startFrom="startTime")
case.run("decomposePar")
claim_runs("runs on two ranks", case, ranks=2)
claim("the same counts on two ranks",
      lambda: flows("postProcessing/dem/0")["walls"][1] == flows("straight")["walls"][1])
finish()
