"""scene_text.py -- the text of a scene: sections, entries with the line that they come from, words.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import textwrap

from .liggghts_region import text
from .report import WIDTH


class SceneText:
    """Sections in the order of the manual, each entry with the line that it comes from."""
    ORDER = ("materials", "effects", "pairs", "walls", "domain", "insert", "outlets", "forces",
             "fluid", "time", "write")

    def __init__(self):
        self.sections = {name: [] for name in self.ORDER}

    def add(self, section, entry, place=None):
        self.sections[section].append((entry, "" if place is None else f"// {place}"))

    def text(self, head):
        lines = list(head) + [""]
        for name, entries in self.sections.items():
            if not entries:
                continue
            lines += [name, "{"]
            wide = min(60, max(len(entry) for entry, _ in entries))
            for entry, comment in entries:
                if len(entry) > 60 and comment:
                    lines.append(f"    {comment}")
                    lines += broken(entry)
                else:
                    lines.append(f"    {entry:{wide}}  {comment}".rstrip())
            lines.append("}")
        return "\n".join(lines) + "\n"


def broken(entry):
    """An entry over several lines, at its blanks."""
    return textwrap.wrap(entry, WIDTH, initial_indent="    ", subsequent_indent="        ",
                         break_long_words=False, break_on_hyphens=False)


def braces(name, settings):
    inner = " ".join(f"{k} {v if isinstance(v, str) else text(v)};" for k, v in settings.items())
    return f"{name} {{ {inner} }}" if inner else f"{name} {{}}"


def as_name(name, start="fix"):
    """A word of a scene."""
    name = "".join(c if c.isalnum() or c == "_" else "_" for c in name)
    return name if name[:1].isalpha() else start + name
