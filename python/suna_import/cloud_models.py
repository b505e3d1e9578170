"""cloud_models.py -- submodels of OpenFOAM's clouds in Suna's words: forces, contacts, patches,
dispersion.

Each table says what becomes of a word: an effect with its settings, or the sentence why not.

The damping coefficient alpha of the spring-slider-dashpot models is Tsuji's, eta = alpha sqrt(m* k)
d^(1/4), and gives the coefficient of restitution e = exp(-pi alpha/sqrt(5 - alpha^2)) at any speed
(dem/laws/contact/dry.c). Their cohesion, an energy density times the area of the overlap's lens,
is 2 pi R* d for small overlaps d: the effect sjkr.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

from .foam_dictionary import Dictionary, Text

# name of the force: (effect, settings, what differs) -- None: the same
FORCES = {
    "gravity": ("gravity", None),
    "sphereDrag": ("schillerNaumann {}", "its drag has 1 + Re^(2/3)/6, here 1 + 0.15 Re^0.687: "
                   "within 4 %"),
    "WenYuDrag": ("wenYu {}", None),
    "ErgunWenYuDrag": ("gidaspow { blend switch; }", None),
    "pressureGradient": ("pressureGradient {}", "there it is rho V Du/Dt, here -V grad p, which "
                         "contains it and buoyancy"),
    "virtualMass": ("virtualMass {}", None),
    "SaffmanMeiLiftForce": ("saffmanMei {}", None),
}
SPHERES = "translated clouds have spheres; for clumps write shapes and hoelzerSommerfeld in constant/demProperties"
REFUSED_FORCES = {
    "PlessisMasliyahDrag": "Suna has gidaspow, diFelice, kochHill, beetstra for the same range; "
                           "name ErgunWenYuDrag here to get gidaspow",
    "nonSphereDrag": SPHERES,
    "distortedSphereDrag": SPHERES,
    "SRF": "particles of Suna have absolute velocities",
    "nonInertialFrame": "particles of Suna have absolute velocities",
    "paramagnetic": "Suna has no magnetic force",
    "BrownianMotion": "Suna has no Brownian motion",
    "TomiyamaLift": "Suna has saffmanMei and magnus",
    "LegendreMagnaudetLift": "Suna has saffmanMei and magnus",
    "interface": "Suna has no force towards an interface",
}
DRAG = ("schillerNaumann", "wenYu", "gidaspow")
PARCELS = "parcels of several particles are not DEM: they do not touch as particles do"


def restitution(alpha):
    """Of Tsuji's damping coefficient: dem/laws/contact/dry.c."""
    return math.exp(-math.pi*alpha/math.sqrt(5 - alpha**2)) if alpha < math.sqrt(5) else 0.0


def as_word(name):
    """A name for a material, from a patch or a pattern of patches."""
    return re.sub(r"\W+", "_", name).strip("_") or "wall"


# ---- forces --------------------------------------------------------------------------------------

def add_forces(forces, properties, report, given=()):
    """Effects of particleForces; returns their names. `given`: those that are added anyway."""
    names = []
    for entry in forces.entries:
        forces.find(entry.name)
        word = forces.full(entry.name)
        inner = entry.value if isinstance(entry.value, Dictionary) else forces.sub(entry.name)
        if entry.name in FORCES:
            effect, differs = FORCES[entry.name]
            names.append(entry.name)
            if entry.name == "virtualMass" and inner.number("Cvm", 0.5) != 0.5:
                effect = f"virtualMass {{ coefficient {inner.number('Cvm'):.12g}; }}"
            for old in ("U", "alphac", "Cvm", "interpolate"):
                inner.find(old)
            inner.refuse_unread(deep=True)
            if differs:
                report.approximated(entry.place, word, f"{effect}: {differs}")
            else:
                report.translated(entry.place, word, effect)
            if effect.split()[0] not in given:
                properties.add("effects", effect, entry.place)
        else:
            report.refuse(entry.place, word, REFUSED_FORCES.get(entry.name,
                          "Suna has no effect for it; leave it out, or see docs/effects.md"))
    return names


# ---- contacts ------------------------------------------------------------------------------------

