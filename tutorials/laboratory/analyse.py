#!/usr/bin/env python3
"""analyse.py -- laboratory tests beside their closed forms and a published law: result.csv, laboratory.png.

    analyse.py [-store "text"]       with -store also stored/ and the table of results.md

Each function of a test has its formula. A row that differs from its reference by more than its bound is
reported, and the exit status is 1.

Hertz of two equal spheres: F = 4/3 E* sqrt(R*) d^(3/2), E* = E/(2 (1 - nu^2)), R* = R/2, at a plane of the
same material R* = R.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy
from dem_case import OURS, REFERENCE, Result, below, blocks, panels, read_table, save, store

D, G = 1e-3, 9.81                                   # diameter of the spheres [m], gravity [m/s2]
HERTZ = 4/3*1e8/(2*(1 - 0.3**2))                    # 4/3 E* of 100 MPa [Pa]


class Rows(Result):
    """Rows with a bound on the relative difference from the reference."""

    def __init__(self):
        super().__init__()
        self.outside = []

    def compare(self, quantity, where, reference, value, bound, unit, ci95=None):
        self.add(quantity, where, reference, value, ci95, unit)
        difference = value/reference - 1
        print(f"{100*difference:+8.3f} % (bound {100*bound:g} %)  {quantity} {where}")
        if not abs(difference) <= bound:
            self.outside.append(f"{quantity}, {where}: differs by {100*difference:.3g} %, more than {100*bound:g} %")


def wall(folder, name):
    rows = read_table(f"runs/{folder}/walls.csv")
    return {key: values[rows["wall"] == name] for key, values in rows.items()}


def at(rows, column, time):
    return rows[column][numpy.argmin(abs(rows["time"] - time))]


# ---- oedometer -----------------------------------------------------------------------------------

def layer(pressure):
    """By how much two layers of the packing approach. A sphere has four contacts with the layer above, whose
    planes are D^2 a sphere: p D^2 = 4 F h/l with the height h between the layers and l^2 = D^2/2 + h^2."""
    low, high = 0.0, 0.1*D
    while high - low > 1e-15*D:
        u = 0.5*(low + high)
        h = D/numpy.sqrt(2) - u
        length = numpy.hypot(D/numpy.sqrt(2), h)
        force = HERTZ*numpy.sqrt(D/4)*(D - length)**1.5
        low, high = (u, high) if 4*force*h/length < pressure*D**2 else (low, u)
    return low


def oedometer(result):
    piston = wall("oedometer", "piston")
    for time, pressure in ((0.03, 100), (0.06, 1000), (0.1, 10000)):
        plane = (pressure*D**2/(HERTZ*numpy.sqrt(D/2)))**(2/3)
        result.compare("oedometer: settlement", f"{pressure} Pa", 1e6*(9*layer(pressure) + 2*plane),
                       1e6*at(piston, "moved", time), 1e-4, "um")
    stress = read_table("runs/oedometer/middle.csv")
    # half of the contacts lean along x: s_x/s_z = D^2/2 over 2 h^2
    result.compare("oedometer: earth pressure at rest", "10000 Pa", D**2/4/(D/numpy.sqrt(2) - layer(1e4))**2,
                   stress["stressXX"][0]/stress["stressZZ"][0], 1e-3, "1")


# ---- triaxial test -------------------------------------------------------------------------------

def triaxial(result):
    """Thornton, Geotechnique 29 (1979) 441: s_z/s_x = 2 (1 + mu)/(1 - mu) at failure. In a cell that has been
    deformed: 2 T (T + mu)/(1 - mu T), with T the tangent of the contacts between layers."""
    cell = read_table("runs/triaxial/cell.csv")
    tangent = cell["Lz"]/2/(cell["Lx"]/3*numpy.sqrt(2))
    ratio = cell["szz"]/cell["sxx"]
    exact = 2*tangent*(tangent + 0.3)/(1 - 0.3*tangent)
    failed = numpy.argmax(ratio/exact)
    for where, row in (("at failure", failed), ("strain 0.8 %", -1)):
        result.compare("triaxial test: strength", where, exact[row], ratio[row], 2e-3, "1")
    result.compare("triaxial test: side stress", "second half", 100,
                   -cell["sxx"][len(ratio)//2:].mean(), 2e-3, "Pa")


# ---- compaction and release ----------------------------------------------------------------------

def compacted():
    """Settlements at 4 N, and released to 1 N [mm]. First loading has the stiffness k in each contact; release and
    reloading have k_2 = k (1 + 4 d_max/d_lim), d_lim = 5/4 of 0.1 times 2 R*, with R* = R/2 in four contacts and R
    in two, at the planes."""
    k, radius, peak, low = 1e4, 5e-3, 4.0, 1.0
    deepest = peak/k
    released = sum(number*(deepest - (peak - low)/(k*(1 + 4*deepest/(1.25*0.1*2*reduced))))
                   for number, reduced in ((4, radius/2), (2, radius)))
    return 1e3*6*deepest, 1e3*released


def compaction(result):
    peak, released = compacted()
    piston = wall("compaction", "piston")
    for where, time, settled in (("4 N", 0.6, peak), ("released to 1 N", 1.0, released), ("4 N again", 1.4, peak)):
        result.compare("compaction: settlement", where, settled, 1e3*at(piston, "moved", time), 1e-3, "mm")


# ---- bonded grains -------------------------------------------------------------------------------

def press(result):
    """The bond of area A = pi R^2 breaks at T = 1e4 A. The grain above touches both others with F_n = T/sin a at an
    angle a from the vertical, so that the piston's force is 2 T cot a, 2 sqrt(3) T for rigid grains.
    sin a = (D/2 + e/2)/(D - d) with the elongation e of the bond and the overlap d."""
    tension = 1e4*numpy.pi*D**2/4
    sine = 0.5
    for _ in range(20):
        overlap = (tension/sine/(HERTZ*numpy.sqrt(D/4)))**(2/3)
        sine = 0.5*(D + 1e4/1e11)/(D - overlap)
    broken = read_table("runs/press/bonds.csv")
    load = read_table("press.csv")
    result.compare("bonded grains: load at which the bond breaks", "", 1e3*2*tension*numpy.sqrt(1/sine**2 - 1),
                   1e3*numpy.interp(broken["time"][0], load["time"], load["value"]), 2e-3, "mN")


# ---- conveyor ------------------------------------------------------------------------------------

def conveyor(result):
    """The block slides with mu g until it has the belt's speed V, by V^2/(2 mu g) along the belt. The ball slides
    for 2 V/(7 mu g), then rolls with 2/7 V. The belt's work is V times the change of momentum."""
    speed, friction, end = 0.5, 0.3, 0.25
    rows = read_table(sorted(Path("runs/conveyor").glob("particles_*.csv"))[-1])
    block = rows["id"] > 0
    result.compare("conveyor: the block slides along the belt by", "", 1e3*speed**2/(2*friction*G),
                   1e3*(speed*end - rows["x"][block].mean()), 2e-3, "mm")
    slides = 2*speed/(7*friction*G)
    ball = ~block
    result.compare("conveyor: speed of the ball", "", 2/7*speed, rows["vx"][ball][0], 2e-3, "m/s")
    result.compare("conveyor: the ball moves by", "0.25 s", 1e3*2/7*speed*(end - slides/2), 1e3*rows["x"][ball][0],
                   2e-3, "mm")
    mass = 2500*numpy.pi/6*2e-3**3
    result.compare("conveyor: work of the belt", "", 1e6*mass*(3 + 2/7)*speed**2, 1e6*wall("conveyor", "belt")["work"].sum(),
                   2e-3, "uJ")


