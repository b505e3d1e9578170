"""averages.py -- profiles across the bed from positions and velocities of the beads, with
intervals.

Void fraction  from the volume of beads in each box (a slab of the whole depth around the height,
               cut in x); spheres are cut exactly at its faces. No field and no kernel of the run
               enters
Velocity       of the beads whose centers are in the box. Two means, which differ where bubbles pass
               because few beads are fast and many are slow:
                 number  every bead counts once: sum of velocities over number of beads
                 time    every instant counts once: mean over time of the mean in the box
Interval       95 %, from blocks of time: jackknife over the blocks, Student's t

SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy

GAUSS = numpy.polynomial.legendre.leggauss(12)


def disc_left(radius, x):
    """Area of a disc around 0 that lies left of x; both may be arrays."""
    x = numpy.clip(x, -radius, radius)
    safe = numpy.maximum(radius, 1e-300)
    return radius**2*(0.5*numpy.pi + numpy.arcsin(x/safe)) + x*numpy.sqrt(numpy.maximum(radius**2 -
        x**2, 0))


def solid_volume(position, radius, edges, low, high):
    """Volume of spheres [m3] between each two edges in x and between low and high in z: discs,
    Gauss over z. The radius may be one for all."""
    near = (position[:, 2] > low - radius) & (position[:, 2] < high + radius)
    x, z = position[near, 0], position[near, 2]
    radius = numpy.broadcast_to(radius, near.shape)[near]
    bottom, top = numpy.maximum(low - z, -radius), numpy.minimum(high - z, radius)
    volume = numpy.zeros(len(edges) - 1)
    for node, weight in zip(*GAUSS):
        at = 0.5*(bottom + top) + 0.5*node*(top - bottom)
        disc = numpy.sqrt(numpy.maximum(radius**2 - at**2, 0))
        left = disc_left(disc[:, None], edges[None, :] - x[:, None])
        volume += numpy.sum(0.5*weight*(top - bottom)[:, None]*numpy.diff(left, axis=1), axis=0)
    return volume


def velocity_sums(position, velocity, edges, low, high):
    """Number of beads and sum of their vertical velocities in each box."""
    inside = (position[:, 2] > low) & (position[:, 2] < high)
    x = position[inside, 0]
    count = numpy.histogram(x, edges)[0].astype(float)
    return count, numpy.histogram(x, edges, weights=velocity[inside, 2])[0]


def slice_sums(position, velocity, volume, edges, height, half):
    """The same of a slice whose profile over z is Gaussian, half as high at `half` above and below:
    beads count at their centres. Solid volume over the slice's, number of beads, sum of their
    vertical velocities in each box."""
    x, profile = position[:, 0], numpy.exp(-numpy.log(2)*((position[:, 2] - height)/half)**2)
    depth = half*numpy.sqrt(numpy.pi/numpy.log(2))
    solid, count, total = (numpy.histogram(x, edges, weights=profile*weight)[0]
                           for weight in (volume, 1, velocity[:, 2]))
    return solid/(numpy.diff(edges)*depth), count, total


# ---- means over frames, rows are frames ----------------------------------------------------------

def mean_in_time(values):
    """Instants without a bead in the box (not a number) do not count."""
    there = numpy.isfinite(values)
    return numpy.where(there, values, 0).sum(axis=0)/numpy.maximum(there.sum(axis=0), 1)


def velocity_by_number(count, total):
    return total.sum(axis=0)/numpy.maximum(count.sum(axis=0), 1)


def velocity_in_time(count, total):
    with numpy.errstate(invalid="ignore", divide="ignore"):
        return mean_in_time(total/count)


# ---- intervals -----------------------------------------------------------------------------------

def student(freedom):
    """97.5 % point of Student's t; exact for 1 and 2 degrees of freedom, then Abramowitz and Stegun
    26.7.5, within 0.5 %."""
    if freedom < 3:
        return (12.7062, 4.3027)[freedom - 1]
    z, n = 1.959964, float(freedom)
    return (z + (z**3 + z)/(4*n) + (5*z**5 + 16*z**3 + 3*z)/(96*n**2)
            + (3*z**7 + 19*z**5 + 17*z**3 - 15*z)/(384*n**3)
            + (79*z**9 + 776*z**7 + 1482*z**5 - 1920*z**3 - 945*z)/(92160*n**4))


def cut_blocks(frames, wanted):
    """Numbers of the frames of each block, blocks of equal length."""
    return numpy.array_split(numpy.arange(frames), max(2, min(wanted, frames)))


def jackknife(estimate, blocks):
    """estimate(frame numbers) of all frames, and the half width of its 95 % interval; arrays are
    accepted."""
    n = len(blocks)
    without = numpy.array([estimate(numpy.concatenate(blocks[:k] + blocks[k + 1:]))
                           for k in range(n)])
    error = numpy.sqrt((n - 1)/n*((without - without.mean(axis=0))**2).sum(axis=0))
    return estimate(numpy.concatenate(blocks)), student(n - 1)*error


# ---- against the measurement ---------------------------------------------------------------------

def difference(centres, profile, measured):
    """Result less measurement, at the measured points."""
    return numpy.interp(measured[0], centres, profile) - measured[1]


def rms(values):
    return numpy.sqrt(numpy.mean(numpy.square(values)))
