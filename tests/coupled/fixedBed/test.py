"""The pressure drop of a fixed bed.

- It follows the closure at the bed's own void fraction.
- The first cell above the inlet carries the whole flux.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *
from closures import gidaspow_gradient, lattice_void

h = 0.0022                                            # height of a cell [m]

for kernel in ("linear", "diffusion"):
    case = Case(kernel)
    case.sub("constant/demProperties", "kernel .*", f"kernel {kernel};")
    claim_runs(f"{kernel}: runs", case)
    # means over the 25 cells of each of the 18 layers
    p, void, U, gradP = (case.field(f"0.02/{name}").reshape(18, 25, -1).mean(1)[:, -1]
                         for name in ("p", "voidFraction", "U", "gradP"))

    # three cells and more below the surface the void fraction is the lattice's
    claim(f"{kernel}: pressure gradient is the closure's (0.5 %)",
          close(1.2*(p[0] - p[3])/(3*h), gidaspow_gradient(lattice_void), 0.005))
    # gradP is the gradient given to the particles; without gravity it is the dynamic part
    claim(f"{kernel}: the lowest particles have the same pressure gradient as those above (1 %)",
          close(gradP[0], gradP[3], 0.01))
    # e U against the flux: a usual volume-averaged solver loses more than half of it in the first cell
    claim(f"{kernel}: the first cell carries the flux (1 %)", close(void[0]*U[0], 0.3, 0.01))
    claim(f"{kernel}: the second cell carries the flux (2 %)", close(void[1]*U[1], 0.3, 0.02))
    claim(f"{kernel}: frozen particles need no warnings of impacts and open patches",
          not re.search("^WARNINGS", case.log(), re.M))
    claim(f"{kernel}: exchange closes", worst(case.log(), "exchange error") < 1e-12)
    claim(f"{kernel}: volume of the particles is kept", worst(case.log(), "volume error") < 1e-12)
    claim(f"{kernel}: continuity to the solver's tolerance", worst(case.log(), "sum local =") < 1e-8)
    # at the bed's surface the mean drag of particles is not the drag at the mean void fraction: 3 %
    claim(f"{kernel}: pressure drop is the closure's, integrated over the void fraction (3 %)",
          close(-h*gradP.sum(), h*gidaspow_gradient(void).sum(), 0.03))
finish()
