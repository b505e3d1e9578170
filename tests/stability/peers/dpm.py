"""dpm.py -- a case of DPMFoam (OpenFOAM's Lagrangian library), written as files, with the schemes of
its tutorial.

    case = Dpm(folder, cells=(4, 4, 4), size=(...), patches={name: (faces, type, U, p)}, step=1e-3,
               end=0.1, particles=dict(d=..., rho=..., at=[...]))
    case.run() -> True if it ends well; case.log

Faces without a patch are periodic in pairs. forces: the block particleForces; contacts:
pairCollision with springs, or none.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import shutil

import fluid

SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
divSchemes { default none; div(alphaPhi.air,U.air) Gauss linearUpwindV unlimited; div(((alpha.air*nuEff.air)*dev2(T(grad(U.air))))) Gauss linear; }"""
# as in its tutorial, to tighter tolerances
SOLUTION = """solvers
{
    "(p|kinematicCloud:theta).*" { solver GAMG; tolerance 1e-12; relTol 0; smoother GaussSeidel; }
    "U.air.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-13; relTol 0; }
}
PIMPLE { nOuterCorrectors %d; nCorrectors 2; momentumPredictor yes; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }"""
CLOUD = """solution
{
    active true; coupled %(coupled)s; transient yes; cellValueSourceCorrection off;
    interpolationSchemes { rho.air cell; rho cell; U.air cellPoint; U cellPoint; mu.air cell; mu cell; curlUcDt cellPoint; DUcDt cellPoint; }
    integrationSchemes { U %(integration)s; }
    sourceTerms { schemes { U %(source)s 1; } }
}
constantProperties { parcelTypeId 1; rhoMin 1e-15; minParcelMass 1e-30; rho0 %(rho).17g; youngsModulus %(young).9g; poissonsRatio 0.3; constantVolume false; alphaMax 0.99; }
subModels
{
    particleForces { %(forces)s }
    injectionModels
    {
        all
        {
            type manualInjection; massTotal 0; parcelBasisType fixed; nParticle 1; SOI 0; positionsFile "kinematicCloudPositions"; U0 (%(U)s);
            sizeDistribution { type fixedValue; fixedValueDistribution { value %(d).17g; } }
        }
    }
    dispersionModel none;
    patchInteractionModel %(wall)s;
    heatTransferModel none; surfaceFilmModel none; stochasticCollisionModel none; radiation off;
    %(collision)s
}
cloudFunctions { }"""
STICKS = "standardWallInteraction; standardWallInteractionCoeffs { type rebound; e 0.8; mu 0.3; }"
SPRINGS = """collisionModel pairCollision;
    pairCollisionCoeffs
    {
        maxInteractionDistance %(d).9g; U U.air; writeReferredParticleCloud no;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs { useEquivalentSize no; alpha 0.12; b 1.5; mu 0.3; cohesionEnergyDensity 0; collisionResolutionSteps 12; }
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs { useEquivalentSize no; collisionResolutionSteps 12; youngsModulus %(young).9g; poissonsRatio 0.3; alpha 0.12; b 1.5; mu 0.3; cohesionEnergyDensity 0; }
    }"""


class Dpm(fluid.Case):
    def __init__(self, folder, **k):
        self.folder, self.solver = folder, k.get("solver", "DPMFoam")
        self.size, self.cells, self.patches = k["size"], k["cells"], k.get("patches", {})
        shutil.rmtree(folder, ignore_errors=True)
        for part in ("0", "constant", "system"):
            os.makedirs(os.path.join(folder, part))
        self.mesh("(1 1 1)")
        single = self.solver != "DPMFoam"
        suffix = "" if single else ".air"
        self.file("dictionary", "system/fvSchemes", SCHEMES)
        self.file("dictionary", "system/fvSolution", SOLUTION % k.get("outer", 1))
        self.control(k["step"], k["end"], k.get("write"), k.get("control", ""))
        self.file("dictionary", "constant/transportProperties",
            "continuousPhase air; rho.air %.9g; transportModel Newtonian; nu %.17g; rhoInf %.9g;" %
            (k["rho"], k["nu"], k["rho"]))
        self.file("dictionary", "constant/turbulenceProperties" + suffix, "simulationType laminar;")
        self.file("uniformDimensionedVectorField", "constant/g",
                  "dimensions [0 1 -2 0 0 0 0]; value (%g %g %g);" % k.get("g", (0, 0, 0)))
        self.file("volVectorField", "0/U" + suffix,
            "dimensions [0 1 -1 0 0 0 0]; internalField %s; boundaryField { %s }" %
            (k.get("U", "uniform (0 0 0)"), self.fields(2)))
        self.file("volScalarField", "0/p",
            "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField { %s }" %
            self.fields(3))
        self.cloud(k)

    def cloud(self, k):
        p = k["particles"]
        words = dict(coupled=k.get("coupled", "true"), integration=k.get("integration", "Euler"),
            source=k.get("source", "semiImplicit"), rho=p["rho"], d=p["d"],
            young=p.get("young", 1e6), forces=k["forces"],
                     U="%g %g %g" % p.get("U", (0, 0, 0)), wall=STICKS)
        words["collision"] = SPRINGS % words if k.get("contacts") else "collisionModel none;"
        self.file("dictionary", "constant/kinematicCloudProperties", CLOUD % words)
        self.file("vectorField", "constant/kinematicCloudPositions",
                  "(\n" + "".join("(%.17g %.17g %.17g)\n" % tuple(x) for x in p["at"]) + ")")

    def run(self, limit=900):
        return self.command("blockMesh") and self.command(self.solver,
            limit=limit) and "\nEnd" in self.log

    def complaint(self):
        lines = [line.strip() for line in self.log.splitlines() if line.strip()]
        at = next((n for n, line in enumerate(lines) if "FOAM FATAL" in line), None)
        return (" ".join(lines[at:at + 3]) if at is not None
            else next((line for line in lines if "exception" in line.lower()
                       or "signal" in line.lower()), lines[-1] if lines else "no word"))[:200]

    def speeds(self, time):
        return self.field(os.path.join(time, "lagrangian", "kinematicCloud"), "U")

    def fraction(self, time):
        """Void fractions of all cells."""
        rows = [r[0] for r in self.field(time, "alpha.air")]
        return rows if len(rows) > 1 else rows*(self.cells[0]*self.cells[1]*self.cells[2])
