"""coupled_case.py -- the case that a translation makes: a copy of the OpenFOAM case of the source
with what Suna needs.

Files of the source stay byte by byte: one that is changed is kept as NAME.original, and the new
file includes it and adds entries, which replace or are merged with the entries of the original. Fields
are written anew, as OpenFOAM would read NAME.original beside them.

demPimpleFoam needs of a case: the application; Euler in time; schemes of its terms; linear solvers
of p and U; PIMPLE; fixedFluxPressure at fixed inlets (docs/demPimpleFoam.md). demInterFoam needs the
same with p_rgh (docs/demInterFoam.md).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import shutil

from .foam_dictionary import Dictionary, Entry, as_text
from .foam_reader import existing, file_text, read_dictionary
from .report import CannotTranslate, Place
from .scene_text import SceneText

FIXED_VELOCITY = ("fixedValue", "uniformFixedValue", "flowRateInletVelocity", "codedFixedValue",
                  "surfaceNormalFixedValue", "timeVaryingMappedFixedValue",
                  "variableHeightFlowRate", "interstitialInletVelocity", "turbulentDFSEMInlet",
                  "cylindricalInletVelocity")
FIELDS = {"U": ("volVectorField", "[0 1 -1 0 0 0 0]"), "p": ("volScalarField", "[0 2 -2 0 0 0 0]"),
          "p_rgh": ("volScalarField", "[1 -1 -2 0 0 0 0]"),
          "voidFraction": ("volScalarField", "[0 0 0 0 0 0 0]")}
# group of fvSchemes, name of demPimpleFoam's term, names for it elsewhere, scheme without one
TERMS = (("gradSchemes", "grad(U)", (), "Gauss linear"),
         ("divSchemes", "div(alphaPhi,U)", ("div(phi,U)",), "Gauss limitedLinearV 1"),
         ("divSchemes", "div((nuEff*dev2(T(grad(U)))))", (), "Gauss linear"),
         ("divSchemes", "div(alphaPhi)", (), "Gauss linear"),
         ("laplacianSchemes", "laplacian(nuEff,U)", (), "Gauss linear corrected"),
         ("interpolationSchemes", "interpolate(inside)", (), "linear"),
         ("snGradSchemes", "snGrad(p)", (), "corrected"))
TERMS_OF_TWO_FLUIDS = (("gradSchemes", "grad(U)", (), "Gauss linear"),
                       ("divSchemes", "div(rhoPhi,U)", (), "Gauss linearUpwind grad(U)"),
                       ("divSchemes", "div(phi,alpha)", (), "Gauss vanLeer"))
SOLVERS = {"p": "solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0;",
           "p_rgh": "solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0;",
           "U": "solver PBiCGStab; preconditioner DILU; tolerance 1e-8; relTol 0;"}


def header(kind, name, comments=()):
    return "".join(line + "\n" for line in comments) + f"""FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    object      {name};
}}

"""


def render(d, indent=""):
    """A dictionary's entries as lines of text."""
    lines = []
    for entry in d.entries:
        name = f'"{entry.name}"' if entry.pattern else entry.name
        if isinstance(entry.value, Dictionary):
            lines += [f"{indent}{name}", indent + "{", *render(entry.value, indent + "    "),
                      indent + "}"]
        else:
            lines.append(f"{indent}{name} {as_text(entry.value)}".rstrip() + ";")
    return lines


