"""Particles along warped wall faces, as snappyHexMesh makes them, are found in the mesh.

- The particles' wall triangles and the fluid's cells differ by the thickness of a warped face. Points lie along every
  wall triangle, 10 nm inside.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from wall_points import read, wall_points

names = {"sphere": "a sphere in a box", "cyclone": "a cyclone", "flange": "a flange"}


def make(name, geometry, inside, box=((-1, -1, -1), (1, 1, 1)), cells="(7 7 7)"):
    """A case with a snappyHexMesh of this geometry in a box of cells."""
    case = Case(name)
    case.write("system/geometry", f"body {{ {geometry} }}\n")
    case.write("system/inside", f"inside {inside};\n")
    case.controls(2e-6, 1e-6, functions='particles { type demCloud; libs ("libdemCoupling.so"); }')
    case.flow("(0 0 0)", '".*" { type fixedValue; value uniform (0 0 0); }', '".*" { type zeroGradient; }')
    case.properties("glass { density 2500; youngsModulus 1e6; }", "stokesDrag {}",
                    'along { type table; file "points.csv"; diameter 1e-9; }', "twoWay no; rho 1; kernel linear;",
                    "time { step 1e-6; }")
    surface = Path(os.environ.get("FOAM_TUTORIALS", ""))/f"resources/geometry/{name}.stl.gz"
    if surface.exists():
        case.copy(surface, f"constant/triSurface/{surface.name}")
    (x0, y0, z0), (x1, y1, z1) = box
    made = case.mesh([(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))],
                     [f"(0 1 2 3 4 5 6 7) {cells}"],
                     {"walls": "type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4) (3 7 6 2) (0 3 2 1) (4 5 6 7));"})
    claim(f"{names[name]}: the mesh", made and case.run("snappyHexMesh", "-overwrite")
          and case.run("surfaceMeshExtract", "walls.obj"))
    return case


def find(case):
    """All points are found, on one rank and on two."""
    name = names[case.path.name]
    triangles = read(case/"walls.obj")
    points = wall_points(triangles, 1e-8)
    print(f"# {name}: {len(points)} points, {len(triangles)} triangles")
    np.savetxt(case/"points.csv", points, fmt="%.17g", delimiter=",", header="x,y,z", comments="")
    claim_runs(f"{name}: points along every wall triangle are in the mesh", case, "icoFoam")
    claim(f"{name}: all particles are written",
          lambda: len(case.field("2e-06/lagrangian/particles/id")) == len(points) > 10000)
    case.run("decomposePar")
    claim_runs(f"{name}: on two ranks too", case, "icoFoam", ranks=2)


find(make("sphere", "type searchableSphere; centre (0.05 0.02 -0.03); radius 0.55;", "(0.8 0.8 0.8)"))
find(make("flange", 'type triSurfaceMesh; file "flange.stl"; scale 0.001;', "(-0.009 0.0001 0.0001)",
          ((-0.03, -0.03, -0.03), (0.03, 0.03, 0.01)), "(20 16 12)"))
if thorough:
    find(make("cyclone", 'type triSurfaceMesh; file "cyclone.stl";', "(0.001 0.001 0.001)",
              ((-0.55, -0.55, -1), (0.55, 0.55, 1.1)), "(12 12 23)"))
finish()
