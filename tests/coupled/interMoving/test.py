"""demInterFoam on a moving mesh.

- A closed vessel that moves as a whole at a constant velocity, with water, air and grains that have it, too: grains of
  the water's density below the surface, and heavy grains across it without gravity. Nothing moves in the vessel.
  The same fluids and grains move through the cells of a mesh at rest.
- A vessel that oscillates along gravity: the fluids stay at rest in it, the pressure gradient is rho (g + a).
- A tank that sways: the surface follows the linear theory of forced sloshing.
- A floor that oscillates under grains in water, with an open top (the mesh deforms): volumes and momentum are kept.
- A vessel that pitches, with free grains: a restart has the same bits, two ranks agree with one.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from two_fluids import *

g = 9.81
walls = {"walls": ("wall", "x- x+ y- y+ z- z+")}
thin = (1000, 1e-9), (1, 1e-12)                         # hardly viscous fluids


def vessel(name, motion, size, cells, end, step, write, velocity=(0, 0, 0), fluids=(WATER, AIR), slip=False,
           gravity=f"(0 0 {-g})"):
    """A closed box of this size and motion; the velocity is the one of walls and fluids at the start."""
    case = TwoFluids(name)
    case.controls(end, step, write=write, precision=17)
    case.fluids(*fluids, gravity=gravity, tolerance=1e-13, sub_cycles=2)
    case.box(size, cells, walls)
    case.fields(("walls",), slip=slip)
    case.dictionary("constant/dynamicMeshDict", f"""dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolverLibs ("libfvMotionSolvers.so"); motionSolver solidBody; solidBodyMotionFunction {motion}""")
    if not slip:
        case.sub("0/U", "type noSlip;", f"type movingWallVelocity; value uniform {vector(velocity)};")
    case.sub("0/U", r"internalField uniform \(0 0 0\)", f"internalField uniform {vector(velocity)}")
    return case


def run(what, case):
    claim_runs(f"{what}: runs", case, "demInterFoam")
    low, high, volume = case.bounds().T
    claim(f"{what}: alpha stays in [0, 1] (1e-12)", low.min() > -1e-12 and high.max() < 1e-12, low.min(), high.max())
    claim(f"{what}: the volume of water is kept (1e-13)", np.ptp(volume) < 1e-13*volume[0], np.ptp(volume)/volume[0])


# ---- all moves as one -------------------------------------------------------------------------------

velocity = np.array([0.2, 0, 0.1])
for what, gravity, density, count, top in (("neutral grains", f"(0 0 {-g})", 1000, 300, 0.02),
                                           ("weightless", "(0 0 0)", 2500, 1000, 0.06)):
    case = vessel(what.replace(" ", "-"), f"linearMotion; velocity {vector(velocity)};", (0.03, 0.03, 0.06), (6, 6, 12),
                  0.02, 1e-3, 0.01, velocity, gravity=gravity)
    case.alpha(lambda x: (0.032 - x[:, 2])/0.005 + 0.5)
    case.grains(f"grain {{ density {density}; youngsModulus 1e6; }}", "hertz {} gidaspow {}",
                f"""grains {{ type random; diameter 2e-3; count {count}; seed 3; velocity {vector(velocity)};
                              min (0 0 0); max (0.03 0.03 {top}); }}""", "kernel linear;")
    run(what, case)
    off = difference(case.interior("U"), np.tile(velocity, (432, 1)))
    claim(f"{what}: the fluids have the velocity of the vessel (1e-10 m/s)", off < 1e-10, off)
    off = difference(case.particles("0.02", "U")[:, 1:], np.tile(velocity, (count, 1)))
    claim(f"{what}: so have the grains", off < 1e-10, off)
    off = difference(case.field("0/alpha.water"), case.interior("alpha.water"))
    claim(f"{what}: the surface stays (1e-10)", off < 1e-10, off)

# ---- the same through the cells of a mesh at rest -------------------------------------------------------

case = TwoFluids("through")
case.controls(0.05, 1e-3, precision=17)
case.fluids(gravity="(0 0 0)", tolerance=1e-13, sub_cycles=2)
case.box((0.03, 0.03, 0.03), (6, 6, 6), cyclic="xyz")
case.fields(())
case.sub("0/U", r"internalField uniform \(0 0 0\)", f"internalField uniform {vector(velocity)}")
case.alpha(lambda x: (0.008 - abs(x[:, 2] - 0.015))/0.005 + 0.5)
case.grains("grain { density 2500; youngsModulus 1e6; }", "hertz {} gidaspow {} virtualMass {}",
            f"""grains {{ type random; diameter 2e-3; count 1000; seed 3; velocity {vector(velocity)};
                          min (0 0 0); max (0.03 0.03 0.03); }}""", "kernel linear;")
run("through cells", case)
off = difference(case.interior("U"), np.tile(velocity, (216, 1)))
claim("through cells: the fluids keep their velocity (1e-7 m/s)", off < 1e-7, off)
off = difference(case.particles("0.05", "U")[:, 1:], np.tile(velocity, (1000, 1)))
claim("through cells: so do the grains", off < 1e-7, off)
off = difference(case.field("0/alpha.water"), case.interior("alpha.water"))
claim("through cells: the surface has moved", off > 0.3, off)

# ---- along gravity ----------------------------------------------------------------------------------

# one tiny particle that does not act on the fluids
probe = "probe { type list; diameter 1e-5; frozen yes; positions ((0.0151 0.002 0.03)); }", "twoWay no;", \
        "time { step 1e-3; }"
material = "grain { density 2500; youngsModulus 1e6; }"
amplitude, omega, step, end, h = 2e-3, 20*math.pi, 1e-3, 0.04, 0.005
case = vessel("heave", f"oscillatingLinearMotion; amplitude (0 0 {amplitude}); omega {omega};", (0.03, 0.03, 0.06),
              (6, 6, 12), end, step, end, (0, 0, amplitude*omega), thin)
case.alpha(lambda x: (0.032 - x[:, 2])/h + 0.5)
case.grains(material, "", *probe)
run("heave", case)


def place(time):
    return amplitude*math.sin(omega*time)


speed = (place(end) - place(end - step))/step
acceleration = (place(end) - 2*place(end - step) + place(end - 2*step))/step**2
off = difference(case.interior("U"), np.tile([0, 0, speed], (432, 1)))
claim("heave: the fluids have the velocity of the vessel (1e-7 m/s)", off < 1e-7, off, speed)
p, z = case.interior("p"), case.centres()[:, 2]
found = (np.mean(p[z < h]) - np.mean(p[abs(z - 1.5*h) < 0.1*h]))/(1000*h)
claim("heave: the pressure on the floor rises by rho (g + a) h (1e-6)", close(found, g + acceleration, 1e-6), found,
      g + acceleration)

# ---- swaying ----------------------------------------------------------------------------------------

L, n, end, step = 0.1, 24, 0.4, 1e-3
amplitude, omega = 1e-3, 12
case = vessel("sway", f"oscillatingLinearMotion; amplitude ({amplitude} 0 0); omega {omega};", (L, L/n, L), (n, 1, n),
              end, step, 0.01, (amplitude*omega, 0, 0), thin)
case.alpha(lambda x: (L/2 - x[:, 2])*n/L + 0.5)
case.grains(material, "", *probe)
run("sway", case)
# the wave cos(k x), driven by its share - 4 L/pi^2 of x in the acceleration of the tank
k = math.pi/L
own = math.sqrt((1000 - 1)/(1000 + 1)*g*k*math.tanh(k*L/2))
times = np.array([float(time) for time in case.times()])
force = -k*math.tanh(k*L/2)*4*L/math.pi**2*amplitude*omega**2
theory = force/(own**2 - omega**2)*(np.sin(omega*times) - omega/own*np.sin(own*times))
x = case.centres()[:, 0]
wave = np.array([2*np.sum(case.field(f"{time}/alpha.water")*np.cos(k*x))/n/n*L for time in case.times()])
off = difference(wave, theory)/largest(theory)
claim("sway: the surface follows the linear theory (3 % of its largest height)", off < 0.03, off, largest(theory))

# ---- an oscillating floor, the mesh deforms ----------------------------------------------------------

case = TwoFluids("floor")
case.controls(0.06, 1e-3, write=0.02, precision=17)
case.fluids(tolerance=1e-12, sub_cycles=2)
case.box((0.02, 0.02, 0.05), (5, 5, 12),
         {"floor": ("wall", "z-"), "sides": ("wall", "x- x+ y- y+"), "top": ("patch", "z+")})
case.fields(("sides",), slip=True, more=(
    """floor { type movingWallVelocity; value uniform (0 0 0); }
       top { type pressureInletOutletVelocity; value uniform (0 0 0); }""",
    "floor { type fixedFluxPressure; value uniform 0; } top { type fixedValue; value uniform 0; }",
    "floor { type zeroGradient; } top { type inletOutlet; inletValue uniform 0; value uniform 0; }"))
case.dictionary("constant/dynamicMeshDict", """dynamicFvMesh dynamicMotionSolverFvMesh;
motionSolverLibs ("libfvMotionSolvers.so"); motionSolver displacementLaplacian; diffusivity uniform;""")
case.dictionary("0/pointDisplacement", """dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0); boundaryField
{ floor { type oscillatingDisplacement; amplitude (0 0 0.005); omega 40; value uniform (0 0 0); }
  sides { type slip; } top { type fixedValue; value uniform (0 0 0); } }""", "pointVectorField")
case.sub("system/fvSolution", '"U',
         'cellDisplacement { solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0; } "U')
case.alpha(lambda x: (0.021 - x[:, 2])/(0.05/12) + 0.5)
case.grains(material, "hertz {} dry { restitution 0.5; } gidaspow {}",
            "grains { type random; diameter 2e-3; count 300; seed 3; min (0 0 0); max (0.02 0.02 0.03); }",
            "kernel linear; record { interval 0.001; budget yes; }")
run("floor", case)
claim("floor: exchange closes", worst(case.log("demInterFoam"), "exchange error") < 1e-12)
table = case.table("postProcessing/dem/0/budget.csv")
for axis in "xyz":
    terms = {name: largest(column) for name, column in table.items() if name.endswith(f".p{axis}")}
    for term, what in (("rest", "momentum closes"), ("faces", "nothing is lost between faces and cells")):
        found, most = terms[f"{term}.p{axis}"], max(terms.values())
        claim(f"floor: {what}, {axis} (1e-12 of the largest term)", found < 1e-12*most, found, most)
off = largest(table["rest.volume"])/largest(table["fluid.volume"])
claim("floor: the volume of the fluids closes (1e-12)", off < 1e-12, off)

# ---- a vessel that pitches: restart and two ranks ------------------------------------------------------

# steps of 1/1024 s: the time, of which the points are a function, has no round-off
end = "0.03125"
case = vessel("pitch", "oscillatingRotatingMotion; origin (0.015 0.015 0); amplitude (0 10 0); omega 30;",
              (0.03, 0.03, 0.06), (6, 6, 12), end, 1/1024, 1/64)
case.alpha(lambda x: (0.032 - x[:, 2])/h + 0.5)
case.grains(material, "hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } gidaspow {}",
            "grains { type random; diameter 2e-3; count 600; seed 3; min (0 0 0); max (0.03 0.03 0.05); }")
run("pitch", case)
claim("pitch: the fluids move in the vessel", largest(case.interior("U")) > 0.05, largest(case.interior("U")))
straight = (case/end).rename(case/"straight")
case.edit("system/controlDict", startTime=0.015625)
case.run("demInterFoam")
found = [path.name for path in straight.iterdir() if path.is_file() and path.name != "alpha.water"
         and not agrees(path, case/end/path.name)]
claim("pitch: continues with the bits of the uninterrupted run, fields", not found, *found)
# interfaceProperties takes a threshold of grad alpha from the mean of the cells' volumes at the start of a run, which
# has other last digits in the turned mesh: one cell, of alpha 3e-41, differs by 8e-55. A difference of 1e-45 is round-off
# of an alpha of 1e-29: all larger ones have the same bits
off = difference(case.field(straight/"alpha.water"), case.interior("alpha.water"))
claim("pitch: continues with the same alpha (1e-45)", off < 1e-45, off)
claim("pitch: continues with the bits of the uninterrupted run, particles",
      lambda: snapshot_hash(straight/"uniform/dem.snapshot") == snapshot_hash(case/end/"uniform/dem.snapshot"))
case.edit("system/controlDict", startTime=0)
case.remove(end, "0.015625")
case.run("decomposePar")
claim_runs("pitch, two ranks: runs", case, "demInterFoam", ranks=2)
case.run("reconstructPar", "-latestTime")
for name, limit in (("U", 1e-8), ("alpha.water", 1e-9), ("voidFraction", 1e-9)):
    gap = difference(case.field(straight/name), case.field(f"{end}/{name}"))
    claim(f"pitch: two ranks give the same {name} ({limit})", gap < limit, gap)
finish()
