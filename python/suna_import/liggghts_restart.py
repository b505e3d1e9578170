"""liggghts_restart.py -- a script of LIGGGHTS that reads a restart file goes on from the script
beside it that writes this file. The file itself is binary and is not read.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import copy


class Restart:
    """Commands of a Translation (liggghts.py)."""

    def do_read_restart(self, words):
        name = words[0].split("/")[-1]
        for script in sorted(self.path.parent.iterdir()):
            if script.is_file() and script.resolve() not in self.seen and \
                    script.resolve() != self.path.resolve() and writes_restart(script, name):
                report = type(self.report)()
                self.before = type(self)(script, report, self.given,
                                         (*self.seen, self.path.resolve())).read()
                self.report.rows += [row for row in report.rows if row not in self.report.rows]
                self.take_over(self.before)
                self.translated(
                    f"the particles at the end of {script.name}, which writes this file")
                return
        self.refuse("restart files of LIGGGHTS cannot be read, and no script in the folder writes "
                    "this one: put the script that does beside it, or read_data a data file",
                    f"read_restart {words[0]}")

    def take_over(self, other):
        """Continue from the end of another script: particles, box, time."""
        for name in ("box", "time", "steps", "particles", "insertions", "groups", "unknown", "templates",
                     "distributions", "names"):
            setattr(self, name, copy.copy(getattr(other, name)))
        self.restarted, self.fresh = other, False
        for insertion in self.insertions:
            insertion.end = min(insertion.end, self.time)

    def do_write_restart(self, words):
        self.harmless("write/snapshot")

    do_restart = do_write_restart


def writes_restart(script, name):
    """A script with `write_restart` of a file of this name. liggghts.restartCFDEM is written by the
    coupled run of a script (writeLiggghts of CFDEMcoupling)."""
    try:
        rows = [line.split() for line in script.read_text(errors="replace").splitlines()]
    except OSError:
        return False
    if "restartCFDEM" in name:
        return any(row[3:4] == ["couple/cfd"] for row in rows) and \
            not any("restartCFDEM" in word for row in rows for word in row)
    return any(row[0] == "write_restart" and row[1].split("/")[-1] == name
               for row in rows if len(row) > 1)
