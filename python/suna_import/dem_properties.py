"""dem_properties.py -- constant/demProperties of a translated case: sections of entries, each with
the line of the source that it comes from.

    properties = DemProperties()
    properties.add("materials", "glass { density 2500; youngsModulus 1e7; }", place)
    text = properties.text(title, "blockMesh; demPimpleFoam", report)

SPDX-License-Identifier: GPL-3.0-or-later
"""
from .scene_text import Names

SECTIONS = ("materials", "effects", "pairs", "walls", "domain", "insert", "start", "outlets",
            "time", "coupling")
COLUMN = 60         # of the comments


class DemProperties:
    def __init__(self):
        self.sections, self.names = {}, Names()

    def add(self, section, text, *places):
        """One entry, or several lines of it; the places are named behind the first."""
        self.sections.setdefault(section, []).append((text, places))

    def named(self, section, name, body, *places):
        """NAME { body }, under a name of its own."""
        self.add(section, f"{self.names.free(section, name)} {{ {body} }}", *places)

    def text(self, title, command, report):
        lines = [f"// {title}", f"// To run: {command}", *report.comment(), ""]
        for section in [*SECTIONS, *(name for name in self.sections if name not in SECTIONS)]:
            if section in self.sections:
                lines += [section, "{"]
                for text, places in self.sections[section]:
                    first, *rest = text.split("\n")
                    where = ", ".join(dict.fromkeys(str(place) for place in places))
                    lines.append(f"    {first:{COLUMN}}  // {where}" if where else f"    {first}")
                    lines += [f"    {line}" for line in rest]
                lines += ["}", ""]
        return "\n".join(lines)
