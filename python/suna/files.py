"""files.py -- read what Suna writes into numpy and pandas.

    read_table      CSV tables: lost, bonds, flows, walls, energy, budget, averages, particles
    read_vtp        particles and bonds for ParaView
    read_snapshot   the state: particles, columns, contacts with history
    read_record     particles.bin of a coupled run
    read_cloud      lagrangian fields of a time folder of OpenFOAM, ascii or binary
    tables          all tables of a coupled case, or of a folder of dem run
    times           time folders of a coupled case

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import functools
import os
import re
from pathlib import Path
from typing import Any, Callable, Iterator, TypeVar

import numpy

from ._arguments import File
from ._core import check, ffi, lib

Read = TypeVar("Read", bound=Callable[..., Any])


class FileError(Exception):
    """A file that is not what it should be: which, and why."""


def reader(read: Read) -> Read:
    """A reader that raises FileError for a damaged file, whatever is met first in it."""
    @functools.wraps(read)
    def guarded(path):
        try:
            return read(path)
        except (FileError, ImportError, OSError):
            raise
        except Exception as error:
            raise FileError(f"{path}: damaged, or not a file of Suna: {error}") from error
    return guarded    # type: ignore[return-value]


# ---- tables --------------------------------------------------------------------------------------

@reader
def read_table(path: File) -> Any:
    """A pandas.DataFrame; columns by name without the unit. In its attrs: `units` by column, and
    `effects`, the names of the acting effects from effects.csv beside it (the last row's)."""
    import pandas
    table = pandas.read_csv(path, comment="#")
    units = {}
    for name in list(table.columns):
        found = re.fullmatch(r"(.*)\[(.*)\]", name)
        if found:
            units[found[1]] = found[2]
    table = table.rename(columns=lambda name: name.split("[")[0])
    table.attrs["units"] = units
    effects = Path(path).with_name("effects.csv")
    if effects.exists() and effects != Path(path):
        table.attrs["effects"] = str(pandas.read_csv(effects)["effects"].iloc[-1]).split()
    return table


# ---- ParaView ------------------------------------------------------------------------------------

VTK_KINDS = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}


@reader
def read_vtp(path: File) -> dict[str, Any]:
    """The arrays of a .vtp file that Suna has written, by name; positions are `points`."""
    raw = Path(path).read_bytes()
    head, found, data = raw.partition(b"<AppendedData")
    if not found:
        raise FileError(f"{path}: no appended data; not a .vtp file of Suna")
    data = data[data.index(b"_") + 1:]
    columns = {}
    for tag in re.findall(rb"<DataArray [^>]*>", head):
        words = dict(re.findall(r'(\w+)="([^"]*)"', tag.decode()))
        at, width = int(words["offset"]), int(words.get("NumberOfComponents", 1))
        size = int.from_bytes(data[at:at + 8], "little")
        values = numpy.frombuffer(data[at + 8:at + 8 + size], VTK_KINDS[words["type"]])
        columns[words["Name"]] = values.reshape(-1, width) if width > 1 else values
    return columns


def write_vtp(path, columns):
    """Write arrays as points for ParaView; positions are `points`."""
    n = len(columns["points"])
    kinds = {numpy.dtype(kind): name for name, kind in VTK_KINDS.items()}
    tags, parts, at = {}, [], 0
    verts = {"connectivity": numpy.arange(n), "offsets": numpy.arange(1, n + 1)}
    for name, values in {**columns, **verts}.items():
        data = numpy.ascontiguousarray(values).tobytes()
        width = values.shape[1] if values.ndim > 1 else 1
        tags[name] = (f'<DataArray type="{kinds[values.dtype]}" Name="{name}" '
                      f'NumberOfComponents="{width}" format="appended" offset="{at}"/>')
        parts.append(len(data).to_bytes(8, "little") + data)
        at += len(parts[-1])
    text = "\n".join((
        '<?xml version="1.0"?>',
        '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">',
        f'<PolyData><Piece NumberOfPoints="{n}" NumberOfVerts="{n}">',
        f'<Points>{tags.pop("points")}</Points>',
        f'<Verts>{tags.pop("connectivity")}{tags.pop("offsets")}</Verts>',
        "<PointData>", *tags.values(), "</PointData>", "</Piece></PolyData>",
        '<AppendedData encoding="raw">', "_"))
    Path(path).write_bytes(text.encode() + b"".join(parts) + b"\n</AppendedData>\n</VTKFile>\n")


