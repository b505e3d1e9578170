"""cfdem_two_fluids.py -- the fluids of cfdemSolverMultiphase (CFDEMcoupling-PFM) as demInterFoam's.

    prepare(case)       writes transportProperties, alpha and p_rgh of demInterFoam into a copied CfdemCase

cfdemSolverMultiphase lists a dictionary for each fluid in `phases`, a surface tension for each pair in
`sigmas`, and has a field alpha for each fluid. demInterFoam has two fluids and the alpha of the first.
Its field rho follows from the phases, so the case needs no coupling/rho.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from .coupled_case import FIXED_VELOCITY, render
from .foam_dictionary import Dictionary, Entry

PROPERTIES = "constant/transportProperties"
# conditions of U that give the flux through the patch
HOLDS = (*FIXED_VELOCITY, "noSlip", "slip", "movingWallVelocity", "rotatingWallVelocity")


def prepare(case):
    fluids, sigma = read_fluids(case)
    write_fluids(case, fluids, sigma)
    choose_alpha(case, list(fluids))
    fix_pressure(case)


def read_fluids(case):
    """{name: dictionary} of both fluids, and their surface tension [N/m]."""
    d, report = case.read(PROPERTIES), case.report
    tokens = d.list("phases")
    fluids = {str(name): inner for name, inner in zip(tokens, tokens[1:])
              if isinstance(inner, Dictionary)}
    if len(fluids) != 2:
        d.refuse("phases", f"{len(fluids)} fluids; demInterFoam has two")
    for name, inner in fluids.items():
        if inner.positive("rho") and inner.word("transportModel") == "Newtonian":
            inner.positive("nu")
        report.translated(inner.place, f"phases/{name}", f"{PROPERTIES}/{name}")
    pairs = d.list("sigmas")
    for pair, value in zip(pairs, pairs[1:]):
        if isinstance(pair, list) and sorted(map(str, pair)) == sorted(fluids):
            sigma = d.numbers("sigmas", [value], 1, "number")[0]
            d.translated("sigmas", "sigma")
            return fluids, sigma
    d.refuse("sigmas", f"has no surface tension of {' and '.join(fluids)}; add it, 0 for none")


def plain(d):
    """Entries without the names that stand before dimensions: nu nu [0 2 -1 0 0 0 0] 1e-6."""
    bare = Dictionary(d.report, d.place, d.path, d.outer)
    for entry in d.entries:
        value = entry.value
        if isinstance(value, Dictionary):
            value = plain(value)
        elif len(value) > 1 and value[0] == entry.name:
            value = value[1:]
        bare.add(Entry(entry.name, entry.place, value))
    return bare


def write_fluids(case, fluids, sigma):
    lines = [f"phases          ({' '.join(fluids)});", f"sigma           {sigma:.12g};"]
    for name, inner in fluids.items():
        lines += [name, "{", *render(plain(inner), "    "), "}"]
    (case.target/PROPERTIES).rename(case.target/(PROPERTIES + ".original"))
    case.write(PROPERTIES, "\n".join(lines) + "\n")


def choose_alpha(case, names):
    report, first, second = case.report, *names
    if f"alpha.{first}" not in case.fields:
        report.refuse(case.control.place, f"{case.start}/alpha.{first}",
                      "there is no such field: the fraction of the first fluid in phases")
    for patch, inner in case.field(f"alpha.{first}").sub("boundaryField").subs():
        if inner.word("type", "none") == "alphaContactAngle":
            inner.refuse("type", f"of {patch} has the angles of many fluids; write interFoam's "
                         "constantAlphaContactAngle", "alphaContactAngle")
    solvers = case.read("system/fvSolution").sub("solvers")
    if f"alpha.{first}" not in solvers:
        # there all fractions have the settings of `alpha`; later entries replace earlier ones
        case.change("system/fvSolution", "solvers", "{", f"    alpha.{first}", "    {",
                    "        cAlpha 1;", "        nAlphaSubCycles 1;",
                    *render(solvers.sub("alpha"), "        "), "    }", "}")
    for name in (f"alpha.{second}", "alphas"):
        for path in (case.zero/name, case.zero/(name + ".gz")):
            if path.exists():
                path.unlink()
                report.harmless(case.control.place, f"{case.start}/{name}", f"follows from "
                                f"alpha.{first}; setFields warns that it is not there")


def fix_pressure(case):
    """fixedFluxPressure for p_rgh where the velocity is given."""
    velocity, pressure = case.field("U"), case.field("p_rgh")
    changed = False
    for name, inner in pressure.sub("boundaryField").subs():
        kind = inner.word("type", "none")
        if kind in ("zeroGradient", "buoyantPressure") and \
                velocity.sub("boundaryField").sub(name).word("type", "none") in HOLDS:
            case.report.translated(inner.where("type"), f"p_rgh/{name} {kind}",
                                   "fixedFluxPressure, so that layers at rest stay at rest")
            case.fix_flux(inner, pressure)
            changed = True
    if changed:
        case.write_field("p_rgh", pressure, [f"// As CFD/{case.start}/p_rgh, with fixedFluxPressure where the "
                                             "velocity is given."])