def contact(d, report, what):
    """(restitution, friction, energy density) of the Coeffs of a pair or wall model."""
    b = d.number("b", 1.5)
    if b != 1.5:
        d.refuse("b", f"{b:g} is no law of Hertz; Suna's hertz has 1.5")
    d.translated("b", "effects/hertz")
    alpha, mu = d.number("alpha"), d.number("mu")
    e = restitution(alpha)
    d.translated("alpha", f"restitution {e:.6g} {what}")
    d.translated("mu", f"mindlin/friction {what}")
    cohesion = d.number("cohesionEnergyDensity", 0.0)
    if cohesion:
        d.translated("cohesionEnergyDensity", f"sjkr/energyDensity {what}")
    if "collisionResolutionSteps" in d:
        d.harmless("collisionResolutionSteps", "time/step auto: 20 steps in a "
                   "contact", f"{d.number('collisionResolutionSteps'):g}")
    if d.switch("useEquivalentSize", False):
        d.refuse("useEquivalentSize", PARCELS)
    d.find("volumeFactor")
    return e, mu, cohesion


def add_material(name, density, d, properties, place):
    properties.add("materials", f"{name} {{ density {density:.12g}; youngsModulus "
                   f"{d.number('youngsModulus'):.12g}; poissonsRatio "
                   f"{d.number('poissonsRatio'):.12g}; }}",
                   place)


def add_contacts(sub, constants, properties, report):
    """Materials, contact laws, pairs. Returns {pattern or name of patches: material} of the walls;
    the name None stands for all."""
    density = constants.number("rho0")
    for name in ("rho0", "youngsModulus", "poissonsRatio"):
        constants.translated(name, "materials/particles")
    add_material("particles", density, constants, properties, constants.where("rho0"))
    coeffs = sub.sub("pairCollisionCoeffs")
    for name in ("maxInteractionDistance", "writeReferredParticleCloud", "U"):
        if coeffs.find(name):
            coeffs.harmless(name,
                            "neighbor lists tune themselves" if name == "maxInteractionDistance" else "")
    model = coeffs.word("pairModel")
    if model != "pairSpringSliderDashpot":
        coeffs.refuse("pairModel", "the importer knows pairSpringSliderDashpot", model)
    d = coeffs.sub(model + "Coeffs")
    e, mu, cohesion = contact(d, report, "of particles")
    report.approximated(coeffs.where("pairModel"), model, "hertz, dry, mindlin: its spring is set "
                        "to zero when a contact slips, mindlin's stays at the limit, so "
                        "contacts that stick and slip in turn hold more")
    d.refuse_unread(deep=True)
    walls = wall_models(coeffs, report)
    values = {name: contact(inner, report, f"on {name or 'walls'}")
              for name, inner in walls.items()}
    cohesive = cohesion or any(energy for _, _, energy in values.values())

    properties.add("effects", "hertz {}", d.where("b"))
    properties.add("effects", f"dry {{ restitution {e:.6g}; }}", d.where("alpha"))
    properties.add("effects", f"mindlin {{ friction {mu:.12g}; }}", d.where("mu"))
    if cohesive:
        properties.add("effects", f"sjkr {{ energyDensity {cohesion:.12g}; }}",
                       d.where("cohesionEnergyDensity"))
    materials = {}
    for name, inner in walls.items():
        materials[name] = word = as_word(name or "wall")
        add_material(word, density, inner, properties, inner.where("youngsModulus"))
        e, mu, energy = values[name]
        properties.add("pairs", f"{word}Contact {{ between (particles {word}); dry {{ restitution "
                       f"{e:.6g}; }} mindlin {{ friction {mu:.12g}; }} " +
                       (f"sjkr {{ energyDensity {energy:.12g}; }} " if cohesive else "") + "}",
                       inner.where("alpha"), inner.where("mu"))
        inner.refuse_unread(deep=True)
    return materials


def wall_models(coeffs, report):
    """{name or pattern of patches: Coeffs}; the name None stands for all."""
    model = coeffs.word("wallModel")
    d = coeffs.sub(model + "Coeffs")
    if model == "wallSpringSliderDashpot":
        return {None: d}
    if model != "wallLocalSpringSliderDashpot":
        coeffs.refuse("wallModel", "the importer knows wallSpringSliderDashpot and "
                      "wallLocalSpringSliderDashpot", model)
    if d.switch("useEquivalentSize", False):
        d.refuse("useEquivalentSize", PARCELS)
    steps = d.number("collisionResolutionSteps", 0.0)
    if steps:
        d.harmless("collisionResolutionSteps", "time/step auto: 20 steps in a contact")
    walls = dict(d.subs())
    d.refuse_unread()
    return walls


