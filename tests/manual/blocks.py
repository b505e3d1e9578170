"""blocks.py -- the code blocks of Markdown pages, fenced and indented, with the comment before each.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re


class Block:
    """page, line of the first line of code, language of the fence, text, marker (the comment
    directly before the block, without its brackets; None if there is none)"""

    def __init__(self, page, line, language, lines, marker, fenced):
        self.page, self.line, self.language = page, line, language
        self.marker, self.fenced = marker, fenced
        self.text = "\n".join(lines) + "\n"


def of(page, text):
    """The blocks of a page, in order."""
    lines, found, k, marker, listed = text.split("\n"), [], 0, None, False
    while k < len(lines):
        line = lines[k]
        fence = re.match(r"( *)(```+|~~~+)\s*(\S*)", line)
        if line.startswith("<!--"):
            comment = [line]
            while "-->" not in lines[k] and k + 1 < len(lines):
                k += 1
                comment.append(lines[k])
            marker = re.sub(r"<!--\s*|\s*-->.*", "", "\n".join(comment), flags=re.S)
        elif fence:
            begin, indent = k + 1, len(fence.group(1))
            k += 1
            while k < len(lines) and not lines[k].strip().startswith(fence.group(2)):
                k += 1
            found.append(Block(page, begin + 1, fence.group(3),
                               [x[indent:] for x in lines[begin:k]], marker, True))
            marker = None
        elif line.startswith("    ") and line.strip() and (k == 0 or not lines[k - 1].strip()
                                                           or lines[k - 1].startswith("<!--")) \
                and not listed:
            begin = k
            while k < len(lines) and (lines[k].startswith("    ") or not lines[k].strip()):
                k += 1
            k -= 1
            end = k
            while not lines[end].strip():
                end -= 1
            found.append(Block(page, begin + 1, "", [x[4:] for x in lines[begin:end + 1]], marker,
                               False))
            marker = None
        elif line.strip():
            marker = None
            listed = bool(re.match(r"\s*([-*]|\d+\.)\s", line)) or \
                (listed and line.startswith("  "))
        k += 1
    return found
