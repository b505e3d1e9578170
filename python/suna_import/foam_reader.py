"""foam_reader.py -- read OpenFOAM's dictionaries into the objects of foam_dictionary.py.

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
import re

from .foam_dictionary import Dictionary, Entry, Text, as_text
from .report import Place

MAX_DEPTH = 50
# comments, strings and code first; then signs; then words, in which brackets may stand in pairs
TOKEN = re.compile(r"""
    (?P<skip>   \s+ | //[^\n]* | /\*.*?\*/ )
  | (?P<code>   \#\{.*?\#\} )
  | (?P<string> "(?:[^"\\]|\\.)*" )
  | (?P<list>   [-+]?\d[\d.eE+-]*(?=\() )
  | (?P<sign>   [;{}()\[\]] )
  | (?P<word>   (?: \$\{[^{}\s]*\} | [^\s;{}()\[\]"] | \((?:[^\s;{}()"]|\([^\s;{}()"]*\))*\) )+ )
""", re.S | re.X)


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