# ---- snapshots -----------------------------------------------------------------------------------

FLOW = numpy.dtype([("name", "S48"), ("kind", "i8"), ("count", "i8"), ("mass", "f8"),
                    ("momentum", "f8", 3), ("energy", "f8"), ("rate", "f8", 3), ("owed", "f8", 3)])
HEADER = numpy.dtype([("magic", "S8"), ("order", "u8"), ("version", "u8"), ("checksum", "u8", 3),
                      ("particles", "i8"), ("rows", "i8"), ("steps", "i8"), ("caller", "i8"),
                      ("time", "f8"), ("window", "i8", 2), ("opened", "f8", 2),
                      ("skins", "i8", 24), ("flows", "i8"), ("next_id", "i8"), ("flow", FLOW, 24),
                      ("materials", "i8"), ("columns", "i8"), ("memories", "i8"),
                      ("list", numpy.dtype([("name", "S48"), ("width", "i8")]), 128)])
RECORD = numpy.dtype([("position", "f8", 3), ("radius", "f8"), ("velocity", "f8", 3),
                      ("inverse_mass", "f8"), ("spin", "f8", 3), ("inverse_inertia", "f8"),
                      ("mass", "f8"), ("id", "i8"), ("material", "u2"), ("flags", "u2"),
                      ("image", "u4"), ("body", "i8")])
CONTACT = numpy.dtype([("low", "i8"), ("high", "i8"), ("image", "u4"), ("counted", "u4")])
VERSION = 8    # DEM_SNAPSHOT_VERSION


@reader
def read_snapshot(path: File) -> dict[str, Any]:
    """The state in a snapshot: `time`, `steps`, `materials` (names), `particles` (a structured array
    with a field for each column of the core, too), `contacts` (a structured array of the ids `low` and `high`,
    -1 less the number of a facet at a wall, the periodic `image`, and a field for each memory) and `history`
    (the names of these)."""
    raw = Path(path).read_bytes()
    if len(raw) < HEADER.itemsize or raw[:4] == b"Foam":
        raise FileError(f"{path}: {len(raw)} bytes, too few for a snapshot")
    head = numpy.frombuffer(raw, HEADER, 1)[0]
    if head["version"] != VERSION:
        raise FileError(f"{path}: version {head['version']}, this reader has {VERSION}; not a "
                        "snapshot, or one of another version of Suna")
    if min(int(head[name]) for name in ("particles", "rows", "materials", "columns", "memories")) < 0:
        raise FileError(f"{path}: a number below 0 in its head; damaged")
    names = [name.decode() for name in head["list"]["name"]]
    materials, columns = int(head["materials"]), int(head["columns"])

    def fields(first, last):
        return [(names[k], "f8", int(head["list"]["width"][k])) if head["list"]["width"][k] > 1
                else (names[k], "f8") for k in range(first, last)]
    kind = numpy.dtype(RECORD.descr + fields(materials, materials + columns))
    contact = numpy.dtype(CONTACT.descr + fields(materials + columns, materials + columns + int(head["memories"])))
    n, rows, at = int(head["particles"]), int(head["rows"]), HEADER.itemsize
    size = at + n*kind.itemsize + rows*contact.itemsize + int(head["caller"])
    if len(raw) != size:
        raise FileError(f"{path}: {len(raw)} bytes, and its head tells of {size}; damaged")
    check(lib.dem_snapshot_hash(os.fsencode(path), ffi.new("uint64_t *")))
    history = names[materials + columns:materials + columns + int(head["memories"])]
    particles = numpy.frombuffer(raw, kind, n, at)
    contacts = numpy.frombuffer(raw, contact, rows, at + n*kind.itemsize)
    return {"time": float(head["time"]), "steps": int(head["steps"]),
            "materials": names[:materials], "particles": particles, "contacts": contacts,
            "history": history}


# ---- coupled cases -------------------------------------------------------------------------------

BEAD = numpy.dtype([("id", "i4"), ("position", "f4", 3), ("velocity", "f4", 3), ("diameter", "f4")])


def read_record(path: File) -> Iterator[tuple[float, Any]]:
    """The instants of a particles.bin, one after the other: time [s], structured array of id,
    position, velocity, diameter. A last one that is not complete is left out."""
    with Path(path).open("rb") as file:
        size = os.fstat(file.fileno()).st_size
        while True:
            head = file.read(16)
            if len(head) < 16:
                return
            time, n = numpy.frombuffer(head, "f8", 1)[0], numpy.frombuffer(head, "i8", 1, 8)[0]
            if n < 0:
                raise FileError(f"{path}: {n} particles at byte {file.tell() - 8}; damaged, or not a record")
            if int(n)*BEAD.itemsize > size - file.tell():
                return
            yield float(time), numpy.frombuffer(file.read(int(n)*BEAD.itemsize), BEAD)


