"""cloud.py -- a case of OpenFOAM with colliding particles (kinematicCloudProperties).

    translate_cloud(Path("Goldschmidt"), Path("Goldschmidt.suna"), report)

DPMFoam's fluid becomes demPimpleFoam's: fields of the phase lose its name (U.air is U), the inlet's
interstitialInletVelocity becomes the superficial velocity. DPMFoam's momentum equation has pressure
and gravity without the void fraction and drag over it: set III (docs/theory-coupling.md), and so
has the result. icoUncoupledKinematicParcelFoam stays the solver, with its own cloud at rest, and a
function object moves the particles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

from .cloud_injection import add_injection
from .cloud_models import DRAG, FORCES, add_contacts, add_dispersion, add_forces, add_patches
from .coupled_case import CoupledCase, FIELDS
from .foam_dictionary import Entry
from .foam_reader import existing, file_text
from .mesh_patches import read_patches
from .report import Place

DPM = ("DPMFoam", "DPMDyMFoam")
UNCOUPLED = ("icoUncoupledKinematicParcelFoam", "icoUncoupledKinematicParcelDyMFoam")
NOT_DEM = ("is not DEM: its parcels do not touch, a model of the stress of packed particles "
           "pushes them apart; set up contact laws and single particles in constant/demProperties")
REACTING = ("is not DEM: its parcels exchange heat and mass with the gas and do not touch")
IDLE = """// the solver's own particles, inactive
solution
{
    active          false;
    coupled         false;
    transient       yes;
    cellValueSourceCorrection off;
    interpolationSchemes { }
    integrationSchemes { }
    sourceTerms { schemes { } }
}
constantProperties { rho0 1; youngsModulus 1; poissonsRatio 0.3; }
subModels { }
cloudFunctions { }
"""


def find_cloud(folder):
    """Names of the files of clouds in constant, or None."""
    names = {path.name.removesuffix(".gz")
             for path in (folder/"constant").glob("*loud*Properties*")}
    return sorted(name for name in names
                  if re.fullmatch(r"\w*[cC]loud\d*Properties", name)) or None


def translate_cloud(source, target, report):
    files = find_cloud(source)
    kinds = [name for name in files if not re.match("kinematicCloud|cloudProperties", name)]
    if kinds:
        report.refuse(Place("constant/" + kinds[0]), kinds[0].removesuffix("Properties"), REACTING)
    if len(files) > 1:
        report.refuse(Place("constant/" + files[1]), "a second cloud", "the importer takes one")
    CloudCase(source, target, report, files[0]).make()


class CloudCase(CoupledCase):
    def __init__(self, source, target, report, file):
        super().__init__(source, target, report)
        self.file, self.positions = "constant/" + file, {}
        self.cloud = self.read(self.file)
        self.name = file.removesuffix("Properties")

    def translate(self):
        self.refuse_others()
        self.application = self.control.word("application")
        place = self.control.where("application")
        if self.application in DPM:
            self.fluid = self.dpm
        elif self.application in UNCOUPLED:
            self.fluid = self.uncoupled
        elif self.application.startswith("inter"):
            self.report.refuse(place, f"application {self.application}", "the importer knows "
                               "clouds in one fluid; write constant/demProperties for demInterFoam "
                               "(docs/demInterFoam.md), or for the function object "
                               "(docs/coupled-case.md) where particles displace little")
        else:
            self.report.refuse(place, f"application {self.application}", "the importer knows "
                               f"{', '.join(DPM + UNCOUPLED)}; for another solver see "
                               "docs/coupled-case.md")
        self.patches = read_patches(self.source, self.report)
        if self.patches is None:
            self.report.refuse(Place("constant/polyMesh"), "boundary", "there is neither a mesh "
                               "nor a blockMeshDict: make the mesh first, so that its patches are "
                               "known")
        self.read_particles()
        self.copy(without=(self.file.split("/")[1] + "*", *self.position_files))
        self.fluid()
        self.write_changes()
        self.write_particles()

    def refuse_others(self):
        sub = self.cloud.sub("subModels")
        for name in ("packingModel", "dampingModel", "isotropyModel"):
            if sub.word(name, "none") != "none":
                sub.refuse(name, NOT_DEM, f"{sub.word(name)} (MP-PIC)")
        for name in ("compositionModel", "phaseChangeModel", "heatTransferModel"):
            if sub.word(name, "none") != "none":
                sub.refuse(name, REACTING, sub.word(name))

    # ---- particles -------------------------------------------------------------------------------

    def read_particles(self):
        report, properties, cloud = self.report, self.properties, self.cloud
        sub, constants = cloud.sub("subModels"), cloud.sub("constantProperties")
        model = sub.word("collisionModel", "none")
        if model != "pairCollision":
            report.refuse(sub.where("collisionModel"),
                          f"subModels/collisionModel {model}", "parcels that "
                          "do not touch are not DEM; pairCollision has contacts")
        report.translated(sub.where("collisionModel"), "subModels/collisionModel pairCollision")
        self.read_solution()
        walls = add_contacts(sub, constants, properties, report)
        self.read_forces(sub)
        add_patches(self.patches, walls, sub, properties, report, sub.place)
        self.read_injections(sub, constants)
        add_dispersion(sub, properties, report)
        self.read_constants(constants)
        self.name_the_rest(sub)

    def read_solution(self):
        report, solution = self.report, self.cloud.sub("solution")
        if not solution.switch("active", True):
            report.refuse(solution.where("active"), "solution/active", "is no, so the cloud has no particles")
        if not solution.switch("transient", True):
            report.refuse(solution.where("transient"), "solution/transient", "is no, and steady clouds are not "
                          "translated; see steady solvers in docs/coupled-case.md")
        self.coupled = solution.switch("coupled", True)
        report.translated(solution.where("coupled"), "solution/coupled", "coupling/twoWay "
                          f"{'yes' if self.coupled else 'no'}")
        for name, why in (("transient", ""), ("cellValueSourceCorrection",
                                              "the exchange is implicit"),
                          ("maxCo", "DEM steps follow from the contact time"),
                          ("interpolationSchemes",
                           "the kernel's weights read the fluid at particles"),
                          ("integrationSchemes", "leapfrog, with exponential drag"),
                          ("sourceTerms", "the exchange is implicit and keeps momentum"),
                          ("calcFrequency", ""), ("maxTrackTime", ""), ("averagingMethod", "")):
            if solution.find(name):
                solution.harmless(name, why)
        solution.refuse_unread()

    def read_forces(self, sub):
        report, properties, forces = self.report, self.properties, sub.sub("particleForces")
        self.dense = self.application in DPM
        names = add_forces(forces, properties, report, given=("gravity", "pressureGradient"))
        self.gravity = "gravity" in names
        if not self.gravity:
            report.approximated(forces.place, "subModels/particleForces without gravity",
                                "constant/g is set to (0 0 0): particles have neither weight nor "
                                "buoyancy")
        properties.add("effects", "pressureGradient {}",
                       forces.where("gravity") if self.gravity else forces.place)
        if self.gravity:
            report.translated(forces.where("gravity"), "subModels/particleForces/gravity, with "
                              "buoyancy (1 - rho/rho0)",
                              "weight from constant/g and pressureGradient")
        if self.dense and "pressureGradient" in names:
            report.approximated(forces.where("pressureGradient"), "subModels/particleForces/"
                                "pressureGradient", "equations III contain the pressure gradient "
                                "of the flow in drag over the void fraction, so it is not added "
                                "twice; there it is")
        if self.dense and "sphereDrag" in names:
            report.approximated(forces.where("sphereDrag"), "subModels/particleForces/sphereDrag",
                                "equations III divide drag by the void fraction, which this law of "
                                "one sphere does not know there")
        drags = [name for name in names if FORCES[name][0].split()[0] in DRAG]
        if len(drags) > 1:
            report.refuse(forces.where(drags[1]), f"subModels/particleForces/{drags[1]}",
                          "a second law of drag; Suna has at most one")

    def read_injections(self, sub, constants):
        report, injections = self.report, sub.sub("injectionModels")
        self.position_files = []
        density = constants.number("rho0")
        for name, d in injections.subs():
            add_injection(name, d, self, density, self.properties, report, self.cloud)
            if "positionsFile" in d:
                self.position_files.append(d.word("positionsFile") + "*")
        if not self.properties.sections["insert"]:
            self.properties.add("start", 'snapshot "settled.dem";', injections.place)
            report.approximated(injections.place, "subModels/injectionModels", "no injection: the "
                                "particles come from another run. Give its file "
                                "uniform/dem.snapshot as settled.dem, or write groups under insert "
                                "in its place")

    def read_constants(self, constants):
        report = self.report
        limit = constants.number("alphaMax", None)
        if limit is not None and self.dense:
            self.properties.add("coupling",
                                f"minVoidFraction {1 - limit:.6g};", constants.where("alphaMax"))
            report.translated(constants.where("alphaMax"), "constantProperties/alphaMax",
                              "coupling/minVoidFraction, one minus it")
        for name in ("parcelTypeId", "rhoMin", "minParcelMass", "constantVolume", "pMin"):
            if constants.find(name):
                constants.harmless(name)
        constants.find("alphaMax")
        constants.refuse_unread(deep=True)

    def name_the_rest(self, sub):
        """Submodels that are none, Coeffs of models that are not chosen, cloudFunctions."""
        report = self.report
        chosen = {entry.value[0] for entry in sub.entries
                  if isinstance(entry.value, list) and entry.value}
        for entry in sub.unread():
            base = str(entry.name).removesuffix("Coeffs")
            none = isinstance(entry.value, list) and str(entry.value[0]) in ("none", "off", "no")
            if none or entry.name.endswith("Coeffs") and base not in chosen:
                report.harmless(entry.place, sub.full(entry.name), "not chosen" if not none else "")
            else:
                report.refuse(entry.place, sub.full(entry.name),
                              "the importer does not know this model")
        for entry in self.cloud.sub("cloudFunctions").entries:
            report.harmless(entry.place, f"cloudFunctions/{entry.name}", "see docs/output.md for "
                            "what Suna writes")
        for name in ("solution", "constantProperties", "subModels", "cloudFunctions"):
            self.cloud.find(name)
        self.cloud.refuse_unread()

    # ---- fluid -----------------------------------------------------------------------------------

    def dpm(self):
        """DPMFoam: demPimpleFoam."""
        report, self.command = self.report, "blockMesh; demPimpleFoam"
        transport = self.read("constant/transportProperties")
        phase = transport.word("continuousPhase" if "continuousPhase" in transport else
                               "continuousPhaseName")
        density = transport.number("rho." + phase)
        self.properties.add("coupling", f"rho {density:.12g};", transport.where("rho." + phase))
        report.translated(transport.where("rho." + phase), "rho." + phase, "coupling/rho")
        self.properties.add("coupling", "equations III;", self.control.where("application"))
        report.translated(self.control.where("application"), "equations of " + self.application,
                          "coupling/equations III; the default, II, is exact in flows that change, "
                          "too")
        self.properties.add("coupling", "kernel linear;", self.cloud.place)
        report.approximated(self.cloud.place, "void fraction of the cells of the centres",
                            "kernel linear, as it does not jump when a particle changes cell: "
                            "smoother by half a cell")
        report.approximated(Place(f"{self.start}/p", 1), "p", "is without the hydrostatic part in "
                            "demPimpleFoam: at the bottom lower by rho g h than there")
        if not self.coupled:
            self.properties.add("coupling", "twoWay no;")
        self.use_solver("U." + phase)
        self.rename_fields(phase)
        name = f"turbulenceProperties.{phase}"
        if self.has("constant/" + name):
            path = existing(self.target/"constant"/name)
            (self.target/"constant/turbulenceProperties").write_text(
                file_text(path).replace(name, "turbulenceProperties"), encoding="latin-1")
        self.set_gravity()

    def rename_fields(self, phase):
        report = self.report
        for name in self.fields:
            field = self.field(name)
            plain = name.removesuffix("." + phase)
            for path in (self.zero/name, self.zero/(name + ".gz")):
                path.unlink(missing_ok=True)
            if plain in ("alpha", "phi") or plain.endswith("theta"):
                report.harmless(Place(f"{self.start}/{name}"), name, "computed from the particles")
                continue
            if plain in FIELDS:
                self.plain_field(plain, field, phase)
            else:
                text = file_text(existing(self.source/self.start/name))
                (self.zero/plain).write_text(re.sub(rf"\b(\w+)\.{phase}\b", r"\1", text),
                                             encoding="latin-1")
            if plain != name:
                report.translated(Place(f"{self.start}/{name}"), name, f"0/{plain}")

    def plain_field(self, plain, field, phase):
        for patch, inner in field.sub("boundaryField").subs():
            if inner.word("type", "") == "interstitialInletVelocity":
                velocity = inner.tokens("inletVelocity")
                self.report.translated(inner.where("type"), f"{patch} interstitialInletVelocity",
                                       "fixedValue: demPimpleFoam's inlets have the superficial "
                                       "velocity")
                inner.entries = [Entry("type", inner.place, ["fixedValue"]),
                                 Entry("value", inner.place, velocity)]
            inner.entries = [e for e in inner.entries if e.name not in ("phi", "alpha")]
        if plain == "p":
            self.fix_pressure(self.field("U." + phase), field)
        self.write_field(plain, field, [f"// As {self.start}/{plain} of {self.application}'s "
                                        "case."])

    def uncoupled(self):
        """A given flow that stands: the solver stays, its cloud rests, a function object acts."""
        report, place = self.report, self.control.where("application")
        self.command = f"blockMesh; {self.application} -cloud idle"
        report.translated(place, f"application {self.application}", f"{self.application} -cloud "
                          "idle with the function object demCloud")
        if self.coupled:
            report.approximated(self.cloud.sub("solution").where("coupled"), "solution/coupled yes",
                                f"coupling/twoWay no: {self.application} does not solve for the "
                                "fluid, so it feels nothing there either")
        self.properties.add("coupling", "twoWay no;", self.cloud.sub("solution").where("coupled"))
        self.write("constant/idleProperties", IDLE)
        self.change("system/controlDict", "functions { particles { type demCloud; libs "
                    '("libdemCoupling.so"); } }')
        schemes = self.read("system/fvSchemes")
        self.use_default(schemes, "ddtSchemes", "Euler")
        self.use_default(schemes, "gradSchemes", "Gauss linear")
        transport = self.read("constant/transportProperties")
        if "rhoInf" not in transport:
            report.refuse(transport.place, "rhoInf", "is missing: the fluid's density")
        self.set_gravity()

    def set_gravity(self):
        if not self.gravity:
            self.write("constant/g", "dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 0);\n",
                       "uniformDimensionedVectorField")

    # ---- result ----------------------------------------------------------------------------------

    def write_particles(self):
        for name, positions in self.positions.items():
            rows = "\n".join(f"    ({x:.17g} {y:.17g} {z:.17g})" for x, y, z in positions)
            (self.target/f"constant/{name}Positions").write_text(f"positions\n(\n{rows}\n);\n")
        self.write_properties(f"{self.source.name} ({self.file})", self.command)