# ---- hopper --------------------------------------------------------------------------------------

def hopper(result):
    """Beverloo's law for a slot, W = 1.03 rho_b sqrt(g) b (w - 1.4 d)^1.5 (Nedderman, Statics and Kinematics of
    Granular Materials, 1992), with the bulk density of the bed before the gate goes. 15 %: as good as the law."""
    d, width, depth = 5e-3, 0.04, 0.025
    flow = read_table("runs/hopper/flows.csv")
    bulk = read_table("runs/hopper/bed.csv")["bulkDensity"][0]
    rows = (flow["name"] == "slot") & (flow["way"] == "forth") & (flow["time"] > 0.499)
    rate, ci95 = blocks(flow["massRate"][rows], 4)
    result.compare("hopper: rate", "slot of 8 d", 1.03*bulk*numpy.sqrt(G)*depth*(width - 1.4*d)**1.5, rate, 0.15, "kg/s", ci95)


# ---- simple shear --------------------------------------------------------------------------------

SHEAR_NUMBER = 6*D*numpy.sqrt(2500/1000)            # I = D_xy d sqrt(rho/p)


def jop():
    """Jop, Forterre, Pouliquen, Nature 441 (2006) 727, glass beads: mu_s + (mu_2 - mu_s)/(I_0/I + 1) with mu_s =
    tan 20.9, mu_2 = tan 32.76, I_0 = 0.279."""
    low, high = (numpy.tan(numpy.radians(angle)) for angle in (20.9, 32.76))
    return low + (high - low)/(0.279/SHEAR_NUMBER + 1)


