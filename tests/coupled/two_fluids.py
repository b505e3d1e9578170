"""Cases of demInterFoam in a box: water below, air above, and particles.

    case = TwoFluids("rest")
    case.controls(end, step)
    case.fluids(sigma=0)
    case.box((0.1, 0.1, 0.2), (5, 5, 10), {"walls": ("wall", "x- x+ y- y+ z- z+")})
    case.fields(("walls",))
    case.alpha(lambda x: x[:, 2] < 0.1)

    case.run("demInterFoam")

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

WATER, AIR = (1000, 1e-3), (1, 1.8e-5)          # density [kg/m3], viscosity [Pa s]


class TwoFluids(Case):

    def fluids(self, first=WATER, second=AIR, sigma=0, gravity="(0 0 -9.81)", tolerance=1e-12, correctors=3,
               outer=1, sub_cycles=1):
        """Properties, schemes and solvers: density [kg/m3] and viscosity [Pa s] of each fluid."""
        phases = "\n".join(f"{name} {{ transportModel Newtonian; nu {mu/rho:.17g}; rho {rho}; }}"
                           for name, (rho, mu) in (("water", first), ("air", second)))
        self.dictionary("constant/transportProperties", f"phases (water air);\n{phases}\nsigma {sigma};")
        self.gravity(gravity)
        self.dictionary("system/fvSchemes", """ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; div(rhoPhi,U) Gauss linearUpwind grad(U); div(phi,alpha) Gauss vanLeer; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""")
        self.dictionary("system/fvSolution", f"""solvers
{{
    "alpha.water.*" {{ cAlpha 1; nAlphaSubCycles {sub_cycles}; }}
    "p_rgh.*" {{ solver PCG; preconditioner DIC; tolerance {tolerance}; relTol 0; maxIter 2000; }}
    "U.*" {{ solver PBiCGStab; preconditioner DILU; tolerance {tolerance}; relTol 0; }}
}}
PIMPLE {{ nOuterCorrectors {outer}; nCorrectors {correctors}; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0;
}}""")

    def fields(self, walls, slip=False, more=("", "", "")):
        """0/U, 0/p_rgh and 0/alpha.water: fluids at rest between walls. more: entries of other patches in each."""
        def entries(condition, others):
            return " ".join(f"{name} {{ {condition} }}" for name in walls) + others
        self.initial("U", "0 1 -1 0 0 0 0", "(0 0 0)",
                     entries("type slip;" if slip else "type noSlip;", more[0]))
        self.initial("p_rgh", "1 -1 -2 0 0 0 0", 0, entries("type fixedFluxPressure; value uniform 0;", more[1]))
        self.initial("alpha.water", "0 0 0 0 0 0 0", 0, entries("type zeroGradient;", more[2]))

    def turbulence(self, model, k, epsilon, entries, nut):
        """kEpsilon (RAS) or a model of LES; k, epsilon: at the start, entries: of their patches, a function of name and
        value; nut: entries of its patches."""
        kind = "RAS" if model == "kEpsilon" else "LES"
        self.dictionary("constant/turbulenceProperties", f"simulationType {kind}; {kind} {{ {kind}Model {model}; "
                        "turbulence on; delta cubeRootVol; cubeRootVolCoeffs { deltaCoeff 1; } }")
        for name, dimensions, value in (("k", "0 2 -2 0 0 0 0", k), ("epsilon", "0 2 -3 0 0 0 0", epsilon)):
            self.initial(name, dimensions, value, entries(name, value))
        self.initial("nut", "0 2 -1 0 0 0 0", 0, nut)
        self.sub("system/fvSolution", '"U\\.', '"(U|k|epsilon).')

    def for_stock(self):
        """Entries that interFoam needs besides."""
        self.sub("system/fvSolution", "nAlphaSubCycles 1;", "nAlphaSubCycles 1; nAlphaCorr 1;")
        self.sub("system/fvSolution", '"p_rgh', '"(p_rgh|pcorr)')
        self.sub("system/fvSchemes", "div.phi,alpha. [^;]*;", r"\g<0> div(phirb,alpha) Gauss linear;")
        self.edit("system/controlDict", maxAlphaCo=1)

    def centres(self):
        """Centres of the cells [m]."""
        if not (self/"0/C").exists():
            self.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        return self.field("0/C")

    def alpha(self, function):
        """Volume fraction of water in each cell, a function of the cells' centres."""
        self.values("alpha.water", np.clip(np.asarray(function(self.centres()), float), 0, 1))

    def values(self, name, values):
        """Set the internal field of 0/NAME."""
        kind = "scalar" if values.ndim == 1 else "vector"
        rows = "\n".join(f"{x:.17g}" if kind == "scalar" else vector(x) for x in values)
        self.sub(f"0/{name}", r"internalField [^;]*;",
                 f"internalField nonuniform List<{kind}>\n{len(values)}\n(\n{rows}\n)\n;")

    def grains(self, material, effects, insert, coupling="", more=""):
        """demProperties with the forces of fluids on particles."""
        self.properties(material, f"pressureGradient {{}} {effects}", insert, coupling, more)

    def interior(self, name):
        """A field at the last time, one row a cell."""
        return self.field(f"{self.times()[-1]}/{name}")

    def kept(self):
        """Largest change of the volume of water with what has left, over the largest volume; from the log."""
        water = self.numbers(r"volume (\S+) m3, left (\S+) m3", "demInterFoam")
        return np.ptp(water.sum(axis=1))/water[:, 0].max()

    def bounds(self):
        """Least alpha, largest alpha - 1 and volumes of water, from the log: one row an iteration."""
        return self.numbers(r"alpha.water between (\S+) and 1 \+ (\S+), volume (\S+) m3", "demInterFoam")
