"""Symmetry planes of the mesh are frictionless walls of the particles.

- A spinning sphere bounces off patches of type symmetryPlane and symmetry as off a wall, and keeps its spin and its
  velocity along them; with the same bits on two ranks. The log names the patches.
- The scene can make such a patch a wall with friction, or an outlet.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

case = Case(source="hydrostatic")
case.box((0.02, 0.02, 0.02), (10, 10, 10),
         {"left": ("symmetryPlane", "x-"), "right": ("symmetry", "x+"), "front": ("symmetryPlane", "y-"),
          "back": ("symmetryPlane", "y+"), "bottom": ("wall", "z-"), "top": ("wall", "z+")})
case.remove("constant/g")
case.edit("system/controlDict", endTime=0.04, deltaT=0.002, writeInterval=0.04)
for field, wall in (("U", "noSlip"), ("p", "zeroGradient")):
    case.sub(f"0/{field}", r"boundaryField(.|\n)*", f"""boundaryField
{{ ".*" {{ type {wall}; }} "left|front|back" {{ type symmetryPlane; }} right {{ type symmetry; }} }}
""")
case.run("decomposePar")


def bounce(left="", outlets="", ranks=1):
    """Run a sphere of 1 mm that moves from the middle to the left, 7 mm, and then to the right."""
    case.remove("0.04")
    case.properties("glass { density 2500; youngsModulus 1e6; } steel { density 7800; youngsModulus 1e6; }",
                    "hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } rollingConstant { friction 0.1; }",
                    """one { type list; material glass; diameter 1e-3; positions ((0.0075 0.009 0.011));
    velocities ((-1 0.05 0.03)); spins ((20 -30 40)); }""", "rho 1000; twoWay no;",
                    f'walls {{ "top|bottom" {{ material steel; }} {left} }} {outlets}')
    case.run("demPimpleFoam", ranks=ranks)


def motion():
    """Velocity and spin of the sphere at the end."""
    return [*case.field("0.04/lagrangian/particles/U")[0], *case.field("0.04/lagrangian/particles/omega")[0]]


along = [0.05, 0.03, 20, -30, 40]                     # velocity along the planes, and spin
bounce()
vx, *kept = motion()
claim_ran("runs", case)
claim("the log names the patches",
      case.found(r"^Suna: frictionless walls, as symmetry planes: 4?\(left right front back\)"))
claim("velocity along the planes and spin stay, exactly", kept == along, kept)
# two bounces: 0.9^2 m/s; Hertz with `dry` to 1 % at the step that the core chooses
claim("two bounces with the restitution (1 %)", close(vx, -0.81, 0.01), vx)
bits = snapshot_hash(case/"0.04/uniform/dem.snapshot")
bounce(ranks=2)
claim("the same bits on two ranks", snapshot_hash(case/"processor0/0.04/uniform/dem.snapshot") == bits)

bounce("left { material glass; }")
vx, *kept = motion()
claim("an entry of walls makes it a wall with friction",
      kept[0] != 0.05 and kept[3] != -30 and case.found(r"symmetry planes: 3?\(right front back\)"), kept)
bounce("left { material glass; frictionless yes; }")
vx, *kept = motion()
claim("... or without, where it says so", kept == along, kept)
bounce(outlets="outlets { out { patch left; } }")
claim("particles leave through it where outlets names it", case.found("^Suna: 0 particles, .* DEM steps"))
finish()
