"""cloud_injection.py -- injection models of OpenFOAM's clouds as groups and streams of `insert`.

A parcel of OpenFOAM stands for nParticle particles; a particle of Suna is one sphere. So parcels
that stand for several are refused where they are placed, and of a flow the mass per second is kept.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

import numpy

from . import cloud_sizes
from .cloud_models import PARCELS
from .foam_reader import existing, file_text
from .report import Place
from .scene_text import vector

# ---- injection -----------------------------------------------------------------------------------

REFUSED_INJECTIONS = {
    "fieldActivatedInjection": "Suna's particles enter at given times, not when a field says so",
    "inflationInjection": "Suna's particles do not grow",
    "patchFlowRateInjection": "its rate follows the fluid's flux; Suna's streams have given "
                              "rates: use patchInjection with massTotal and duration",
    "coneNozzleInjection": "a spray nozzle; use coneInjection or patchInjection",
    "kinematicLookupTableInjection": "a table of parcels; write the particles as positionsFile of "
                                     "a manualInjection",
    "injectedParticleInjection": "it reads parcels that another run wrote; use manualInjection",
    "injectedParticleDistributionInjection":
    "it reads parcels that another run wrote; use patchInjection with their distribution",
}


def parcels(d, report):
    """Is the distribution one by volume? Refuses parcels of several particles."""
    basis = d.word("parcelBasisType", "mass")
    if basis == "fixed":
        n = d.number("nParticle", 1.0)
        if n != 1:
            d.refuse("nParticle", PARCELS, f"{n:g}")
        report.translated(d.where("parcelBasisType"), d.full("parcelBasisType") + " fixed",
                          "each parcel is a particle")
        return False
    return basis == "mass"


def read_positions(path, place, report):
    """Vectors of a list file of OpenFOAM."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", file_text(existing(path)), flags=re.S)
    text = re.sub(r"FoamFile\s*\{.*?\}", " ", text, flags=re.S)
    inner = re.search(r"\((.*)\)", text, flags=re.S)
    try:
        found = numpy.array(re.sub(r"[()]", " ", inner[1]).split() if inner else [], float)
    except ValueError:
        found = numpy.empty(0)
    if len(found) == 0 or len(found) % 3 or not numpy.isfinite(found).all():
        report.refuse(place, "positions", "is no list of points ( (x y z) ... )")
    return found.reshape(-1, 3)


def add_injection(name, d, case, density, properties, report, cloud):
    kind = d.word("type")
    place, word = d.where("type"), d.full("type") + " " + kind
    if kind in REFUSED_INJECTIONS:
        report.refuse(place, word, REFUSED_INJECTIONS[kind])
    if kind == "none":
        report.translated(place, word, "no particles")
    elif kind == "manualInjection":
        manual(name, d, case, properties, report, place, word)
    elif kind == "patchInjection":
        stream(name, d, density, properties, report, place, word, f"patch {d.word('patch')};")
    elif kind == "coneInjection":
        cone(name, d, density, properties, report, place, word)
    elif kind == "cellZoneInjection":
        zone(name, d, properties, report, place, word)
    else:
        report.refuse(place, word, "the importer does not know this injection")
    for old in ("massTotal", "SOI", "nParticle", "parcelBasisType", "ignoreOutOfBounds",
                "minParticlesPerParcel", "selectionMethod", "sizeDistribution"):
        d.find(old)
    d.refuse_unread()


def manual(name, d, case, properties, report, place, word):
    parcels(d, report)
    if d.number("SOI", 0.0) > 0:
        d.refuse("SOI", "particles of a list are there from the start; let the run begin at this "
                 "time")
    file = d.word("positionsFile")
    source = case.source/"constant"/file
    if existing(source) is None:
        d.refuse("positionsFile", f"there is no file constant/{file}")
    positions = read_positions(source, Place(f"constant/{file}"), report)
    case.positions[name] = positions
    report.translated(place, word, f"insert/{name}, a list of {len(positions)} particles")
    diameters = cloud_sizes.diameters(d.sub("sizeDistribution"), len(positions), report)
    if diameters is None:
        size = cloud_sizes.sizes(d.sub("sizeDistribution"), "number", report)
    else:
        size = "diameters (" + " ".join(f"{x:.9g}" for x in diameters) + ");"
    u = d.vector("U0", (0.0, 0.0, 0.0))
    properties.add("insert", f"{name} {{ type list; material particles; {size} velocity "
                   f"{vector(u)}; #include \"{name}Positions\" }}", place)