# ---- patches -------------------------------------------------------------------------------------

def interactions(sub, report):
    """[(name or pattern of patches, type, place, dictionary)] of the patch interaction model."""
    model = sub.word("patchInteractionModel", "none")
    place = sub.where("patchInteractionModel")
    word = sub.full("patchInteractionModel") + " " + model
    if model == "none":
        return []
    d = sub.sub(model + "Coeffs")
    if model == "rebound":
        return [(Text(".*"), "rebound", place, d)]
    if model == "standardWallInteraction":
        # of walls only
        return [(None, d.word("type"), d.where("type"), d)]
    if model != "localInteraction":
        report.refuse(place, word, "the importer knows rebound, standardWallInteraction and "
                      "localInteraction")
    found = []
    patches = d.find("patches").value if "patches" in d else []
    pairs = [(e.name, e.value) for e in patches.entries] if isinstance(patches, Dictionary) else \
        list(zip(patches[-1], patches[-1][1:])) if patches else []
    for name, inner in pairs:
        if isinstance(inner, Dictionary):
            found.append((name, inner.word("type"), inner.where("type"), inner))
    return found


def interaction_of(patch, found):
    for name, kind, place, d in found:
        if name is None:
            if patch.type == "wall":
                return kind, place, d
        elif re.fullmatch(name, patch.name) if isinstance(name, Text) else name == patch.name:
            return kind, place, d
    return None, None, None


def add_patches(patches, walls, sub, properties, report, place):
    """Walls and outlets: what becomes of a particle at each patch."""
    found = interactions(sub, report)
    symmetry = False
    for patch in patches.values():
        kind, at, d = interaction_of(patch, found)
        for old in ("e", "mu") if d is not None else ():
            if old in d:
                d.find(old)
                d.harmless(old, "wall contacts follow the wall model, here as there: centres "
                           "never reach the face", f"of {patch.name}")
        if patch.type == "wall":
            material = next((word for name, word in walls.items() if name and (
                re.fullmatch(name, patch.name) if isinstance(name, Text) else name == patch.name)),
                walls.get(None))
            if material is None:
                report.refuse(place, f"patch {patch.name}", "the wall model has no entry for it")
            properties.add("walls", f"{patch.name} {{ material {material}; "
                           f"{'absorb yes; ' if kind == 'stick' else ''}}}", at or place)
            if kind == "stick":
                report.approximated(at, f"stick of {patch.name}", "particles that touch the wall "
                                    "are removed and counted, there they stay on it")
            elif kind:
                report.translated(at, f"{kind} of {patch.name}", "a wall; the wall model acts")
        elif patch.type in ("symmetry", "symmetryPlane"):
            symmetry = True
            properties.add("walls", f"{patch.name} {{ material symmetry; }}", at or place)
            report.approximated(at or place, f"patch {patch.name} ({patch.type})", "a smooth "
                                "elastic wall; there centres are reflected, so half a particle may "
                                "stick out")
        elif patch.type in ("patch", "mappedPatch"):
            if kind == "rebound":
                material = next(iter(walls.values()))
                properties.add("walls", f"{patch.name} {{ material {material}; }}", at)
                report.approximated(at, f"rebound of {patch.name}", "a wall that particles touch "
                                    "with their surface; there their centres rebound")
            else:
                properties.add("outlets", f"{patch.name} {{ patch {patch.name}; }}", at or place)
                report.translated(at or place, f"{kind or 'no interaction'} of {patch.name}",
                                  "outlets: particles leave")
    if symmetry:
        properties.add("materials", "symmetry { density 1000; youngsModulus 1e8; }")
        properties.add("pairs", "symmetryContact { between (particles symmetry); dry { "
                       "restitution 1; } mindlin { friction 0; } }")


# ---- dispersion ----------------------------------------------------------------------------------

def add_dispersion(sub, properties, report):
    model = sub.word("dispersionModel", "none")
    place, word = sub.where("dispersionModel"), f"dispersionModel {model}"
    if model in ("stochasticDispersionRAS", "gradientDispersionRAS"):
        properties.add("effects", "turbulentDispersion {}", place)
        report.approximated(place, word, "turbulentDispersion: eddies of exponential length in all "
                            "directions" + (", there along the gradient of "
                                            "k" if model[0] == "g" else ""))
    elif model != "none":
        report.refuse(place, word, "Suna has turbulentDispersion; name stochasticDispersionRAS "
                                   "here")