def times(case: File) -> list[tuple[float, Path]]:
    """Time folders of a case with particles, in order: (time, path)."""
    found: list[tuple[float, Path]] = []
    for folder in Path(case).iterdir():
        try:
            found.append((float(folder.name), folder))
        except ValueError:
            continue
    return sorted((time, folder) for time, folder in found if any(folder.glob("lagrangian/*")))


def tables(case: File) -> dict[str, Any]:
    """CSV tables by name of a coupled case, or of a folder that dem run writes (without its
    particles_*.csv). Of a case the rows of all starts: a later start replaces what an earlier one
    has from its time on."""
    import pandas
    found: dict[str, Any] = {}
    folders = sorted(Path(case).glob("postProcessing/dem/*"), key=lambda path: float(path.name))
    if not folders and Path(case, "effects.csv").exists():
        folders = [Path(case)]
    if not folders:
        raise FileError(f"{case}: no folder in its postProcessing/dem, and no effects.csv; give the folder of a "
                        "coupled case that has run, or a folder of dem run with tables")
    for folder in folders:
        for path in folder.glob("*.csv"):
            if path.name == "effects.csv" or re.fullmatch(r"particles_\d+\.csv", path.name):
                continue
            table, earlier = read_table(path), found.get(path.stem)
            if earlier is not None and "time" in table:
                kept = earlier[earlier["time"] < float(folder.name)*(1 + 1e-9)]
                attrs = table.attrs
                table = pandas.concat([kept, table], ignore_index=True)
                table.attrs = attrs
            found[path.stem] = table
    return found


def _foam_file(path):
    raw = Path(path).read_bytes()
    end = raw.index(b"}") + 1
    head, body = raw[:end].decode(errors="replace"), raw[end:].lstrip()
    while body.startswith(b"//"):
        body = body.split(b"\n", 1)[1].lstrip()
    return re.search(r"class\s+([^;]+);", head)[1], "binary" in head, body


def _foam_list(path):
    kind, binary, body = _foam_file(path)
    found = re.match(rb"(\d+)\s*([({])", body)
    if not found:
        raise FileError(f"{path}: no list of values")
    n, at = int(found[1]), found.end()
    width = 3 if kind.startswith("vector") else 1
    number = "<i4" if kind.startswith("label") else "<f8"
    if kind == "Cloud<basicKinematicCollidingParcel>" or "positions" in Path(path).name:
        return _positions(path, n, at, binary, body)
    if found[2] == b"{":
        one = numpy.array(re.findall(rb"[-+0-9.eE]+", body[at:body.rindex(b"}")]), float)
        values = numpy.tile(one, n)
    elif binary:
        values = numpy.frombuffer(body, number, n*width, at)
    else:
        values = numpy.array(re.findall(rb"[-+0-9.eE]+", body[at:body.rindex(b")")]), float)
    return values.reshape(-1, width) if width > 1 else values


def _positions(path, n, at, binary, body):
    if not binary:
        rows = re.findall(rb"\(([^()]+)\)\s*-?\d+", body[at:])
        return numpy.array([row.split() for row in rows], float).reshape(-1, 3)
    # "(" 3 doubles, 1 label ")" and a line's end
    entry = numpy.dtype([("open", "S1"), ("x", "<f8", 3), ("cell", "<i4"), ("close", "S1"),
                         ("end", "S1")])
    at = body.index(b"(", at)
    rows = numpy.frombuffer(body, entry, n, at)
    if not (rows["open"] == b"(").all():
        raise FileError(f"{path}: not {n} positions, each with a cell label of 32 bits; damaged, or of a "
                        "build with other labels")
    return rows["x"]


@reader
def read_cloud(folder: File) -> dict[str, Any]:
    """Fields of the particles in a time folder by name; `positions` are n x 3 [m]."""
    clouds = sorted(Path(folder).glob("lagrangian/*/positions"))
    if len(clouds) != 1:
        raise FileError(f"{folder} has {len(clouds)} clouds in lagrangian; give a time folder with one")
    return {path.name: _foam_list(path) for path in sorted(clouds[0].parent.iterdir())
            if path.name not in ("coordinates",)}
