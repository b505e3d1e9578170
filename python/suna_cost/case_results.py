"""case_results.py -- results of a run of an OpenFOAM case with particles.

Quantities, means over the samples: kinetic energy by mass, height of the centre and of 95 % of the
volume, largest overlap, least void fraction of a cell; the largest force on a wall; the difference
of pressure between patches. Scales of errors: heights, the mean diameter; kinetic energy, at least
1e-6 of its value after a fall by one diameter; others, the reference.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

import numpy

from suna import read_record
from suna.command import Refused


def sample_values(beads, up):
    """Kinetic energy by mass (of equal densities), heights of the centre and of 95 % of the volume,
    volume, of the particles of one instant."""
    volume = beads["diameter"].astype(float)**3
    height = beads["position"].astype(float) @ up
    order = numpy.argsort(height)
    below = numpy.cumsum(volume[order])
    level = height[order][min(numpy.searchsorted(below, 0.95*below[-1]), len(beads) - 1)]
    speed2 = (beads["velocity"].astype(float)**2).sum(axis=1)
    return (0.5*(volume*speed2).sum()/below[-1], (volume*height).sum()/below[-1], level,
            below[-1]/len(beads))


def particle_values(record, gravity):
    """Values and scales from a particles.bin."""
    size = numpy.linalg.norm(gravity)
    up = -gravity/size if size else gravity
    instants = [beads for _, beads in read_record(record) if len(beads)]
    if not instants:
        return {}, {}
    kinetic, height, level, cube = numpy.mean([sample_values(beads, up) for beads in instants], 0)
    diameter = cube**(1/3)
    values, scales = {"kinetic": kinetic}, {}
    if kinetic < 1e-6*size*diameter:
        scales["kinetic"] = 1e-6*size*diameter
    if size:
        values["height"], scales["height"] = height, diameter
        if len(instants[-1]) > 1:
            values["level"], scales["level"] = level, diameter
    return values, scales


def result_values(folder, case):
    """Values and scales of the run in this folder."""
    post = folder/"postProcessing"
    values, scales = particle_values(post/"dem"/case.start_name/"particles.bin", case.gravity)
    lines = re.findall(r"^Suna: .* void fraction at least ([^,]*), overlap at most ([^, ]*) ",
                       (folder/"log").read_text(), re.M)
    if lines:
        values["void"], values["overlap"] = numpy.mean(numpy.array(lines, float), axis=0)
    walls = post/"dem"/case.start_name/"walls.csv"
    if walls.exists() and walls.stat().st_size:
        force = numpy.genfromtxt(walls, delimiter=",", usecols=(2, 3, 4), ndmin=2)  # its head: nan
        largest = numpy.nanmax(numpy.linalg.norm(force, axis=1), initial=0.0)
        if largest > 0:
            values["force"] = largest
    means = [numpy.loadtxt(file, ndmin=2)[:, 1].mean()
             for file in post.glob("cost_*/*/surfaceFieldValue.dat")]
    if len(means) > 1:
        values["drop"] = max(means) - min(means)
    return {q: float(x) for q, x in values.items()}, {q: float(x) for q, x in scales.items()}


def processor_time(log, steps):
    times = [float(x) for x in re.findall(r"^ExecutionTime = (\S+)", log, re.M)]
    if len(times) < 2:
        raise Refused(f"the window has {len(times)} steps, too few to time; give a longer -window")
    return (times[-1] - times[0])*steps/(steps - 1)


def failure_reason(log):
    """The error message that ended a run."""
    found = re.search(r"(--> FOAM FATAL.*|Suna: .*failed.*)\n?((?:.*\n?){0,3})", log)
    text = " ".join(found.groups()) if found else (log.strip().splitlines() or ["it wrote nothing"])[-1]
    return re.sub(r"^--> FOAM FATAL( IO)? ERROR: *", "", re.sub(r"\s+", " ", text))[:300].strip()