def shear(result):
    """15 %: friction and sizes of the measured beads are not known."""
    cell = read_table("runs/shear/cell.csv")
    steady = cell["shear"] > 0.6
    friction, ci95 = blocks(abs(cell["sxy"][steady]/cell["syy"][steady]), 6)
    result.compare("simple shear: friction of the packing", f"inertial number {SHEAR_NUMBER:.2g}", jop(), friction, 0.15,
                   "1", ci95)


# ---- picture -------------------------------------------------------------------------------------

def draw():
    figure, (left, middle, right) = panels(3, 12)
    cell = read_table("runs/triaxial/cell.csv")
    strain = 100*(1 - cell["Lz"]/cell["Lz"][0])
    tangent = cell["Lz"]/2/(cell["Lx"]/3*numpy.sqrt(2))
    left.plot(strain, 2*tangent*(tangent + 0.3)/(1 - 0.3*tangent), color=REFERENCE, lw=1.2, label="closed form, published law")
    left.plot(strain, cell["szz"]/cell["sxx"], color=OURS, ls="--", label="Suna")
    left.set(xlabel="triaxial test: strain [%]", ylabel="axial over side stress", ylim=(0, None))
    piston = wall("compaction", "piston")
    peak, released = compacted()
    middle.plot([0, peak, released], [0, 4, 1], color=REFERENCE, lw=1.2)
    middle.plot(1e3*piston["moved"], piston["fz_now"], color=OURS, ls="--", marker="o", ms=3)
    middle.set(xlabel="compaction: settlement [mm]", ylabel="load [N]", xlim=(0, None), ylim=(0, None))
    cell = read_table("runs/shear/cell.csv")
    right.plot(cell["shear"], abs(cell["sxy"]/cell["syy"]), color=OURS, lw=0.8)
    right.axhline(jop(), color=REFERENCE, lw=1.2)
    right.set(xlabel="simple shear: strain", ylabel="shear over normal stress", xlim=(0, None), ylim=(0, None))
    below(figure, left, columns=2)
    save(figure, "laboratory.png")


def main():
    result = Rows()
    for test in (oedometer, triaxial, compaction, press, conveyor, hopper, shear):
        test(result)
    result.write()
    draw()
    if sys.argv[1:2] == ["-store"]:
        store(sys.argv[2], "laboratory.png")
    for text in result.outside:
        print("outside:", text)
    sys.exit(bool(result.outside))


if __name__ == "__main__":
    main()
