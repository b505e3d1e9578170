"""liggghts_contact.py -- contact models of LIGGGHTS (`pair_style gran model ...`, `fix wall/gran
model ...`) as effects with settings.

`laws(model, properties, i, j)` gives {effect: {setting: value}} for a contact of types i and j. The
effects of a scene hold between its particles; `pairs` has what differs, for types and for walls
whose model is another one: friction, rolling resistance or cohesion that a wall lacks is 0 there.

    hertz, hooke                the same force; hooke with impactSpeed = characteristicVelocity
    hooke/hysteresis            hookeHysteresis; beside it hooke of a wall is unloading 1
    tangential history          mindlin beside hertz, else linear with k_t = k_n
                                (2/7 with ktToKnUser); k_t = kt of .../stiffness
    no_history                  linear with k_t = 0: the dashpot alone, up to mu F_n
    cdt, epsd, epsd2            rollingConstant, rollingSpring (K = 2.25 mu_r^2; K of k_t R*^2)
    sjkr, sjkr2                 sjkr; twice the energy density between particles, at walls the same

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
from typing import NamedTuple

from .report import Place

SWITCHES = {
    "tangential_damping": "on",
    "limitForce": "off",
    "ktToKnUser": "off",
    "absolute_damping": "off",
    "viscous": "off",
    "torsionTorque": "off"}
WITHOUT_EFFECT = ("computeElasticPotential", "computeDissipatedEnergy", "heating_normal_hertz",
                  "heating_normal_hooke", "heating_tangential_history", "heating_tracking")
PARTS = ("tangential", "rolling_friction", "cohesion", "surface")

NORMAL = ("hertz", "hooke", "hooke/hysteresis", "hertz/stiffness", "hooke/stiffness")
TANGENTIAL = ("history", "no_history", "incremental", "incremental_history", "off")
ROLLING = ("cdt", "epsd", "epsd2", "off")
COHESION = ("sjkr", "sjkr2", "off")

STOKES = (
    "restitution falls with the Stokes number of the impact. Suna takes the speed of the impact, "
    "LIGGGHTS the instantaneous one, which gives 0.08 where the law says 0.48 (St 50), 0.55 for "
    "0.68 (100), 0.956 for 0.937 (1000)")


class Model(NamedTuple):
    normal: str
    tangential: str
    rolling: str
    cohesion: str
    switches: tuple         # (name, on or off)
    place: Place
    word: str               # pair_style gran, fix wall/gran

    def on(self, name):
        return dict(self.switches)[name] == "on"

    def key(self):
        return self[:5]


class Properties:
    """property/global: values by name; type numbers from 1."""

    def __init__(self, length=1.0):
        self.values, self.places, self.length = {}, {}, length       # m in a unit of length

    def set(self, name, kind, values, place):
        self.values[name], self.places[name] = (kind, tuple(values)), place

    def copy(self):
        other = Properties(self.length)
        other.values, other.places = dict(self.values), dict(self.places)
        return other

    def has(self, name):
        return name in self.values

    def value(self, name, i, j=None):
        kind, values = self.values[name]
        if kind == "scalar" or len(values) == 1:
            return values[0]
        pairs = j is not None and kind not in ("peratomtype", "atomtype", "vector")
        n = math.isqrt(len(values)) if pairs else len(values)
        if i > n or pairs and j > n:
            raise Need(name, f"has no value for type {i}" + (f" and {j}" if pairs else ""))
        return values[(i - 1)*n + j - 1] if pairs else values[i - 1]

    def key(self):
        return tuple(sorted(self.values.items()))


def read_model(words, place, word, report):
    """`words` after `model`: HERTZ tangential ... with switches; returns the model and the words
    left."""
    parts = {"tangential": "off", "rolling_friction": "off", "cohesion": "off",
             "surface": "default"}
    switches, k = dict(SWITCHES), 1
    normal = words[0]
    while k < len(words):
        name = words[k]
        if name in PARTS:
            parts[name] = words[k + 1]
        elif name in switches:
            if words[k + 1] not in ("on", "off"):
                report.refuse(place, name, f"{words[k + 1]} is neither on nor off")
            switches[name] = words[k + 1]
        elif name in WITHOUT_EFFECT:
            report.harmless(place, name, "energy is in write/energy")
        else:
            break
        k += 2
    for value, known, what, lacks in (
            (normal, NORMAL, "model", "no such normal law; jkr is an effect beside hertz"),
            (parts["tangential"], TANGENTIAL, "tangential", "no such friction"),
            (parts["rolling_friction"], ROLLING, "rolling_friction", "no such rolling resistance"),
            (parts["cohesion"], COHESION, "cohesion", "no such cohesion; for liquid bridges add "
             "liquidBridge to the scene, for the adhesion of JKR jkr"),
            (parts["surface"], ("default",), "surface", "spheres only, each contact by itself")):
        if value not in known:
            report.refuse(place, f"{what} {value}", f"Suna has {lacks}; known: {', '.join(known)}")
    model = Model(normal, parts["tangential"], parts["rolling_friction"], parts["cohesion"],
                  tuple(sorted(switches.items())), place, word)
    if model.on("torsionTorque"):
        report.refuse(place, "torsionTorque on", "Suna has twistingSpring in its place, with other "
                      "parameters; write off, and add twistingSpring to the scene")
    if model.on("viscous"):
        report.approximated(place, "viscous on", "stokesDamping: " + STOKES)
    return model, words[k:]


def tell(model, report):
    """What of a model is not quite the same."""
    def near(word, text):
        report.approximated(model.place, word, text)
    if model.normal.endswith("/stiffness") and model.tangential == "history":
        near("tangential history", "linear with ratio kt/kn: spring and dashpot together obey "
             "mu F_n")
    elif model.tangential == "history" and model.normal == "hertz":
        near("tangential history",
             "mindlin: damping of slip is 1/sqrt(4 G*/E*) times LIGGGHTS' (1.1 for a "
             "Poisson's ratio of 0.3), and spring and dashpot together obey mu F_n; an oblique "
             "impact at 1 m/s changes by 0.01 m/s, a settled bed by 0.02 diameters "
             "(docs/results.md)")
    elif model.tangential == "history":
        near("tangential history",
             "linear: spring and dashpot together obey mu F_n; an oblique impact at 1 m/s "
             "changes by up to 0.18 m/s, a settled bed by 0.005 diameters (docs/results.md)")
    elif model.tangential == "no_history":
        near("tangential no_history",
             "linear with ratio 0: slip is damped with the coefficient of the normal law, "
             "beside hertz 1/sqrt(4 G*/E*) times LIGGGHTS'; no heap rests, as there")
    elif model.tangential.startswith("incremental"):
        near("tangential " + model.tangential,
             "mindlinIncremental: the spring loses force with the stiffness "
             "while surfaces separate, so no cycle gives energy")
    if model.rolling == "cdt":
        near("rolling_friction cdt",
             "rollingConstant: mu_r R* times the normal force with its damping, LIGGGHTS "
             "without; at most what stops rolling in one step")
    elif model.rolling == "epsd":
        near("rolling_friction epsd",
             "rollingSpring with K = 2.25 mu_r^2: the limit holds for spring and dashpot "
             "together, in LIGGGHTS for the spring")
    elif model.rolling == "epsd2":
        near("rolling_friction epsd2",
             "rollingSpring without damping: the angle is stored, in LIGGGHTS the torque")
    if model.cohesion.startswith("sjkr"):
        near("cohesion " + model.cohesion,
             "sjkr: the area of contact to first order in the overlap")
    if model.on("limitForce"):
        near("limitForce on",
             "attraction clamped: restitution is too high in both codes, 0.33 for 0.2, 0.55 for "
             "0.5, 0.81 for 0.8")
    elif model.normal == "hooke/hysteresis":
        near("tangential",
             "the friction limit counts adhesion, mu (F_n + k_c d), in LIGGGHTS mu |F_n|")


class Need(Exception):
    """A property that the model needs and the script does not give, or one that has to be another:
    `why`."""

    def __init__(self, name, why="the model needs this property, which the script does not give"):
        super().__init__(name)
        self.why = why


def laws(model, base, properties, i, j):
    """`base`: the model of the particles, which decides the kinds of laws."""
    def value(name):
        if not properties.has(name):
            raise Need(name)
        return properties.value(name, i, j)

    found = {}
    normal, settings = normal_law(model, base, value, properties.length)
    found[normal] = settings
    damping = {"attraction": "clamped"} if model.on("limitForce") else {}
    if model.normal == "hooke/stiffness" and model.on("absolute_damping"):
        found["viscous"] = {"coefficient": value("gamman_abs"), **damping}
        check_slip(model, value("gammat_abs"), value("gamman_abs"), "gammat_abs")
    elif model.normal.endswith("/stiffness"):
        if value("gamman") != 0:
            raise Need("gamman", "Suna damps by the restitution or by a coefficient in kg/s; write "
                       "model hertz or hooke with coefficientRestitution")
        found["dry"] = {"restitution": 1.0}
        check_slip(model, value("gammat"), 0.0, "gammat")
    elif model.on("viscous"):
        found["stokesDamping"] = {"restitution": value("MaximumRestitution"), "beta": abs(
            value("CriticalStokes")), "viscosity": value("FluidViscosity"), **damping}
    else:
        found["dry"] = {"restitution": value("coefficientRestitution"), **damping}
    if base.tangential != "off":
        law, settings = friction_law(base, value)
        settings["friction"] = value("coefficientFriction") if model.tangential != "off" else 0.0
        if not model.on("tangential_damping"):
            settings["tangentialDamping"] = "no"
        found[law] = settings
    if base.rolling != "off":
        mu = value("coefficientRollingFriction") if model.rolling != "off" else 0.0
        if base.rolling == "cdt":
            found["rollingConstant"] = {"friction": mu}
        elif base.rolling == "epsd":
            damping = value("coefficientRollingViscousDamping") if model.rolling != "off" else 0.0
            found["rollingSpring"] = {"friction": mu, "stiffness": 2.25*mu**2, "damping": damping}
        else:
            found["rollingSpring"] = {"friction": mu, "damping": 0.0}
    if base.cohesion != "off":
        factor = {"sjkr": 1.0, "sjkr2": 2.0, "off": 0.0}[model.cohesion]
        found["sjkr"] = {"energyDensity": factor*value("cohesionEnergyDensity") if factor else 0.0}
    return found


def normal_law(model, base, value, length):
    """`length`: kn is a force over a length, beside hertz over its square."""
    if base.normal == "hooke/hysteresis":
        speed = {"impactSpeed": value("characteristicVelocity")}
        if model.normal == "hooke":
            return "hookeHysteresis", {"unloading": 1.0, "adhesion": 0.0, **speed}
        return "hookeHysteresis", {"unloading": value("coefficientMaxElasticStiffness"),
                                   "adhesion": value("coefficientAdhesionStiffness"),
                                   "plasticDepth": value("coefficientPlasticityDepth"), **speed}
    return {"hertz": lambda: ("hertz", {}),
            "hooke": lambda: ("hooke", {"impactSpeed": value("characteristicVelocity")}),
            "hertz/stiffness": lambda: ("hertz", {"stiffness": value("kn")/length}),
            "hooke/stiffness": lambda: ("hooke", {"stiffness": value("kn")})}[model.normal]()


def check_slip(model, given, normal, name):
    """Suna damps slip with the coefficient of the normal direction, or not at all."""
    if model.on("tangential_damping") and model.tangential != "off" and given != normal:
        raise Need(name, f"{given:g} is not {normal:g}: Suna damps slip with the coefficient of "
                   "the normal direction; write this one, or tangential_damping off")


def friction_law(base, value):
    if base.tangential == "no_history":
        return "linear", {"ratio": 0.0}
    if base.normal.endswith("/stiffness") and base.tangential == "history":
        return "linear", {"ratio": value("kt")/value("kn")}
    if base.normal.startswith("hertz"):
        return ("mindlin" if base.tangential == "history" else "mindlinIncremental"), {}
    return "linear", {"ratio": 2/7 if base.on("ktToKnUser") and base.normal == "hooke" else 1.0}


def fits(model, base):
    """A wall with this model can be a wall of a scene whose particles have the base: else a
    sentence."""
    if model.normal != base.normal and (model.normal, base.normal) != ("hooke", "hooke/hysteresis"):
        return (f"model {model.normal} beside {base.normal} of pair_style: a scene has one normal "
                "law")
    for part in ("tangential", "rolling", "cohesion"):
        mine, theirs = getattr(model, part), getattr(base, part)
        if mine not in (theirs, "off") and not (part == "cohesion" and theirs != "off"):
            return f"{part} {mine} beside {theirs} of pair_style: a scene has one law of each kind"
    if model.on("viscous") != base.on("viscous") or \
            model.on("absolute_damping") != base.on("absolute_damping"):
        return "damping that differs from pair_style: a scene has one law of damping"
    return ""
