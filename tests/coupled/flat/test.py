"""Two dimensions: meshes one cell thick between empty patches.

- Spheres stay in the middle plane; momentum and volume are conserved as in three dimensions, in demPimpleFoam and in
  stock pimpleFoam.
- Particles as dense as the fluid stay at rest.
- A fixed bed, upright or inclined, has the pressure drop of the closure.
- A domain that does not fit the mesh is refused.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import gidaspow_gradient, lattice_void

properties = "constant/demProperties"
EFFECTS = "hertz {} dry { restitution 0.9; } gidaspow {} pressureGradient {}"
GLASS = "glass { density 2500; youngsModulus 1e6; }"


class Slab(Case):
    """A case of a slab in x and z, 1.1 mm thick."""

    patches = "slab { type empty; }"

    def slab(self, size, cells, ends, lean=0):
        """Make a mesh of this size [m]; ends {name: ("wall;", "x- x+")} are its other sides; the top is shifted by
        `lean` [m] along x."""
        (x, z), y = size, 1.1e-3
        floor = [(0, 0), (x, 0), (x, y), (0, y)]
        faces = {"x-": "(0 4 7 3)", "x+": "(1 2 6 5)", "z-": "(0 3 2 1)", "z+": "(4 5 6 7)"}
        self.mesh([(a, b, 0) for a, b in floor] + [(a + lean, b, z) for a, b in floor],
                  [f"(0 1 2 3 4 5 6 7) ({cells[0]} 1 {cells[1]})"],
                  {"slab": "type empty; faces ((0 1 5 4) (3 7 6 2));",
                   **{name: f"type {kind} faces ({' '.join(faces[side] for side in sides.split())});"
                      for name, (kind, sides) in ends.items()}})


def stays_in_plane():
    """All particles have one y, and neither velocities across the plane nor spins along it."""
    y = case.field("0.02/lagrangian/particles/positions")[:, 1]
    U, omega = (case.field(f"0.02/lagrangian/particles/{name}") for name in ("U", "omega"))
    return np.ptp(y) == 0 and not U[:, 1].any() and not omega[:, [0, 2]].any()


def keeps_momentum(solver):
    """The total changes by less than 1e-8 of the particles' first momentum."""
    total, particles = (case.vectors(word, "momentum", solver) for word in ("sum", "particles"))
    return (len(total) > 20
            and np.linalg.norm(total - total[0], axis=1).max() < 1e-8*np.linalg.norm(particles[0]))


# ---- momentum: two groups of particles in a periodic plane of liquid -------------------------------

SIDES = {"left": ("cyclic; neighbourPatch right;", "x-"), "right": ("cyclic; neighbourPatch left;", "x+")}
ROUND = {**SIDES, "bottom": ("cyclic; neighbourPatch top;", "z-"), "top": ("cyclic; neighbourPatch bottom;", "z+")}
cyclic = '"(left|right|bottom|top)" { type cyclic; }'
swarm = "type lattice; diameter 8e-4; count 50; spacing 1.2; jitter 0.1;"

case = Slab("momentum")
case.controls(0.02, 0.0005, nu=1e-6)
case.slab((0.012, 0.012), (6, 6), ROUND)
case.flow("(0 0 0)", cyclic, cyclic)
case.properties("glass { density 2500; youngsModulus 1e5; }", EFFECTS + " mindlin { friction 0.3; }", f"""
    up {{ {swarm} min (0 1.5e-4 0); max (0.012 9.5e-4 0.006); velocity (0.05 0 0.1); spin (0 90 0); }}
    down {{ {swarm} min (0 1.5e-4 0.006); max (0.012 9.5e-4 0.012); velocity (0 0 -0.1); }}""", "rho 1000;")
