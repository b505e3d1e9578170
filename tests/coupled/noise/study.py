#!/usr/bin/env python3
"""study.py -- pressure noise of each kernel in scenes that are hard for it.

    ./study.py                   all scenes and kernels; 1.5 minutes of processor time
    ./study.py sphere -k linear  this scene, this kernel; several of either may be given
    ./study.py -store            writes stored.csv; docs/kernels.md has the main rows

Each number is an rms of pressure over a mean of it:

sphere   A sphere of water's scene is towed at constant velocity through cells of 2 diameters, in
         a duct closed at one end. Its drag over the section is the pressure on that end, which
         should be constant. Noise: rms over mean in time.
step     The same sphere from cells of 4 diameters to cells of 1/2 and back, 1 : 8 with no size
         between them; and to cells of 2.
bed      Gas flows through a fixed lattice that fills a duct of two sizes of cells, 1 : 8 and 1 : 2.
         Noise: rms of the pressure gradient over its mean, by volume, in either half. The mean
         should be Ergun's.
waves    A pressure wave travels over a fixed lattice in viscous liquid. Noise: what is not a wave
         of that length and period, in the bed's cells, over that wave.
jet      Gas enters through a square in the middle of a square plate, under a fixed random bed
         two cells thick. Noise: what has not the symmetry of the square, over the mean, in the
         bed's cells; and rms over mean in time of a probe under it.

shallow  Gas flows through a fixed random bed 15 d deep with a free surface. Not noise but what is
         missing of the pressure drop, against Ergun's at the void fraction inside the bed.

The lattice is even, with 8/7 diameters from sphere to sphere, which no cell is a multiple of:
noise is the kernel's. Of the jet's a part is the packing's. SUNA_KEEP=1 keeps the cases.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from case import *

KERNELS = {name: f"kernel {name};"
           for name in ("linear", "particleCentre", "divided", "diffusion", "gaussian")}
KERNELS["diffusion-divided"] = "kernel diffusion; base divided;"
D = 1e-3                                # diameter of all spheres [m]


# ---- cases ---------------------------------------------------------------------------------------

class Scene(Case):
    """A case of which each command must succeed."""

    def __init__(self, name):
        super().__init__(name, "shared")
        self.controls(1, 1)

    def run(self, *command, **options):
        run = super().run(*command, **options)
        if not run:
            raise RuntimeError(f"{' '.join(command)} failed in {self.path}\n" + run.log[-2000:])
        return run

    def refine(self, box, levels):
        """Split in two each way, several times, with no step between them."""
        for _ in range(levels):
            self.dictionary("system/topoSetDict", "actions ({ name c0; type cellSet; action new; "
                            f"source boxToCell; box {box}; }});")
            self.dictionary("system/refineMeshDict", "set c0; coordinateSystem global; "
                            "globalCoeffs { tan1 (1 0 0); tan2 (0 1 0); } "
                            "directions (tan1 tan2 normal); useHexTopology no; geometricCut yes; "
                            "writeMesh no;")
            self.run("topoSet")
            self.run("refineMesh", "-overwrite", "-dict", "system/refineMeshDict")

    def solve(self, step, end, nu, particles, functions=""):
        self.controls(end, step, functions=functions, nu=nu)
        self.dictionary("constant/demProperties", particles)
        self.run("demPimpleFoam")

    def series(self, function, file):
        """The rows of a function object's table."""
        return np.loadtxt(self/"postProcessing"/function/"0"/file)


def noise(values):
    """rms over the magnitude of the mean, and the mean"""
    mean = float(np.mean(values))
    return float(np.std(values))/abs(mean), mean


def ergun(solid, flux, rho, nu):
    """Ergun's pressure gradient [Pa/m] at a superficial velocity"""
    void = 1 - solid
    return (150*(solid/D)**2*rho*nu + 1.75*solid/D*rho*flux)*flux/void**3


def schiller_naumann(speed, rho, nu):
    """drag [N] of one sphere"""
    return 3*math.pi*rho*nu*D*speed*(1 + 0.15*(speed*D/nu)**0.687)


# ---- scenes: each returns rows (quantity, noise, mean, closed form or "", unit) ------------------

BED = """
materials { glass { density 2500; youngsModulus 1e6; } }
effects { hertz {} ergun {} pressureGradient {} }
insert { bed { diameter %g; frozen yes; %s } }
"""
SPACING = 8/7


def lattice(*counts):
    """From the origin, these many spheres each way"""
    return BED % (D, f"type lattice; count {math.prod(counts)}; spacing {SPACING - 1e-7:.9g}; jitter 0; "
                  f"min (0 0 0); max ({' '.join(f'{n*SPACING*D:.9g}' for n in counts)});")


