"""cfdem.py -- a case of CFDEMcoupling (CFD/constant/couplingProperties, DEM/in.*).

    translate_cfdem(Path("ErgunTestMPI"), Path("ErgunTestMPI.suna"), report)

The fluid's side is copied from CFD: fields U and p, boundary conditions of voidfraction, system.
The DEM script that couplingProperties names (twoWayMPIProps/liggghtsPath) goes through the importer
of LIGGGHTS; what it says of particles becomes constant/demProperties. Where it reads a restart
file, the particles come from the script beside it that writes the file: its insertion becomes
`insert`, and `demPimpleFoam -settle` lets them settle in the mesh's own walls for as long as that
script runs. cfdemSolverMultiphase becomes demInterFoam (cfdem_two_fluids.py).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

from . import cfdem_two_fluids
from .cfdem_models import HEAT, add_equations, add_exchange, add_forces, add_kernel
from .cfdem_script import read_dem_script
from .cfdem_walls import place_walls
from .coupled_case import CoupledCase
from .foam_dictionary import Dictionary, as_text
from .foam_reader import existing
from .liggghts_mesh import write_stl
from .mesh_patches import COUPLED, read_patches
from .report import Place

SOLVERS = ("cfdemSolverPiso", "cfdemSolverPimple", "cfdemSolverPimpleImEx",
           "cfdemSolverPimpleImExFace")
TWO_FLUIDS = "cfdemSolverMultiphase"
REFUSED_SOLVERS = {
    "cfdemSolverIB": "resolved particles (immersed boundary); Suna's particles are not larger "
                     "than cells",
    "cfdemSolverPisoScalar": HEAT,
    "cfdemSolverPisoSTM": HEAT,
    "cfdemSolverRhoPimple": "a compressible gas in a dense bed; demPimpleFoam is incompressible",
}
# word: {value: None (no effect) or the sentence why not}
TOP = {
    "locateModel": {"engine": None, "standard": None, "turboEngine": None, "turboEngineM2M": None,
                    "engineIB": None},
    "meshMotionModel": {"noMeshMotion": None},
    "regionModel": {"allRegion": None},
    "IOModel": {"basicIO": None, "trackIO": None, "noIO": None, "off": None, "sophIO": None},
    "probeModel": {"off": None, "noProbe": None, "particleProbe": None},
    "averagingModel": {"dense": None, "dilute": None},
    "clockModel": {"off": None, "noClock": None, "standardClock": None},
    "dataExchangeModel": {
        "twoWayMPI": None, "M2M": None, "twoWayM2M": None, "twoWayFiles": None,
        "twoWayOne2One": None,
        "oneWayVTK": "particles read from VTK files; Suna moves its own",
        "noDataExchange": "no particles are exchanged"},
}
FREE = {"turbulenceModelType": "constant/turbulenceProperties is read", "debug": "", "verbose": "",
        "ignore": "", "allowAdjustTimeStep":
        "adjustTimeStep of controlDict", "checkPeriodicCells": "",
        "syncMode": "fluid and particles exchange in each fluid step",
        "imExSplitFactor": "the exchange is implicit", "depth": "", "solveScalarTransport": ""}
HANDLED = ("modelType", "couplingInterval", "voidFractionModel", "smoothingModel", "forceModels",
           "momCoupleModels", "useDDTvoidfraction", "solveFlow", "FoamFile", "particleShapeType")
NOT_NEEDED = ("Us", "Ksl", "rho", "voidfraction", "sSmoothField", "vSmoothField", "dSmoothing",
              "phiIB", "UsNext", "voidfractionNext", "nuSgs")
INPUT = ("couplingProperties", "liggghtsCommands", "particleTrackProperties")


def is_cfdem(folder):
    return existing(folder/"CFD/constant/couplingProperties") is not None


def translate_cfdem(source, target, report):
    CfdemCase(source, target, report).make()


class CfdemCase(CoupledCase):
    def __init__(self, source, target, report):
        super().__init__(source/"CFD", target, report, prefix="CFD/")
        self.top = source
        self.coupling = self.read("constant/couplingProperties")

    def translate(self):
        self.read_solver()
        self.read_top()
        self.patches = read_patches(self.source, self.report)
        if self.patches is None:
            self.report.refuse(Place("CFD/constant/polyMesh"), "boundary", "there is neither a "
                               "mesh nor a blockMeshDict: make the mesh first, so that its patches "
                               "are known")
        if not any(patch.faces for patch in self.patches.values()):
            self.report.refuse(Place("CFD/constant/polyMesh"), "points",
                               "is binary: write it as text "
                               "(foamFormatConvert), so that walls can be compared with patches")
        self.read_commands()
        self.read_script()
        number = add_equations(self.coupling, self.properties, self.report)
        add_kernel(self.coupling, self.dem.diameter, self.properties, self.report)
        if self.two_fluids and number != "II":
            self.report.refuse(self.coupling.where("modelType"), "modelType",
                               "must be A: demInterFoam solves equations of set II only")
        add_forces(self.coupling, number, self.properties, self.report, self.two_fluids)
        add_exchange(self.coupling, self.properties, self.report)
        self.read_interval()
        self.read_rest()
        if not self.two_fluids:
            self.read_density()
        self.copy(without=INPUT + tuple(name + "_*" for name in INPUT))
        self.dem.add_particles(self.properties, self.target)
        for name, triangles in self.surfaces.items():
            (self.target/"constant/triSurface").mkdir(exist_ok=True)
            write_stl(self.target/f"constant/triSurface/{name}.stl", triangles)
        self.write_fluid()
        self.write_changes()
        solver = "demInterFoam" if self.two_fluids else "demPimpleFoam"
        settle = f"{solver} -settle; " if self.dem.settle is not None else ""
        self.write_properties(f"{self.top.name} (CFDEMcoupling)", f"blockMesh; {settle}{solver}")

    # ---- couplingProperties ----------------------------------------------------------------------

    def read_solver(self):
        """The solver is the one that the case's scripts start: controlDict is not asked for it."""
        names = [self.control.word("application", "none")]
        for script in sorted(self.top.glob("*.sh")):
            names += re.findall(r'solverName="?(\w+)"?', script.read_text(errors="replace"))
        place = self.control.where("application")
        for name in names:
            if name in REFUSED_SOLVERS:
                self.report.refuse(place, name, REFUSED_SOLVERS[name])
        self.two_fluids = TWO_FLUIDS in names
        if not any(name in (*SOLVERS, TWO_FLUIDS) for name in names):
            self.report.approximated(place, f"application {names[0]}", "taken for "
                                     "cfdemSolverPiso, as no solver of CFDEMcoupling is named")

    def read_top(self):
        report, d = self.report, self.coupling
        if not d.switch("solveFlow", True):
            report.refuse(d.where("solveFlow"), "solveFlow off", "demPimpleFoam always solves for "
                          "the flow; for a given flow see icoUncoupledKinematicParcelFoam in "
                          "docs/coupled-case.md")
        if "particleShapeType" in d and d.word("particleShapeType"):
            report.refuse(d.where("particleShapeType"), "particleShapeType",
                          "clumps of a coupled case are not translated; write shapes in constant/demProperties")
        for name, values in TOP.items():
            if name in d:
                value = d.word(name)
                word = f"{name} {value}"
                if value not in values:
                    report.refuse(d.where(name), word, f"known are {', '.join(values)}")
                if values[value]:
                    report.refuse(d.where(name), word, values[value])
                report.harmless(d.where(name), word)

    def read_rest(self):
        """What nobody has read: free words, settings of models that are not chosen."""
        report, d, idle = self.report, self.coupling, []
        for entry in d.unread():
            if entry.name in FREE:
                report.harmless(entry.place, entry.name, FREE[entry.name])
            elif entry.name in HANDLED or entry.name in TOP:
                continue
            elif isinstance(entry.value, Dictionary) and re.search(r"Props\)?$", entry.name):
                idle.append((entry.name, entry.place))
            else:
                report.refuse(entry.place, str(entry.name), "the importer does not know this entry")
        for name in ("engineProps", "twoWayMPIProps"):
            if d.find(name):
                report.harmless(d.where(name), name)
        if idle:
            report.harmless(idle[0][1], " ".join(str(name) for name, _ in idle), "of models that "
                            "are not chosen, or that change nothing here")

    def read_interval(self):
        report, d = self.report, self.coupling
        interval, step = d.number("couplingInterval"), self.dem.step
        fluid = self.control.number("deltaT")
        place, word = d.where("couplingInterval"), f"couplingInterval {interval:g}"
        if step is None:
            report.approximated(place, word,
                                f"deltaT {fluid:g} s of controlDict; the script has no timestep")
            return
        window = interval*step
        if window < fluid*(1 - 1e-6):
            report.approximated(place, word, f"deltaT {window:g} s: {interval:g} DEM steps of "
                                f"{step:g} s, where controlDict has {fluid:g} s")
            self.change("system/controlDict", f"deltaT          {window:.12g};")
        elif window > fluid*(1 + 1e-6):
            report.approximated(place, word, f"deltaT {fluid:g} s of controlDict: fluid and "
                                f"particles exchange in each fluid step, not every {window:g} s")
        else:
            report.translated(place, word,
                              f"deltaT {fluid:g} s: {interval:g} DEM steps of {step:g} s")

    def read_commands(self):
        """liggghtsCommands: what CFDEMcoupling tells LIGGGHTS during the run."""
        report = self.report
        if not self.has("constant/liggghtsCommands"):
            return
        d = self.read("constant/liggghtsCommands")
        place = d.where("liggghtsCommandModels")
        for k, name in enumerate(str(x) for x in d.list("liggghtsCommandModels", [])):
            props = d.sub(f"{name}Props{k}") if f"{name}Props{k}" in d else d.sub(name + "Props")
            if name == "runLiggghts":
                report.translated(place, name)
            elif name == "writeLiggghts":
                report.harmless(place, name, "a snapshot is written at each write time")
            elif name == "execute":
                words = [str(x) for x in props.list("command", [])]
                text = " ".join(word for word in words if word not in ("noBlanks", "blanks"))
                if words[:1] != ["write_restart"]:
                    report.refuse(props.where("command"), f"execute {text}", "a command to "
                                  "LIGGGHTS during the run; Suna takes none")
                report.harmless(props.where("command"), f"execute {text}", "a snapshot is written "
                                "at each write time")
            else:
                report.refuse(place, name, "a command to LIGGGHTS during the run; known are "
                              "runLiggghts, writeLiggghts, execute write_restart")

    # ---- the DEM script --------------------------------------------------------------------------

    def script_path(self):
        d = self.coupling
        model = d.word("dataExchangeModel")
        props = d.sub(model + "Props")
        if model == "twoWayFiles" or "liggghtsPath" not in props:
            scripts = sorted((self.top/"DEM").glob("in.*run*")) or \
                sorted((self.top/"DEM").glob("in.*"))
            if not scripts:
                self.report.refuse(d.where("dataExchangeModel"), model,
                                   "there is no script DEM/in.*; put it there")
            return scripts[0], d.where("dataExchangeModel")
        name = as_text(props.tokens("liggghtsPath")).strip('"')
        path = (self.source/name).resolve()
        if not path.is_file():
            self.report.refuse(props.where("liggghtsPath"), f"liggghtsPath {name}",
                               "there is no such file")
        return path, props.where("liggghtsPath")

    def read_script(self):
        report, (path, place) = self.report, self.script_path()
        top = self.top.resolve()
        name = str(path.relative_to(top) if path.is_relative_to(top) else path)
        report.translated(place, name, "constant/demProperties")
        self.dem = read_dem_script(path, top, report)
        self.dem.add_laws(self.properties)
        self.surfaces = place_walls(self.dem.walls, self.patches,
                                    (self.dem.centre, self.dem.diameter), self.dem.material,
                                    self.properties, report, self.coupling.place)
        self.check_periodic()

    def check_periodic(self):
        cyclic = [patch.name for patch in self.patches.values() if patch.type in COUPLED]
        if self.dem.periodic and not cyclic:
            self.report.refuse(self.dem.periodic, "boundary p", "particles are periodic and the "
                               "mesh has no cyclic patches; in Suna they follow the mesh")
        if cyclic and not self.dem.periodic:
            self.report.approximated(self.coupling.place, f"patch {cyclic[0]}", "particles are "
                                     "periodic as the mesh is; in the DEM script they are not")

    # ---- the fluid -------------------------------------------------------------------------------

    def read_density(self):
        report = self.report
        if "rho" not in self.fields:
            report.refuse(Place(f"CFD/{self.start}/rho"), "rho",
                          "there is no such field: the fluid's density")
        tokens = self.field("rho").tokens("internalField")
        place = self.field("rho").where("internalField")
        if tokens[:1] != ["uniform"]:
            report.refuse(place, "rho", "is not uniform; demPimpleFoam has a fluid of one density")
        density = self.field("rho").positive("internalField")
        self.properties.add("coupling", f"rho {density:.12g};", place)
        report.translated(place, "rho", "coupling/rho")

    def write_fluid(self):
        report = self.report
        self.use_solver(two_fluids=self.two_fluids)
        if self.two_fluids:
            cfdem_two_fluids.prepare(self)
        else:
            velocity, pressure = self.field("U"), self.field("p")
            if self.fix_pressure(velocity, pressure):
                self.write_field("p", pressure, [f"// As CFD/{self.start}/p, with fixedFluxPressure "
                                                 "where the velocity is given."])
        if "voidfraction" in self.fields:
            self.write_field("voidFraction", self.field("voidfraction"),
                             [f"// Boundary conditions of CFD/{self.start}/voidfraction."])
            report.translated(Place(f"CFD/{self.start}/voidfraction"), "boundaryField",
                              "0/voidFraction")
        for name in NOT_NEEDED:
            for path in (self.zero/name, self.zero/(name + ".gz")):
                if path.exists():
                    path.unlink()
                    if name not in ("rho", "voidfraction"):
                        report.harmless(Place(f"CFD/{self.start}/{name}"), name,
                                        "computed from particles")
        if "libs" in self.control:
            libraries = as_text(self.control.tokens("libs"))
            report.harmless(self.control.where("libs"), "libs " + libraries,
                            "libraries of CFDEMcoupling")
            self.change("system/controlDict", "libs ();")
        self.driving_force()
        self.set_gravity()

    def set_gravity(self):
        """Of the DEM script, as the particles' weight is that one."""
        given = self.read("constant/g").vector("value") if self.has("constant/g") else None
        acts, place = self.dem.state["gravity"] or ((0.0, 0.0, 0.0), self.coupling.place)
        place = self.dem.place(place) if self.dem.state["gravity"] else place
        if given is None or any(abs(a - b) > 1e-6 for a, b in zip(given, acts)):
            self.report.approximated(place, "fix gravity", f"constant/g is set to it, {given} in "
                                     "CFD: weight and buoyancy have one g")
            text = " ".join(f"{x:.12g}" for x in acts)
            self.write("constant/g", f"dimensions [0 1 -2 0 0 0 0];\nvalue ({text});\n",
                       "uniformDimensionedVectorField")
        else:
            self.report.translated(place, "fix gravity", "constant/g")

    def driving_force(self):
        """meanSupVelocityForce of CFDEMcoupling as OpenFOAM's meanVelocityForce."""
        for name in ("system/fvOptions", "constant/fvOptions"):
            if not self.has(name):
                continue
            for option, d in self.read(name).subs():
                if not d.entries or option == "FoamFile":
                    continue
                kind = d.word("type", "none")
                if kind != "meanSupVelocityForce":
                    continue
                inner = d.sub(kind + "Coeffs")
                velocity = inner.vector("Ubar")
                self.report.approximated(d.where("type"), f"{option} {kind}", "meanVelocityForce: "
                                         "the mean of the interstitial velocity, there of the "
                                         "superficial one; they differ by the mean solid fraction")
                text = " ".join(f"{x:.12g}" for x in velocity)
                self.change(name, f"{option}", "{", "    type meanVelocityForce;",
                            "    selectionMode all;", "    fields (U);", f"    Ubar ({text});",
                            f"    relaxation {inner.number('relaxation', 1.0):g};",
                            "    meanVelocityForceCoeffs { selectionMode all; fields (U); "
                            f"Ubar ({text}); relaxation {inner.number('relaxation', 1.0):g}; "
                            f"}}", "}")
