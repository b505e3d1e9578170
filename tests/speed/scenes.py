"""scenes.py -- the beds that speed.py measures, and the runs of Suna.

A scene is a bed at rest, settled once and kept in beds/, repeated along x, with a random velocity
added. Every code starts from the same text, one particle a line: id, diameter, position, velocity,
spin.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
BEDS = os.path.join(HERE, "beds")

# contact law; width along x and y [m], copies along x; random speed added [m/s]; step [s], steps;
# mean diameter [m]. Exceptions: `bed`, the scene that settles it (default: the law's).
# `spheres` and `height`: of a bed other than the scene's. `classes`: diameters at which
# another class of size begins, for searches with classes. `young`: stiffness other than 5e6 Pa.
# `mesh`: file of triangles that the scene reads where it runs.
EQUAL = dict(law="equal", width=0.025, copies=1, speed=0.0, step=2e-6, steps=2000, mean=1e-3)
SMALL = dict(EQUAL, width=0.01, speed=0.5, steps=500, spheres=500, height=0.006)
SIZES = dict(law="sizes", width=0.04, copies=5, speed=0.0, step=2e-6, steps=600, mean=1.6e-3,
             classes=(2e-3,))
RATIO = dict(law="ratio", width=0.016, copies=5, speed=0.0, step=3e-7, steps=300, mean=0.38e-3,
             classes=(0.4e-3, 0.8e-3, 1.6e-3), young=3e7)
SCENES = {
    "settled20k": EQUAL,
    "settled100k": dict(EQUAL, copies=5, steps=400),
    "settled300k": dict(EQUAL, copies=15, steps=200),
    "agitated20k": dict(EQUAL, speed=0.7),
    "sizes50k": SIZES,
    "ratio100k": RATIO,
    "agitatedRatio100k": dict(RATIO, speed=0.7, steps=1000),
    "bonded20k": dict(EQUAL, law="bonded", bed="equal", speed=0.02),
    "hysteresis20k": dict(EQUAL, law="hysteresis"),
    "rolling20k": dict(EQUAL, law="rolling", bed="equal"),
    "hopper50k": dict(EQUAL, law="hopper", width=0.08, steps=800, mesh="hopper.stl"),
    "small": SMALL,
    "smallRest": dict(SMALL, speed=0.0, steps=100),
    "smallSizes": dict(SMALL, law="sizes", width=0.02, spheres=500, height=0.009, mean=1.6e-3,
                       classes=(2e-3,)),
    "smallBonded": dict(SMALL, law="bonded", bed="equal", speed=0.02),
    "smallHysteresis": dict(SMALL, law="hysteresis"),
    "smallRolling": dict(SMALL, law="rolling", bed="equal"),
}
FULL = [name for name in SCENES if not name.startswith("small")]


def spent(bed, command, folder, log):
    """Processor time [s] and peak memory [bytes] of a command; ends the benchmark when it fails."""
    path = os.path.join(folder, log)
    with open(path, "w") as out:
        status = subprocess.run([bed, "spend"] + command, cwd=folder, stdout=out,
                                stderr=subprocess.STDOUT).returncode
    if status:
        sys.exit(f"speed: {' '.join(command)} failed; see {path}")
    with open(path) as text:
        return [float(word) for word in text.read().splitlines()[-1].split()[1:]]


def write_hopper(path):
    """The frustum of hopper.dem, 64 triangles in STL. Returns the path."""
    def corner(radius, z, k):
        angle = math.pi*k/16
        return f"{0.04 + radius*math.cos(angle):.7g} {0.04 + radius*math.sin(angle):.7g} {z}"

    with open(path, "w") as file:
        file.write("solid hopper\n")
        for k in range(32):
            low, next_low = corner(0.01, 0, k), corner(0.01, 0, k + 1)
            high, next_high = corner(0.028, 0.06, k), corner(0.028, 0.06, k + 1)
            for triangle in (low, high, next_low), (next_low, high, next_high):
                file.write("facet normal 0 0 0\n outer loop\n" + "".join(f"  vertex {x}\n" for x in triangle)
                           + " endloop\nendfacet\n")
        file.write("endsolid hopper\n")
    return path


def file_of(law):
    return os.path.join(HERE, law + ".dem")


def box(scene):
    """Entries of the domain's sides."""
    return [("domain/x", f"(0 {scene['copies']*scene['width']!r})"),
            ("domain/y", f"(0 {scene['width']!r})")]


def folder_of(scene):
    """Where the bed settled, with the mesh that its scene reads."""
    return os.path.join(BEDS, f"{scene.get('bed', scene['law'])}{scene.get('spheres', '')}")


def settled(dem, bed, scene):
    """The snapshot of a bed at rest, made if missing."""
    name, folder = scene.get("bed", scene["law"]), folder_of(scene)
    snapshot = os.path.join(folder, "settled", "snapshot.dem")
    if not os.path.exists(os.path.join(folder, "done")):
        os.makedirs(folder, exist_ok=True)
        if "mesh" in scene:
            write_hopper(os.path.join(folder, scene["mesh"]))
        print(f"# settling {name} (once)", flush=True)
        other = []
        if "spheres" in scene:
            for entry, value in box(scene) + [("insert/bed/count", str(scene["spheres"])),
                                              ("insert/bed/max", f"({scene['width']!r} {scene['width']!r} {scene['height']!r})")]:
                other += ["-set", entry, value]
        spent(bed, [dem, "run"] + other + [file_of("settle" + name.capitalize())], folder,
              "log.settle")
        open(os.path.join(folder, "done"), "w").close()
    return snapshot


def print_state(dem, bed, scene, path):
    """Write the text of a scene's bed."""
    snapshot = settled(dem, bed, scene)
    command = [bed, "state", file_of(scene.get("bed", scene["law"])), snapshot, str(scene["copies"]),
               repr(scene["width"]), repr(scene["speed"])]
    with open(path, "w") as out:
        return subprocess.run(command, stdout=out, stderr=subprocess.PIPE, text=True, cwd=folder_of(scene))


def state(dem, bed, name, scene):
    """The text of particles that a scene starts from, and the particles."""
    path = os.path.join(BEDS, name + ".txt")
    if not os.path.exists(path):
        # of two that make it at a time the later one wins
        part = f"{path}.{os.getpid()}"
        result = print_state(dem, bed, scene, part)
        if result.returncode and "version" in result.stderr:  # a snapshot of an older Suna: settle anew
            shutil.rmtree(folder_of(scene))
            result = print_state(dem, bed, scene, part)
        if result.returncode:
            sys.exit(result.stderr.rstrip())
        os.rename(part, path)
    with open(path) as text:
        return path, [line.split() for line in text]


def suna(bed, scene, path, steps, end=None):
    """Processor time, bytes, kinetic energy, contacts, rebuilds, prunes, bonds; `end`: file of the
    final positions."""
    command = [bed, "run", file_of(scene["law"]), path, repr(scene["step"]), str(steps), end or "-"]
    result = subprocess.run(command + [word for entry in box(scene)
                                     for word in entry], capture_output=True, text=True, cwd=folder_of(scene))
    if result.returncode:
        sys.exit(result.stderr.rstrip())
    return [float(word) for word in result.stdout.split()]
