"""scene_text.py -- the text of a scene or of constant/demProperties: sections, entries with the line that
they come from, words.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import textwrap

from .report import WIDTH


class Names:
    """Names that are given once in each section."""

    def __init__(self):
        self._taken = {}

    def free(self, section, name):
        """The name, with a number if the section has it already: x, x_2, x_3."""
        taken, found, k = self._taken.setdefault(section, set()), name, 1
        while found in taken:
            k += 1
            found = f"{name}_{k}"
        taken.add(found)
        return found


class SceneText:
    """Sections in the order of the manual, each entry with the lines that it comes from."""
    ORDER = ("materials", "effects", "pairs", "shapes", "walls", "domain", "insert", "start", "outlets", "forces",
             "fluid", "time", "coupling", "write")

    def __init__(self):
        self.sections, self.names = {name: [] for name in self.ORDER}, Names()

    def add(self, section, entry, *places):
        where = ", ".join(dict.fromkeys(str(place) for place in places if place is not None))
        self.sections[section].append((entry, f"// {where}" if where else ""))

    def named(self, section, name, body, *places):
        """NAME { body }, under a name of its own."""
        self.add(section, f"{self.names.free(section, name)} {{ {body} }}", *places)

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


def text(value):
    return f"{value + 0.0:.12g}"


def vector(values):
    return "(" + " ".join(text(x) for x in values) + ")"


def broken(entry):
    """An entry over several lines, at its blanks."""
    return textwrap.wrap(entry, WIDTH, initial_indent="    ", subsequent_indent="        ",
                         break_long_words=False, break_on_hyphens=False)


def braces(name, settings):
    inner = " ".join(f"{k} {v if isinstance(v, str) else text(v)};" for k, v in settings.items())
    return f"{name} {{ {inner} }}" if inner else f"{name} {{}}"


def as_name(name, start="fix"):
    """A word of a scene."""
    name = re.sub(r"\W", "_", name, flags=re.A)
    return name if name[:1].isalpha() else start + name
