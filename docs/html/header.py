"""header.py -- a public header of the library as a page: its comments as text, its declarations as code.

A header is a head comment, sections /* ---- title ---- */, and blocks between blank lines: comments
before a declaration, declarations, comments behind them. Names of functions, structs and constants
lead to the block that declares them, in any header.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
from pathlib import Path

from myst_parser.parsers.sphinx_ import MystParser

INCLUDE = Path(__file__).resolve().parents[2]/"dem"/"include"
DECLARED = re.compile(r"^(?:[\w* ]+?[ *])(dem_\w+)\(|^struct (dem_\w+)$|^#define (DEM_\w+)|^    (DEM_\w+)\b", re.M)


def blocks(text):
    """Parts of a header between blank lines that are in no comment and no braces."""
    text = re.sub(r"^#(if|endif|include).*\n|^#define DEM\w*_H\n|^extern \"C\" \{\n|^\}\n", "", text, flags=re.M)
    part, depth, comment = [], 0, False
    for line in text.split("\n"):
        if not line.strip() and not depth and not comment:
            if part:
                yield "\n".join(part)
            part = []
            continue
        part.append(line)
        for token in re.findall(r"/\*|\*/|[{}]", line):
            comment = token == "/*" or comment and token != "*/"
            if not comment and token in "{}":
                depth += 1 if token == "{" else -1
    if part:
        yield "\n".join(part)


def prose(comment):
    """The text of a comment; what is indented in it stays as it is."""
    text = re.sub(r"^ ?\*( |$)", "", comment.strip()[2:-2].strip("\n "), flags=re.M)
    return "\n".join(line[3:] if line.startswith("   ") and not line.startswith("    ") else line
                     for line in text.split("\n"))


def names(block):
    """What a block declares."""
    code = re.sub(r"/\*.*?\*/", "", block, flags=re.S)
    return list(dict.fromkeys(name for found in DECLARED.findall(code) for name in found if name))


def anchors():
    """The header and the anchor of each name."""
    found = {}
    for path in sorted(INCLUDE.glob("*.h")):
        for block in blocks(path.read_text()):
            for name in names(block):
                found.setdefault(name, f"{path.name}#{names(block)[0].lower()}")
    return found


def linked(text, known):
    def link(match):
        name = match.group(0)
        return f"[{name}]({known[name]})" if name in known else name
    return "\n".join(line if line.startswith("    ") else re.sub(r"\bdem_\w+\b(?!\.h)|\bDEM_\w+\b", link, line)
                     for line in text.split("\n"))


def page(text):
    """Markdown of a header."""
    known = anchors()
    out = []
    for block in blocks(text):
        if block.startswith("/*\n * ") and not out:
            name, _, rest = prose(block).partition(" -- ")
            rest = rest.replace("SPDX-License-Identifier: GPL-3.0-or-later", "").strip()
            out += [f"# {name}", linked(rest[:1].upper() + rest[1:], known)]
        elif section := re.match(r"/\* -+ (.+?) -+ \*/$", block):
            out.append(f"## {section.group(1).capitalize()}")
        elif names(block) or block.startswith("struct"):
            comment = re.match(r"/\*.*?\*/\n", block, re.S)
            code = block[comment.end():] if comment else block
            if names(block):
                out.append(f"### {names(block)[0]}")
            out.append(f"```c\n{code.strip()}\n```")
            if comment:
                out.append(linked(prose(comment.group(0).strip()), known))
        elif block.startswith("/*"):
            out.append(linked(prose(block), known))
    return "\n\n".join(out) + "\n"


class HeaderParser(MystParser):
    """For Sphinx: files .h are pages."""

    supported = ("header",)

    def parse(self, inputstring, document):
        for path in INCLUDE.glob("*.h"):        # links lead to them
            document.settings.env.note_dependency(str(path))
        super().parse(page(inputstring), document)
