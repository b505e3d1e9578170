"""The start of coupled runs, in a cylinder of 12 mm with a mesh of 16 flat faces around.

- Groups of insert fill the mesh and its zones without touching the walls, with the same digits on two ranks.
- A snapshot made in a smooth cylinder is refused; a scene that is newer than its snapshot is warned of.
- demPimpleFoam -settle makes a snapshot within the walls of the mesh, with the same bits on two ranks; the coupled run
  starts from it at rest, or frozen.
- Numbers of demProperties that macros use are no entries of the scene; gravity has its dimensions.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

scene = "constant/demProperties"
R, radius = 6e-3, 0.5e-3                              # of the edges of the mesh, of the spheres [m]
axes = math.pi/4 + (2*np.arange(16) + 1)*math.pi/16   # directions of the faces, R cos(pi/16) from the axis
face = R*math.cos(math.pi/16)


def cylinder(case):
    """A mesh around the z axis, 20 mm high: a square inside four blocks."""
    corners = [(r*math.cos(a), r*math.sin(a)) for r in (R, R/2) for a in math.pi*(0.25 + 0.5*np.arange(4))]
    quarters = [(k, (k + 1) % 4) for k in range(4)]
    arcs = [f"arc {k + n} {m + n} {vector((R*math.cos(a), R*math.sin(a), z))}" for n, z in ((0, 0), (8, 0.02))
            for (k, m), a in zip(quarters, math.pi*(0.5 + 0.5*np.arange(4)))]
    faces = {"side": [f"({k} {m} {m + 8} {k + 8})" for k, m in quarters],
             "bottom": ["(4 5 6 7)"] + [f"({k + 4} {m + 4} {m} {k})" for k, m in quarters],
             "top": ["(12 13 14 15)"] + [f"({k + 12} {m + 12} {m + 8} {k + 8})" for k, m in quarters]}
    case.mesh([(x, y, z) for z in (0, 0.02) for x, y in corners],
              ["(4 5 6 7 12 13 14 15) (4 4 8)"] + [
                  f"({k + 4} {k} {m} {m + 4} {k + 12} {k + 8} {m + 8} {m + 12}) (3 4 8)" for k, m in quarters],
              {name: f"type {'patch' if name == 'top' else 'wall'}; faces ({' '.join(at)});" for name, at in faces.items()},
              " ".join(arcs))


case = Case()
case.controls(0.002, 0.0005)
cylinder(case)
case.flow("(0 0 0)", '"(side|bottom)" { type noSlip; } top { type pressureInletOutletVelocity; value uniform (0 0 0); }',
          '"(side|bottom)" { type fixedFluxPressure; } top { type fixedValue; value uniform 0; }')
case.gravity()
case.properties("glass { density 2500; youngsModulus 2e5; }", "hertz {} dry { restitution 0.3; } mindlin { friction 0.3; } "
                "gidaspow {} pressureGradient {}", "bed { type random; inside mesh; solidFraction 0.45; diameter 1e-3; }",
                "rho 1.2; kernel diffusion; width 3;")
settle = case.read(scene)
header = settle[:settle.index("materials")]
case.dictionary("system/topoSetDict", """actions (
{ name low; type cellSet; action new; source boxToCell; box (-1 -1 -1) (1 1 0.01); }
{ name lower; type cellZoneSet; action new; source setToCellZone; set low; } );""")
case.run("topoSet")
case.run("decomposePar")


def refuses(what, sentence, *options, ranks=1):
    """demPimpleFoam ends with this sentence and writes no time."""
    case.remove("[0-9]*.[0-9]*", "processor*/[0-9]*.[0-9]*")
    ran = case.run("demPimpleFoam", *options, ranks=ranks, limit=60)
    written = [*case.path.glob("0.002"), *case.path.glob("processor*/0.002")]
    claim(what, ran.status not in (0, 124) and re.search(sentence, ran.log) and not written,
          *ran.log.splitlines()[-12:])


def outwards(positions):
    """The distance from the axis along the normal of the face that is the nearest."""
    return (positions[:, :2] @ [np.cos(axes), np.sin(axes)]).max(1)


# ---- insertion with walls and mesh ------------------------------------------------------------------

# without gravity: after one short step all are at their initial positions
case.edit("system/controlDict", endTime=1e-6, deltaT=1e-6, writeInterval=1e-6)
(case/"constant/g").rename(case/"g")
insertion = """
materials { glass { density 2500; youngsModulus 2e5; } }
effects { hertz {} dry { restitution 0.3; } }
insert
{
    low  { type random; zone lower; solidFraction 0.45; diameter 1e-3; }
    high { type lattice; inside mesh; min (-0.006 -0.006 0.011); max (0.006 0.006 0.03); diameter 1e-3; spacing 1; }
}
coupling { rho 1.2; twoWay no; }
"""
case.write(scene, header + insertion)
claim_runs("groups in the mesh and in a zone: runs", case)
x = case.particles("1e-06", "positions")[:, 1:]
claim_runs("groups in the mesh and in a zone: runs on two ranks", case, ranks=2)
both = np.concatenate([case.particles(f"processor{rank}/1e-06", "positions") for rank in range(2)])
claim("the same digits on two ranks", len(x) > 0 and np.array_equal(both[np.argsort(both[:, 0]), 1:], x))
# first face at 45 + 11.25 degrees; the lattice rests on its first layer at 11.5 mm
z = x[:, 2]
claim("a radius off each face, inside the mesh and the zone",
      outwards(x).max() <= face - radius*(1 - 1e-9) and z.min() >= radius*(1 - 1e-9) and z.max() <= 20e-3
      and not np.any((z > 10e-3) & (z < 11e-3)))
apart = np.linalg.norm(x[:, None] - x, axis=2)[np.triu_indices(len(x), 1)]
claim("no overlaps", apart.min() >= 2*radius*math.sqrt(1 - 1e-9))
# 0.45 of the lower half, 16/2 R^2 sin(2 pi/16) of 10 mm, in spheres of 1 mm
spheres = 0.45*8*R**2*math.sin(math.pi/8)*10e-3/(math.pi/6*1e-9)
claim("the solid fraction is the zone's", (z < 10e-3).sum() == round(spheres), spheres)
# sites of 1 mm, 12 x 12 in the square around, with spheres within the 16 faces; layers from 11.5 to 19.5 mm, as all
# centres above are outside the mesh
sites = np.stack(np.meshgrid(np.arange(12) - 5.5, np.arange(12) - 5.5), -1).reshape(-1, 2)*1e-3
sites = 9*(outwards(sites) <= face - radius).sum()
claim("a lattice without count fills all its sites in the mesh", (z > 11e-3).sum() == sites, sites)


def slip(what, sentence, old, new):
    case.write(scene, header + insertion.replace(old, new))
    refuses(f"{what}: fails and says '{sentence}'", sentence)


slip("a misspelt zone", "lower", "zone lower", "zone lowr")
slip("a misspelt region", "mesh", "inside mesh", "inside meshes")
slip("a zone and the mesh", "keep one", "inside mesh", "zone lower; inside mesh")
slip("more than the lattice holds in the mesh", "lie inside", "spacing 1;", "spacing 1; count 1200;")
slip("the fraction of a part of the mesh", "whose volume is not known",
     "zone lower;", "inside mesh; min (-1 -1 0); max (1 1 0.01);")
slip("a box between the faces and the circle", "off the walls", "zone lower; solidFraction 0.45; diameter 1e-3",
     "inside mesh; min (0.0059 -0.001 0); max (0.0061 0.001 0.002); count 1; diameter 2e-4")
(case/"g").rename(case/"constant/g")

# ---- a snapshot made in other walls -----------------------------------------------------------------

case.edit("system/controlDict", endTime=0.002, deltaT=5e-4, writeInterval=0.002)
case.write("smooth.dem", """
materials { glass { density 2500; youngsModulus 2e5; } }
effects { hertz {} dry { restitution 0.3; } mindlin { friction 0.3; } }
walls { tube { type cylinder; point (0 0 0); axis (0 0 1); radius 0.006; particles inside; } }
insert { one { type list; diameter 1e-3; positions ((0.0030556287 0.0045730829 0.01)); } }
time { end 1e-5; }
write { vtk no; }
""")
case.run("dem", "run", "smooth.dem")
case.write(scene, settle)
case.sub(scene, "^insert .*", 'start { snapshot "smooth/snapshot.dem"; }')
# R (1 - cos(pi/16)) = 0.1153 mm in the middle of a face
overlap = "particle 0 at .* m overlaps wall side by 0.115 of a diameter .* demPimpleFoam -settle"
refuses("from the smooth cylinder: refused with the overlap of 0.115 diameters, the position and the cure", overlap)
refuses("from the smooth cylinder: refused on two ranks", overlap, ranks=2)
case.run("dem", "run", "-set", "walls/tube/radius", "0.005895",
         "-set", "insert/one/positions", "((0.0029972951 0.0044857788 0.01))", "smooth.dem")
claim_runs("from a cylinder that overlaps by 1 %: runs", case)
claim("from the smooth cylinder: a warning", "settled in other walls" in case.log())

# the scene of the snapshot, by its date
newer = "smooth.dem is newer than smooth/snapshot.dem, with whose particles the run begins"
claim("the scene of the snapshot is older: no warning", newer not in " ".join(case.log().split()))
later = time.time() + 3600
os.utime(case/"smooth.dem", (later, later))
case.remove("[0-9]*.[0-9]*")
case.run("demPimpleFoam", "-plan", limit=60)
claim("the scene of the snapshot is newer: the plan warns", newer in " ".join(case.log().split()),
      *case.log().splitlines()[-20:])
claim_runs("the scene of the snapshot is newer: runs", case)
claim("the scene of the snapshot is newer: the run warns", newer in " ".join(case.log().split()))

# ---- a bed at rest in the walls of the mesh ---------------------------------------------------------


def started(start):
    """The scene of the bed with these entries before its insert."""
    case.write(scene, settle)
    case.sub(scene, "^insert", f"{start}\ninsert")


case.write(scene, settle)
claim_runs("-settle ends", case, "demPimpleFoam", "-settle")
claim("-settle ends with a bed at rest", case.found("at rest at t .*settled.dem"))
claim("-settle names the line to add", 'start { snapshot "settled.dem"; }' in case.log())
started('start { snapshot "bed/rest.dem"; }')
refuses("a missing snapshot: the log names the cure",
        "no file .*bed/rest.dem.*start/snapshot.*demPimpleFoam -settle")
(case/"bed").mkdir()
claim_runs("-settle on two ranks writes what start names", case, "demPimpleFoam", "-settle", ranks=2)
claim("the same bits on two ranks", lambda: snapshot_hash(case/"settled.dem") == snapshot_hash(case/"bed/rest.dem"))
claim_runs("the coupled run starts from it", case, ranks=2)
claim("the log reports that insert is for -settle", case.found("not read from insert.*bed"))
# the bed was quiet, 99 % below 1.4e-2 sqrt(g d) = 1.4e-3 m/s; a fall for 2 ms would end with 20e-3
fastest = max(largest(case.field(f"processor{rank}/0.002/lagrangian/particles/U")) for rank in range(2))
claim("particles stay at rest", fastest < 5e-3, f"largest speed {fastest} m/s")
# at equal force the overlap with a wall is less than between spheres
overlaps = case.numbers("overlap of at most (.*) diameters with a wall.* and (.*) between particles")
claim("overlaps with walls are less than between spheres", len(overlaps) == 1 and 0 < overlaps[0, 0] < overlaps[0, 1])

# ---- entries of start besides the snapshot ----------------------------------------------------------

started('start { snapshot "bed/rest.dem"; frozen yes; }\ntime { step 5e-4; }')
case.remove("[0-9]*.[0-9]*")
claim_runs("frozen from its snapshot: runs", case)
flags, velocities = (case.particles("0.002", name)[:, 1:] for name in ("flags", "U"))
claim("all particles are frozen", len(flags) > 0 and np.all(flags == 1) and largest(velocities) == 0)
started('start { snapshot "bed/rest.dem"; temperatur 300; }')
refuses("a misspelt entry beside the snapshot is refused", "temperatur")

# ---- an open patch below the bed --------------------------------------------------------------------

opened = Case("opened", "hydrostatic")
opened.sub("constant/polyMesh/boundary", "(walls\\s*{\\s*type\\s*)wall;", r"\1patch;")
# and a patch without faces, as snappyHexMesh may leave one
opened.sub("constant/polyMesh/boundary", r"^2\n\(", "3\n(\n    none { type patch; nFaces 0; startFace 300; }")
for field in "Up":
    opened.sub(f"0/{field}", r"^boundaryField\n\{", "boundaryField\n{\n    none { type calculated; }")
opened.run("decomposePar")
claim_runs("-settle on two ranks, with a patch without faces", opened, "demPimpleFoam", "-settle", ranks=2)
claim("-settle on two ranks: the patch without faces is no wall",
      not opened.found("open patches are walls .*none") and opened.found("open patches are walls .*walls"))
claim_runs("-settle in open patches", opened, "demPimpleFoam", "-settle")
claim("-settle in open patches: they are walls, says the log",
      opened.found("while particles settle, open patches are walls of neutral: .*walls"))
claim("-settle in open patches: all particles rest in the mesh", opened.found("at rest at t .*settled.dem"))

case.write(scene, settle)
case.sub(scene, "^insert.*", "insert { feed { type stream; rate 1; diameter 1e-3; patch top; } }")
refuses("nothing to settle: fails with a sentence", "no particles to settle", "-settle")

# ---- numbers for macros, and gravity ------------------------------------------------------------------

numbers = Case("numbers", "hydrostatic")
numbers.run("blockMesh")
numbers.sub(scene, "density 1000;", "density $rhop;")
numbers.sub(scene, "^materials", "rhop 1000;\nmaterials")
claim_runs("a number for a macro", numbers, "demPimpleFoam", "-plan")
numbers.sub(scene, r"\$rhop", "1000")
claim_refused("a number that nothing uses", numbers, 'unknown entry "rhop"', "demPimpleFoam", "-plan")
numbers.sub(scene, "^rhop.*", "")
numbers.dictionary("constant/g", "dimensions [0 1 -1 0 0 0 0]; value (0 0 -9.81);", "uniformDimensionedVectorField")
claim_refused("gravity in m/s", numbers, "constant/g has dimensions [0 1 -1 0 0 0 0]; give [0 1 -2 0 0 0 0]",
              "demPimpleFoam", "-plan")
finish()
