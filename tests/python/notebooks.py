"""notebooks.py -- the notebooks run from the first cell to the last, and what they find is right. Prints
TAP.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import sys
import tempfile
from pathlib import Path

import matplotlib

from tap import finish, run_tests

matplotlib.use("Agg")
FOLDER = Path(__file__).resolve().parents[2]/"python"/"notebooks"


def run(name):
    """The names of a notebook after its cells have run."""
    names = {"__name__": name}
    for k, cell in enumerate(json.loads((FOLDER/f"{name}.ipynb").read_text())["cells"]):
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), f"{name}.ipynb, cell {k}", "exec"), names)
    return names


def repose():
    """repose: the resistance that scipy finds gives the slope"""
    found = run("repose")
    assert 0.01 < found["friction"] < 0.4 and abs(found["slope"](found["sim"]) - 22) < 2


def oedometer():
    """oedometer: the plate's work is the area under its force; grains press sideways by less than axially"""
    found = run("oedometer")
    assert found["area"] > 0 and abs(found["work"]/found["area"] - 1) < 0.02, (found["work"], found["area"])
    assert 0.3 < found["ratio"] < 0.8, found["ratio"]


def drum():
    """drum: torque is weight times offset less the gain of angular momentum; power is the work of walls"""
    found = run("drum")
    assert abs(found["torque"]/(found["expected"] - found["gain"]) - 1) < 0.01, found["torque"]
    assert abs(found["power"]/found["supplied"] - 1) < 0.01, (found["power"], found["supplied"])


def triaxial():
    """triaxial: side stresses are held; the strength does not depend on them; a dense packing dilates and softens"""
    found = run("triaxial")
    for pressure, (_, _, volumetric, side) in found["results"].items():
        assert abs(side[len(side)//4:].mean()/pressure - 1) < 0.01, (pressure, side)
        assert volumetric[-1] > 0.02, volumetric
    peak, residual = found["peak"], found["residual"]
    assert abs(peak[1] - peak[0]) < 2 and abs(residual[1] - residual[0]) < 2, (peak, residual)
    assert min(peak) > max(residual) + 2 and 18 < residual[0] < 26, (peak, residual)


if __name__ == "__main__":
    os.chdir(tempfile.mkdtemp(dir=sys.argv[1]))
    run_tests(repose, oedometer, drum, triaxial)
    finish()
