"""Meshes in which a point lies in several cells are refused.

- Refused: two parts of a mesh that overlap, one inside the other or in a corner only; in demPimpleFoam, on one rank and
  on two, its -settle, and the function object.
- Refused: an overset patch.
- Accepted: parts that only touch.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


def parts(*boxes):
    """A mesh of boxes that share no faces, each (x0, y0, z0), (x1, y1, z1), cells."""
    corners, blocks, faces = [], [], []
    for k, ((x0, y0, z0), (x1, y1, z1), cells) in enumerate(boxes):
        corners += [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        blocks.append(f"{vector(range(8*k, 8*k + 8))} {vector(cells)}")
        faces += [vector(8*k + int(corner) for corner in side) for side in "0321 4567 0473 1265 0154 3762".split()]
    case.mesh(corners, blocks, {"walls": f"type wall; faces ({' '.join(faces)});"})
    case.remove("processor*")
    case.run("decomposePar")


def refused(what, *command, **options):
    claim_refused(what, case, "Parts of the mesh overlap: the centres of ... cells lie in other cells",
                  *command, **options)


case = Case("case", "hydrostatic")
case.edit("system/controlDict", endTime=0.002, writeInterval=1)
case.sub("system/decomposeParDict", "method .*", "method hierarchical;")
case.flow("(0 0 0)", "walls { type noSlip; }", "walls { type zeroGradient; }")
case.properties("glass { density 2500; youngsModulus 1e6; }",
                "hertz {} dry { restitution 0.5; } pressureGradient {} schillerNaumann {}",
                "one { type list; diameter 1e-3; positions ((0.01 0.01 0.01)); }", "rho 1000;")
box = (0, 0, 0), (0.02, 0.02, 0.02), (10, 10, 10)

parts(box, ((0.0081, 0.0079, 0.0083), (0.0142, 0.0139, 0.0144), (6, 6, 6)))
refused("a part within another is refused", "demPimpleFoam")
refused("a part within another is refused on two ranks", "demPimpleFoam", ranks=2)
refused("a part within another is refused by -settle", "demPimpleFoam", "-settle")
control = case.read("system/controlDict")
case.append("system/controlDict", 'functions { particles { type demCloud; libs ("libdemCoupling.so"); } }\n')
refused("a part within another is refused by the function object", "pimpleFoam")
case.write("system/controlDict", control)

parts(box, ((0.0181, 0.0179, 0.0183), (0.0342, 0.0339, 0.0344), (16, 16, 16)))
refused("a corner in another part is refused", "demPimpleFoam")
parts(box, box)
refused("the same part twice is refused", "demPimpleFoam")
parts(box, ((0.02, 0, 0), (0.04, 0.02, 0.02), (10, 7, 13)))
claim_runs("parts that touch: runs", case)

parts(box)
case.append("system/controlDict", 'libs ("liboverset.so");\n')
case.sub("constant/polyMesh/boundary", r"type\s+wall;", "type overset;")
case.flow("(0 0 0)", "walls { type overset; }", "walls { type overset; }")
claim_refused("an overset patch is refused", case, "The mesh is overset (walls)", "demPimpleFoam")
finish()
