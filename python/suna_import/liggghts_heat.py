"""liggghts_heat.py -- heat of LIGGGHTS: `fix heat/from .scene_text import text
gran` as the effect conduction.

    LIGGGHTS    H = 2 k sqrt(A),    A = pi R* d (2 + O(d/R)): circle in which the surfaces overlap
    Suna        H = 2 k a,          a = c sqrt(R* d): contact of Hertz

    H    conductance of a contact [W/K]
    k    harmonic mean of the conductivities [W/(m K)]
    d    overlap [m]

So conductivities are multiplied by sqrt(2 pi): H is the same as in LIGGGHTS, at walls too, more by d/(8 R)
between equal spheres and d/(4 R) at a wall.
`area_correction yes` multiplies d by (E*/E*_original)^(1/x) with x = 3/2 for hertz, which is
c = (E*/E*_original)^(1/3), `area force` of Suna with realModulus; x = 1 for hooke.

Temperatures: initial_temperature, set property/atom Temp, set_property Temp of an insertion, and of
walls. Sources of heat in particles, radiation and fixed areas of contact are refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from dataclasses import dataclass

from .scene_text import text


FACTOR = math.sqrt(2*math.pi)
AREA = "Suna's area of a contact follows from the overlap; known: overlap"


@dataclass
class Heat:
    """A fix heat/gran."""
    name: str
    temperature: float              # initial
    corrected: bool
    place: object

    def key(self):
        return self.corrected


def conduction(t, name, group, words):
    if group != "all":
        t.refuse("Suna's conduction acts among all particles; write group all", f"fix heat/gran {group}")
    if words[0] != "initial_temperature":
        t.refuse("initial_temperature is missing")
    found = Heat(name, t.number(words[1]), False, t.command.place)
    rest = words[2:]
    while rest:
        key, value, rest = rest[0], rest[1], rest[2:]
        if key == "area_correction":
            found.corrected = value == "yes"
        elif key == "contact_area" and value != "overlap":
            t.refuse(AREA, f"contact_area {value}")
        elif key == "store_contact_data":
            t.harmless("output", key)
        elif key != "contact_area":
            t.refuse("the importer does not know this word", f"fix heat/gran {key}")
    t.heat = found
    if found.corrected and t.fixes[name] == "heat/gran":
        t.approximated("of walls, too; LIGGGHTS 3.8.0 corrects them only if the fix is called "
                       "heat/gran/conduction", "area_correction yes")
    t.approximated(f"conduction with sqrt(2 pi) = {FACTOR:.4g} times the conductivity: so a "
                   "contact conducts as in LIGGGHTS, more by up to overlap/(4 R); without the "
                   "factor it conducts as Batchelor and O'Brien derived (docs/heat.md)")


def set_particles(t, chosen, name, word):
    """`set ... property/atom NAME VALUE`."""
    if name in ("heatSource", "heatFlux"):
        t.refuse("conduction has no source of heat in a particle; give a wall a flux, or add to "
                 'sim.set_scalar("temperature", values) between two advances in Python', f"set {name}")
    if name != "Temp":
        return False
    if t.inserted():
        t.refuse("temperatures of particles that fix insert/... has placed cannot be set; write "
                 "set_property in the fix, or sim.set_scalar(\"temperature\", values) between two advances in "
                 "Python", "set Temp")
    t.particles.temperature[chosen] = t.number(word)
    return True


# ---- what a scene gets of it -------------------------------------------

def of_material(heat, properties, kind, need):
    """Entries of a material."""
    found = f" conductivity {text(FACTOR*need(properties, 'thermalConductivity', kind))};" + \
        f" heatCapacity {text(need(properties, 'thermalCapacity', kind))};"
    if heat.corrected:
        found += f" realModulus {text(need(properties, 'youngsModulusOriginal', kind))};"
    return found


def effect(heat, model, report):
    """Settings of conduction."""
    if heat.corrected and not model.normal.startswith("hertz"):
        report.approximated(heat.place, "area_correction yes", "the radius of contacts is "
                            "corrected by (E*/E*_original)^(1/3), of Hertz; LIGGGHTS takes 1/2 "
                            "beside hooke, so it conducts less by (E*/E*_original)^(1/6)")
    return {} if heat.corrected else {"area": "overlap"}