case.sub("system/fvSolution", "nOuterCorrectors 1", "nOuterCorrectors 8")
claim_runs("momentum: runs", case)
claim("momentum: exchange closes", worst(case.log(), "exchange error") < 1e-12)
claim("momentum: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
# 100 spheres of 0.8 mm in 12 x 12 x 1.1 mm
claim("momentum: the mean void fraction counts spheres in the slab",
      close(1 - case.field("0.02/voidFraction").mean(), 100*math.pi/6*8e-4**3/(0.012*0.012*0.0011), 1e-12))
sizes = np.linalg.norm(case.vectors("particles", "momentum"), axis=1)
claim("momentum: the particles lose more than half of their momentum", sizes[-1] < sizes[0]/2)
# linear solvers of 1e-11, as in three dimensions
claim("momentum: the total is kept", keeps_momentum("demPimpleFoam"))
claim("momentum: the particles collide", worst(case.log(), "overlap at most") > 0)
claim("momentum: all stay exactly in the plane", stays_in_plane())

alone = case.particles("0.02", "positions")
case.remove("0.02")
case.run("decomposePar")
case.run("demPimpleFoam", ranks=2)
case.run("reconstructPar", "-latestTime")
# the bound of tests/coupled/ranks
claim("momentum: two ranks agree", lambda: difference(alone, case.particles("0.02", "positions")) < 1e-8)

case.controls(0.02, 0.0005, functions='particles { type demCloud; libs ("libdemCoupling.so"); }')
case.sub("system/fvSchemes", r"div\(alphaPhi,U\)", "div(phi,U)")
claim_runs("momentum: runs in stock pimpleFoam", case, "pimpleFoam")
claim("momentum: exchange closes in pimpleFoam", worst(case.log("pimpleFoam"), "exchange error") < 1e-12)
claim("momentum: the total is kept in pimpleFoam", keeps_momentum("pimpleFoam"))
claim("momentum: all stay exactly in the plane in pimpleFoam", stays_in_plane())

# ---- refused ---------------------------------------------------------------------------------------

good = case.read(properties)


def refused(what, pattern, to, words):
    case.write(properties, good)
    case.sub(properties, pattern, to)
    claim_refused(f"{what} is refused", case, words, "pimpleFoam")


refused("a domain that ends elsewhere", "^materials", "domain { y (0 2e-3); } materials",
        "domain ends at 0 and 0.002 m along y, but the mesh, between its empty patches (slab), at 0 and 0.0011 m")
refused("a particle beside the plane", "^insert {",
        "insert { more { type list; material glass; diameter 2e-4; positions ((6e-3 2e-4 6e-3)); }",
        "particle 0 is at y = 0.0002 m, but the domain is flat there and holds all centres at 0.00055 m")
refused("a period across the slab", "^materials", "domain { periodic (z x y); } materials",
        "domain/periodic lists y, but the mesh has no cyclic patches along it")
refused("a period that is missing", "^materials", "domain { periodic (x); } materials",
        "domain/periodic does not list z, but patch bottom is cyclic along it")
refused("a period of another length", "^materials", "domain { x (0 0.011); } materials",
        "domain ends at 0 and 0.011 m along x, but the mesh, between its cyclic patches (left), at 0 and 0.012 m")
refused("a velocity across the plane", r"velocity \(0 0 -0.1\)", "velocity (0 0.1 0)",
        "moves by 0.1 m/s along y, where the domain is flat")
refused("a stream through the slab", "^insert {", "insert { feed { type stream; rate 1; diameter 2e-4; patch slab; }",
        "insert/feed: patch slab is of type empty, so particles cannot pass it")
case.slab((0.012, 0.012), (6, 6), ROUND, lean=0.002)
refused("a period at a slant", "^materials", "materials",
        "which is not x, y or z, but the particles' domain can only be periodic along these")

# ---- hydrostatic: particles as heavy as the liquid -------------------------------------------------

case = Slab("hydrostatic")
case.controls(0.05, 0.005, nu=1e-6)
case.slab((0.02, 0.02), (10, 10), {"walls": ("wall;", "x- x+ z- z+")})
case.flow("(0 0 0)", "walls { type noSlip; }", "walls { type zeroGradient; }")
case.properties("neutral { density 1000; youngsModulus 1e5; }", EFFECTS, """grains { type random; diameter 1e-3;
    count 150; seed 3; min (0 5e-5 0); max (0.02 1.05e-3 0.02); }""", "rho 1000;")
case.gravity()
claim_runs("hydrostatic: runs", case)
# 1e-8 m/s: the bound of the reference case
claim("hydrostatic: no particle moves", largest(case.field("0.05/lagrangian/particles/U")) < 1e-8)
claim("hydrostatic: no fluid moves", largest(case.field("0.05/U")) < 1e-8)

# ---- a fixed bed, upright and inclined: the lattice of fixedBed, one sphere thick ------------------

ENDS = {"bottom": ("patch;", "z-"), "top": ("patch;", "z+")}
# the sides of the inclined one are periodic, so that it has no corners
for lean, sides, U, p in ((0, {"sides": ("wall;", "x- x+")}, "slip", "zeroGradient"),
                          (0.02, SIDES, "cyclic", "cyclic")):
    name = f"bed, inclined by {lean} m"
    case = Slab(f"bed{lean}")
    case.controls(0.02, 0.001, nu=1.5e-5)
    case.slab((0.011, 0.0396), (5, 18), {**sides, **ENDS}, lean)
    case.flow("(0 0 0.3)", f'"(sides|left|right)" {{ type {U}; }} top {{ type zeroGradient; }} '
              "bottom { type fixedValue; value uniform (0 0 0.3); }",
              f'"(sides|left|right)" {{ type {p}; }} top {{ type fixedValue; value uniform 0; }} '
              "bottom { type zeroGradient; }")
    case.properties(GLASS, EFFECTS, """bed { type lattice; diameter 1e-3; count 200; spacing 1.1; jitter 0;
    frozen yes; min (0 0 0); max (0.011 0.0011 0.022); }""", "rho 1.2;")
    case.sub("system/fvSolution", "nNonOrthogonalCorrectors 0", "nNonOrthogonalCorrectors 4")
    claim_runs(f"{name}: runs", case)
    p, flux = case.field("0.02/p").reshape(18, 5).mean(1), case.field("0.02/voidFraction")*case.field("0.02/U")[:, 2]
    claim(f"{name}: the pressure gradient is the closure's (0.5 %)",
          close(1.2*(p[0] - p[3])/(3*0.0022), gidaspow_gradient(lattice_void), 0.005))
    claim(f"{name}: the first cells carry the flux (1 %)", close(flux[:5].mean(), 0.3, 0.01))
    claim(f"{name}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
finish()
