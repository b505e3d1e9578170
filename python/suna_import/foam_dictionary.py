"""foam_dictionary.py -- OpenFOAM's dictionaries as Python objects that know file and line of each
entry.

    d = read_dictionary(Path("case/constant/g"), "constant/g", report)
    d.vector("value")                               (0.0, 0.0, -9.81)
    d.sub("dividedProps").number("alphaMin", 0.1)   0.3, or 0.1 where it is not there
    d.unread()                                      entries that nobody asked for: to be reported

Syntax: comments, "strings", "(patterns|of names)" as keys, lists with or without their count,
dictionaries in lists, dimensions [ ... ] (skipped), $name, ${name}, $..name, $:a.b, `$name;` to
insert a dictionary, #include, #includeIfPresent, #{ code #}, and files that are compressed (.gz). A
later entry replaces an earlier one, dictionaries are merged, as in OpenFOAM. Other directives stand
as text: #calc in a value, where its reader gets an error with the line, #includeEtc and the like as
entries that are never read.

The reader of dem/input is for Suna's own files: it has no patterns as keys and refuses what it does
not know, where foreign files must be read to their end.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import gzip
import math
import re

from .report import Place

MAX_DEPTH = 50
YES, NO = ("yes", "on", "true", "y", "t"), ("no", "off", "false", "n", "f", "none")
# comments, strings and code first; then signs; then words, in which brackets may stand in pairs
TOKEN = re.compile(r"""
    (?P<skip>   \s+ | //[^\n]* | /\*.*?\*/ )
  | (?P<code>   \#\{.*?\#\} )
  | (?P<string> "(?:[^"\\]|\\.)*" )
  | (?P<list>   [-+]?\d[\d.eE+-]*(?=\() )
  | (?P<sign>   [;{}()\[\]] )
  | (?P<word>   (?: \$\{[^{}\s]*\} | [^\s;{}()\[\]"] | \((?:[^\s;{}()"]|\([^\s;{}()"]*\))*\) )+ )
""", re.S | re.X)


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
            self.refuse(name, "has no word as its value")
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
            self.refuse(name, "has no list as its value")
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


# ---- reading -------------------------------------------------------------------------------------

def existing(path):
    """The file, or its compressed form; None."""
    for candidate in (path, path.with_name(path.name + ".gz")):
        if candidate.is_file():
            return candidate
    return None


def file_text(path):
    with (gzip.open if path.suffix == ".gz" else open)(path, "rb") as file:
        return file.read().decode("latin-1")


class Reader:
    def __init__(self, path, name, report, depth=0):
        self.path, self.name, self.report, self.depth = path, name, report, depth
        self.tokens, line, at = [], 1, 0
        text = file_text(existing(path))
        while at < len(text):
            match = TOKEN.match(text, at)
            if match is None:
                report.refuse(Place(name, line), text[at:at + 20].split("\n")[0],
                              "cannot be read as OpenFOAM's syntax")
            kind, token = match.lastgroup, match[0]
            if kind == "string":
                self.tokens.append((Text(token[1:-1]), line, False))
            elif kind != "skip":
                self.tokens.append((token, line, kind == "sign"))
            line += token.count("\n")
            at = match.end()
        self.at = 0

    def place(self):
        rest = self.tokens[self.at:self.at + 1] or self.tokens[-1:]
        return Place(self.name, rest[0][1] if rest else 1)

    def peek(self):
        return self.tokens[self.at][0] if self.at < len(self.tokens) else None

    def next_is(self, sign):
        return (self.at < len(self.tokens) and self.tokens[self.at][2]
                and self.tokens[self.at][0] == sign)

    def take(self):
        token = self.peek()
        self.at += 1
        return token

    def expect(self, sign, what):
        if not self.next_is(sign):
            self.report.refuse(self.place(), str(self.peek() or "end of file"),
                               f"'{sign}' is missing after {what}")
        self.at += 1

    def deeper(self, by):
        """Of brackets and included files, which are in one another."""
        self.depth += by
        if self.depth > MAX_DEPTH:
            self.report.refuse(self.place(), self.peek() or "#include", f"{MAX_DEPTH} brackets or "
                               "files in one another are the limit; does a file include itself?")

    def dictionary(self, d, closing):
        """Entries up to } or the end of the file."""
        self.deeper(1)
        while self.at < len(self.tokens):
            if closing and self.next_is("}"):
                self.at += 1
                self.deeper(-1)
                return d
            if self.next_is(";"):
                self.at += 1
            else:
                self.entry(d)
        if closing:
            self.report.refuse(d.place, d.path or "{", "has no closing }")
        self.deeper(-1)
        return d

    def entry(self, d):
        place, name = self.place(), self.take()
        if name in ("#include", "#includeIfPresent", "#sinclude"):
            self.include(d, name, place)
        elif name.startswith("#"):
            # #includeEtc, #inputMode, ...: an entry that nobody asks for
            d.add(Entry(f"{name} {as_text(self.take())}", place, []))
        elif name.startswith("$") and not isinstance(name, Text):
            macro = d.resolve(name[1:])
            if macro is None or not isinstance(macro.value, Dictionary):
                d.add(Entry(name, place, self.value(d, ";", name)))
                return
            for inner in macro.value.entries:
                d.add(Entry(inner.name, inner.place, inner.value))
        elif self.next_is("{"):
            self.at += 1
            inner = Dictionary(self.report, place, d.full(name), d)
            d.add(Entry(name, place, self.dictionary(inner, True)))
        elif name in ("(", ")", "{", "[", "]"):
            self.report.refuse(place, name, "stands where a name should")
        else:
            value = self.value(d, ";", name)
            self.expect(";", name)
            d.add(Entry(name, place, value))

    def value(self, d, end, name):
        """Tokens up to the sign `end`, which is left."""
        value = []
        self.deeper(1)
        while self.at < len(self.tokens) and not self.next_is(end):
            if self.next_is("}"):
                self.expect(end, name)
            if self.next_is("("):
                self.at += 1
                value.append(self.value(d, ")", name))
                self.expect(")", name)
            elif self.next_is("["):
                while self.at < len(self.tokens) and not self.next_is("]"):
                    self.at += 1
                self.expect("]", name)
            elif self.next_is("{"):
                place = self.place()
                self.at += 1
                inner = Dictionary(self.report, place, d.full(name), d)
                # in a list the word before it is the name of the dictionary
                if value and type(value[-1]) is str and not re.fullmatch(r"\d+", value[-1]):
                    inner.path = d.full(value[-1])
                value.append(self.dictionary(inner, True))
            else:
                token = self.take()
                macro = (d.resolve(token[1:]) if token.startswith("$") and type(token) is str
                         else None)
                if macro is None:
                    value.append(token)
                else:
                    value += macro.value if isinstance(macro.value, list) else [macro.value]
        self.deeper(-1)
        return value

    def include(self, d, directive, place):
        wanted = str(self.take())
        path = self.path.parent/wanted
        if existing(path) is None:
            if directive != "#include":
                return
            self.report.refuse(place, f'{directive} "{wanted}"', "there is no such file")
        name = str(self.path.parent/wanted) if wanted.startswith("/") else \
            "/".join([*self.name.split("/")[:-1], wanted])
        Reader(path, name, self.report, self.depth).dictionary(d, False)


def read_dictionary(path, name, report):
    """The dictionary in this file (or in its .gz), which messages call `name`."""
    if existing(path) is None:
        report.refuse(Place(name), path.name, "there is no such file")
    d = Dictionary(report, Place(name, 1))
    Reader(path, name, report).dictionary(d, False)
    d.find("FoamFile")
    return d
