"""A coupled run whose particles' steps are made by an OpenCL device has the bits of the same run on the CPU, on one rank
and on two.

- Two groups of spheres in a liquid box, with gidaspow, pressureGradient and saffmanMei; own wake left out; a floor of
  triangles (the walls of the mesh): snapshot, fields, exchange in the log.
- The device makes nearly all steps: contacts stay there between fluid steps.
- A run that ends by an overlap above its limit leaves the same last good state, whose contacts were on the device.

Skipped without an OpenCL device; pocl is one, on CPUs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

# hwloc shall not bring pocl into MPI; programs of the device are kept here
os.environ.update(HWLOC_COMPONENTS="-opencl", XDG_CACHE_HOME=str(work/"cache"))
(work/"cache").mkdir()
devices = subprocess.run(["dem", "run", "-device", "list"], capture_output=True, text=True).stdout
name = next((line.split("  (")[0] for line in devices.splitlines() if "driver" in line), None)


def box(folder, ranks, *entries):
    """A run in a box of 8 mm with walls, with further entries."""
    case = Case(folder, source="shared")
    case.flow("(0 0 0)", "walls { type noSlip; }", "walls { type fixedFluxPressure; }")
    case.gravity("(1 0 -9.81)")
    case.controls(0.02, 0.001, nu=1e-6)
    case.box((0.008,)*3, (4,)*3, {"walls": ("wall", "x- x+ y- y+ z- z+")})
    case.properties("glass { density 2500; youngsModulus 2e5; poissonsRatio 0.3; }",
                    "hertz {} dry { restitution 0.8; } mindlin { friction 0.4; } gidaspow {} pressureGradient {} "
                    "saffmanMei {}",
                    "bed { type lattice; diameter 8e-4; count 300; spacing 1.2; jitter 0.9; seed 3; "
                    "velocity (0.05 0 -0.1); min (0.0002 0.0002 0.0002); max (0.0078 0.0078 0.0078); }",
                    "rho 1000; kernel diffusion; width 3; ownWake yes; record { interval 0.002; }",
                    "walls { walls { material glass; } }\n" + "\n".join(entries))
    if ranks > 1:
        case.run("decomposePar")
    case.run("demPimpleFoam", ranks=ranks)
    return case


def same_particles(what, cpu, device, part):
    """The last snapshot of both runs has the same fingerprint."""
    last = [case.times(part)[-1] for case in (cpu, device)]
    claim(what, last[0] == last[1] and len({snapshot_hash(case/part/last[0]/"uniform/dem.snapshot")
                                            for case in (cpu, device)}) == 1)


if name is None:
    skip("steps on a device in a coupled run", devices.splitlines()[0] if devices else "no OpenCL")
else:
    for ranks, parts in (1, [""]), (2, ["processor0", "processor1"]):
        on = f", ranks: {ranks}"
        cpu, device = [box(f"{folder}{ranks}", ranks, *entries)
                       for folder, entries in (("cpu", []), ("device", [f'device "{name}";']))]
        claim_ran("the CPU runs" + on, cpu)
        claim_ran("the device runs" + on, device)
        claim("the log names the device" + on, device.found(rf"^Suna: device: {re.escape(name)}"))
        claim("and the device makes steps" + on, device.found(r"^    device +[1-9][0-9.]* %"))
        claim("contacts stay there between fluid steps: the CPU makes few lists" + on,
              int(device.found(r"lists: rebuilt (\d+) times")[1]) <= 10)
        same_particles("same particles" + on, cpu, device, parts[0] or ".")
        for field in ("U", "p", "voidFraction"):
            last = cpu.times(parts[0] or ".")[-1]
            claim(f"same field {field}" + on,
                  all([agrees(cpu/part/last/field, device/part/last/field) for part in parts]))
        claim("same loads on walls" + on,
              agrees(*(next(iter(sorted(c.path.glob("postProcessing/**/walls.csv")))) for c in (cpu, device))))

    # the largest overlap of these runs is 0.03
    limit = "time { maxOverlap 0.025; }"
    cpu, device = box("cpuEnds", 1, limit), box("deviceEnds", 1, limit, f'device "{name}";')
    sentence = r"overlap .* 0\.025[^;]*"
    claim("an overlap above its limit ends the run with the same sentence",
          cpu.found(sentence) and device.found(sentence) and cpu.found(sentence)[0] == device.found(sentence)[0])
    same_particles("the same last good state", cpu, device, ".")
finish()
