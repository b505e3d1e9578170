"""foam_dictionary.py -- OpenFOAM's dictionaries as Python objects that know file and line of each
entry.

    d = read_dictionary(Path("case/constant/g"), "constant/g", report)    # foam_reader.py
    d.vector("value")                               (0.0, 0.0, -9.81)
    d.sub("dividedProps").number("alphaMin", 0.1)   0.3, or 0.1 where it is not there
    d.unread()                                      entries that nobody asked for: to be reported

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import re

YES, NO = ("yes", "on", "true", "y", "t"), ("no", "off", "false", "n", "f", "none")


class Text(str):
    """A "string"; as a key it is a regular expression."""


def matches(pattern, name):
    """A key that is no regular expression matches only itself."""
    try:
        return re.fullmatch(pattern, name) is not None
    except re.error:
        return pattern == name


class Entry:
    """name, place, and a Dictionary or a list of tokens: words, Text, lists, Dictionaries."""

    def __init__(self, name, place, value):
        self.name, self.place, self.value, self.read = name, place, value, False
        self.pattern = isinstance(name, Text)


class Dictionary:
    def __init__(self, report, place, path="", outer=None):
        self.report, self.place, self.path, self.outer = report, place, path, outer
        self.entries = []

    # ---- filling ---------------------------------------------------------------------------------

    def add(self, entry):
        for i, old in enumerate(self.entries):
            if old.name == entry.name:
                if isinstance(old.value, Dictionary) and isinstance(entry.value, Dictionary):
                    for inner in entry.value.entries:
                        old.value.add(inner)
                else:
                    self.entries[i] = entry
                return
        self.entries.append(entry)

    # ---- finding ---------------------------------------------------------------------------------

    def find(self, name):
        """The entry of this name, or the last one whose pattern matches it; None. Marks it read."""
        plain = [e for e in self.entries if e.name == name and not e.pattern]
        found = plain or [e for e in self.entries if e.pattern and matches(e.name, name)][-1:]
        for entry in found[:1]:
            entry.read = True
            self.report.at = entry.place
            return entry
        return None

    def __contains__(self, name):
        return any(matches(e.name, name) if e.pattern else e.name == name
                   for e in self.entries)

    def where(self, name=None):
        """Place of the entry, or of the dictionary where there is none."""
        for entry in self.entries:
            if entry.name == name:
                return entry.place
        found = self.find(name) if name else None
        return found.place if found else self.place

    def unread(self):
        return [entry for entry in self.entries if not entry.read]

    # ---- what becomes of an entry, or of its value -----------------------------------------------

    def translated(self, name, text="", value=""):
        self.report.translated(self.where(name), self.full(name, value), text)

    def approximated(self, name, text, value=""):
        self.report.approximated(self.where(name), self.full(name, value), text)

    def harmless(self, name, text="", value=""):
        self.report.harmless(self.where(name), self.full(name, value), text)

    def refuse(self, name, text, value=""):
        self.report.refuse(self.where(name), self.full(name, value), text)

    def refuse_unread(self, deep=False):
        for entry in self.entries:
            if not entry.read:
                self.refuse(entry.name, "the importer does not know this entry")
            if deep and isinstance(entry.value, Dictionary):
                entry.value.refuse_unread(deep)

    def full(self, name, value=""):
        return (f"{self.path}/{name}" if self.path else name) + (f" {value}" if value else "")

    # ---- values ----------------------------------------------------------------------------------

    def tokens(self, name, *default):
        """The tokens of the value, without dimensions; missing without a default: an error."""
        entry = self.find(name)
        if entry is None or isinstance(entry.value, Dictionary):
            if default:
                return default[0]
            self.report.refuse(entry.place if entry else self.place, self.full(name),
                               "is a dictionary, not a value" if entry else "is missing here")
        return entry.value

    def word(self, name, *default):
        tokens = self.tokens(name, *(None,) if default else ())
        if tokens is None or not tokens or not isinstance(tokens[-1], str):
            if default:
                return default[0]
            self.refuse(name, "needs a word as its value")
        return str(tokens[-1])

    def number(self, name, *default):
        if name not in self and default:
            return default[0]
        return self.numbers(name, self.tokens(name)[-1:], 1, "number")[0]

    def positive(self, name, *default):
        value = self.number(name, *default)
        if value is not None and value <= 0:
            self.refuse(name, f"{value:g} is not above 0")
        return value

    def numbers(self, name, tokens, many=None, what="list of numbers"):
        """Finite numbers, all these tokens of an entry; `many`: how many there are."""
        try:
            found = [float(x) for x in tokens]
        except (ValueError, TypeError):
            found = [math.nan]
        if len(found) != (many or len(found)) or not all(map(math.isfinite, found)):
            self.refuse(name, f"{as_text(tokens)[:60]!r} is no {what}; write one")
        return found

    def indices(self, name, tokens, below):
        """Whole numbers from 0."""
        found = self.numbers(name, tokens)
        if not all(x == int(x) and 0 <= x < below for x in found):
            self.refuse(name, f"{as_text(tokens)!r} are not numbers of points from 0 to "
                        f"{below - 1}")
        return [int(x) for x in found]

    def vector(self, name, *default):
        if name not in self and default:
            return default[0]
        tokens = self.tokens(name)
        given = tokens[-1] if tokens and isinstance(tokens[-1], list) else tokens
        return tuple(self.numbers(name, given, 3, "vector"))

    def switch(self, name, default):
        """OpenFOAM's words for yes and no; an entry without value is yes, as its presence is."""
        if name not in self:
            return default
        tokens = self.tokens(name)
        if not tokens or str(tokens[0]).lower() in YES:
            return True
        if str(tokens[0]).lower() in NO:
            return False
        self.refuse(name, f"{as_text(tokens)!r} is neither yes nor no")

    def list(self, name, *default):
        """The last list of the value: words, lists, Dictionaries."""
        if name not in self and default:
            return default[0]
        lists = [token for token in self.tokens(name) if isinstance(token, list)]
        if not lists:
            self.refuse(name, "needs a list as its value")
        return lists[-1]

    def sub(self, name):
        """The dictionary of this name; an empty one where there is none."""
        entry = self.find(name)
        if entry is not None and isinstance(entry.value, Dictionary):
            return entry.value
        return Dictionary(self.report, entry.place if entry else self.place, self.full(name), self)

    def subs(self):
        """(name, dictionary) of each dictionary in this one."""
        for entry in self.entries:
            if isinstance(entry.value, Dictionary):
                entry.read = True
                yield entry.name, entry.value

    # ---- macros ----------------------------------------------------------------------------------

    def resolve(self, name):
        """The entry that $name means, or None."""
        name, scope = name.strip("{}"), self
        if name.startswith(":"):
            name = name[1:]
            while scope.outer is not None:
                scope = scope.outer
        elif name.startswith("."):
            dots = len(name) - len(name.lstrip("."))
            name = name[dots:]
            for _ in range(dots - 1):
                scope = scope.outer or scope
        while scope is not None:
            entry, inner = None, scope
            for part in [name] if name in scope else name.split("."):
                entry = inner.find(part) if isinstance(inner, Dictionary) else None
                inner = entry.value if entry else None
            if entry is not None:
                return entry
            scope = scope.outer
        return None


def as_text(value):
    """A value as OpenFOAM writes it."""
    if isinstance(value, Dictionary):
        return "{ " + "".join(f"{e.name} {as_text(e.value)}" +
                              (" " if isinstance(e.value, Dictionary) else "; ")
                              for e in value.entries) + "}"
    if isinstance(value, Text):
        return f'"{value}"'
    if isinstance(value, list):
        return " ".join("(" + as_text(x) + ")" if isinstance(x, list) else as_text(x)
                        for x in value)
    return str(value)
