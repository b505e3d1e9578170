"""Scenes drawn at random, many at a time in one program (test_random_scenes.c).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess
HARD = "combinations drawn at random"
TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")


def check(c):
    build = os.path.dirname(os.path.abspath(c.dem))
    program = os.path.join(build, "tests", "stability", "test_random_scenes")
    # those of the program, which mutations changes in a copy
    sources = os.environ.get("DEM_SOURCES") or os.path.join(TOP, "dem")
    made = subprocess.run(["make", "--no-print-directory", "-C", sources, "BUILD=" + build,
                           program], capture_output=True, text=True)
    if made.returncode:
        c.holds("test_random_scenes can be built", False, made.stdout + made.stderr)
        return
    first, count = (1001, 3000) if c.long else (1, 200)
    run = c.command(["mpirun", "-np", "3", program, str(first), str(count), "."])
    seen = re.search(r"scenes (\d+) bad (\d+) ranks (\d+)", run.out)
    for seed in re.findall(r"^# (seed .*)", run.out, re.M)[:10]:
        c.holds(seed + "; test_random_scenes -print SEED prints the scene", False)
    c.equal("%d scenes from seed %d on, finite, restart and 3 ranks with the same bits: bad ones" %
            (count, first), int(seen.group(2)) if seen else run.err, 0)
    for what, worst, limit in re.findall(r"^worst (.*): (\S+) limit (\S+)", run.out, re.M):
        c.below("worst " + what + ", relative", float(worst), float(limit))
