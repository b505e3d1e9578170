"""A case on a sector of 5 degrees of a pipe about z, with wedge patches.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *


class Pipe(Case):
    """A pipe of this radius and height [m], divided into cells (radial, axial); the type of the patches bottom and top
    is `ends`."""

    patches = '"(front|back)" { type wedge; }'

    def __init__(self, name, radius, height, cells, ends="patch"):
        super().__init__(name, "shared")
        self.controls(1, 1, precision=17)
        x, y = radius*math.cos(math.pi/72), radius*math.sin(math.pi/72)
        bottom, top = ("neighbourPatch top;", "neighbourPatch bottom;") if ends == "cyclic" else ("", "")
        self.mesh([(0, 0, 0), (x, -y, 0), (x, y, 0), (0, 0, height), (x, -y, height), (x, y, height)],
                  [f"(0 1 2 0 3 4 5 3) ({cells[0]} 1 {cells[1]})"],
                  {"front": "type wedge; faces ((0 1 4 3));", "back": "type wedge; faces ((0 3 5 2));",
                   "wall": "type wall; faces ((1 2 5 4));", "bottom": f"type {ends}; {bottom} faces ((0 2 1 0));",
                   "top": f"type {ends}; {top} faces ((3 4 5 3));"})


def rings_of_spheres(h, layers):
    """Positions of five rings of spheres at a distance h, of 3, 9, 15, 21 and 27, in proportion to the volume of each
    ring, in layers; every other layer is rotated by half a sphere. The solid fraction is (pi/6 d^3)/(pi/3 h^3)."""
    places = []
    for k in range(layers):
        for j in range(5):
            angle = 2*np.pi*(np.arange(6*j + 3) + k % 2/2)/(6*j + 3)
            r = (j + 0.5)*h
            places += zip(r*np.cos(angle), r*np.sin(angle), np.full(len(angle), (k + 0.5)*h))
    return " ".join(map(vector, places))
