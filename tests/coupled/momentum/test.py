"""In a periodic box the momentum of liquid and particles is conserved.

- The particles lose more than half of their momentum to the liquid.
- One outer iteration in a step keeps momentum to 2e-8 in a liquid with added mass, with three correctors.
- The particle fields on the mesh have the volume, momentum and energy of the particles, and the stress of the
  table of means over the box.
- Under-relaxation of the last iteration, which would lose momentum, is refused; of the others it is not.
- demMeans has the mean and the 95 % interval of probed samples.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

case = Case()
case.append("system/controlDict", """
functions
{
    means
    {
        type            fieldAverage;
        libs            ("libfieldFunctionObjects.so");
        writeControl    writeTime;
        fields          ( U.particles { mean on; prime2Mean off; base time; } );
    }
    sure
    {
        type            demMeans;
        libs            ("libdemCoupling.so");
        fields          (U.particles Theta.particles);
    }
    cell
    {
        type            probes;
        libs            ("libsampling.so");
        writeControl    timeStep;
        writeInterval   1;
        fields          (U.particles Theta.particles);
        probeLocations  ((0.001 0.001 0.001));
    }
}
""")
claim_runs("runs", case)
log = case.log()
total, particles = case.vectors("sum", "momentum"), case.vectors("particles", "momentum")
size = np.linalg.norm(particles[0])
claim("exchange closes", worst(log, "exchange error") < 1e-12)
claim("volume of the particles is kept", worst(log, "volume error") < 1e-12)
claim("the particles lose more than half of their momentum", np.linalg.norm(particles[-1]) < size/2)
claim("total momentum is kept",
      len(total) > 30 and np.linalg.norm(total - total[0], axis=1).max() < 1e-8*size)

# ---- the particles as fields -----------------------------------------------------------------------

V, density = 8e-9, 2500                               # a cell's volume [m3], kg/m3
alpha, U, Theta = (case.field(f"0.04/{name}") for name in ("alpha.particles", "U.particles", "Theta.particles"))
mass, v = case.field("0.04/lagrangian/particles/mass"), case.field("0.04/lagrangian/particles/U")
m = density*alpha*V
claim("alpha.particles is 1 - voidFraction", largest(alpha + case.field("0.04/voidFraction") - 1) < 1e-14)
for k in range(3):
    claim(f"U.particles has the particles' momentum, axis {k + 1}",
          close((m*U[:, k]).sum(), particles[-1, k], 1e-5))     # the log's six digits
claim("U.particles and Theta.particles have their energy",
      close((0.5*m*((U**2).sum(1) + 3*Theta)).sum(), (0.5*mass*(v**2).sum(1)).sum(), 1e-12))
# the sum of Vc (stress - rho U U) is the contact part less m v v: the numbers of the table, except for P P/M
box = case.table("postProcessing/dem/0/box.csv")
claim("stress.particles has the stress of the box",
      close((V*case.field("0.04/stress.particles")[:, 0] - m*U[:, 0]**2).sum(),
            1.728e-6*(box["stressXX"][0] - box["bulkDensity"][0]*box["velocityX"][0]**2), 1e-7))    # nine digits that cancel
claim("fieldAverage accepts the fields", (case/"0.04/U.particlesMean").stat().st_size > 0)

# ---- means with intervals --------------------------------------------------------------------------


def blocks(field, k):
    """Mean and 95 % interval of 40 probed samples of the first cell, in 20 blocks of two (t of 19: 2.093)."""
    rows = re.sub("#.*|[()]", "", case.read(f"postProcessing/cell/0/{field}")).split("\n")
    x = np.array([float(row.split()[k + 1]) for row in rows if row.strip()])
    m = x.reshape(20, 2).mean(1)
    return x.mean(), 2.093*m.std(ddof=1)/math.sqrt(20)


for name, k in (("U.particles", 0), ("U.particles", 2), ("Theta.particles", 0)):
    mean, interval = blocks(name, k)
    first = [case.field(f"0.04/{name}{kind}").reshape(216, -1)[0, k] for kind in ("BlockMean", "Interval")]
    claim(f"demMeans has the mean of {name} {k + 1}", close(first[0], mean, 1e-5))          # the probe's six digits
    claim(f"demMeans has the interval of {name} {k + 1}", close(first[1], interval, 1e-3))  # four digits of t
claim("demMeans reports its blocks", case.found(r" s in 20 blocks$"))
mean = case.read("0.04/U.particlesBlockMean")
run = case.run("demPimpleFoam", "-postProcess", log="log.postProcess")
claim("demMeans leaves the means of the run as they are with -postProcess",
      re.search("^End", run.log, re.M) and case.read("0.04/U.particlesBlockMean") == mean,
      *run.log.splitlines()[-12:])

# ---- one outer iteration ---------------------------------------------------------------------------

# each corrector takes off a factor of about 100; docs/theory-demPimpleFoam.md has the losses
for correctors, bound in ((2, 2e-6), (3, 2e-8)):
    name = f"one outer iteration, {correctors} correctors, added mass"
    one = Case(f"correctors{correctors}")
    one.sub("system/fvSolution", "nOuterCorrectors 8; nCorrectors 2", f"nOuterCorrectors 1; nCorrectors {correctors}")
    one.sub("constant/demProperties", "gidaspow", "gidaspow {} virtualMass")
    one.edit("system/controlDict", endTime=0.01, writeInterval=0.01)
    claim_runs(f"{name}: runs", one)
    total, particles = one.vectors("sum", "momentum"), one.vectors("particles", "momentum")
    loss = np.linalg.norm(total - total[0], axis=1).max()/np.linalg.norm(particles[0])
    claim(f"{name}: total momentum is kept ({bound})", len(total) > 8 and loss < bound, loss)

case.sub("system/controlDict", "U.particles Theta.particles", "U.particles Thetta")
claim("a missing field is named",
      not case.run("demPimpleFoam") and "no field Thetta" in case.log())

# ---- under-relaxation --------------------------------------------------------------------------------

case = Case("relaxed")
case.copy("shared/system/fvSolution", "system/fvSolution.shared")
case.run("blockMesh")
solution = case.read("system/fvSolution")
for name in ('"U.*"', '".*"', "default", "UFinal"):
    case.write("system/fvSolution", solution + f"relaxationFactors {{ equations {{ {name} 0.7; }} }}\n")
    for plan in ((), ("-plan",)):
        claim_refused(f"relaxation of {name}{''.join(plan)} is refused", case, "relax the last iteration of U by 0.7, "
                      "which does not keep momentum and heat of fluid and particles; give UFinal 1 in equations",
                      "demPimpleFoam", *plan)
case.write("system/fvSolution", solution + 'relaxationFactors { equations { "U.*" 0.7; UFinal 1; } }\n')
case.edit("system/controlDict", endTime=0.005)
claim_runs("relaxation of all but the last iteration: runs", case)
total = case.vectors("sum", "momentum")
claim("relaxation of all but the last iteration: total momentum is kept",
      len(total) > 3 and np.linalg.norm(total - total[0], axis=1).max() < 1e-6*size,
      np.linalg.norm(total - total[0], axis=1).max()/size)
finish()
