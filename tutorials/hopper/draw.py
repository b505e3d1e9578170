"""draw.py -- the hopper at four instants while it empties: hopper.png.

    draw.py CASE

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent/"muellerBed"))
import frames       # noqa: E402
import render       # noqa: E402

# section of the mesh [m]: x, and y, which is up
OUTLINE = 1e-3*numpy.array([(135, 0), (0, 77.9423), (0, 300), (300, 300), (300, 77.9423), (165, 0)])
SPEED = 0.5         # m/s, at the end of the colours


def upright(vectors):
    """With z up, as the pictures have it."""
    return numpy.stack([vectors[:, 0], -vectors[:, 2], vectors[:, 1]], axis=1)


def main():
    listed = frames.list_frames(sys.argv[1])
    panels = []
    for k in range(4):
        time, *place = listed[round(k*(len(listed) - 1)/3)]
        position, velocity, diameter = frames.read_frame(*place)
        panels.append(render.Panel(f"{time:.2f} s", upright(position), upright(velocity), diameter))
    lines = [upright(numpy.insert(OUTLINE, 2, z, axis=1)) for z in (0, 0.0062)]
    render.draw(HERE/"hopper.png", panels, lines, "speed", SPEED, pixels=500)


if __name__ == "__main__":
    main()
