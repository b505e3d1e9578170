"""Cells of any shape: tetrahedra, polyhedra, slivers, thin cells of 1 : 1000, and cells inclined by 80 degrees.

- Particles as dense as the fluid stay at rest; the solid volume is exact; the exchange closes. Slivers are a millionth
  of their neighbors.
- A fixed bed has the pressure gradient of its closure (1 %).
- A uniform flow stays uniform on inclined cells.

Flow through slivers, which needs a very short step (docs/limits.md), is not tested.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import gidaspow_gradient, lattice_void

properties, control = "constant/demProperties", "system/controlDict"


def column(name, cells, grading=(1, 1, 1), lean=0):
    """The case of fixedBed on a column of 11 x 11 x 50.6 mm with a bed of 33 mm; the top is shifted by `lean` [m]."""
    case = Case(name, "fixedBed")
    case.copy(case/"0", "0.orig")
    case.sub(properties, "count 2000", "count 3000")
    case.sub(properties, "0.011 0.022", "0.011 0.033")
    case.sub("system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 3")
    # the Gauss gradient is not exact on cells other than boxes
    case.sub("system/fvSchemes", "^gradSchemes .*", "gradSchemes { default leastSquares; }")
    floor = [(0, 0), (0.011, 0), (0.011, 0.011), (0, 0.011)]
    if lean:
        sides = {"left": "type cyclic; neighbourPatch right; faces ((3 0 4 7));",
                 "right": "type cyclic; neighbourPatch left; faces ((1 2 6 5));",
                 "sides": "type wall; faces ((0 1 5 4) (2 3 7 6));"}
    else:
        sides = {"sides": "type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7));"}
    case.mesh([(x, y, 0) for x, y in floor] + [(x + lean, y, 0.0506) for x, y in floor],
              [f"(0 1 2 3 4 5 6 7) {vector(cells)} simpleGrading {vector(grading)}"],
              {"inlet": "type patch; faces ((0 3 2 1));", **sides, "outlet": "type patch; faces ((4 5 6 7));"})
    return case


def tetrahedra(name):
    case = column(name, (3, 3, 14))
    case.run("bash", "./tetrahedra")
    return case


def polyhedra(name):
    case = tetrahedra(name)
    case.run("polyDualMesh", "-overwrite", 75)
    if (case/"0/polyMesh").exists():                  # the mesh is there with the fields, if it was read from there
        case.remove("constant/polyMesh")
        case.copy(case/"0/polyMesh", "constant/polyMesh")
    case.remove("0")
    case.copy(case/"0.orig", "0")
    return case


def slivers(name):
    """Tetrahedra, but the central point of block cell 60 is moved next to its first face: the tetrahedron there has
    1e-6 of its volume."""
    case = tetrahedra(name)
    centre = 4*4*15 + 60                              # the tetrahedra of a block cell share this point
    points = case.field("constant/polyMesh/points")
    faces = case.field("constant/polyMesh/faces")[:, 1:].astype(int)
    near = np.unique(faces[(faces == centre).any(1)])
    top = points[near[points[near, 2] > points[centre, 2]]].mean(0)
    points[centre] = [top[0], top[1], top[2] + (points[centre, 2] - top[2])*1e-6]
    case.dictionary("constant/polyMesh/points", f"{len(points)}\n(\n" + "\n".join(map(vector, points)) + "\n)",
                    "vectorField")
    return case


def thin(name):
    return column(name, (28, 3, 14), grading=(1000, 1, 1))


def leaning(name):
    """The top is shifted by 0.287 m along the periodic x: 80 degrees between the lower and upper faces and the lines
    through them."""
    case = column(name, (5, 5, 23), lean=0.287)
    for field in ("0/U", "0/p"):
        case.sub(field, "^ *inlet", "left { type cyclic; } right { type cyclic; } inlet")
    # with linear weights a uniform bed is not uniform on inclined cells
    case.sub(properties, "kernel  diffusion;", "kernel diffusion; base divided;")
    return case


def bed(case):
    """A fixed bed in a flow."""
    name = case.path.name
    claim_runs(f"{name}: a fixed bed runs", case)
    claim(f"{name}: volume of the particles is exact", worst(case.log(), "volume error") < 1e-12)
    claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    for function in ("writeCellCentres", "writeCellVolumes"):
        case.run("postProcess", "-func", function, "-latestTime")
    height, p, volume = case.field("0.02/C")[:, 2], case.field("0.02/p"), case.field("0.02/V")
    inside = (height > 0.010) & (height < 0.023)
    slope = np.polyfit(height[inside], p[inside], 1, w=np.sqrt(volume[inside]))[0]
    claim(f"{name}: the pressure gradient is the closure's (1 %)",
          close(-1.2*slope, gidaspow_gradient(lattice_void), 0.01))


def rest(case):
    """Particles as dense as the fluid, without flow."""
    name = case.path.name.replace("-rest", "")
    case.sub("0/U", r"uniform \(0 0 0.3\)", "uniform (0 0 0)")
    case.sub(properties, "density 2500", "density 1.2")
    case.sub(properties, "frozen yes;", "")
    case.gravity()
    case.edit(control, endTime=0.005, writeInterval=0.005)
    claim_runs(f"{name}: at rest runs", case)
    claim(f"{name}: at rest the volume is exact", worst(case.log(), "volume error") < 1e-12)
    # 1e-6 m/s is required; round-off of g T is below 1e-17
    claim(f"{name}: no particle moves", largest(case.field("0.005/lagrangian/particles/U")) < 1e-8)


def mesh_numbers(case, pattern):
    """What checkMesh prints there."""
    case.run("checkMesh")
    return [float(number) for number in case.found(pattern, "checkMesh").groups()]


def smallest(case):
    """The volume of the smallest cell over the largest."""
    low, high = mesh_numbers(case, r"Min volume = (\S+)\. Max volume = (\S+)\. ")
    return low/high


def uniform_flow(case):
    """A uniform flow with one very small particle, as a run needs one: its drag changes the velocity of the fluid by
    1e-7 m/s."""
    case.sub("0/U", r"uniform \(0 0 0\)", "uniform (0 0 0.3)")
    case.edit("constant/transportProperties", nu=1e-6)
    for pattern, to in (("youngsModulus 1e6", "youngsModulus 1e3"), ("kernel .*", "kernel linear;"),
                        (r"bed \{[^}]*\}", "one { type list; material glass; diameter 1e-7; frozen yes; "
                                           "positions ((0.005 0.005 0.02)); }")):
        case.sub(properties, pattern, to)
    case.remove("0.005")
    case.run("demPimpleFoam")
    U = case.field("0.005/U", 1)
    claim("leaning: a uniform flow stays uniform (1e-6)",
          np.linalg.norm(U - [0, 0, 0.3], axis=1).max() < 1e-6*0.3)


for make in (tetrahedra, polyhedra, slivers, thin, leaning):
    case = make(make.__name__)
    still = Case(f"{make.__name__}-rest")
    still.copy(case.path, ".")
    if make is not slivers:
        bed(case)
    rest(still)
    if make is slivers:
        claim("slivers: the smallest cell is a millionth of the largest", smallest(still) < 1.1e-6)
    if make is thin:
        claim("thin: the smallest cell is a thousandth of the largest", smallest(still) < 1.1e-3)
    if make is leaning:
        claim("leaning: non-orthogonality is 80 degrees",
              close(*mesh_numbers(still, r"Mesh non-orthogonality Max: (\S+) "), 80, 1e-3))
        uniform_flow(still)
finish()
