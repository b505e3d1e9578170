"""liggghts_script.py -- the commands of an input script of LIGGGHTS in the order in which it
executes them.

Lines are joined at a trailing &, comments are cut at #, quoted words are one word. ${name}, $x and
$(expression) are replaced outside quotes, from the variables known at that line. `include`, `jump`,
`label`, `next` and `if` are followed where they are decided by the script alone, so loops are
unrolled. A condition that only a run decides is refused. Commands, nested files, nested variables
and the length of a line are limited, so an endless loop ends with a sentence.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import functools
import os
import re
from pathlib import Path
from typing import NamedTuple

from .liggghts_expression import Dynamic, Expression, Malformed
from .liggghts_words import BadWords, Words, as_number, as_whole, written
from .report import Place, collected

MAX_COMMANDS = 100000       # executed, of a script with loops
MAX_FILES = 16              # included in one another, as in LIGGGHTS
MAX_LINE = 100000           # characters, with variables replaced
MAX_DEPTH = 20              # of variables that use variables
MAX_VALUES = 10000          # of variables that a line needs
WORD = re.compile(r'"""(.*?)"""|"([^"]*)"|\'([^\']*)\'|(\S+)', re.S)
REFERENCE = re.compile(r"\$\{(\w+)\}|\$\(([^()]*(?:\([^()]*\)[^()]*)*)\)|\$(\w)")
PARTITION = re.compile(r"\s*partition\s+(yes|no)\s+(\d*)(\*?)(\d*)\s+")
QUOTED = re.compile(r'("""(?:.|\n)*?"""|"[^"]*"|\'[^\']*\')')


class Command(NamedTuple):
    place: Place
    words: Words            # without quotes
    name: str


class Variable(NamedTuple):
    style: str
    values: object          # list or range; of equal and atom: one expression
    index: int = 0


def without_comment(line):
    quote = ""
    for k, c in enumerate(line):
        if quote:
            quote = "" if c == quote else quote
        elif c in "\"'":
            quote = c
        elif c == "#":
            return line[:k]
    return line


def read_lines(path):
    """(number, text) of the commands, continued lines joined."""
    found, parts, first = [], [], 0
    with open(path, errors="replace") as file:
        for number, line in enumerate([*file, ""], 1):
            line = without_comment(line.rstrip("\n\r")).rstrip()
            first = first if parts else number
            parts.append(line.removesuffix("&"))
            if not line.endswith("&"):
                text = " ".join(parts)
                if text.strip():
                    found.append((first, text))
                parts = []
    return found


def labels(lines):
    """Number of the line that follows each label; the first one counts."""
    rows = [(text.split(), k) for k, (_, text) in enumerate(lines, 1)]
    return {words[1]: k for words, k in reversed(rows) if words[0] == "label" and len(words) > 1}


def is_file(path):
    """A regular file; no name that the system refuses is one."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def split(text):
    return Words(split_once(text))


@functools.lru_cache(10000)
def split_once(text):
    return tuple(next(group for group in match.groups() if group is not None)
                 for match in WORD.finditer(text))


