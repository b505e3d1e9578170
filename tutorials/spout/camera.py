#!/usr/bin/env python3
"""camera.py -- speed of the beads as particle image velocimetry at the front wall would give it.

    camera.py [-interval 2] [-window 7] [-passes 3] [-from 1] [-to 3] [-every 1] [RUN]
    camera.py -check        beads that all move alike: their speed is found

RUN is runs/bed by default. Prints the speed at the points 3.5, 10.5 ... mm from the middle, at the
heights of evaluate.py, its 95 % interval and the measured one.

Each instant of the record gives two pictures of the beads seen from the front: at their positions,
and `interval` [ms] later at their velocities. A square window [mm] has moved to where the
cross-correlation of its two pictures, less their means, is largest, to a fraction of a pixel
(parabola). From the second pass on the second window is moved along, as programs for PIV do. The
speed is the magnitude of the mean velocity over the instants; windows without beads do not count.

A bead is a ball lit from the camera and hides those behind it; light falls by e within 8 mm of
depth. A quarter is mirrored at its planes of symmetry; of a whole bed the halves are seen one after
the other, from the front and from the back. Noise, blur and the pattern of light on the beads are
left out.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import sys
from pathlib import Path

import numpy

import evaluate

averages = evaluate.averages

PIXEL = 0.25e-3                     # m
FADE = 8e-3                         # m
DEPTH = 0.04                        # m
POINTS = evaluate.CENTRES[:10]      # m, from the middle
MARGIN = 16e-3                      # m, around the points


def picture(place, diameter, low, shape):
    """Brightness of the pixels [z, x] from the corner `low`; place: x, depth, z."""
    reach = int(0.5*diameter/PIXEL) + 1
    dz, dx = numpy.mgrid[-reach:reach + 1, -reach:reach + 1].reshape(2, -1, 1)
    across, depth, up = place.T
    x = numpy.floor((across - low[0])/PIXEL).astype(int) + dx
    z = numpy.floor((up - low[1])/PIXEL).astype(int) + dz
    square = ((x + 0.5)*PIXEL + low[0] - across)**2 + ((z + 0.5)*PIXEL + low[1] - up)**2
    ball = numpy.sqrt(numpy.maximum(0.25*diameter**2 - square, 0))
    seen = (ball > 0) & (x >= 0) & (x < shape[1]) & (z >= 0) & (z < shape[0])
    surface = (depth - ball)[seen]
    light = (2/diameter*ball*numpy.exp(-depth/FADE))[seen]
    order = numpy.argsort(-surface)                 # the nearest is painted last
    image = numpy.zeros(shape)
    image[z[seen][order], x[seen][order]] = light[order]
    return image


def peak(values, at):
    """Place of a maximum between the points of a periodic array, along its first axis."""
    below, top, above = (values[(at + step) % len(values)] for step in (-1, 0, 1))
    curve = below - 2*top + above
    return at + (0.5*(below - above)/curve if curve else 0)


def shift(first, second):
    """Of the second picture against the first [pixels, x and z], or NaN where one is uniform."""
    first, second = first - first.mean(), second - second.mean()
    if not (first.any() and second.any()):
        return numpy.full(2, numpy.nan)
    size = [2*length for length in first.shape]
    product = numpy.conj(numpy.fft.rfft2(first, size))*numpy.fft.rfft2(second, size)
    values = numpy.fft.irfft2(product, size)
    z, x = numpy.unravel_index(values.argmax(), size)
    found = numpy.array([peak(values[z], x), peak(values[:, x], z)])
    return (found + first.shape[::-1]) % size[::-1] - first.shape[::-1]


def displacement(pair, x, z, side, passes):
    """Of the window whose corner is x, z [pixels]; later passes move the second window along."""
    moved = numpy.zeros(2, int)
    for _ in range(passes):
        at = numpy.clip((x, z) + moved, 0, numpy.array(pair[1].shape[::-1]) - side)
        moved = at - (x, z)
        found = moved + shift(pair[0][z:z + side, x:x + side],
                              pair[1][at[1]:at[1] + side, at[0]:at[0] + side])
        if numpy.isnan(found).any() or (found.round().astype(int) == moved).all():
            break
        moved = found.round().astype(int)
    return found


def views(position, velocity):
    """Positions and velocities with the camera at y = 0 and the half to be seen at positive x."""
    planes = numpy.array([0, DEPTH, 0])
    if position[:, 1].max() < 0.6*DEPTH:
        for mirror in ((-1, 1, 1), (1, -1, 1)):
            position = numpy.concatenate([position, position*mirror + (planes if mirror[1] < 0 else 0)])
            velocity = numpy.concatenate([velocity, velocity*mirror])
        return [(position, velocity)]
    return [(position*(side, face, 1) + (planes if face < 0 else 0), velocity*(side, face, 1))
            for side in (1, -1) for face in (1, -1)]


def velocities(position, velocity, diameter, height, interval, window, passes):
    """Along x and z [m/s] at the points, of one instant."""
    side = round(window/PIXEL)
    low = numpy.array([-MARGIN, height - MARGIN])
    near = ((abs(position[:, 2] - height) < 2*MARGIN) & (position[:, 0] > -2*MARGIN)
            & (position[:, 0] < POINTS[-1] + 2*MARGIN))
    position, velocity = position[near], velocity[near]
    shape = (round(2*MARGIN/PIXEL), round((POINTS[-1] + 2*MARGIN)/PIXEL))
    pair = [picture(place, diameter, low, shape)
            for place in (position, position + velocity*interval)]
    corners = ((POINTS - 0.5*window - low[0])/PIXEL).round().astype(int)
    return PIXEL/interval*numpy.array([displacement(pair, x, (shape[0] - side)//2, side, passes)
                                       for x in corners])


def check():
    """Beads at random places that all move alike: the largest error of the camera [m/s]."""
    random = numpy.random.default_rng(1)
    position = random.random((3000, 3))*[0.09, 0.02, 0.06]
    given = numpy.array([0.2, 0.1, 0.7])
    alike = numpy.tile(given, (len(position), 1))
    (view,) = views(position, alike)
    found = velocities(*view, 2.5e-3, 0.03, 3e-3, 14e-3, passes=3)
    return abs(found[1:] - given[::2]).max()        # beside the first is the mirror image


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("-interval", type=float, default=2, help="ms between the pictures")
    parser.add_argument("-window", type=float, default=7, help="mm, at most 21")
    parser.add_argument("-passes", type=int, default=3, help="1: both windows at one place")
    parser.add_argument("-from", dest="start", type=float, default=1, help="s, first instant")
    parser.add_argument("-to", dest="end", type=float, default=numpy.inf, help="s, last instant")
    parser.add_argument("-every", type=int, default=1, help="of the instants, this one only")
    parser.add_argument("-check", action="store_true", help="beads that all move alike")
    parser.add_argument("run", nargs="?", type=Path, default=evaluate.HERE/"runs/bed")
    words = parser.parse_args()
    if words.check:
        error = check()             # bound: a quarter of a pixel in 3 ms
        sys.exit(f"camera: error {error:.3g} m/s of 0.73 m/s" if error > 0.02 else 0)
    if words.interval <= 0 or not 0 < words.window <= 21:
        parser.error("an interval above 0 and a window of at most 21 mm")
    chosen = [place for time, *place in evaluate.frames.list_frames(words.run)
              if words.start*(1 - 1e-9) <= time <= words.end*(1 + 1e-9)][::words.every]
    if len(chosen) < 10:
        parser.error(f"{len(chosen)} instants of the record of {words.run}; means take 10 at least")
    print("mm from the middle ", *(f"{1e3*point:6.1f}" for point in POINTS))
    for share in evaluate.SHARES:
        rows = []
        for place in chosen:
            position, velocity, diameter = evaluate.frames.read_frame(*place)
            rows.append(numpy.nanmean([velocities(*view, diameter[0], share*evaluate.AT_REST,
                                                  1e-3*words.interval, 1e-3*words.window, words.passes)
                                       for view in views(position, velocity)], axis=0))
        rows = numpy.array(rows)
        speed, half = averages.jackknife(
            lambda some, rows=rows: numpy.hypot(*numpy.nanmean(rows[some], axis=0).T),
            averages.cut_blocks(len(rows), 5))
        both = sum(side for _, side in evaluate.measured(share))/2
        print(f"{share:.2f} camera, m/s   ", *(f"{value:6.3f}" for value in speed))
        print("     95 % interval ", *(f"{value:6.3f}" for value in half))
        print("     measured, m/s ", *(f"{value:6.3f}" for value in both[:len(POINTS)]))


if __name__ == "__main__":
    main()
