"""Particles enter a duct with the liquid through its inlet and leave through its outlet.

- The number of particles follows the rate; the exchange closes; a restarted run has the same bits; two ranks agree
  with one.
- In a closed box with a stream and an outlet inside, the momentum of liquid and particles is the initial momentum
  plus the inserted less the removed momentum.
- The void fraction has the part of a sphere that is before the outlet.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools

from case import *

tables = "postProcessing/dem/0"


def flow(name, column):
    """The last number of a stream or outlet in the table of flows."""
    table = case.table(f"{tables}/flows.csv")
    return table[column][np.array(table["name"]) == name][-1]


def same_residence(table):
    return all(np.array_equal(table[key], residence[key]) for key in ("time", "name", "particles", "mean", "bin0"))


def signs(table):
    return np.where(np.array(table["way"]) == "in", 1, -1)


case = Case()
claim_runs("runs", case)
claim("the exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("the fluid has the volume of the particles present", worst(case.log(), "volume error") < 1e-12)
# checked at the start of a step: 0.199 s have passed
claim("1500 a second for 0.199 s", flow("feed", "particles") == 298)
claim("by mass, within one particle of the mass due", -1e-12 < 0.199*2e-4 - flow("fast", "mass") < 2.3e-6)
claim("inside the duct, until the end of that stream", flow("drop", "particles") == 45)
claim("some left through the outlet, some through the inner outlet",
      flow("out", "particles") > 100 and flow("trap", "particles") > 0)
table = case.table(f"{tables}/flows.csv")
last, mass = table["time"] == 0.2, case.field("0.2/lagrangian/particles/mass")
claim("the particles present are those inserted less those removed",
      len(mass) == (signs(table)*table["particles"])[last].sum())
# nine digits of the table
claim("the mass present is that inserted less that removed",
      close(mass.sum(), (signs(table)*table["mass"])[last].sum(), 1e-8))
claim("with the liquid's velocity", close(flow("feed", "px"), 0.4*flow("feed", "mass"), 1e-8))
claim("the table names the law of drag", case.names_effects("gidaspow pressureGradient", f"{tables}/flows.csv"))
claim_tables("the tables", case/tables, "effects", "flows", "residence")
residence = case.table(f"{tables}/residence.csv")
claim("residence.csv has a row at each write time for the outlet that asks", residence["name"] == ["out", "out"])
claim("its particles are those that left, whose times are below 0.2 s",
      residence["particles"][-1] == flow("out", "particles") and 0.02 < residence["mean"][-1] < 0.2)
claim("no particle was lost", not (case/tables/"lost.csv").exists())

# ---- restart from halfway --------------------------------------------------------------------------


def last_rows(name):
    return [row for row in case.read(name).splitlines() if row.startswith("0.2,")]


rows, ages = last_rows(f"{tables}/flows.csv"), last_rows(f"{tables}/residence.csv")
(case/"0.2").rename(case/"straight")
case.edit("system/controlDict", startFrom="latestTime")
claim_runs("continues from halfway", case)
for field in ("positions", "U", "id"):
    claim(f"the same bits after a restart, particles' {field}",
          agrees(case/f"0.2/lagrangian/particles/{field}", case/f"straight/lagrangian/particles/{field}"))
for field in ("U", "p", "phi", "voidFraction"):
    claim(f"the same bits after a restart, {field}", agrees(case/"0.2"/field, case/"straight"/field))
claim("the table continues after the restart", rows and last_rows("postProcessing/dem/0.1/flows.csv") == rows)
claim("and the residence times", ages and last_rows("postProcessing/dem/0.1/residence.csv") == ages)

# ---- rows at the interval of the record, and at the end --------------------------------------------

case.remove("0.2", "postProcessing")
case.sub("constant/demProperties", "rho     1000;", r"\g<0> record { interval 0.004; }")
case.edit("system/controlDict", endTime=0.11)
claim_runs("from 0.1 s, with a record, to a time that is not written", case)
claim("flows.csv has rows at multiples of record/interval, and at the end",
      sorted(set(case.table("postProcessing/dem/0.1/flows.csv")["time"])) == [0.104, 0.108, 0.11])
claim("residence.csv, too", list(case.table("postProcessing/dem/0.1/residence.csv")["time"]) == [0.104, 0.108, 0.11])
case.sub("constant/demProperties", "record .*", "")
case.edit("system/controlDict", endTime=0.2)

# ---- a run that begins later -----------------------------------------------------------------------

late = Case("late")
(late/"0").rename(late/"5")
late.sub("constant/demProperties", "rate 1500;", "rate 1500; start 5.01; end 5.03;")
late.edit("system/controlDict", startTime=5, endTime=5.04, writeInterval=0.02)
claim_runs("late: a run that begins at 5 s", late)
times = late.table("postProcessing/dem/5/flows.csv")
feed = [int(n) for n, name in zip(times["particles"], times["name"]) if name == "feed"]
claim("late: the stream of 5.01 to 5.03 s enters then", feed[-1] == 30 and 0 < feed[0] < 20, feed)

# ---- two ranks -------------------------------------------------------------------------------------

case.remove("0.[12]")
case.edit("system/controlDict", startFrom="startTime")
case.run("decomposePar")
claim_runs("runs on two ranks", case, ranks=2)
again = case.table(f"{tables}/flows.csv")
claim("the same counts on two ranks",
      all(np.array_equal(again[key], table[key]) for key in ("time", "name", "way", "particles", "waiting")))
claim("the residence times on two ranks", same_residence(case.table(f"{tables}/residence.csv")))
claim("the exchange closes on two ranks", worst(case.log(), "exchange error") < 1e-12)

# ---- back through the inlet ------------------------------------------------------------------------


def says(log, sentence):
    return re.search(sentence, " ".join(log.split()))


# particles that return to the inlet are removed only if it is an outlet, too
case.sub("constant/demProperties", r"velocity \(0.6 0 0\); spread \(0.1 0.1 0.1\)", "velocity (2 0 0); end 0.003")
case.sub("constant/demProperties", "rate 1500", "rate 1")
case.sub("constant/g", r"\(0 0 -9.81\)", "(-500 0 0)")
case.edit("system/controlDict", maxParticleCo=0.001)
run = case.run("demPimpleFoam", limit=120)
claim("back through the inlet: the run ends with an error", run.status not in (0, 124))
claim("back through the inlet: the sentence names the patch and the cure",
      says(run.log, "out through patch inlet, .*outlets { NAME { patch"))
claim("back through the inlet: beside the step, which is long, too",
      says(run.log, "above 0.001 .maxParticleCo.; .*outlets { NAME { patch inlet; } }"))
case.edit("system/controlDict", maxParticleCo=0.5)
case.sub("constant/demProperties", "out  { patch outlet; residence 0.2; }", r"\g<0> back { patch inlet; }")
claim_runs("where it is an outlet, it runs", case)
claim("back through the inlet, also an outlet: they are counted", flow("back", "particles") > 0)

# ---- likely mistakes: the plan warns ---------------------------------------------------------------

for what, sentence, name, entry, wrong in (
        ("a velocity out of the mesh", r"insert/fast: nothing enters through patch inlet, as velocity \(-0.6 0 0\) m/s does "
         r"not point into the mesh; give one with a component along \(1 0 0\)",
         "constant/demProperties", r"velocity \(0.6 0 0\)", "velocity (-0.6 0 0)"),
        # 3e5/s of pi/6 mm3 over 4 cm2 at 0.4 m/s
        ("more than there is room for", "insert/feed: 0.00015708 m3/s of particles through patch inlet at 0.4 m/s have a "
         "solid fraction of 0.98[0-9]*, above 0.5, .*; give a rate of at most 9167[0-9.]+ 1/s, or a velocity of at least "
         "1.30[0-9]* m/s", "constant/demProperties", "rate 1500", "rate 3e5"),
        ("weight out of the inlet", "insert/feed: particles may return to patch inlet, which ends the run: .* add outlets { "
         "back { patch inlet; } }", "constant/g", r"\(0 0 -9.81\)", "(-500 0 0)")):
    case.copy(here/"constant/demProperties", "constant/demProperties")
    case.gravity()
    plain = case.run("demPimpleFoam", "-plan")
    claim(f"{what}: not in the case", plain and not says(plain.log, sentence), plain.log[-2000:])
    case.sub(name, entry, wrong)
    log = case.run("demPimpleFoam", "-plan").log
    claim(f"{what}: warns", says(log, sentence), log[-2000:])

# grains of 0.25 mm sink at 0.2 m/s, spheres of 1 mm at 0.6 m/s
case.copy(here/"constant/demProperties", "constant/demProperties")
case.gravity("(-100 0 0)")
claim("spheres that are faster than the fluid may return", says(case.run("demPimpleFoam", "-plan").log, sentence))
case.sub("constant/demProperties", "diameter 1e-3", "diameter 0.25e-3")
case.sub("constant/demProperties", "min 0.6e-3; max 1.2e-3;", "min 0.15e-3; max 0.3e-3;")
case.append("constant/demProperties", "parcels { ratio 4; }")
plain = case.run("demPimpleFoam", "-plan")
claim("parcels of that size, whose grains are slower, do not", plain and not says(plain.log, sentence),
      plain.log[-2000:])
case.gravity()

# ---- slips: the run ends before its first step -----------------------------------------------------

for what, sentence, entry, wrong in (
        ("an unknown inlet patch", "insert/feed: unknown patch .?inlett.?.*inlet",
         "feed { type stream; patch inlet", "feed { type stream; patch inlett"),
        ("an unknown outlet patch", "outlets/out: unknown patch .?outlets.?.*outlet",
         "patch outlet;", "patch outlets;"),
        ("a stream through a wall", "insert/feed: patch walls is a wall of the particles",
         "feed { type stream; patch inlet", "feed { type stream; patch walls"),
        ("an outlet that is a wall", "outlets/out: patch walls is a wall of the particles",
         "patch outlet;", "patch walls;"),
        ("an outlet that coupling/walls makes a wall", "outlets/out: patch outlet is a wall of the particles",
         "rho     1000;", "rho 1000; walls (outlet);"),
        ("a patch and a region", "insert/feed: more than one of min and max",
         "feed { type stream;", "feed { type stream; min (0 0 0); max (0.01 0.01 0.01);"),
        ("a velocity that is a word", "insert/feed: velocity flow; give fluid, or a vector",
         "rate 1500;", "rate 1500; velocity flow;"),
        ("a rate of nothing", "insert/feed: rate 0; give a number above 0",
         "rate 1500", "rate 0")):
    case.copy(here/"constant/demProperties", "constant/demProperties")
    case.sub("constant/demProperties", entry, wrong)
    run = case.run("demPimpleFoam", limit=60)
    claim(f"{what}: says '{sentence}'", run.status not in (0, 124) and says(run.log, sentence) and
          not re.search("^Time = |sigFpe|sigSegv", run.log, re.M), *run.log.splitlines()[-12:])

# ---- a closed box ----------------------------------------------------------------------------------

case = Case("closed", "momentum")
# a solver without void fraction, as the particles' volume changes in a closed box
case.append("system/controlDict", function_object)
case.edit("system/controlDict", writeInterval=0.001)
for entry in ("pressureGradient {}", r"fields  \(.*", "^averages.*"):
    case.sub("constant/demProperties", entry, "")
case.sub("constant/demProperties", "count 500", "count 300")
case.append("constant/demProperties", """
insert { more { type stream; rate 8000; diameter 8e-4; min (-0.002 0 0); max (0.004 0.012 0.012);
                velocity (0.3 -0.2 0.1); spread (0.1 0.1 0.1); } }