def patch_mean(name, patch):
    """The function object `name`: the mean of p over a patch in each step."""
    return f"""{name} {{ type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); fields (p);
    operation areaAverage; regionType patch; name {patch}; writeFields no; log no; writeControl timeStep; }}"""


def probes(name, points):
    """The function object `name`: p at these points in each step."""
    return f"""{name} {{ type probes; libs ("libsampling.so"); fields (p); writeControl timeStep;
    probeLocations ({" ".join(map(vector, points))}); }}"""


def gas_enters(case, velocity):
    """Gas flows from the inlet to the outlet between sides without friction."""
    case.flow(velocity, f"""inlet {{ type fixedValue; value uniform {velocity}; }} outlet {{ type zeroGradient; }}
    sides {{ type slip; }}""", """inlet { type fixedFluxPressure; } outlet { type fixedValue; value uniform 0; }
    sides { type fixedFluxPressure; }""")


def duct(case, length, cells):
    """A duct of 8 diameters, closed at one end."""
    case.box((length*D, 8*D, 8*D), cells, {"closed": ("patch", "x-"), "open": ("patch", "x+"),
                                           "sides": ("patch", "y- y+ z- z+")})


def towed(case, kernel, start, velocity, step, end, skip):
    """A sphere towed through a duct: noise and mean of the pressure on the closed end after `skip` steps, and the
    closed form."""
    case.flow("(0 0 0)", """closed { type fixedValue; value uniform (0 0 0); } open { type zeroGradient; }
    sides { type slip; }""", """closed { type fixedFluxPressure; } open { type fixedValue; value uniform 0; }
    sides { type fixedFluxPressure; }""")
    case.solve(step, end, 1e-6, f"""
materials {{ heavy {{ density 1e9; youngsModulus 1e9; }} }}
effects {{ hertz {{}} schillerNaumann {{}} pressureGradient {{}} }}
insert {{ sphere {{ type list; diameter {D}; velocity {vector(velocity)}; positions ({vector(start)}); }} }}
coupling {{ rho 1000; {KERNELS[kernel]} walls (); }}""", patch_mean("end", "closed"))
    rows = case.series("end", "surfaceFieldValue.dat")
    speed = math.hypot(*velocity)
    return noise(1000*rows[rows[:, 0] > skip*step, 1]) + (
        -schiller_naumann(speed, 1000, 1e-6)*velocity[0]/speed/(8*D)**2, "Pa")


def sphere(kernel, steps=(2.5e-3, 1.25e-3)):
    """Drag over the section: Schiller and Naumann at 0.11 m/s in water, 5.5e-6 N over 64 mm2, is 0.08 Pa; a jump of
    the centroid by a cell in one step is a thousand times more."""
    rows = []
    for step in steps:
        case = Scene(f"sphere-{kernel}-{step:g}")
        duct(case, 24, (12, 4, 4))
        rows.append((f"sphere, step {1e3*step:g} ms",) + towed(
            case, kernel, (7.3*D, 2.1*D, 2.7*D), (0.1, 0.037, 0.023), step, 0.08, 0.01/step))
    return rows


def step(kernel):
    rows = []
    for levels, name in ((3, "1 : 8"), (1, "1 : 2")):
        case = Scene(f"step-{kernel}-{levels}")
        duct(case, 40, (10, 2, 2))
        case.refine("(0.0201 -1 -1) (0.0279 1 1)", levels)
        rows.append((f"sphere, cells {name}",) + towed(
            case, kernel, (14.3*D, 3.6*D, 4.3*D), (0.1, 0, 0), 2.5e-3, 0.1, 4))
    return rows


def bed(kernel):
    rows = []
    for levels, name in ((3, "1 : 8"), (1, "1 : 2")):
        case = Scene(f"bed-{kernel}-{levels}")
        case.box((24*D, 8*D, 8*D), (6, 2, 2), {"inlet": ("patch", "x-"), "outlet": ("patch", "x+"),
                                               "sides": ("wall", "y- y+ z- z+")})
        case.refine("(0.0161 -1 -1) (1 1 1)", levels)
        gas_enters(case, "(0.3 0 0)")
        case.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        case.run("postProcess", "-func", "writeCellVolumes", "-time", "0")
        case.solve(1e-3, 8e-3, 1.5e-5, lattice(21, 7, 7) + f"coupling {{ rho 1.2; {KERNELS[kernel]} }}")
        x, volume = case.field("0/Cx"), case.field("0/V")
        gradient = -case.field("0.008/gradP")[:, 0]
        for half, where in (("coarse", (x > 4*D) & (x < 16*D)), ("fine", (x > 16*D) & (x < 22*D))):
            weights, values = volume[where]/volume[where].sum(), gradient[where]
            mean = float((weights*values).sum())
            rows.append((f"bed, cells {name}, {half} half",
                         float((weights*(values - mean)**2).sum()**0.5)/abs(mean), mean,
                         ergun(math.pi/6/SPACING**3, 0.3, 1.2, 1.5e-5), "Pa/m"))
    return rows


