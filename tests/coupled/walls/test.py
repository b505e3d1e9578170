"""Moving walls in coupled runs: a patch with a surface velocity and a moving surface file drag grains along.

- A sphere placed on either slides, then rolls at 2/7 of the wall's velocity, on one rank and on two.
- The record contains its weight and the work of the walls.
- The patch wears by Archard's law.
- A missing file, a patch with a motion and misspelt words are refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

PLATE = """solid plate
facet normal 0 0 1 outer loop vertex 2 2 12 vertex 18 2 12 vertex 18 18 12 endloop endfacet
facet normal 0 0 1 outer loop vertex 2 2 12 vertex 18 18 12 vertex 2 18 12 endloop endfacet
endsolid plate
"""

case = Case("walls", "hydrostatic")
case.edit("system/controlDict", endTime=0.02, writeInterval=0.02)
case.edit("system/decomposeParDict", numberOfSubdomains=2)
case.write("constant/triSurface/plate.stl", PLATE)
case.properties("glass { density 2500; youngsModulus 1e6; } steel { density 7800; youngsModulus 1e7; }",
                """gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; }
    mindlin { friction 0.3; }""",
                """grains { type list; material glass; diameter 1e-3;
    positions ((0.006 0.01 0.0005) (0.014 0.01 0.0125)); }""",
                "rho 1; twoWay no; record { interval 0.005; energy yes; }", """walls
{
    walls { material steel; surfaceVelocity (0.05 0 0); wear { coefficient 1e-4; hardness 1e9; } }
    plate { type surface; file "plate.stl"; scale 0.001; material steel;
            motion { type translation; velocity (-0.05 0 0); } }
}""")
good = case.read("constant/demProperties")
case.remove("constant/g")
claim_runs("runs", case)

# ---- velocities, forces and work -------------------------------------------------------------------

U = case.particles("0.02", "U")
# 2/7 of 0.05 m/s; the lever arm is R less the overlap of 0.2 %, and the contact oscillates for a while
claim("a sphere on a patch with a surface velocity rolls at 2/7 of it", close(U[:, 1].max(), 0.05*2/7, 0.01))
claim("a sphere on a moving surface file rolls at 2/7 of its velocity", close(U[:, 1].min(), -0.05*2/7, 0.01))

# m g of a glass sphere of 1 mm; the last of four means, when the bounce has nearly decayed
walls = case.table("postProcessing/dem/0/walls.csv")
weight = dict(zip(walls["wall"], walls["fz"]))
claim("the record has the weight on the patch", close(weight["walls"], -1.28413e-05, 0.01))
claim("the record has the weight on the surface", close(weight["plate"], -1.28413e-05, 0.01))

energy = {name: column[-1] for name, column in case.table("postProcessing/dem/0/energy.csv").items()}
# a wall gives m V (2/7 V), V = 0.05 m/s, to each of two spheres of 1.309e-6 kg
claim("the energy balance has the work of both", close(energy["work_walls"], 1.870e-9, 0.02))
# half of it is dissipated by friction; the initial bounce is in the dashpot and the residual
claim("half of it is dissipated by friction", close(energy["lost_mindlin"], 0.935e-9, 0.05))
claim("the energy balance closes within 1e-3 of that work", abs(energy["residual"]) < 1.87e-12)
claim_tables("the tables", case/"postProcessing/dem/0", "effects", "walls", "energy")

# ---- wear ------------------------------------------------------------------------------------------

WEAR = "postProcessing/dem/0/walls_0.02.vtp"


def worn():
    """Volumes that the triangles have lost [m3], by wall."""
    raw, file = (case/WEAR).read_bytes(), {}
    start = raw.index(b"_", raw.index(b"<AppendedData")) + 1
    for kind, name, offset in re.findall(rb'type="(Float64|Int64)" Name="(points|wall|wear)".* offset="(\d+)"', raw[:start]):
        at = start + int(offset)
        size = int.from_bytes(raw[at:at + 8], "little")
        file[name.decode()] = np.frombuffer(raw[at + 8:at + 8 + size], "<f8" if kind == b"Float64" else "<i8")
    corners = file["points"].reshape(-1, 3, 3)
    areas = 0.5*np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return np.bincount(file["wall"], file["wear"]*areas)


# friction mu reduces the slip v as the impulse J of the normal force grows, dv = -7/2 mu dJ/m, until the sphere
# rolls, so the integral of v dJ is m v^2/(7 mu); the tangential spring takes a little of it
volumes = worn()
claim("the patch wears by k/H times m v^2/(7 mu)", close(volumes.max(), 1e-4/1e9*1.309e-6*0.05**2/(7*0.3), 0.03), volumes)
claim("and nothing else wears", np.count_nonzero(volumes) == 1)
claim("the collection lists it", WEAR.rpartition("/")[2] in case.read("postProcessing/dem/0/walls.pvd"))

# ---- two ranks -------------------------------------------------------------------------------------

(case/"postProcessing/dem/0/energy.csv").rename(case/"energy.one")
case.run("decomposePar")
claim_runs("runs on two ranks", case, ranks=2)
both = np.concatenate([case.field(f"processor{k}/0.02/lagrangian/particles/U").reshape(-1, 3) for k in range(2)])
claim("the same digits on two ranks", np.array_equal(np.sort(both[:, 0]), np.sort(U[:, 1])))
claim("the same wear on two ranks", lambda: np.array_equal(worn(), volumes))
claim("the same digits of the energy balance on two ranks",
      lambda: agrees(case/"postProcessing/dem/0/energy.csv", case/"energy.one"))

# ---- refused ---------------------------------------------------------------------------------------

for what, words, pattern, to in (
        ("a misspelt word of the record", "energi", "energy yes", "energi yes"),
        ("a surface that is not there", "There is no file ... nothing.stl", "plate.stl", "nothing.stl"),
        ("a surface without a file", "without a file", 'file "plate.stl";', ""),
        ("a patch that should move", "Take out motion", r"surfaceVelocity \(0.05 0 0\);",
         "motion { type translation; velocity (1 0 0); }"),
        ("a misspelt word of a surface", "velocty", r"velocity \(-0", "velocty (-0")):
    case.write("constant/demProperties", good)
    case.sub("constant/demProperties", pattern, to)
    claim_refused(f"{what} is refused: '{words}'", case, words, "demPimpleFoam")
finish()