def rate(d, density, report):
    """`rate` or `massRate` of a stream, and by what its sizes count."""
    by_mass = parcels(d, report)
    duration, total = d.positive("duration"), d.number("massTotal", 0.0)
    per_second = d.number("parcelsPerSecond", 0.0)
    if "massFlowRate" in d:
        total = d.number("massFlowRate")*duration
    if d.word("parcelBasisType", "mass") == "fixed":
        return f"rate {per_second:.12g};", "number"
    if not total > 0:
        d.refuse("massTotal", "must be above 0")
    d.approximated("parcelBasisType", f"massRate {total/duration:.6g} kg/s of single particles, "
                   f"where {per_second:g} parcels a second stood for "
                   "them", d.word("parcelBasisType", "mass"))
    return f"massRate {total/duration:.12g};", "volume" if by_mass else "number"


def profile(d, report, *names):
    for word in names:
        tokens = d.tokens(word, None)
        if tokens is not None and tokens and tokens[0] != "constant" and not re.fullmatch(
                r"[-+\d.eE]+", str(tokens[0])):
            d.refuse(word, "changes in time; Suna's streams have constant rates: give the mean, or "
                     "several injections")


def stream(name, d, density, properties, report, place, word, inlet):
    profile(d, report, "flowRateProfile")
    amount, by = rate(d, density, report)
    start = d.number("SOI", 0.0)
    u = d.vector("U0")
    properties.add("insert", f"{name} {{ type stream; material particles; {inlet} {amount} start "
                   f"{start:g}; end {start + d.number('duration'):g}; velocity {vector(u)}; "
                   f"{cloud_sizes.sizes(d.sub('sizeDistribution'), by, report)} }}", place)
    report.translated(place, word, f"insert/{name}, a stream")


def cone(name, d, density, properties, report, place, word):
    profile(d, report, "flowRateProfile", "Umag", "thetaInner", "thetaOuter")
    for one, two in d.list("positionAxis", []) or [(d.list("position"), d.list("direction"))]:
        at, axis = (numpy.array(d.numbers("type", v, 3, "vector")) for v in (one, two))
        if not axis.any():
            report.refuse(place, word, "its axis has no direction")
        axis = axis/numpy.linalg.norm(axis)
        angle, speed = math.radians(d.number("thetaOuter")), d.number("Umag")
        across = speed*math.sin(angle)*numpy.sqrt(numpy.maximum(0, 1 - axis**2))
        size = cloud_sizes.sizes(d.sub("sizeDistribution"), "number", report)
        biggest = max(float(x) for x in re.findall(r"[\d.]+(?:e[-+]?\d+)?", size))
        duration, start = d.number("duration"), d.number("SOI", 0.0)
        amount, by = rate(d, density, report)
        v = speed*math.cos(angle/2)*axis
        properties.add("insert", f"{name} {{ type stream; material particles; {amount} start "
                       f"{start:g}; end {start + duration:g}; disc {{ centre {vector(at)}; normal "
                       f"{vector(axis)}; radius {biggest:g}; }} velocity {vector(v)}; spread "
                       f"{vector(across)}; {size.replace('by number', 'by ' + by)} }}", place)
        report.approximated(place, word, "a disc of one diameter for its point, velocities "
                            "uniform in a box for the cone, within its outer angle along the axes")
    for old in ("parcelsPerInjector", "thetaInner", "injectionMethod", "flowType"):
        d.find(old)


def zone(name, d, properties, report, place, word):
    parcels(d, report)
    size = d.sub("sizeDistribution")
    kind, inner = cloud_sizes.distribution(size, report)
    if kind != "fixedValue":
        size.refuse("type", "in a zone the importer knows fixedValue, as it does not know the "
                    "volume", kind)
    diameter, n = inner.number("value"), d.number("numberDensity")
    u = d.vector("U0", (0.0, 0.0, 0.0))
    properties.add("insert", f"{name} {{ type random; material particles; zone "
                             f"{d.word('cellZone')}; "
                   f"solidFraction {n*math.pi*diameter**3/6:.9g}; diameter {diameter:.12g}; "
                   f"velocity {vector(u)}; }}", place)
    report.translated(place, word, f"insert/{name}: {n:g} particles per m3 of the zone as solid "
                                   "fraction")
