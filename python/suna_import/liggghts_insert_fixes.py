"""liggghts_insert_fixes.py -- templates, distributions and insertion: the fixes of LIGGGHTS, word
by word. What they become: liggghts_insertion.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

import numpy

from . import liggghts_clumps
from .liggghts_insertion import Base, Distribution, Insertion, Template
from .scene_text import as_name, vector

AMOUNTS = {                     # attribute of Insertion, kind of number
    "volumefraction_region": ("fraction", "number"),
    "particles_in_region": ("count", "number"),
    "mass_in_region": ("mass", "mass"),
    "nparticles": ("count", "number"),
    "mass": ("mass", "mass"),
    "particlerate": ("rate", "rate"),
    "massrate": ("mass_rate", "mass rate")}
RADII = {"constant": 1, "uniform": 2, "gaussian": 2, "lognormal": 2}    # how many numbers
PLACING = ("ntry_mc", "warn_region", "verbose", "parallel", "random_distribute", "compress_tags",
           "check_obb", "save_template", "extrude_length", "duration", "duration_time")


def template(t, name, group, words):
    base, style, radius = Base(t), "constant", None
    for key, rest in base.others(words[1:]):
        if key == "radius":
            style, radius, rest[:] = radii(t, rest)
        elif key in ("volume_limit", "relative"):
            rest.pop(0)
        else:
            t.refuse("the importer does not know this word", f"particletemplate/sphere {key}")
    if radius is None:
        t.refuse("radius is missing")
    t.templates[name] = Template(base.type, base.density, style, radius, t.command.place)
    t.translated("insert: diameter, sizes")


def radii(t, rest):
    """Style and numbers of `radius`, and the words left."""
    style = rest.pop(0)
    if rest[0] == "mass":
        t.refuse("sizes are drawn by mass; write number, with a distribution by number", f"radius {style} mass")
    if rest[0] == "number":
        rest.pop(0)
    if style not in RADII:
        t.refuse("known: constant, uniform, gaussian, lognormal", f"radius {style}")
    if style == "lognormal" and t.units.name != "si":
        t.refuse("lognormal is read in SI units only", "radius lognormal")
    many = RADII[style]
    return style, t.numbers(rest[:many], "length"), rest[many:]


def distribution(by_mass):
    def add(t, name, group, words):
        rows = words[2:2 + 2*t.whole(words[1], 1, 1000)]
        found = [t.find(t.templates, key, "particletemplate") for key in rows[0::2]]
        weights = numpy.array([t.number(word) for word in rows[1::2]])
        if (weights < 0).any() or not weights.any():
            t.refuse(f"weights {' '.join(rows[1::2])}: none may be below 0, and one must be above")
        if by_mass:
            weights = weights/[template.mass() for template in found]
        t.distributions[name] = Distribution(found, list(weights/weights.sum()))
        t.translated("insert: sizes" if len(found) > 1 else "insert")
    return add


def insertion(style):
    def add(t, name, group, words):
        own = t.names.free("insert", as_name(name))
        rest = words[:]
        i = Insertion(name, own, style, group, None, t.command.place, t.time)
        if t.box is not None:
            free = numpy.transpose([[axis[k] not in "pf" for k in (0, -1)] for axis in t.boundary])
            i.limits = numpy.where(free, [[-math.inf], [math.inf]], numpy.transpose(t.box))
        while rest:
            key = rest.pop(0)
            if key in AMOUNTS:
                attribute, kind = AMOUNTS[key]
                word = rest.pop(0)
                setattr(i, attribute, math.inf if word == "INF" else t.number(word, kind))
            elif key in ONE_WORD:
                ONE_WORD[key](t, i, rest.pop(0))
            elif key in MORE_WORDS:
                rest = MORE_WORDS[key](t, i, rest)
            elif key in PLACING:
                rest.pop(0)
            else:
                t.refuse("the importer does not know this word", f"insert/{style} {key}")
        check(t, i)
        t.insertions.append(i)
        t.translated("insert")
    return add


# ---- words with one value ----------------------------------------------

def seed(t, i, word):
    i.seed = t.whole(word)


def of_templates(t, i, word):
    i.distribution = t.find(t.distributions, word, "particledistribution")


def every(t, i, word):
    i.every_steps = 0.0 if word == "once" else t.number(word)


def every_time(t, i, word):
    i.every = t.number(word, "time")


def start(t, i, word):
    i.start_step = t.number(word)


def region(t, i, word):
    i.region = t.find(t.regions, word, "region")


def face(t, i, word):
    i.face = t.find(t.meshes, word, "mesh")


def all_in(t, i, word):
    i.all_in = word == "yes"


def overlap_check(t, i, word):
    if word == "no":
        t.approximated("Suna inserts without overlap", "overlapcheck no")


def attempts(t, i, word):
    i.tries = t.whole(word, 1, 10000)


def off_border(t, i, word):
    i.off_border = word == "yes"


ONE_WORD = {"maxattempt": attempts, "check_dist_from_subdomain_border": off_border,
            "seed": seed, "distributiontemplate": of_templates, "insert_every": every,
            "every": every, "insert_every_time": every_time, "start": start, "region": region,
            "insertion_face": face, "all_in": all_in, "overlapcheck": overlap_check}


# ---- words with more; each returns the words left ----------------------

def spin(t, i, rest):
    i.spin = numpy.array(t.numbers(rest[1:4], "spin"))
    return rest[4:]


def orientation(t, i, rest):
    """Of clumps; spheres have none."""
    if rest[0] != "constant":
        i.orientation = "" if rest[0] == "random" else i.orientation
        return rest[1:]
    i.orientation = f" orientation {vector(t.numbers(rest[1:5]))};"
    return rest[5:]


def set_property(t, i, rest):
    if rest[0] == "Temp":
        i.temperature = t.number(rest[1])
        t.translated("temperature, where there is fix heat/gran")
    else:
        t.harmless("no law that was translated reads it", "set_property")
    return rest[2:]


def velocity(t, i, rest):
    style = rest.pop(0)
    if style not in ("constant", "uniform", "gaussian"):
        t.refuse("known: constant, uniform, gaussian", f"vel {style}")
    i.velocity, rest = numpy.array(t.numbers(rest[:3], "velocity")), rest[3:]
    if style != "constant":
        i.spread, rest = numpy.array(t.numbers(rest[:3], "velocity")), rest[3:]
        if i.style == "pack":
            t.approximated("all particles of a group have the mean velocity; LIGGGHTS spreads it "
                           f"by {i.spread} m/s", f"vel {style}")
        elif style == "gaussian":
            i.spread = i.spread*math.sqrt(3)
            t.approximated("spread: uniform with the same variance", "vel gaussian")
    return rest


MORE_WORDS = {"vel": velocity, "omega": spin, "orientation": orientation,
              "set_property": set_property}


def check(t, i):
    if i.distribution is None:
        t.refuse("distributiontemplate is missing")
    if len({bool(template.shape) for template in i.distribution.templates}) > 1:
        t.refuse("its distribution mixes spheres and clumps; give each an insertion of its own", f"fix {i.fix}")
    if i.style == "stream" and i.face is None:
        t.refuse("insertion_face is missing")
    if i.style != "stream" and i.region is None:
        t.refuse("region is missing")
    if i.style != "pack" and not (i.rate or i.mass_rate):
        t.refuse("particlerate or massrate is missing")
    if i.style == "rate" and not i.region.is_shape():
        t.refuse("a stream enters in a block, cylinder or sphere; use one of these",
                 f"region {i.region.style}")


METHODS = {
    "particletemplate/sphere": template,
    "particletemplate/multisphere": liggghts_clumps.template,
    "particledistribution/discrete": distribution(True),
    "particledistribution/discrete/massbased": distribution(True),
    "particledistribution/discrete/numberbased": distribution(False),
    "insert/pack": insertion("pack"),
    "insert/stream": insertion("stream"),
    "insert/rate/region": insertion("rate")}
