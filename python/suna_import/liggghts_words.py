"""liggghts_words.py -- the words of a command of LIGGGHTS: each read is checked, so a command that
ends too early, or a word that is no number, is an error of the input with its sentence.

    words = Words(["gravi", "all", "gravity", "9.81"])
    words[3], words.number(3), words.pop(), words[:2]     BadWords where there are too few
    words.get(7)                                          the word or "", without an error

`liggghts.py` and `liggghts_script.py` add file, line and command to the sentence.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
MOST = 10**15           # of a whole number


class BadWords(Exception):
    """What is wrong with the words of a command: the sentence."""


class Words(list):
    """Words of a command, read as a list is."""

    def _missing(self):
        return BadWords(f'words are missing after "{self[-1]}"' if self else
                        "words are missing at its end")

    def __getitem__(self, k):
        """Slices with an end are complete, or an error."""
        if isinstance(k, slice):
            if k.stop is not None and k.stop > len(self):
                raise self._missing()
            return Words(super().__getitem__(k))
        if not -len(self) <= k < len(self):
            raise self._missing()
        return super().__getitem__(k)

    def get(self, k):
        return super().__getitem__(k) if k < len(self) else ""

    def pop(self, k=0):
        if not self:
            raise self._missing()
        return super().pop(k)

    def after(self, word):
        """Place of the word behind this one."""
        if word not in self:
            raise BadWords(f"{word} is missing")
        return self.index(word) + 1


def as_number(word, what="number"):
    """A finite number as LIGGGHTS writes it."""
    if not NUMBER.fullmatch(word) or not math.isfinite(float(word)):
        raise BadWords(f'"{word}" is no {what}')
    return float(word)


def written(value, digits=15):
    """A value as LIGGGHTS writes it in place of ${name}: 0.15456/1e-5 is 15456, not 15455.999999999998.
    $(...) has 20 digits, so it stays below 15456."""
    return f"{value:.{digits}g}"


def as_whole(word, low=0, high=MOST):
    value = as_number(word, "whole number")
    if value != int(value) or not low <= value <= high:
        raise BadWords(f'"{word}" is no whole number from {low} to {high}')
    return int(value)
