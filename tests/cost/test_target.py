"""test_target.py -- `dem cost -target` finds steps within the target for six scenes. Prints TAP.

The kinetic energy has a closed form that the search does not use, or uses as one quantity of
several. The chosen scene is run, and its mean kinetic energy of translation over the samples of the
search is compared with the closed form. dem run prints whether the target is met.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
import sys
from functools import partial
from math import cos, exp, pi, sin, sqrt
from pathlib import Path

import numpy

import suna
from tap import finish, run_tests

DEM, FOLDER = os.environ["DEM"], Path(sys.argv[1])/"target"
R, DENSITY, G = 5e-4, 2500.0, 9.81
M = DENSITY*4/3*pi*R**3
BALL = f"materials {{ ball {{ density {DENSITY}; youngsModulus 1e7; }} }}\n"
PLATE = "walls { plate { type plane; point (0 0 0); normal (0 0 1); } }\n"


def one(height, velocity):
    return (f"insert {{ one {{ type list; diameter {2*R}; positions ((0 0 {height:.15g})); velocities "
            f"(({velocity})); }} }}\n")


def pair(speed):
    return (f"insert {{ two {{ type list; diameter {2*R}; positions ((0 0 0) ({2.002*R:.9g} 0 0)); "
            f"velocities (({speed} 0 0) (-{speed} 0 0)); }} }}\n")


def damped():
    e = 0.8
    return (BALL + "effects { hertz {} dry { restitution 0.8; } }\n" + pair(0.5)
            + "time { end 3e-4; }\n", lambda t: M*(0.5*e)**2)


def oil():
    v, mu = 0.5, 0.001
    e = 0.97*exp(-35/(M*v/(6*pi*mu*R**2)))
    return (BALL + f"effects {{ hertz {{}} stokesDamping {{ restitution 0.97; viscosity {mu}; }} }}\n" + PLATE
            + one(1.01*R, f"0 0 -{v}") + "time { end 2e-4; }\n", lambda t: 0.5*M*(e*v)**2)


def impact():
    k, v = 1000.0, 0.5
    omega = sqrt(k/M)
    return (BALL + f"effects {{ hooke {{ stiffness {k}; }} }}\n" + PLATE + one(R, f"0 0 -{v}")
            + f"time {{ end {2.5/omega:.9g}; }}\n", lambda t: 0.5*M*(v*cos(omega*t))**2)


def weight():
    k = 10.0
    omega = sqrt(k/M)
    return (BALL + f"effects {{ gravity {{ acceleration (0 0 -{G}); }} hooke {{ stiffness {k}; }} }}\n"
            + PLATE + one(R, "0 0 0") + f"time {{ end {7/omega:.9g}; }}\n",
            lambda t: 0.5*M*(G/omega*sin(omega*t))**2)


def sliding():
    k, v, mu = 1000.0, 0.1, 0.3     # slips for 2 v/(7 mu G) = 9.7 ms
    return (BALL + f"effects {{ gravity {{ acceleration (0 0 -{G}); }} hooke {{ stiffness {k}; }} mindlin "
            f"{{ friction {mu}; }} }}\n" + PLATE + one(R - M*G/k, f"{v} 0 0")
            + "time { end 0.008; }\n", lambda t: 0.5*M*(v - mu*G*t)**2)


def settling():
    mu, rho = 0.1, 1000.0
    tau = M/(6*pi*mu*R)
    end = G*tau
    return (BALL + f"fluid {{ density {rho}; viscosity {mu}; }}\n"
            f"effects {{ gravity {{ acceleration (0 0 -{G}); }} stokesDrag {{}} }}\n"
            + one(0.0, "0 0 0") + f"time {{ end {3*tau:.9g}; step {tau/5:.9g}; }}\n",
            lambda t: 0.5*M*(end*(1 - exp(-t/tau)))**2)


# oil: at 1 % the phase of the first contact step still shows, which the estimate cannot see
CASES = {damped: 1e-3, oil: 1e-3, impact: 1e-4, weight: 1e-3, sliding: 0.01,
         settling: 0.01}


def call(*words, **environment):
    done = subprocess.run([DEM, *words], cwd=FOLDER, text=True, capture_output=True,
                          env={**os.environ, **environment})
    assert done.returncode == 0, done.stderr + done.stdout
    return done.stdout


def check(case, target):
    scene, kinetic = case()
    name = case.__name__
    (FOLDER/f"{name}.dem").write_text(scene)
    text = call("cost", "-series", "step", "-runs", "3", "-steps", "1,0.5,0.25", "-target", str(target),
                f"{name}.dem")
    samples = int(re.search(r"(\d+) samples?$", text, re.M)[1])
    window = float(re.search(r"a window of (\S+) s", text)[1])
    found = call("run", "-set", "write/vtk", "no", f"{name}.accurate.dem")
    met = re.search(r"^accuracy: target .*, (met|NOT met): (\w+), .* within (\S+) %", found, re.M)
    assert met and met[1] == "met", text + found
    sim = suna.Simulation(str(FOLDER/f"{name}.accurate.dem"))
    end = float(sim.value("time/end"))
    assert window > 0.999*end, f"a window of {window} s"
    values = []
    for _ in range(samples):
        sim.advance(end/samples)
        values.append(sim.totals["kinetic"] - 0.2*(M*R**2*(sim.spin**2).sum()))
    exact = numpy.mean([kinetic(end*(k + 1)/samples) for k in range(samples)])
    error = abs(numpy.mean(values)/exact - 1)
    print(f"# {name}: error {100*error:.3g} %, found to be within {met[3]} %, target "
          f"{100*target:g} %, step {sim.step[0]:.3g} s")
    assert error <= target, f"error {error}, target {target}"


def wish():
    """a target in the scene: the search, then the run in one command"""
    scene, _ = damped()
    (FOLDER/"wish.dem").write_text(scene + "accuracy { target 0.002; }\nwrite { vtk no; }\n")
    # the program is not on PATH
    text = call("run", "wish.dem", PATH="/usr/bin:/bin")
    assert "searching the step" in text and re.search("^accuracy: target 0.2 %, met", text, re.M), text
    assert re.search("^hash", text, re.M)
    assert not (FOLDER/"wish.accurate.dem").exists()


def longer():
    """a longer step than the search found: not met"""
    text = call("run", "-set", "time/step", "1e-5", "-set", "time/force", "yes", "damped.accurate.dem")
    assert re.search("^accuracy: target 0.1 %, NOT met: the step is 1e-05 s", text, re.M), text


def short():
    """a budget that is too small: not reached, and the copy says so"""
    text = call("cost", "-series", "step", "-budget", "0.1", "-target", "1e-9", "weight.dem")
    assert re.search("^target 1e-09 is not reached: half the finest step would take", text, re.M), text
    assert "// the target is not reached" in (FOLDER/"weight.accurate.dem").read_text()
    assert "NOT met" in call("run", "-set", "write/vtk", "no", "weight.accurate.dem")


def refused():
    """targets that are none"""
    for entry, words in (("target 2", "accuracy/target 2; give a relative error"),
                         ("target 0.01; budget 0", "accuracy/budget 0 s; give 0.1 s or more"),
                         ("target 0.01; reached 0; window 0; of kinetic; step 1e-6",
                          "accuracy has reached 0, window 0 s")):
        (FOLDER/"bad.dem").write_text(damped()[0] + f"accuracy {{ {entry}; }}\n")
        done = subprocess.run([DEM, "run", "bad.dem"], cwd=FOLDER, text=True, capture_output=True)
        assert done.returncode != 0 and re.search(words, done.stderr), done.stderr


def main():
    FOLDER.mkdir(parents=True)
    for case, target in CASES.items():
        test = partial(check, case, target)
        test.__doc__ = f"{case.__name__}: the chosen step is within the target of the closed form"
        run_tests(test)
    run_tests(wish, longer, short, refused)
    finish()


main()
