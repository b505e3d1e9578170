"""cfdem_models.py -- models of CFDEMcoupling's couplingProperties in Suna's words.

Each table says what becomes of a word: an effect or entry of constant/demProperties, nothing
because the answer does not depend on it, or the sentence why it cannot be translated.

`constDiffSmoothing` is one implicit step of diffusion with D dt = smoothingLength^2. Its Green's
function has the variance 2 L^2 along each axis; the kernel diffusion has b^2/2, so b = 2 L.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from .foam_dictionary import as_text

# name of the force model: (effect or None, what is to be said)
FORCES = {
    "gradPForce": ("pressureGradient {}", ""),
    "Archimedes": (None, "buoyancy is part of pressureGradient"),
    "viscForce": ("viscousStress {}", ""),
    "KochHillDrag": ("kochHill {}", ""),
    "DiFeliceDrag": ("diFelice {}", ""),
    "GidaspowDrag": ("gidaspow { blend switch; }", ""),
    "BeetstraDrag": ("beetstra { mean around; }", ""),
    "RongDrag": ("rong {}", ""),
    "SchillerNaumannDrag": ("schillerNaumann {}", ""),
    "virtualMassForce": ("virtualMass {}", ""),
    "MeiLift": ("saffmanMei {}", ""),
}
DRAG = tuple(name for name in FORCES if name.endswith("Drag"))
DIAGNOSTICS = ("particleCellVolume", "particleVolume", "volWeightedAverage",
               "totalMomentumExchange", "fieldStore", "fieldTimeAverage", "fieldVolWeighted",
               "checkCouplingInterval", "averageSlipVel", "particleProbe", "typeConcentration")
HEAT = ("heat and species between fluid and particles are not translated; add gunn for heat to "
        "constant/demProperties by hand")
RESOLVED = "a resolved particle (immersed boundary); Suna's particles are not larger than cells"
REFUSED_FORCES = {
    "LaEuScalarTemp": HEAT, "scalarGeneralExchange": HEAT, "heatTransferGunn": HEAT,
    "ShirgaonkarIB": RESOLVED, "ArchimedesIB": RESOLVED, "IBTorque": RESOLVED,
    "noDrag": "it switches off the forces of the others; leave those out that are not wanted, and "
              "noDrag",
    "surfaceTensionForce": "it needs two fluids, application cfdemSolverMultiphase; leave it out here",
    "DEMbasedDrag": "drag by a script of LIGGGHTS; name one of Suna's laws",
}
# settings of a force that do not change the answer, or not more than the exchange does
FREE = {
    "verbose": "", "verboseToDisk": "", "verboseDiskIntervall": "", "suppressProbe": "",
    "interpolation": "the kernel's weights read the fluid at particles",
    "implForceDEM": "drag is integrated exactly between fluid steps",
    "implForceDEMaccumulated": "drag is integrated exactly between fluid steps",
    "explicitCorr": "the exchange is implicit", "treatForceExplicit": "the exchange is implicit",
    "rhoParticle": "", "UrelOldName": "", "phiFieldName": "", "splitUrelCalculation": "",
}
NAMES = {"velFieldName": "U", "velocityFieldName": "U", "voidfractionFieldName": "voidfraction",
         "granVelFieldName": "Us", "densityFieldName": "rho", "pFieldName": "p",
         "gravityFieldName": "g", "stfFieldName": "surfaceTensionForce"}
NUMBERS = {"scale": 1.0, "scaleDrag": 1.0, "scaleDragLocal": 1.0, "scaleTorque": 1.0, "phi": 1.0,
           "switchingVoidfraction": 0.8}
SWITCHES = {
    "treatForceDEM": "the fluid would not feel the force; Suna's exchange keeps momentum",
    "useFilteredDragModel": "filtered drag", "useParcelSizeDependentFilteredDrag": "filtered drag",
    "scalarViscosity": "a viscosity of its own for one force; the fluid has one",
    "useCorrectedVoidage": "a correction of the void fraction", "multisphere": "multispheres",
    "superquadric": "superquadrics", "convex": "convex particles",
    "anisotropicDrag": "drag that depends on direction", "useTorque": "name viscousTorque",
    "voidageFunctionDiFelice": "name DiFeliceDrag", "voidageFunctionRong": "name RongDrag",
    "voidageFunctionTang": "Tang's law of drag", "useAddedMass": "name virtualMassForce",
    "particleSpecificCG": "coarse grain", "pullRotation": "", "pullOrientation": "",
    "pullShape": "", "useUf": "", "useFhydro": "", "implTorqueDEM": "", "useVisc": "",
    "useMpData": "",
    "useQuaternion": "", "pushTurbulence": "", "pullType": "", "pullDensity": "",
    "pushConvectiveHeatFlux": HEAT, "pullTemp": HEAT,
}
# voidFractionModel: (kernel, what differs)
KERNELS = {
    "divided": ("divided", ""),
    "centre": ("particleCentre", ""),
    "trilinear": ("linear", ""),
    "Gauss": ("gaussian", "the width is 3 diameters here, there the particle's radius"),
    "bigParticle": ("divided", "the exact volume of the sphere in each cell, there all cells whose "
                    "centre lies in it get the same"),
}
REFUSED_KERNELS = {
    "IB": RESOLVED,
    "noVoidFraction": "particles that take no volume; leave Suna's kernel, and name "
                      "coupling/twoWay no",
}
SETS = {"A": ("II", "model A"), "B": ("III", "model B"), "Bfull": ("I", "model Bfull")}


# ---- equations, kernel ---------------------------------------------------------------------------

def add_equations(d, properties, report):
    """Returns the name of the set."""
    model = d.word("modelType")
    place, word = d.where("modelType"), f"modelType {model}"
    if model == "none":
        report.refuse(place, word, "has no averaged equations; Suna has the sets of models A, B "
                                   "and Bfull")
    if model not in SETS:
        report.refuse(place, word, "known are A, B, Bfull")
    number, text = SETS[model]
    report.translated(place, word, f"coupling/equations {number}")
    properties.add("coupling", f"equations {number};", place)
    return number


def add_kernel(d, diameter, properties, report):
    model = d.word("voidFractionModel")
    place, word = d.where("voidFractionModel"), f"voidFractionModel {model}"
    if model not in KERNELS:
        report.refuse(place, word, REFUSED_KERNELS.get(model, f"known are {', '.join(KERNELS)}"))
    kernel, differs = KERNELS[model]
    props = d.sub(model + "Props")
    weights(props, report)
    smoothing = d.word("smoothingModel", "off")
    width = None
    if smoothing not in ("off", "noSmoothing"):
        width = smooth(d, smoothing, diameter, report)
        base = {"divided": "divided", "particleCentre": "particleCentre"}.get(kernel, "linear")
        properties.add("coupling", f"kernel diffusion; base {base}; width {width:.4g};", place,
                       d.where("smoothingModel"))
    else:
        report.harmless(d.where("smoothingModel"), "smoothingModel " + smoothing)
        properties.add("coupling", f"kernel {kernel};", place)
    if differs:
        report.approximated(place, word, f"kernel {kernel}: {differs}")
    else:
        report.translated(place, word, f"coupling/kernel "
                                       f"{'diffusion, base ' if width else ''}{kernel}")
    limit = props.number("alphaMin", 0.1)
    properties.add("coupling", f"minVoidFraction {limit:.6g};", props.where("alphaMin"))
    report.approximated(props.where("alphaMin"), "alphaMin", f"minVoidFraction {limit:g}: fuller "
                        "cells pass the excess on to neighbours, there the volume is cut off")


def weights(props, report):
    """Settings of a void fraction model."""
    for name in ("weight", "porosity", "scaleUpVol"):
        if name in props and props.number(name) != 1:
            props.refuse(name, "scales the volumes of the particles; only 1 is translated")
    if "volScale" in props:
        props.refuse("volScale", "scales volumes by type, which Suna does not")
    for name in ("maxCellsPerParticle", "interpolation", "verbose", "procBoundaryCorrection",
                 "cfdemUseOnly", "alphaMin", "weight", "porosity", "scaleUpVol"):
        props.find(name)
    props.refuse_unread()


def smooth(d, model, diameter, report):
    """Width of the kernel in diameters."""
    place, word = d.where("smoothingModel"), f"smoothingModel {model}"
    if model not in ("constDiffSmoothing", "localPSizeDiffSmoothing"):
        report.refuse(place, word, "known are off, constDiffSmoothing, localPSizeDiffSmoothing")
    props = d.sub(model + "Props")
    name = "smoothingLength" if model == "constDiffSmoothing" else "dSmoothingLength"
    length = props.number(name)
    if not diameter:
        props.refuse(name, "the mean diameter is not known, so the width in diameters is not; "
                     "write coupling { kernel diffusion; diameter; width; }")
    width = 2*length/diameter
    props.approximated(name, f"width {width:.4g} diameters: a Gaussian of the same variance, which "
                       "acts for forces and the fluid's values, too; there only the void fraction "
                       "is smoothed", f"{length:g}")
    for old in ("lowerLimit", "upperLimit", "smoothingLengthReferenceField", "Csmoothing",
                "verbose"):
        if props.find(old):
            props.harmless(old, "smoothing keeps the total")
    props.refuse_unread()
    return width


# ---- forces --------------------------------------------------------------------------------------

def add_forces(d, number, properties, report, two_fluids=False):
    """Effects of forceModels; `number`: the set of equations."""
    place, names = d.where("forceModels"), [str(x) for x in d.list("forceModels")]
    drags = [name for name in names if name in DRAG]
    if len(drags) > 1:
        report.refuse(place, f"forceModels {' '.join(drags)}",
                      "two laws of drag; Suna has at most one")
    for name in names:
        props = d.sub(name + "Props")
        if name in DIAGNOSTICS:
            report.harmless(place, f"forceModels {name}", "no force; see docs/output.md for what "
                            "is written")
        elif name == "surfaceTensionForce" and two_fluids:
            report.translated(place, f"forceModels {name}", "pressureGradient, which is without the "
                              "capillary jump: -V grad p + V sigma kappa grad alpha there")
            settings(props, report)
        elif name not in FORCES:
            report.refuse(place, f"forceModels {name}", REFUSED_FORCES.get(
                name, "Suna has no effect for it; docs/effects.md lists what there is"))
        else:
            add_force(name, props, number, place, properties, report)
    if "gradPForce" not in names or number == "III":
        properties.add("effects", "pressureGradient {}", place)
    lacks = [name for name in ("gradPForce", "Archimedes")
             if name not in names and not (name == "gradPForce" and number == "III")]
    if two_fluids and "surfaceTensionForce" not in names:
        report.approximated(place, "forceModels without surfaceTensionForce", "particles do not feel "
                            "the capillary jump of the pressure; there they do")
    if lacks:
        report.approximated(place, f"forceModels without {' and '.join(lacks)}", "pressureGradient "
                            "acts, with buoyancy: the equations need it")


def add_force(name, props, number, place, properties, report):
    effect, text = FORCES[name]
    if name == "viscForce" and number == "III":
        report.approximated(place, "forceModels viscForce", "left out: in set III the stress of "
                            "the flow is in the fluid's equation whole")
        effect = None
    elif name == "gradPForce" and number == "III":
        report.approximated(place, "forceModels gradPForce", "set III has the pressure gradient "
                            "of the flow in drag over the void fraction, so it is not added twice")
        effect = None
    else:
        report.translated(place, f"forceModels {name}", effect or text)
    if name == "virtualMassForce" and "Cadd" in props:
        effect = f"virtualMass {{ coefficient {props.number('Cadd'):.12g}; }}"
    if name == "MeiLift" and props.find("useSecondOrderTerms"):
        props.approximated("useSecondOrderTerms", "saffmanMei has Mei's correction of the first "
                           "order alone")
    if effect:
        properties.add("effects", effect, place)
    settings(props, report)


def settings(props, report):
    """What the settings of a force change."""
    for entry in props.entries:
        word = props.full(entry.name)
        if entry.name in FREE:
            report.harmless(entry.place, word, FREE[entry.name])
        elif entry.name in NAMES:
            if props.word(entry.name) != NAMES[entry.name]:
                report.refuse(entry.place, word, f"{as_text(entry.value)}: the field is "
                              f"{NAMES[entry.name]} in demPimpleFoam")
        elif entry.name in NUMBERS:
            if props.number(entry.name) != NUMBERS[entry.name]:
                report.refuse(entry.place, f"{word} {as_text(entry.value)}", "only "
                              f"{NUMBERS[entry.name]:g} is known here")
        elif entry.name in SWITCHES:
            if props.switch(entry.name, False):
                report.refuse(entry.place, word, SWITCHES[entry.name] or "Suna has nothing like it")
        elif entry.name not in ("Cadd", "useSecondOrderTerms") and not (
                entry.name == "nu" and not props.switch("scalarViscosity", False)):
            report.refuse(entry.place, word, "the importer does not know this setting")
        props.find(entry.name)


# ---- exchange ------------------------------------------------------------------------------------

def add_exchange(d, properties, report):
    place = d.where("momCoupleModels")
    names = [str(x) for x in d.list("momCoupleModels")]
    if not names or names in (["off"], ["noCouple"]):
        properties.add("coupling", "twoWay no;", place)
        report.translated(place, "momCoupleModels off", "coupling/twoWay no")
    for name in names:
        props = d.sub(name + "Props")
        if name == "implicitCouple":
            if "KslLimit" in props and props.number("KslLimit") == 0:
                properties.add("coupling", "twoWay no;", props.where("KslLimit"))
                report.translated(props.where("KslLimit"), "KslLimit 0", "coupling/twoWay no")
            elif "KslLimit" in props:
                report.approximated(props.where("KslLimit"), "KslLimit", "no limit: the exchange "
                                    "is stable without one")
            report.approximated(place, "implicitCouple", "the exchange is implicit and keeps "
                                "momentum; there the fluid gets a drag that particles did not feel")
        elif name == "explicitCouple":
            report.approximated(place, "explicitCouple",
                                "the exchange is implicit and keeps momentum")
        elif name not in ("off", "noCouple"):
            report.refuse(place, f"momCoupleModels {name}",
                          "known are implicitCouple, explicitCouple, off")
    # an entry without a value means on
    if as_text(d.tokens("useDDTvoidfraction", ["off"])) == "off":
        report.approximated(d.where("useDDTvoidfraction"), "useDDTvoidfraction off", "continuity "
                            "has the change of the void fraction, which is left out there")
    else:
        report.translated(d.where("useDDTvoidfraction"), "useDDTvoidfraction")
