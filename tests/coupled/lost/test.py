"""Lost particles, last good states and broken bonds in coupled runs.

- The log names the patch of particles that leave through an outlet, on one rank and two.
- If leaving is an error, the run writes its last good state, and a restart from it agrees with a run that did not
  fail.
- Broken bonds are reported and listed; intact ones are drawn.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

tables = "postProcessing/dem/0"


def says(log, sentence):
    return re.search(sentence, " ".join(log.split()))


def runs(what, solver="demPimpleFoam", ranks=1):
    claim_runs(what, case, solver, ranks=ranks)


def fails(what, sentence, solver="demPimpleFoam", ranks=1):
    run = case.run(solver, ranks=ranks, limit=120)
    claim(f"{what}: the run ends with an error", run.status not in (0, 124))
    claim(f"{what}: it says why", says(run.log, sentence), *re.findall("(?:Suna: lost|ERROR)(?:.*\n){7}", run.log))


def leaving(what):
    case.sub("constant/demProperties", "leaving (remove|error)", f"leaving {what}")


def control(**entries):
    case.edit("system/controlDict", **entries)


def positions(time="0.03"):
    return case.particles(time, "positions")


def numbers(name):
    """The columns of numbers of a table, one row a line."""
    return np.column_stack([column for column in case.table(name).values() if isinstance(column, np.ndarray)])


# ---- two particles leave ---------------------------------------------------------------------------

case = Case()
runs("runs")
lost = f"{tables}/lost.csv"
log, table, rows = case.log(), case.table(lost), numbers(lost)
claim("the first is reported", says(log, f"Suna: lost 1 particles, 1 in this run: 60; where and why is in {lost}"))
claim("and the second", says(log, "Suna: lost 1 particles, 2 in this run: 61;"))
claim("a row for each", list(table["id"]) == [60, 61])
claim("all that is written names the law of drag", case.names_effects(
    "gidaspow pressureGradient", lost, "0.03/voidFraction", "0.03/uniform/lagrangian/particles/cloudProperties",
    *(f"0.03/lagrangian/particles/{field}" for field in
      ("positions", "U", "omega", "contactForce", "d", "mass", "id", "material", "flags"))))
claim_tables("the tables", case/tables, "effects", "lost")
claim("without bonds no file of them", not list(case.path.glob("postProcessing/**/bonds*")))
claim("with the side, the speed and the patch", all(re.match(
    r"left through domain max z at 0\.[0-9]+ m/s, no wall there; out through patch top, 0\.00[0-9]+ m ahead", cause)
    for cause in table["cause"]))
# particles outside are removed every 32 steps: less than 32 of 2.6e-5 s at 1 m/s outside
claim("with its place", all((table["z"] > 0.038) & (table["z"] < 0.03884)))
straight, U = positions(), case.field("0.03/U")
case.remove("0.0*")

case.run("decomposePar")
runs("runs on two ranks", ranks=2)
# the pressure solver sums in another order: 1e-11 of its residual; the list has nine digits
claim("the same list on two ranks", difference(rows, numbers(lost)) < 1e-7)

# ---- leaving is an error ---------------------------------------------------------------------------

good = "its last good state is time 0.008, fluid and particles: look at it, or go on from it with startFrom latestTime"
leaving("error")
fails("an error", f"particle 60 left the domain at .*; {good}")
claim("the last good state has particles and fluid", all((case/"0.008"/name).stat().st_size for name in (
    "uniform/dem.snapshot", "lagrangian/particles/U", "U", "p", "phi", "voidFraction")))
claim("and nothing later is left", case.times() == ["0.008"])
leaving("remove")
# runTime counts from where a run starts: 0.03 s
control(startFrom="latestTime", writeInterval=0.022)
runs("corrected, it continues")
claim("from the last good state", says(case.log(), "Suna: particles from .*0.008/uniform/dem.snapshot"))
# fields pass through 16 decimal digits and linear solvers of 1e-11
claim("as if it had not failed, particles", difference(straight, positions()) < 1e-9)
claim("as if it had not failed, fluid", difference(U, case.field("0.03/U")) < 1e-7)
claim("with a list of its own", len(case.table("postProcessing/dem/0.008/lost.csv")["id"]) == 2)

# a state that is written anyway
case.remove("0.0*")
leaving("error")
control(writeInterval=0.008)
fails("after a write", good)
claim("that time is left as it was written", re.search("index *8;", case.read("0.008/uniform/time")))
case.remove("0.0*")
case.sub("constant/demProperties", "rho  .*", r"\g<0> lastGood no;")
control(writeInterval=0.01)
fails("lastGood no", "particle 60 left the domain at .* or set domain/leaving remove From")
claim("lastGood no: nothing is written", case.times() == [])
case.sub("constant/demProperties", "lastGood no;", "")
case.sub("constant/demProperties", r"velocity \(0 0 1\); }       // id 60", "velocity (0 0 20); }  // id 60")
fails("in the first step", "its last good state is the one that it started from")
case.sub("constant/demProperties", r"velocity \(0 0 20\)", "velocity (0 0 1)")

# 50 km/s in a cell: the fluid is to blame, and its state is not good
inside = case.read("0/U")
case.sub("0/U", "internalField.*", "internalField uniform (0 0 5e4);")
fails("a fluid that has diverged",
      r"; the fluid has diverged, with .* m/s at \(.*\) m, .* cells in a time step: look at its schemes")
claim("a fluid that has diverged: no state is written", case.times() == [])
case.write("0/U", inside)

# fluid steps of 4 DEM steps: copies are 25 DEM steps apart
control(deltaT=0.0001)
fails("short fluid steps", r"the particles' last good state, of time 0.008[0-9]* s, is in lastGood.dem")
claim("short fluid steps: nothing but the file", (case/"lastGood.dem").stat().st_size and case.times() == [])
control(deltaT=0.001)

case.remove("processor*")
case.run("decomposePar", "-force")
fails("an error on two ranks", f"particle 60 left the domain at .*; {good}", ranks=2)
claim("both ranks have written theirs", all((case/name).stat().st_size for name in (
    "processor0/0.008/uniform/dem.snapshot", "processor0/0.008/U", "processor1/0.008/U")))
leaving("remove")
control(writeInterval=0.022)
runs("corrected, two ranks continue", ranks=2)
case.run("reconstructPar", "-latestTime")
claim("as if they had not failed", difference(straight, positions()) < 1e-8)

# out of the mesh: the top is no wall and no outlet
case.remove("0.0*", "processor*")
case.sub("constant/demProperties", "^domain.*", "")
fails("out of the mesh", r"outside the mesh.*the first is particle 60 at .* m, with 0\.[0-9]+ m/s; "
      r"out through patch top, .* m behind\..*; its last good state is time 0.0")

# ---- another solver --------------------------------------------------------------------------------

case = Case("other")
leaving("error")
case.append("system/controlDict", function_object)
fails("a function object", "particle 60 left the domain.*; the particles' last good state, of time 0.008 s, is in "
      "lastGood.dem: start . snapshot .lastGood.dem.; . in constant/demProperties begins with these particles, and the "
      "fluid at time 0 ", "pimpleFoam")
claim("a function object: no time that the fluid is ahead of", case.times() == [])
leaving("remove")
case.append("constant/demProperties", 'start { snapshot "lastGood.dem"; }\n')
runs("a function object: particles start from there", "pimpleFoam")
claim("a function object: those that left are reported",
      says(case.log("pimpleFoam"), "Suna: lost 1 particles, 2 in this run: 61;"))

# with a written time fluid and particles can continue together
case.remove("0.0*", "lastGood.dem")
leaving("error")
case.sub("constant/demProperties", "^start .*", "")
control(writeInterval=0.005)
fails("a function object, after a write", "is in lastGood.dem: look at it, or go on with fluid and particles of time "
      "0.005, the last that was written: startFrom startTime; startTime 0.005;", "pimpleFoam")
leaving("remove")
control(startTime=0.005, writeInterval=0.025)
runs("a function object: corrected, it continues", "pimpleFoam")
claim("a function object: from the written time",
      says(case.log("pimpleFoam"), "Suna: particles from .0.005/uniform/dem.snapshot"))
rescued = positions()
case.remove("0.0*")
control(startTime=0, writeInterval=0.03)
case.run("pimpleFoam")
# lists are renewed at other times: round-off, which contacts amplify
claim("a function object: as if it had not failed", difference(positions(), rescued) < 1e-9)

# ---- bonds -----------------------------------------------------------------------------------------

bonds = f"{tables}/bonds.csv"


def bond(id, cause, name=bonds):
    """Time, place and energy of the row of bonds.csv for the bond of this particle and the next."""
    table = case.table(name)
    k, = np.flatnonzero((table["id1"] == id) & (table["id2"] == id + 1) & (np.array(table["cause"]) == cause))
    return np.array([table[key][k] for key in ("time", "x", "y", "z", "energy")])


def drawn(*pictures):
    """The number of bonds in each of these pictures."""
    return [int(re.search('NumberOfLines="([0-9]*)"', case.read(name))[1]) for name in pictures]


case = Case("bonds")
pictures = [f"{tables}/bonds_{time}.vtp" for time in ("0.004", "0.008", "0.012")]
case.copy(here/"constant/demProperties.bonds", "constant/demProperties")
control(endTime=0.012, writeInterval=0.004)
runs("bonds: runs")
log, table = case.log(), case.table(bonds)
claim("bonds: the first that breaks is reported",
      says(log, f"Suna: 1 bond broke, 1 in this run; where and why is in {bonds}"))
claim("bonds: and the second", says(log, "Suna: 1 bond broke, 2 in this run;"))
claim("bonds: a row for each", list(zip(table["id1"], table["id2"], table["cause"])) ==
      [(0, 1, "tension"), (2, 3, "distance")])
# sin(w t) = s w/v, w^2 = 2 k/m: s = normalStrength/normalStiffness, k = normalStiffness pi R^2, within two DEM steps;
# there k s^2/2 is lost, plus the stretch of one step. The middle of the pair goes at 1 m/s.
dt = float(case.found("time step of the particles at most (.*?) s")[1])
torn, apart = bond(0, "tension"), bond(2, "distance")
k, s, m = 1e8*math.pi*1e-6, 1e-4, 2500*4/3*math.pi*1e-9
w = math.sqrt(2*k/m)
t, U = math.asin(s*w/2)/w, k*s*s/2
claim("bonds: with time, place and energy of a spring that is torn",
      t - dt <= torn[0] <= t + 2*dt and abs(torn[1] - 0.01 - t) < 2*dt and 0.999*U <= torn[4] <= U*(1 + 2*dt/s)**2,
      f"{torn}: expected {t} s, {U} J, steps of {dt} s")
# a gap of 0.5 mm at 0.05 m/s; spring and gas take 0.2 % of the speed
claim("bonds: one that is drawn apart", close(apart[0], 0.01, 0.01))
claim("bonds: a picture at each time with those that hold", drawn(*pictures) == [2, 2, 1])
claim_tables("bonds: the tables", case/tables, "effects", "bonds")
claim("bonds: pictures and list name the effects, too", case.names_effects(
    "bondLinear .*gidaspow pressureGradient", bonds, *pictures))
listed = re.findall('timestep="([^"]*)".*file="bonds_([^"]*).vtp"', case.read("postProcessing/dem/0/bonds.pvd"))
claim("bonds: and the list of pictures with their times",
      difference(np.array(listed, float), np.outer([0.004, 0.008, 0.012], [1, 1])) < 1e-12)

case.run("decomposePar")
runs("bonds: runs on two ranks", ranks=2)
two = [bond(0, "tension"), bond(2, "distance")]
# as above; energies of 1e-6 and 4e-11 J are far below that bound, so they are compared separately
claim("bonds: the same rows on two ranks, and no others",
      len(case.table(bonds)["time"]) == 2 and difference([torn, apart], two) < 1e-7)
claim("bonds: and the same energies", close(two[0][4], torn[4], 1e-7) and close(two[1][4], apart[4], 1e-7))
claim("bonds: and as many lines", drawn(*pictures) == [2, 2, 1])

control(startTime=0.008)
case.remove("processor*", "0.012")
runs("bonds: continues")
later = "postProcessing/dem/0.008"
claim("bonds: with a list of its own", len(case.table(f"{later}/bonds.csv")["time"]) == 1)
claim("bonds: that has the row of the straight run",
      difference(apart, bond(2, "distance", f"{later}/bonds.csv")) < 1e-7)
claim("bonds: and a picture", drawn(f"{later}/bonds_0.012.vtp") == [1] and
      not (case/later/"bonds_0.008.vtp").exists())

# the second bond exceeds the limit in the third step: the bond that broke in the first step has its row, and the last
# good state has no picture
case.remove("0.0*", "postProcessing")
control(startTime=0)
case.append("constant/demProperties", "domain { min (-1 -1 -1); max (0.0155 1 1); leaving error; }\n")
fails("bonds: an error", "particle 1 left the domain at .*; its last good state is time 0.002")
claim("bonds: an error: those that broke are listed, and nothing is drawn",
      len(bond(0, "tension")) and sorted(os.listdir(case/tables)) == ["bonds.csv", "effects.csv"])
case.sub("constant/demProperties", "0.0155", "0.0125")
case.remove("0.0*", "postProcessing")
fails("bonds: an error in the step of a break", "particle 1 left the domain")
claim("bonds: it is listed all the same", lambda: len(bond(0, "tension")))
finish()