outlets { hole { min (0.006 0.003 0.003); max (0.009 0.009 0.009); } }
""")
claim_runs("closed: runs", case, "pimpleFoam")
claim("closed: many are inserted and removed", min(flow("more", "particles"), flow("hole", "particles")) > 50)
table, total = case.table(f"{tables}/flows.csv"), case.vectors("sum", "momentum", "pimpleFoam")
# two rows a time: the stream and the outlet
passed = np.column_stack([(signs(table)*table[p]).reshape(40, 2).sum(1) for p in ("px", "py", "pz")])
# nine digits of the table; linear solvers to 1e-11
claim("closed: momentum is the initial one plus that inserted less that removed",
      difference(total - passed, np.tile(total[0] - passed[0], (40, 1))) < 1e-8*largest(passed))

# ---- the fraction of a sphere that crosses a patch -------------------------------------------------

# One sphere leaves, another is fixed in the middle. The void fraction has the whole of the fixed one and
# t^2 (3 - 2 t) of the other, t the distance of its center from the outlet, at x = 0.04 m, over its diameter of
# 1 mm; nothing when it is beyond, in the step in which it is removed.
case = Case("share")
for line in ("feed {.*", "fast {.*", "trap {.*"):
    case.sub("constant/demProperties", line, "")
case.sub("constant/demProperties", "drop {.*",
         "held { type list; diameter 1e-3; frozen yes; positions ((0.02 0.011 0.0093)); } "
         "ball { type list; diameter 1e-3; velocity (0.4 0 0); positions ((0.0385 0.0103 0.0088)); }")
case.edit("system/controlDict", endTime=0.006, writeInterval=0.001)
claim_runs("crossing: runs", case)
places, error = [], []
for when in case.times():
    x = case.field(f"{when}/lagrangian/particles/positions")[:, 0].max()
    there = x > 0.03                                                            # else only the fixed one
    t = np.clip((0.04 - x)/1e-3, 0, 1) if there else 0
    spheres = (1 - case.field(f"{when}/voidFraction")).sum()*6.4e-8/(math.pi/6*1e-9)
    error.append(spheres - 1 - t*t*(3 - 2*t))
    places.append("removed" if not there else {1: "inside", 0: "beyond"}.get(t, "crossing"))
# 250 numbers near 1, with 16 digits, for 0.02 in all
claim("crossing: the void fraction has the closed form (1e-11)", len(error) == 6 and largest(error) < 1e-11)
claim("crossing: the sphere was inside, crossing, beyond, and removed",
      [place for place, _ in itertools.groupby(places)] == ["inside", "crossing", "beyond", "removed"])
finish()
