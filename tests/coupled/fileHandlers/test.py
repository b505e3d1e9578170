"""Coupled runs with each of OpenFOAM's file handlers: uncollated, collated and, in a long run, masterUncollated; and
with distributed roots.

- demPimpleFoam, and pimpleFoam with the function object, write fields, particles and snapshot into the folders of the
  handler; reconstructPar and redistributePar find U, p and the particles there, with the bytes of the uncollated run.
- A restart has the bits of the uninterrupted run, also from folders of another handler, and runs on another number of
  ranks.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

snapshot = "uniform/dem.snapshot"


def divided(solver, handler, name):
    """The case of the restart test for 8 steps, for two ranks."""
    case = Case(name, "restart")
    case.append("system/controlDict", function_object*(solver == "pimpleFoam"))
    case.edit("system/controlDict", endTime=0.008)
    case.run("decomposePar", "-fileHandler", handler)
    return case


def three_ranks(case):
    case.edit("system/decomposeParDict", numberOfSubdomains=3)
    case.sub("system/decomposeParDict", r"n \( 2 1 1 \)", "n ( 3 1 1 )")


def there(*paths):
    return all(path.stat().st_size > 0 for path in paths)


def particles(case, time):
    """Id, position, cell and velocity of the particles, by id."""
    rows = np.column_stack([case.field(f"{time}/lagrangian/particles/{name}") for name in ("id", "positions", "U")])
    return rows[rows[:, 0].argsort()]


def same_time(case, reference):
    """U and p of the last time have the bytes of a reference, and more than 100 particles the same numbers."""
    a, b = (particles(case, time) for time in (reference, "0.008"))
    return all(agrees(reference/name, case/"0.008"/name) for name in ("U", "p")) \
        and len(a) > 100 and np.array_equal(a, b)


def same_snapshot(a, b):
    return snapshot_hash(a/snapshot) == snapshot_hash(b/snapshot)


def written_and_continued(solver, handler, reference=None):
    """A run with this handler, and its restart from half its time; `reference` is what the uncollated run wrote."""
    what = f"{solver}, {handler}"
    case = divided(solver, handler, f"{solver}.{handler}")
    first = case/("processors2" if handler == "collated" else "processor0")/"0.008"
    claim_runs(f"{what}: runs on two ranks", case, solver, "-fileHandler", handler, ranks=2)
    claim(f"{what}: the snapshot is beside the fields of the first rank, and nowhere else",
          list(case.path.glob(f"processor*/0.008/{snapshot}")) == [first/snapshot])
    claim(f"{what}: the particles are in the folder of the fields",
          lambda: there(first/"U", first/"lagrangian/particles/positions"))
    claim_runs(f"{what}: reconstructPar ends", case, "reconstructPar", "-fileHandler", handler, "-latestTime")
    # sand beyond a periodic face, until it is wrapped; some versions stop where a particle is in no cell
    claim(f"{what}: particles are written inside the periodic box",
          lambda: (at := particles(case, "0.008")[:, 1:4]).min() >= 0 and (at <= (0.016, 0.012, 0.016)).all())
    if reference:
        claim(f"{what}: reconstructPar gives the bytes of the uncollated run", lambda: same_time(case, reference))
    else:
        claim(f"{what}: fluid and particles are reconstructed",
              lambda: there(*(case/"0.008"/name for name in ("U", "p", "lagrangian/particles/positions"))))
    claim(f"{what}: reconstructPar takes the snapshot along", lambda: same_snapshot(first, case/"0.008"))

    straight = (case/"0.008").rename(case/"straight")
    case.remove("processor*/0.008")
    case.edit("system/controlDict", startFrom="latestTime")
    case.run(solver, "-fileHandler", handler, ranks=2)
    case.run("reconstructPar", "-fileHandler", handler, "-latestTime")
    claim(f"{what}: a restart has the bits of the uninterrupted run",
          lambda: same_time(case, straight) and same_snapshot(straight, case/"0.008"))
    return case


case = written_and_continued("pimpleFoam", "uncollated")
written_and_continued("pimpleFoam", "collated", case/"straight")
uncollated = written_and_continued("demPimpleFoam", "uncollated")
reference = uncollated/"straight"
if thorough:
    written_and_continued("demPimpleFoam", "masterUncollated", reference)
collated = written_and_continued("demPimpleFoam", "collated", reference)

# ---- other ranks, and folders of another handler --------------------------------------------------


def continued_on_three(what, case, *options):
    """The case continues from the snapshot of half its time on three ranks."""
    claim_runs(f"{what}: runs", case, "demPimpleFoam", *options, ranks=3)
    claim(f"{what}: continues from the snapshot", case.found(f"^Suna: particles from .*0.004/{snapshot}"))


collated.remove("0.008", "processors2/0.008")
collated.run("reconstructPar", "-fileHandler", "collated", "-latestTime")
collated.remove("processors2")
three_ranks(collated)
collated.run("decomposePar", "-fileHandler", "collated", "-latestTime")
continued_on_three("from two collated ranks to three", collated, "-fileHandler", "collated")

uncollated.remove("0.008", "processor*/0.008")
three_ranks(uncollated)
uncollated.run("redistributePar", "-latestTime", "-overwrite", ranks=3)
claim_ran("redistributePar from two to three: ends", uncollated, "redistributePar")
continued_on_three("redistributePar from two to three", uncollated)

# ---- distributed roots ----------------------------------------------------------------------------

case = divided("demPimpleFoam", "uncollated", "roots")
other = work/"other/roots"
for name in ("system", "constant"):
    shutil.copytree(case/name, other/name)
(case/"processor1").rename(other/"processor1")
claim_runs("distributed roots: runs", case, "demPimpleFoam", "-roots", f'("{other.parent}")', ranks=2)
claim("distributed roots: the snapshot is under the root of the first rank",
      lambda: there(case/"processor0/0.008"/snapshot, other/"processor1/0.008/U"))
(other/"processor1").rename(case/"processor1")
case.run("reconstructPar", "-latestTime")
claim("distributed roots: reconstructPar gives the bytes of a run with one root", lambda: same_time(case, reference))
finish()