def waves(kernel, period=0.1, per=40, amplitude=0.1):
    length, rho = 24*D, 1000.0
    nx, ny, nz = 12, 4, 8
    k, omega = 2*math.pi/length, 2*math.pi/period
    case = Scene(f"waves-{kernel}")
    case.box((24*D, 8*D, 16*D), (nx, ny, nz), {
        "left": ("cyclic; neighbourPatch right", "x-"), "right": ("cyclic; neighbourPatch left", "x+"),
        "top": ("patch", "z+"), "sides": ("wall", "y- y+ z-")})
    points = [(2*D*(i + 0.5), 2*D*(j + 0.5)) for j in range(ny) for i in range(nx)]
    data = "constant/boundaryData/top"
    case.write(f"{data}/points", "(\n" + "\n".join(vector((x, y, 16*D)) for x, y in points) + "\n)\n")
    dt, end = period/per, 2*period
    for n in range(2*per + 1):
        values = (f"{amplitude/rho*math.cos(k*x - omega*n*dt):.9g}" for x, _ in points)
        case.write(f"{data}/{n*dt:.9g}/p", "(\n" + "\n".join(values) + "\n)\n")
    case.flow("(0 0 0)", """left { type cyclic; } right { type cyclic; } sides { type slip; }
    top { type pressureInletOutletVelocity; value uniform (0 0 0); }""",
              """left { type cyclic; } right { type cyclic; } sides { type fixedFluxPressure; }
    top { type timeVaryingMappedFixedValue; mapMethod nearest; setAverage no; offset 0; }""")
    case.solve(dt, end, 1e-5, lattice(21, 7, 10) + f"coupling {{ rho {rho:g}; {KERNELS[kernel]} }}",
               probes("all", [(x, y, 2*D*(z + 0.5)) for z in range(nz) for x, y in points]))
    rows = case.series("all", "p")
    rows = rows[rows[:, 0] > period*1.0001]
    phase = (k*np.array([x for x, _ in points])[None, :] - omega*rows[:, 0][:, None]).ravel()
    base = np.stack((np.cos(phase), np.sin(phase)), axis=1)
    result = []
    for z in range(1, 5):               # layers inside the bed: 2 to 10 d above its bottom
        values = rho*rows[:, 1 + z*nx*ny:1 + (z + 1)*nx*ny].ravel()
        fit = base @ np.linalg.lstsq(base, values, rcond=None)[0]
        result.append((np.mean((values - fit)**2), np.mean(fit**2)))
    rest, wave = np.sum(result, axis=0)
    return [("waves over a bed", math.sqrt(rest/wave), math.sqrt(wave/4), "", "Pa")]


def jet(kernel, seed=3):
    case = Scene(f"jet-{kernel}")
    case.box((16*D, 16*D, 20*D), (8, 8, 10), {"plate": ("wall", "z-"), "outlet": ("patch", "z+"),
                                              "sides": ("wall", "x- x+ y- y+")})
    case.dictionary("system/topoSetDict", "actions ({ name jet; type faceSet; action new; "
                    "source boxToFace; box (0.0061 0.0061 -1e-5) (0.0099 0.0099 1e-5); });")
    case.dictionary("system/createPatchDict", "pointSync false; patches ({ name jet; "
                    "patchInfo { type patch; } constructFrom set; set jet; });")
    case.run("topoSet")
    case.run("createPatch", "-overwrite")
    case.flow("(0 0 0)", """jet { type fixedValue; value uniform (0 0 2); } plate { type noSlip; }
    sides { type slip; } outlet { type pressureInletOutletVelocity; value uniform (0 0 0); }""",
              '"(jet|plate|sides)" { type zeroGradient; } outlet { type fixedValue; value uniform 0; }')
    case.solve(5e-4, 0.05, 1.5e-5, BED % (D, f"type random; solidFraction 0.5; seed {seed}; "
                                           "min (0 0 0.004); max (0.016 0.016 0.008);")
               + f"coupling {{ rho 1.2; {KERNELS[kernel]} }}",
               probes("under", [(0.009, 0.009, 0.003), (0.013, 0.009, 0.003)]))
    layers = 1.2*case.field("0.05/p").reshape(10, 8, 8)[2:4]            # the bed's two
    turned = [np.rot90(q, n, (1, 2)) for q in (layers, layers.transpose(0, 2, 1)) for n in range(4)]
    rest = layers - np.mean(turned, axis=0)
    rows = case.series("under", "p")
    rows = rows[rows[:, 0] > 0.025, 1]
    return [("jet under a thin bed, symmetry",
             float(np.sqrt(np.mean(rest**2))/layers.mean()), float(layers.mean()), "", "Pa"),
            ("jet under a thin bed, time",) + noise(1.2*rows) + ("", "Pa")]


