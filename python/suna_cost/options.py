"""options.py -- values of options: numbers, levels, lists.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os

from suna.command import Refused, unknown


def number(name, text, low, high, default):
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not low <= value <= high:
        raise Refused(f"{name} {text}; give a number from {low:g} to {high:g}")
    return value


def whole(name, text, low, high, default):
    value = number(name, text, low, high, default)
    if value != int(value):
        raise Refused(f"{name} {value:g}; give a whole number")
    return int(value)


def fraction(name, text, default):
    """A number from 1e-12 to 1, or a percentage as in 1%."""
    if text and text.endswith("%"):
        return number(name, text[:-1], 1e-10, 100.0, None)/100
    return number(name, text, 1e-12, 1.0, default)


def levels(name, text, default, what="scene"):
    """Numbers separated by commas, 1 among them; the largest, which is the coarsest, first."""
    given = text or default
    try:
        found = sorted((float(x) for x in given.split(",")), reverse=True)
    except ValueError:
        found = [math.nan]
    if not all(1e-6 <= x <= 1e6 for x in found):
        raise Refused(f"{name} {given}; give numbers from 1e-6 to 1e6 separated by commas, as in "
                      f"{default}")
    for a, b in zip(found, found[1:]):
        if a == b:
            raise Refused(f"{name} {given} has {a:g} twice; give each level once")
    if len(found) < 3 or 1.0 not in found:
        raise Refused(f"{name} {given}; give three levels or more, 1 (the {what} as it is) among them")
    return found


def words(what, name, text, known):
    if text is None:
        return None
    if not text:
        raise Refused(f'{name} ""; give words separated by commas')
    for word in text.split(","):
        if word not in known:
            raise unknown(what, word, known)
    return tuple(word for word in known if word in text.split(","))


def make_folder(folder):
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise Refused(f"cannot make the folder {folder}: {error.strerror}; give another -folder") \
            from None