class Script:
    def __init__(self, path, report, keyword, given=()):
        """`keyword(name)`: value of a thermo keyword, or Dynamic. `given`: (name, value) of
        -var."""
        self.report, self.keyword = report, keyword
        self.variables = {name: Variable("index", [value]) for name, value in given}
        self.given = set(self.variables)
        self.files, self.place, self.folder, self.known = [], None, Path(path).parent, {}
        self.skip_jump, self.depth, self.evaluated = False, 0, 0
        self._open(Path(path))

    def _open(self, path):
        if path not in self.known:
            lines = read_lines(path)
            self.known[path] = lines, labels(lines)
        self.path, self.lines, self.at = path, self.known[path][0], 0
        self.name = os.path.relpath(path, self.folder)

    # ---- commands in the order of execution ------------------------------------------------------

    def __iter__(self):
        for _ in range(MAX_COMMANDS):
            while self.at == len(self.lines) and self.files:
                self.path, self.name, self.lines, self.at = self.files.pop()
            if self.at == len(self.lines):
                return
            number, text = self.lines[self.at]
            self.at += 1
            self.place = Place(self.name, number)
            yield from self._commands(text)
        with collected():
            self._fault("jump", f"the script has executed {MAX_COMMANDS} commands, the limit; an "
                        "endless loop cannot be translated (is next missing?)")

    def _commands(self, text):
        self.report.at, self.evaluated = self.place, 0
        match = PARTITION.match(text)
        if match:           # there is one partition, number 1
            chosen, low, star, high = match.groups()
            of = int(low or 1) <= 1 <= int(high or 1) if star else low == "1"
            text = text[match.end():] if of == (chosen == "yes") else text
        with collected():
            words = self._words(text)
            if words.get(0) == "if":
                for line in self._branch(split(text)):
                    yield from self._commands(line)
            elif words:
                yield Command(self.place, words[1:], words[0])

    def _words(self, text):
        """Words of a command that is left to do; what decides the order is done."""
        words = split(self.replace(text))
        control = CONTROL.get(words.get(0))
        if control is None:
            return words
        try:
            control(self, words[1:])
        except BadWords as error:
            self._fault(words[0], str(error))
        return Words()

    def _branch(self, words):
        try:
            return self._do_if(words)
        except BadWords as error:
            self._fault("if", str(error))

    def _fault(self, word, sentence):
        self.report.refuse(self.place, word, sentence)

    # ---- variables -------------------------------------------------------------------------------

    def replace(self, text):
        """References outside quotes."""
        if "$" not in text:
            return text
        found = "".join(part if k % 2 else self.replace_all(part)
                        for k, part in enumerate(QUOTED.split(text)))
        if len(found) > MAX_LINE:
            self._fault(text.split()[0], f"its variables make a line of {len(found)} characters; "
                        f"the limit is {MAX_LINE}")
        return found

    def replace_all(self, text):
        return REFERENCE.sub(self._reference, text)

    def _reference(self, match):
        try:
            if match.group(2) is not None:
                return written(self.evaluate(match.group(2)), 20)
            return self.text(match.group(1) or match.group(3))
        except Dynamic as error:
            self._fault(match.group(0), f"{error} is known only in a run of LIGGGHTS; write its "
                        "value instead")

    def text(self, name):
        if name not in self.variables:
            self._fault(f"${{{name}}}", f"there is no such variable; give -var {name}=VALUE")
        style, values, index = self.variables[name]
        if style == "equal":
            return written(self.evaluate(values[0]))
        if style == "atom":
            raise Dynamic(f"variable {name} of style atom")
        return str(values[index])

    def number(self, name):
        return as_number(self.text(name), f"number, the value of variable {name}")

    def evaluate(self, text):
        self.evaluated += 1
        if self.depth == MAX_DEPTH or self.evaluated > MAX_VALUES:
            self._fault(f'"{text}"', "a variable refers to itself, or to too many others")
        self.depth += 1
        try:
            return Expression(text, self.number, self.keyword).value()
        except Malformed as error:
            self._fault("expression", str(error))
        finally:
            self.depth -= 1

    # ---- what decides the order ------------------------------------------------------------------

    def _do_variable(self, words):
        name, style, rest = words[0], words[1], words[2:]
        if style == "delete":
            self.variables.pop(name, None)
        elif style in ("equal", "atom"):
            self.variables[name] = Variable(style, ["".join(rest)])
        elif name in self.given or name in self.variables and style != "string":
            return          # of these styles the first definition holds
        elif style in ("index", "world", "universe"):
            self.variables[name] = Variable(style, [rest[0], *rest[1:]])
        elif style == "string":
            self.variables[name] = Variable(style, [" ".join(rest)])
        elif style in ("loop", "uloop"):
            numbers = Words(as_whole(word) for word in rest if word != "pad")
            low, high = numbers[:2] if len(numbers) > 1 else (1, numbers[0])
            if low > high:
                raise BadWords(f"the loop from {low} to {high} has no turn")
            self.variables[name] = Variable(style, range(low, high + 1))
        elif style == "getenv":
            self.variables[name] = Variable(style, [os.environ.get(rest[0], "")])
        else:
            self._fault(f"variable {name} {style}", "this style is not read; known: equal, atom, "
                        "index, loop, string, getenv, world, universe, uloop")

    def _do_next(self, words):
        for name in words:
            style, values, index = self.variables.get(name, Variable("", []))
            if style == "":
                self._fault(f"next {name}", "there is no such variable")
            if style in ("universe", "uloop", "world"):
                index = len(values)         # each partition has one value; the first one is taken
            if index + 1 < len(values):
                self.variables[name] = Variable(style, values, index + 1)
            else:
                self.variables.pop(name)
                self.skip_jump = True

    def _do_label(self, words):
        pass

    def _do_jump(self, words):
        if self.skip_jump:
            self.skip_jump = False
            return
        if words[0] not in ("SELF", self.path.name):
            self._open(self._find(words[0], "jump"))
        else:
            self.at = 0
        if len(words) > 1:
            found = self.known[self.path][1].get(words[1])
            self.at = len(self.lines) if found is None else found
            if found is None:
                self._fault(f"jump {words[1]}", "there is no such label in the file")

    def _do_include(self, words):
        path = self._find(words[0], "include")
        if len(self.files) == MAX_FILES:
            self._fault(f"include {words[0]}", f"more than {MAX_FILES} files include one "
                        "another; does a file include itself?")
        self.files.append((self.path, self.name, self.lines, self.at))
        self._open(path)

    def _find(self, name, word):
        """LIGGGHTS looks in the folder where it runs: the folder of the script."""
        for folder in (self.path.parent, Path(".")):
            if is_file(folder/name):
                return folder/name
        self._fault(f"{word} {name}", "there is no such file")

    def _do_quit(self, words):
        self.at, self.files = len(self.lines), []

    def _do_if(self, words):
        """The commands of the branch that holds."""
        groups, k = [(words[1], [])], 3
        if words[2] != "then":
            self._fault("if", "then is missing")
        while k < len(words):
            if words[k] in ("elif", "else"):
                condition = words[k + 1] if words[k] == "elif" else "1"
                k += words[k] == "elif"
                groups.append((condition, []))
            else:
                groups[-1][1].append(words[k])
            k += 1
        for condition, commands in groups:
            if self._holds(condition):
                return commands
        return []

    def _holds(self, condition):
        text = self.replace_all(condition)
        match = re.fullmatch(r"\s*([^\s=!<>&|()]+)\s*(==|!=)\s*([^\s=!<>&|()]+)\s*", text)
        try:
            if match:
                a, operator, b = match.groups()
                try:
                    a, b = float(a), float(b)
                except ValueError:
                    pass
                return (a == b) == (operator == "==")
            return self.evaluate(text) != 0
        except Dynamic as error:
            self._fault(f"if {condition}",
                        f"{error} is known only in a run of LIGGGHTS; import the "
                        "branch that is wanted")


CONTROL = {"variable": Script._do_variable, "next": Script._do_next, "label": Script._do_label,
           "jump": Script._do_jump, "include": Script._do_include, "quit": Script._do_quit}