def shallow(kernel):
    rows = []
    for cells in (4, 8):
        case = Scene(f"shallow-{kernel}-{cells}")
        case.box((8*D, 8*D, 32*D), (cells, cells, 4*cells), {
            "inlet": ("patch", "z-"), "outlet": ("patch", "z+"), "sides": ("wall", "x- x+ y- y+")})
        gas_enters(case, "(0 0 0.3)")
        case.solve(1e-3, 8e-3, 1.5e-5,
                   BED % (D, "type random; solidFraction 0.55; min (0 0 0); max (0.008 0.008 0.015);")
                   + f"coupling {{ rho 1.2; {KERNELS[kernel]} }}", patch_mean("under", "inlet"))
        z = case.field("0.008/lagrangian/particles/positions")[:, 2]/D

        def below(height):              # volume of the spheres' parts below, over the section [d]
            a = np.clip(height - z, -0.5, 0.5) + 0.5
            return float(np.sum(math.pi*(a**2/2 - a**3/3)))/64
        inside = (below(12) - below(3))/9
        closed = ergun(inside, 0.3, 1.2, 1.5e-5)*below(99)/inside*D
        drop = 1.2*case.series("under", "surfaceFieldValue.dat")[-1, 1]
        rows.append((f"bed of 15 d, cells of {8//cells} d: drop missing", 1 - drop/closed, drop, closed, "Pa"))
    return rows


SCENES = {"sphere": sphere, "step": step, "bed": bed, "waves": waves, "jet": jet, "shallow": shallow}


# ---- table ---------------------------------------------------------------------------------------

def machine():
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return "unknown"


def commit():
    return subprocess.run(["git", "-C", str(here), "rev-parse", "--short", "HEAD"],
                          capture_output=True, text=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenes", nargs="*", help=", ".join(SCENES))
    parser.add_argument("-k", dest="kernels", action="append", choices=KERNELS)
    parser.add_argument("-store", action="store_true")
    options = parser.parse_args()
    unknown = [s for s in options.scenes if s not in SCENES]
    if unknown:
        raise SystemExit(f"study: there is no scene {unknown[0]}; there are {', '.join(SCENES)}")
    kernels = options.kernels or KERNELS

    found = {}                  # {(quantity, closed form, unit): {kernel: (noise, mean)}}
    for scene in options.scenes or SCENES:
        for kernel in kernels:
            began = os.times().children_user
            for quantity, value, mean, closed, unit in SCENES[scene](kernel):
                found.setdefault((quantity, closed, unit), {})[kernel] = value, mean
                print(f"{quantity}, {kernel}: {value:.4g} of {mean:.5g} {unit}"
                      + (f", closed form {closed:.5g}" if closed else ""), flush=True)
            print(f"# {scene}, {kernel}: {os.times().children_user - began:.1f} s", flush=True)

    if options.store:
        with open(here/"stored.csv", "w", newline="") as file:
            file.write(f"# ./study.py -store, {time.strftime('%-d %B %Y')}, one core of {machine()}, "
                       f"OpenFOAM {os.environ.get('WM_PROJECT_VERSION', '')}, commit {commit()}\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["quantity", "kernel", "noise [1]", "mean", "closed form", "unit"])
            for (quantity, closed, unit), values in found.items():
                for kernel, (value, mean) in values.items():
                    writer.writerow([quantity, kernel, f"{value:.3g}", f"{mean:.4g}",
                                     f"{closed:.4g}" if closed else "", unit])
    print("| scene | " + " | ".join(f"`{k}`" for k in kernels) + " |")
    print("|---" * (len(kernels) + 1) + "|")
    for (quantity, closed, _), values in found.items():
        print(f"| {quantity} | " + " | ".join(f"{values[k][0]:.2g}" + (
            f" ({values[k][1]/closed:.2f})" if closed else "") for k in kernels) + " |")


if __name__ == "__main__":
    main()
