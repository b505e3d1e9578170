"""_arguments.py -- what callers give, as the library takes it: texts, paths, numbers, arrays, scenes.

The library takes C's types: a text ends at its first NUL, a short vector is filled up with zeros, any
object is true. What would become another value on the way is refused here, with a sentence.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import reprlib
from pathlib import Path
from typing import Union

import numpy

File = Union[str, "os.PathLike[str]"]


class SunaError(Exception):
    """What the core or this package refuses or cannot do: its sentence."""

    __module__ = "suna"


def text(what, value):
    """A text as bytes."""
    if not isinstance(value, str):
        raise SunaError(f"{what} is {reprlib.repr(value)}; give a text")
    if "\0" in value:
        raise SunaError(f"{what} is {value!r}, which has the character NUL in it; leave that out")
    try:
        # names of files that are not UTF-8 have surrogates
        return value.encode(errors="surrogateescape")
    except UnicodeEncodeError as error:
        raise SunaError(f"{what} is {value!r}, which is not Unicode: {error}") from None


def file_name(what, value):
    """The path of a file or folder as bytes."""
    try:
        return text(what, os.fsdecode(value))
    except TypeError:
        raise SunaError(f"{what} is {reprlib.repr(value)}; give a path, as a text or Path") from None


def number(what, value):
    """A number; the library checks its range."""
    if not isinstance(value, (bool, numpy.bool_, str, bytes, bytearray)):
        try:
            return float(value)
        except (TypeError, ValueError, OverflowError):
            pass
    raise SunaError(f"{what} is {reprlib.repr(value)}; give a number")


def switch(what, value):
    """Yes or no."""
    if not isinstance(value, (bool, numpy.bool_)):
        raise SunaError(f"{what} is {reprlib.repr(value)}; give True or False")
    return bool(value)


def _array(what, value, kinds, wanted):
    """An array of these kinds of numbers (numpy.dtype.kind); an empty one has none."""
    try:
        array = numpy.asarray(value)
    except (ValueError, OverflowError):    # lists of unequal lengths
        array = numpy.empty(1, object)
    if array.size and array.dtype.kind not in kinds:
        raise SunaError(f"{what} is {reprlib.repr(value)}; give {wanted}")
    return array


def _spread(what, array, shape):
    """One value, or one for each, as an array of this shape."""
    shape = shape if isinstance(shape, tuple) else (shape,)
    try:
        return numpy.broadcast_to(array, shape)
    except ValueError:
        raise SunaError(f"{what} has the shape {array.shape}; give one value for all, or an array of "
                        f"the shape {shape}") from None


def numbers(what, value, shape):
    """Numbers, one for all or one for each, as an array of doubles."""
    return _spread(what, _array(what, value, "iuf", "numbers").astype(float), shape)


def vectors(what, value, *shape):
    """Numbers as an array of n items of this shape: n x 3 for vectors. One item may stand alone."""
    array = _array(what, value, "iuf", "numbers").astype(float)
    if array.size == 0:
        return numpy.empty((0, *shape))
    if array.shape[-len(shape):] != shape or array.ndim > len(shape) + 1:
        raise SunaError(f"{what} has the shape {array.shape}; give an array of the shape (n, "
                        + ", ".join(map(str, shape)) + ")")
    return numpy.ascontiguousarray(array).reshape(-1, *shape)


def whole_numbers(what, value, shape):
    """Ids: 64 bits, from 0; the core keeps the largest number for itself."""
    array = _array(what, value, "iu", "whole numbers")
    if array.size and (int(array.min()) < 0 or int(array.max()) >= 2**63 - 1):
        raise SunaError(f"{what} is {reprlib.repr(value)}; give whole numbers from 0 to 2^63 - 2")
    return _spread(what, array.astype(numpy.int64), shape)


def switches(what, value, shape):
    """Yes or no, one for all or one for each."""
    return _spread(what, _array(what, value, "b", "True or False"), shape)


def texts(what, value, shape):
    """Texts, one for all or one for each, as a list of bytes."""
    return [text(what, one) for one in _spread(what, numpy.asarray(value, object), shape)]


# ---- scenes --------------------------------------------------------------------------------------

def as_text(what, value):
    """A value of an entry in the dictionary syntax: yes and no, vectors in brackets."""
    if isinstance(value, numpy.generic) or (isinstance(value, numpy.ndarray) and value.ndim == 0):
        value = value.item()
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    if isinstance(value, dict):
        return "{ " + as_scene(value, group=f"{what}/").replace("\n", " ") + "}"
    if isinstance(value, Path):
        if '"' in str(value):
            raise SunaError(f"{what} is {str(value)!r}; a path in a scene cannot have quotation marks")
        return f'"{value}"'
    if numpy.iterable(value) and not isinstance(value, (bytes, bytearray)):
        return "(" + " ".join(as_text(what, x) for x in value) + ")"
    return str(value) if isinstance(value, int) else repr(number(what, value))


def as_scene(entries, indent="", group=""):
    """A dict as text: a dict in it is a group, all else an entry. Text stays as it is, so that a
    file name needs its quotation marks: '"wall.stl"'."""
    lines = []
    for name, value in entries.items():
        if not isinstance(name, str):
            raise SunaError(f"{group or 'the scene'} has an entry {name!r}; give its name as a text")
        if isinstance(value, dict):
            lines += [f"{indent}{name}", indent + "{",
                      as_scene(value, indent + "    ", f"{group}{name}/") + indent + "}"]
        else:
            lines.append(f"{indent}{name} {as_text(group + name, value)};")
    return "".join(line + "\n" for line in lines)
