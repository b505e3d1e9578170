"""coupled.py -- read what a coupled case has written: particles of its last time, its record, its
tables.

    python3 coupled.py CASE

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import numpy

import suna


def main(case):
    time, folder = suna.times(case)[-1]
    cloud = suna.read_cloud(folder)
    kinetic = 0.5*(cloud["mass"]*(cloud["U"]**2).sum(axis=1)).sum()
    print(f"{time} s: {len(cloud['id'])} particles, kinetic energy of translation {kinetic:.6g} J")

    last, beads = None, None
    for last, beads in suna.read_record(f"{case}/postProcessing/dem/0/particles.bin"):
        pass
    print(f"last instant of the record: {last:g} s, {len(beads)} particles")

    for name, table in suna.tables(case).items():
        print(f"{name}.csv: {len(table)} rows of {', '.join(table.columns[:5])} ...; effects "
              f"{' '.join(table.attrs['effects'])}")

    # the record has single precision
    order, other = numpy.argsort(cloud["id"]), numpy.argsort(beads["id"])
    assert abs(last - time) < 1e-9
    assert numpy.allclose(cloud["positions"][order], beads["position"][other], rtol=1e-6, atol=1e-9)


if __name__ == "__main__":
    main(sys.argv[1])
