"""report.py -- what became of each line of the input: translated, approximated, without effect on
the answer, output that is lost, or refused.

A translator calls one method for each line that it reads, so nothing is left out in silence:

    report = Report()
    place = Place("in.chute", 12)
    report.translated(place, "fix gravity", "effects/gravity")
    report.approximated(place, "viscous", "restitution falls with St; 0.68 for 0.69 at St 100")
    report.harmless(place, "neighbor", "lists tune themselves")
    report.refuse(place, "atom_style ellipsoid", "no ellipsoids")   # raises CannotTranslate

`refuse` raises. A translator that reads on to find the other faults, too, reads each line in a
block `with collected():` and calls `raise_refused` at the end.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import csv
import textwrap
from typing import NamedTuple

from suna.command import Refused

WIDTH = 100     # characters of a line


class Place(NamedTuple):
    """A line of an input file; line 0: the file as a whole, or a file that is not text."""
    file: str
    line: int = 0

    def __str__(self):
        return f"{self.file}:{self.line}" if self.line else self.file


class CannotTranslate(Refused):
    """The sentence: file, line, word, what Suna lacks or what to write instead."""


@contextlib.contextmanager
def collected():
    """Refusals in this block are in the report; the block ends there, what follows goes on."""
    try:
        yield
    except CannotTranslate:
        pass


class Row(NamedTuple):
    place: Place
    word: str
    kind: str           # one of KINDS
    text: str


TRANSLATED, APPROXIMATED, LOST, HARMLESS, REFUSED = KINDS = (
    "translated", "approximated", "lost output", "no effect", "refused")


class Report:
    def __init__(self):
        self.rows, self._known = [], set()
        self.at = None          # Place of the input that is being read

    # ---- one line of the input -------------------------------------------------------------------

    def translated(self, place, word, text=""):
        """The same in Suna; `text` is what it has become."""
        self._add(place, word, TRANSLATED, text)

    def approximated(self, place, word, text):
        """Something near to it; `text` is what acts instead, and by how much the answer changes."""
        self._add(place, word, APPROXIMATED, text)

    def lost(self, place, word, text):
        """Output that the script writes and Suna does not; `text` is what, and what to use."""
        self._add(place, word, LOST, text)

    def harmless(self, place, word, text=""):
        """Not translated, without effect on the answer: numerical lists, messages, output that Suna
        writes in its own way."""
        self._add(place, word, HARMLESS, text)

    def refuse(self, place, word, text):
        """Raises. `text`: what Suna lacks, or what to write instead."""
        self._add(place, word, REFUSED, text)
        raise CannotTranslate(sentence(Row(place, word, REFUSED, text)))

    def _add(self, place, word, kind, text):
        row = Row(place, word, kind, text)
        if row not in self._known:      # a line of a loop is read many times
            self._known.add(row)
            self.rows.append(row)

    # ---- the whole -------------------------------------------------------------------------------

    def of(self, kind):
        return [row for row in self.rows if row.kind == kind]

    def raise_refused(self):
        """Raises one error with the sentences of all refused lines, if there are any."""
        refused = self.of(REFUSED)
        if refused:
            raise CannotTranslate("\n".join(sentence(row) for row in refused))

    def counts(self):
        return ", ".join(f"{len(self.of(kind))} {kind}" for kind in KINDS if self.of(kind)) or \
            "nothing was read"

    def comment(self):
        """What differs, is lost or has no effect, as comment lines for the head of the result."""
        lines = []
        for kind, title in ((APPROXIMATED, "Approximated, with the effect on the answer:"),
                            (LOST, "Output of the source that is not written:"),
                            (HARMLESS, "Not translated, without effect on the answer:")):
            rows = self.of(kind)
            if rows:
                lines += ["//", f"// {title}"]
            for row in rows:
                lines += wrap(f"{row.place} {row.word}" + (f": {row.text}" if row.text else ""),
                              "//   ", "//       ")
        return lines

    def table(self):
        """All lines, for the terminal."""
        place = max([len(str(row.place)) for row in self.rows], default=0)
        word = min(30, max([len(row.word) for row in self.rows], default=0))
        lines = []
        for row in self.rows:
            head = f"{str(row.place):{place}}  {row.kind:12}  {row.word:{word}}"
            lines += wrap(f"{head}  {row.text}".rstrip(), "", " "*(place + 16))
        return "\n".join([*lines, self.counts()])

    def write_csv(self, path):
        with open(path, "w", newline="") as file:
            out = csv.writer(file)
            out.writerow(("file", "line", "word", "kind", "text"))
            out.writerows((row.place.file, row.place.line, row.word, row.kind, row.text)
                          for row in self.rows)


def sentence(row):
    return f"{row.place}: {row.word}: {row.text}"


def wrap(text, first, rest):
    # a space in a word of the input is kept
    return textwrap.wrap(text, WIDTH, initial_indent=first, subsequent_indent=rest,
                         break_long_words=False, break_on_hyphens=False,
                         replace_whitespace=False, drop_whitespace=True) or [first.rstrip()]
