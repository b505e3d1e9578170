"""Two rings of cells about z with faces that do not match between them, for a sliding interface.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import math, vector


def rings(case, radii, height, cells, interface="cyclicAMI", turned=0, lids=False):
    """Make the mesh, of four blocks a ring in zones rotor and stator.

    radii       of the inner ring and of the outer one [mm]
    cells       of a block of either: across, around, along z
    interface   type of the patches inside and outside between the rings
    turned      angle of the outer ring [rad]
    lids        patches lids and ends of the rotor and the stator at the lower and the upper end
    """
    def corner(circle, quarter, z):
        return circle*8 + quarter % 4*2 + z

    def point(circle, quarter, z):
        angle = quarter*math.pi/2 + (turned if circle > 1 else 0)
        return radii[circle]*math.cos(angle), radii[circle]*math.sin(angle), height*z

    def cylinder(circle):
        return " ".join(vector([corner(circle, q, 0), corner(circle, q, 1), corner(circle, q + 1, 1),
                                corner(circle, q + 1, 0)]) for q in range(4))

    def sector(circle, quarter, z):
        return [corner(circle, quarter, z), corner(circle + 1, quarter, z), corner(circle + 1, quarter + 1, z),
                corner(circle, quarter + 1, z)]

    def ends(circle):
        return " ".join(vector(sector(circle, q, z)) for q in range(4) for z in range(2))

    corners = [(circle, quarter, z) for circle in range(4) for quarter in range(4) for z in range(2)]
    patches = {"shaft": f"type wall; faces ({cylinder(0)});",
               "inside": f"type {interface}; neighbourPatch outside; faces ({cylinder(1)});",
               "outside": f"type {interface}; neighbourPatch inside; faces ({cylinder(2)});",
               "vessel": f"type wall; faces ({cylinder(3)});"}
    if lids:
        patches.update(lids=f"type patch; faces ({ends(0)});", ends=f"type patch; faces ({ends(2)});")
    case.mesh([point(*end) for end in corners],
              [f"{vector(sector(2*k, q, 0) + sector(2*k, q, 1))} {zone} {vector(cells[k])}"
               for k, zone in enumerate(("rotor", "stator")) for q in range(4)], patches, scale=0.001,
              edges=" ".join(f"arc {corner(circle, q, z)} {corner(circle, q + 1, z)} {vector(point(circle, q + 0.5, z))}"
                             for circle, q, z in corners))
