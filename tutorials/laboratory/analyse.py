#!/usr/bin/env python3
"""analyse.py -- laboratory tests beside closed forms, published laws and LIGGGHTS: result.csv, laboratory.png.

    analyse.py [frictionless] [-store "text"]     with -store also stored/ and the table of results.md

With `frictionless` only the runs of Allrun -long.

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


# ---- frictionless spheres ------------------------------------------------------------------------

def frictionless(result):
    """Peyneau and Roux, Phys. Rev. E 78 (2008) 011307: friction and solid fraction in the limit of slow shear are
    tan 5.76 degrees and 0.639. mu_0 + c I^a through all rates, with the number I = D_xy sqrt(m/(p d)).
    Bounds: half a degree, and 0.5 %, since overlaps of 0.3 % raise the solid fraction."""
    from scipy.optimize import curve_fit
    paths = sorted(Path("runs").glob("frictionless-*"), key=lambda path: -float(path.name.split("-")[1]))
    numbers = numpy.array([float(path.name.split("-")[1]) for path in paths])
    friction, error, solid = [], [], []
    for number, path in zip(numbers, paths):
        cell = read_table(path/"cell.csv")
        steady = cell["shear"] > 0.25*cell["shear"].max()
        mean, ci95 = blocks(abs(cell["sxy"][steady]/cell["syy"][steady]), 8)
        friction.append(mean)
        error.append(ci95)
        solid.append(cell["solidFraction"][steady].mean())
        result.add("frictionless spheres: friction", f"inertial number {number:g}", None, mean, ci95, "1")
        result.add("frictionless spheres: solid fraction", f"inertial number {number:g}", None, solid[-1], None, "1")

    def law(number, limit, factor, power):
        return limit + factor*number**power

    (limit, *_), covariance = curve_fit(law, numbers, friction, (0.1, 1, 0.4), sigma=error, absolute_sigma=True)
    degrees = numpy.degrees(numpy.arctan(limit))
    result.compare("frictionless spheres: angle of friction", "slow limit", 5.76, degrees, 0.5/5.76, "degrees",
                   numpy.degrees(numpy.sqrt(covariance[0, 0])))
    (volume, *_), _ = curve_fit(law, numbers, 1/numpy.array(solid), (1.56, 0.3, 0.5))
    result.compare("frictionless spheres: solid fraction", "slow limit", 0.639, 1/volume, 5e-3, "1")


# ---- shear cell, drum, mixer ---------------------------------------------------------------------

def liggghts(scene):
    """Mean of LIGGGHTS from the same initial positions; peer/peer.py has the sums."""
    rows = read_table("stored/liggghts.csv")
    return rows["mean"][rows["scene"] == scene][0]


def shear_cell(result):
    """Force along x on the upper half over the normal force in the plane of shear, which the lower half carries; from
    1 mm of displacement on. 10 %: the means of both codes have intervals of some 5 %."""
    floor, *sides = (wall("shearCell", name) for name in
                     ("floor", "lowerLeft", "lowerRight", "upperLeft", "upperRight"))
    normal = -(floor["fz"] + sides[0]["fz"] + sides[1]["fz"])
    shear_force = -(sides[2]["fx"] + sides[3]["fx"])
    steady = floor["time"] > 0.083
    friction, ci95 = blocks(shear_force[steady]/normal[steady], 5)
    result.compare("shear cell: friction of the packing", "LIGGGHTS", liggghts("shearCell"), friction, 0.1, "1", ci95)
    lid = wall("shearCell", "lid")["fz"][steady]
    result.compare("shear cell: load of the lid", "given", 0.24, lid.mean(), 0.01, "N")


def drum(result):
    """The torque about the axis is weight times offset of the centre of mass, less the growth of angular momentum;
    the power is the torque times the angular velocity."""
    begin, end, omega = 0.5, 2.5, 3.0
    rows = wall("drum", "drum")
    taken = rows["time"] > begin + 0.1
    torque = -rows["ty"][taken].mean()
    states = [read_table(path) for path in sorted(Path("runs/drum").glob("particles_*.csv"))]
    states = [state for state in states if state["time"][0] > begin - 1e-3]
    mass = 2500*numpy.pi/6*states[0]["diameter"]**3
    offset = [mass @ state["x"]/mass.sum() for state in states]

    def momentum(state):
        orbit = state["z"]*state["vx"] - state["x"]*state["vz"]
        return mass @ (orbit + 0.1*state["diameter"]**2*state["wy"])

    mean = numpy.mean([0.5*(one + next) for one, next in zip(offset, offset[1:])])
    expected = -G*mass.sum()*mean + (momentum(states[-1]) - momentum(states[0]))/(end - begin)
    result.compare("drum: torque", "closed form", 1e3*expected, 1e3*torque, 5e-3, "mN m")
    result.compare("drum: power", "torque times speed", 1e3*torque*omega, 1e3*rows["power"][taken].mean(), 1e-3, "mW")


def mixer(result):
    """8 %: the means of both codes have intervals of 4 %."""
    blade = wall("mixer", "blade")
    steady = blade["time"] > 1.0
    torque, ci95 = blocks(-1e3*blade["tz"][steady], 5)
    result.compare("mixer: torque of the blade", "LIGGGHTS", liggghts("mixer"), torque, 0.08, "mN m", ci95)
    result.compare("mixer: power", "torque times speed", 9*torque, 1e3*blade["power"][steady].mean(), 1e-3, "mW")


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
    result, arguments = Rows(), sys.argv[1:]
    long = arguments[:1] == ["frictionless"]
    for test in (frictionless,) if long else (oedometer, triaxial, compaction, press, conveyor, hopper, shear,
                                              shear_cell, drum, mixer):
        test(result)
    result.write()
    if not long:
        draw()
    if long and arguments[1:2] == ["-store"]:
        store(arguments[2], name="frictionless", result="frictionless.csv")
    elif arguments[:1] == ["-store"]:
        store(arguments[1], "laboratory.png")
    for text in result.outside:
        print("outside:", text)
    sys.exit(bool(result.outside))


if __name__ == "__main__":
    main()