class CoupledCase:
    """source: folder with system and constant; target: the folder to be made."""

    def __init__(self, source, target, report, prefix=""):
        self.source, self.target, self.report, self.prefix = source, target, report, prefix
        if target.exists():
            report.refuse(Place(str(target)), "the result",
                          "exists already; name another folder, or remove it")
        self.control = self.read("system/controlDict")
        self.start = self.start_folder()
        self.changes = {}           # file: lines that are added to it
        self.properties = SceneText()

    def make(self):
        """The case, or nothing where it cannot be translated."""
        try:
            self.translate()
        except CannotTranslate:
            shutil.rmtree(self.target, ignore_errors=True)
            raise

    def read(self, name):
        return read_dictionary(self.source/name, self.prefix + name, self.report)

    def has(self, name):
        return existing(self.source/name) is not None

    def start_folder(self):
        """Name of the folder with the initial fields."""
        folders = {path.name for path in self.source.iterdir() if path.is_dir()}
        times = sorted((float(name), name) for name in folders
                       if re.fullmatch(r"\d+(\.\d*)?", name))
        begins = self.control.word("startFrom", "latestTime")
        if begins == "startTime":
            start = self.control.number("startTime", 0.0)
            times = [x for x in times if x[0] == start]
        elif begins == "firstTime":
            times = times[:1]
        for name in ([times[-1][1]] if times else []) + ["0.orig", "0.org"]:
            if name in folders:
                return name
        self.report.refuse(self.control.where("startTime"), "startTime",
                           "there is no folder with the fields of this time, and no 0.orig")

    @property
    def fields(self):
        """Names of the fields at the start, without .gz."""
        return sorted({path.name[:-3] if path.suffix == ".gz" else path.name
                       for path in (self.source/self.start).iterdir() if path.is_file()})

    def field(self, name):
        return self.read(f"{self.start}/{name}")

    # ---- writing ---------------------------------------------------------------------------------

    def copy(self, without=()):
        """`without`: files of constant that are input of the other code."""
        self.target.mkdir(parents=True)
        leave = shutil.ignore_patterns(*without, "lagrangian")
        shutil.copytree(self.source/"system", self.target/"system")
        shutil.copytree(self.source/"constant", self.target/"constant", ignore=leave)
        self.zero = self.target/("0" if self.start.startswith("0.o") else self.start)
        shutil.copytree(self.source/self.start, self.zero, ignore=leave)
        for path in self.target.rglob("*"):
            path.chmod(path.stat().st_mode | 0o200)

    def change(self, name, *lines):
        """Adds lines to a file of the source."""
        self.changes.setdefault(name, []).extend(lines)

    def write_changes(self):
        for name, lines in self.changes.items():
            path = self.target/name
            text = file_text(existing(path))
            kept = path.with_name(path.name + ".original")
            existing(path).rename(kept)
            if kept.read_bytes()[:2] == b"\x1f\x8b":
                kept.write_text(text, encoding="latin-1")
            path.write_text(header("dictionary", path.name,
                                   [f"// As {self.prefix}{name}, with what Suna needs."]) +
                            f'#include "{kept.name}"\n\n' + "\n".join(lines) + "\n")

    def write(self, name, text, kind="dictionary"):
        path = self.target/name
        path.write_text(header(kind, path.name) + text)

    def write_properties(self, source, command):
        self.write("constant/demProperties", self.properties.text(
            [f"// Particles of {source}, translated by dem import.", f"// To run: {command}",
             *self.report.comment()]))

    def write_field(self, name, field, comments=()):
        kind, dimensions = FIELDS[name]
        for old in (self.zero/name, self.zero/(name + ".gz")):
            old.unlink(missing_ok=True)
        inner = as_text(field.tokens("internalField"))
        (self.zero/name).write_text(
            header(kind, name, comments) +
            f"dimensions      {dimensions};\ninternalField   {inner};\n\n"
            "boundaryField\n{\n" + "\n".join(render(field.sub("boundaryField"), "    ")) + "\n}\n")

    # ---- what the solvers need -------------------------------------------------------------------

    def use_solver(self, velocity="U", two_fluids=False):
        """Solver, schemes and linear solvers; `velocity` is the name of U in the source."""
        report, place = self.report, self.control.where("application")
        name = "demInterFoam" if two_fluids else "demPimpleFoam"
        report.translated(place, "application " + self.control.word("application", "none"), name)
        self.change("system/controlDict", f"application     {name};")
        self.use_schemes(velocity, two_fluids)
        self.use_solvers(velocity, "p_rgh" if two_fluids else "p")

    def use_schemes(self, velocity, two_fluids):
        report, schemes = self.report, self.read("system/fvSchemes")
        time = schemes.sub("ddtSchemes")
        for entry in time.entries:
            if as_text(entry.value) not in ("Euler", "none"):
                report.approximated(entry.place, f"ddtSchemes/{entry.name} {as_text(entry.value)}",
                                    "Euler, which demPimpleFoam needs: first order in time")
        if any(as_text(e.value) != "Euler" for e in time.entries) or not time.entries:
            self.change("system/fvSchemes", "ddtSchemes",
                        "{", *(f"    {name} Euler;" for name in
                               {"default": 0, **{e.name: 0 for e in time.entries}}), "}")
        for group, term, elsewhere, scheme in TERMS_OF_TWO_FLUIDS if two_fluids else TERMS:
            d = schemes.sub(group)
            flux = f"alphaPhi{velocity[1:]}" if velocity != "U" else "phi"
            names = [name.replace("U", velocity).replace("phi", flux) for name in elsewhere]
            found = next((name for name in (term, *names) if name in d), None)
            if found == term:
                continue
            if found:
                scheme = as_text(d.tokens(found))
            elif d.word("default", "none") != "none":
                continue
            self.change("system/fvSchemes", f"{group} {{ {term} {scheme}; }}")
        self.use_default(schemes, "laplacianSchemes", "Gauss linear corrected")
        self.use_default(schemes, "interpolationSchemes", "linear")
        self.use_default(schemes, "gradSchemes", "Gauss linear")
        if two_fluids:
            self.use_default(schemes, "divSchemes", "Gauss linear")
            self.use_default(schemes, "snGradSchemes", "corrected")

    def use_default(self, schemes, group, scheme):
        """Where the group has no default."""
        if schemes.sub(group).word("default", "none") == "none":
            self.change("system/fvSchemes", f"{group} {{ default {scheme}; }}")

    def use_solvers(self, velocity, pressure):
        report, solution = self.report, self.read("system/fvSolution")
        solvers = solution.sub("solvers")
        for name, elsewhere in ((pressure, pressure), ("U", velocity)):
            for end in ("", "Final"):
                if name + end in solvers:
                    continue
                found = next((x for x in (elsewhere + end, elsewhere, name) if x in solvers), None)
                inner = " ".join(render(solvers.sub(found))) if found else SOLVERS[name]
                self.change("system/fvSolution", f"solvers {{ {name}{end} {{ {inner} }} }}")
        if "PIMPLE" not in solution:
            piso = solution.sub("PISO")
            self.change("system/fvSolution", "PIMPLE", "{", "    nOuterCorrectors 1;",
                        *render(piso, "    "), *(() if "nCorrectors" in piso else
                                                 ("    nCorrectors 2;",)), "}")
            if piso.entries:
                report.translated(piso.place, "PISO", "PIMPLE with one outer corrector")

    @staticmethod
    def fix_flux(patch, pressure):
        """fixedFluxPressure on a patch of the field pressure."""
        patch.entries = [Entry("type", patch.place, ["fixedFluxPressure"]),
                         Entry("value", patch.place, pressure.tokens("internalField"))]

    def fix_pressure(self, velocity, pressure):
        """fixedFluxPressure where the flux is given. Names of the patches that were changed."""
        changed = []
        for name, inner in pressure.sub("boundaryField").subs():
            given = velocity.sub("boundaryField").sub(name)
            kind = given.word("type", "none")
            moves = kind in FIXED_VELOCITY and not re.fullmatch(
                r"uniform \(0 0 0\)", as_text(given.tokens("value", ["x"]))) or \
                kind in FIXED_VELOCITY[1:]
            if moves and inner.word("type", "none") == "zeroGradient":
                self.report.translated(
                    inner.where("type"), f"p/{name} zeroGradient", "fixedFluxPressure: the "
                    "gradient inside balances the drag of particles at the inlet")
                self.fix_flux(inner, pressure)
                changed.append(name)
        return changed
