"""fuzz.py FOLDER [NUMBER] -- `dem import` of inputs with exchanged, lost or doubled words ends in a
scene or case that the core reads, or in one sentence with file and line. Prints TAP.

Input N is made from the seed texts (test_liggghts.py, test_cases.py) with the random numbers of N
alone. With NUMBER only this input is read, and its folder stays.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import random
import re
import resource
import shutil
import signal
import sys
import traceback
import warnings
from pathlib import Path

import test_cases
import test_liggghts

import suna
from suna_import import __main__ as importer
from suna_import.liggghts_mesh import write_stl
from suna_import.report import CannotTranslate, Report
from suna_import.units import Units
from tap import claim, finish

WORK = Path(sys.argv[1]).resolve()/"fuzz"
INPUTS = range(1, 20001 if os.environ.get("SUNA_LONG") else 401)
MEMORY = 4 << 30
LONGEST = 120  # s, of one input: an endless loop
EVIL = ("", "0", "-1", "1", "nan", "inf", "-inf", "1e308", "-1e308", "1e-308", "1e999", "0x10", "1_0",
        "1000000000", "99999999999999999999", "-5", "0.5", "1e-9", "x", "all", "NULL", "INF", "EDGE",
        "yes", "no", "on", "off", "${x}", "$x", "${", "$(", "$(1/0)", "$(step)", "v_x", "v_", "&", "#",
        '"', "'", "(", ")", "{", "}", ";", "//", "/*", "[", "]", "..", "/", "/dev/null", "a"*300,
        "\u00b2", "\u00e4", "\0", "SELF", "#include", "$a", "$:", '".*"', '"("', "*", "*1", "1:", ":", "1*")

EVERYTHING = """units si
atom_style granular
boundary p f f
newton off
communicate single vel yes
hard_particles yes
variable a equal 2*3+sqrt(4)
variable b index 1e-6 2e-6
variable name string "grains"
variable k loop 2
region box block -0.02 0.02 -0.02 0.02 -0.02 0.05 units box
region ball sphere 0 0 0.01 0.005 units box
region rod cylinder z 0 0 0.004 0.01 0.03 units box
region hut cone z 0 0 0.002 0.008 0.01 0.04 units box
region leaning prism 0 0.01 0 0.01 0 0.01 0.002 0 0 units box
region two union 2 ball rod
region both intersect 2 ball rod side in
create_box 2 box
neighbor 0.001 bin
fix m1 all property/global youngsModulus peratomtype 5e6 6e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.4
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.8 0.7 0.7 0.6
fix m4 all property/global coefficientFriction peratomtypepair 2 0.5 0.4 0.4 0.3
fix m5 all property/global characteristicVelocity scalar 2
fix m6 all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix m7 all property/global cohesionEnergyDensity peratomtypepair 2 1000 0 0 10
pair_style gran model hertz tangential history rolling_friction cdt cohesion sjkr
pair_coeff * *
timestep ${b}
fix down all gravity 9.81 vector 0 0 -1
fix cad all mesh/surface file plate.stl type 1 scale 0.01 move 0 0 0.01 rotate axis 1 0 0 angle 90
fix belt all mesh/surface/stress file plate.stl type 2 surface_vel 1 0 0 curvature 1e-5
fix drum all mesh/surface file plate.stl type 2 surface_ang_vel origin 0 0 0 axis 0 0 1 omega 3
fix walls all wall/gran model hertz tangential history rolling_friction cdt cohesion sjkr mesh n_meshes 3 meshes cad belt drum
fix z0 all wall/gran model hertz tangential history primitive type 1 zplane -0.02 shear x 0.1
fix z1 all wall/gran model hertz tangential history primitive type 1 zcylinder 0.02 0 0
fix c0 all wall/gran model hertz tangential history primitive type 1 general_cone 0.01 0 0 -0.02 0 0 0 0.02
fix up all move/mesh mesh cad linear 0 0 0.1
fix p1 all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.0005
fix p2 all particletemplate/sphere 15485867 atom_type 2 density constant 2600 radius uniform 0.0004 0.0008
fix pd all particledistribution/discrete 32452843 2 p1 0.5 p2 0.5
fix i1 all insert/pack seed 86028121 distributiontemplate pd vel constant 0 0 -1 insert_every once overlapcheck yes all_in yes particles_in_region 20 region ball
fix i2 all insert/pack seed 86028157 distributiontemplate pd maxattempt 20 insert_every 100 all_in no volumefraction_region 0.05 region rod
fix i3 all insert/rate/region seed 32452867 distributiontemplate pd mass 0.01 massrate 0.1 vel uniform 0 0 -1 0 0 0.1 region rod
fix face all mesh/surface/planar file plate.stl type 1
fix i4 all insert/stream seed 49979687 distributiontemplate pd nparticles INF particlerate 100 vel constant 0 0 -1 insertion_face face extrude_length 0.01
fix out all massflow/mesh mesh face count once vec_side 0 0 -1 delete_atoms yes file out.txt
create_atoms 1 single 0 0 0.04 units box
lattice sc 0.005
create_atoms 2 region ball
set group all diameter 1e-3 density 2500
set region ball property/atom Temp 300
velocity all set 0.1 0 NULL
group some id 1:3 5
group kind type 2
group rest subtract all some
fix push some addforce 0 0 1e-6
fix still kind freeze
fix lead rest move linear 0 0 -0.1
fix thermal all property/global thermalConductivity peratomtype 50 50
fix capacity all property/global thermalCapacity peratomtype 500 500
fix hot all heat/gran initial_temperature 310
fix drag all viscous 1e-6
fix integr all nve/sphere
fix said all print 100 "time $(step)" file said.txt
dump d all custom 100 post/*.txt id x y z
include more
label again
run 100
if "${k} == 2" then "unfix z0" "run 10" else "unfix up"
next k
jump SELF again
run 10 upto
"""
DATA = "data\n\n2 atoms\n1 atom types\n-0.01 0.01 xlo xhi\n-0.01 0.01 ylo yhi\n0 0.05 zlo zhi\n\nAtoms\n\n" \
    "7 1 1e-3 2500 0 0 0.01\n9 1 2e-3 2500 0 0 0.02\n\nVelocities\n\n9 0 0 -1 0 0 5\n"
DUMP = "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\n" \
    "ITEM: ATOMS id type x y z vx vy vz omegax omegay omegaz radius\n" \
    "1 1 0 0 0 0 0 0 0 0 0 0.001\n2 1 0.01 0 0 0 0 0 0 0 0 0.001\n"


# ---- seeds -------------------------------------------------------------------------------------------

def seeds():
    """(what is imported, {file: text}) of each."""
    write_stl(WORK/"plate.stl", [[(-1, -1, -.5), (1, -1, -.5), (0, 2, -.5)]])
    plate = (WORK/"plate.stl").read_text()
    scripts = [test_liggghts.BASE, test_liggghts.ONE, test_liggghts.WARM, EVERYTHING, EVERYTHING,
               test_liggghts.CUP.read_text().replace("${seed}", "32452867")]
    found = [("in.test", {"in.test": script, "plate.stl": plate, "more": "fix e all enforce2d\n"})
             for script in scripts]
    found.append(("in.test", {"in.test": "read_data grains.data\n" + test_liggghts.ONE,
                              "grains.data": DATA}))
    found += [("grains.data", {"grains.data": DATA}), ("dump.txt", {"dump.txt": DUMP})]
    test_cases.WORK = WORK/"cases"
    for make, what in ((test_cases.cfdem_case, "cfdem"), (test_cases.cloud_case, "cloud")):
        make()
        source = test_cases.WORK/"source"
        found += [(".", {str(path.relative_to(source)): path.read_text()
                         for path in sorted(source.rglob("*")) if path.is_file()})]*2
    return found


def mutated(text, words, chance):
    """One to four changes of words or lines."""
    lines = text.split("\n")
    for _ in range(chance.choice((1, 1, 2, 4))):
        k = chance.randrange(len(lines))
        parts = re.split(r"(\s+|[;{}()])", lines[k])
        at = chance.randrange(len(parts))
        change = chance.randrange(9)
        if change == 0:
            parts[at] = ""
        elif change == 1:
            parts.insert(at, chance.choice(EVIL) + " ")
        elif change == 2:
            parts[at] = chance.choice(words)
        elif change == 3:
            parts = parts[:at]
        elif change == 4:
            other = chance.randrange(len(parts))
            parts[at], parts[other] = parts[other], parts[at]
        elif change < 7:
            parts[at] = chance.choice(EVIL)
        lines[k] = "".join(parts)
        if change == 7:
            lines.insert(chance.randrange(len(lines)), lines[k])
        elif change == 8:
            del lines[k]
            lines = lines or [""]
    return "\n".join(lines)[:chance.choice((None, None, None, None, len(text)//2))]


# ---- one input ---------------------------------------------------------------------------------------

def read(path):
    """Imports it; the sentence of a refusal, or nothing."""
    report = Report()
    translate = importer.kind_of(path)
    with importer.sentences(path, report):
        if path.is_dir():
            translate(path, Path("result"), report)
        else:
            files, _ = translate(path, "result.dem", report, [], Units())
            for file in files:
                if file.endswith(".dem"):
                    suna.Simulation(file).close()
    report.table()


def too_long(*_):
    raise TimeoutError(f"not read within {LONGEST} s")


def fault(number, found):
    """What is wrong with input NUMBER: text, or nothing."""
    chance = random.Random(number)
    name, files = chance.choice(found)
    folder = WORK/"input"
    shutil.rmtree(folder, ignore_errors=True)
    target = chance.choice(list(files))
    vocabulary = [word for text in files.values() for word in text.split()]
    for file, text in files.items():
        (folder/file).parent.mkdir(parents=True, exist_ok=True)
        (folder/file).write_text(mutated(text, vocabulary, chance) if file == target else text)
    os.chdir(folder)
    signal.alarm(LONGEST)
    try:
        read(Path(name))
    except CannotTranslate as error:
        first = str(error).splitlines()[0]
        if importer.FAULT in first:
            return f"{target}: {first}\n" + "".join(traceback.format_exception(error.__cause__)[-3:])
        if not re.match(r"[^\n:]+(:\d+)?: ", first):
            return f"{target}: without a file: {first}"
    except Exception:
        return f"{target}: " + traceback.format_exc(limit=-4)
    finally:
        signal.alarm(0)
    return ""


def main():
    signal.signal(signal.SIGALRM, too_long)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    warnings.simplefilter("ignore")
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    found, faults = seeds(), {}
    for number in [int(sys.argv[2])] if len(sys.argv) > 2 else INPUTS:
        text = fault(number, found)
        if text:
            faults.setdefault(text.strip().splitlines()[-1], (number, text))
    claim("each input ends in a scene or in a sentence with file and line", not faults,
          "\n".join(f"input {n}: {text}" for n, text in faults.values()))
    finish()


if __name__ == "__main__":
    main()
