"""liggghts_expression.py -- values of the expressions in an input script of LIGGGHTS: `variable x
equal ...`, `$(...)`, conditions of `if`.

Operators by rising precedence: ||, &&, == !=, < <= > >=, + -, * / %, ^, and - and ! before a value.
All are left-associative, as in LIGGGHTS, where -2^2 is 4. Angles are in rad.

A value that only a run has (thermo keywords, computes, fixes, particles) raises Dynamic with its
word. Random numbers come from Python, not from LIGGGHTS' generator.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import random
import re

from .liggghts_words import BadWords

TOKEN = re.compile(r"""\s*(?:
    (?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) |
    (?P<name>[A-Za-z_][A-Za-z0-9_]*) |
    (?P<operator>\|\||&&|==|!=|<=|>=|[-+*/%^()<>!,\[\]]))""", re.X)

LEVELS = (("||",), ("&&",), ("==", "!="), ("<", "<=", ">", ">="),
          ("+", "-"), ("*", "/", "%"), ("^",))

OPERATORS = {
    "||": lambda a, b: float(a != 0 or b != 0), "&&": lambda a, b: float(a != 0 and b != 0),
    "==": lambda a, b: float(a == b), "!=": lambda a, b: float(a != b),
    "<": lambda a, b: float(a < b), "<=": lambda a, b: float(a <= b),
    ">": lambda a, b: float(a > b), ">=": lambda a, b: float(a >= b),
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a*b,
    "/": lambda a, b: a/b, "%": math.fmod, "^": lambda a, b: a**b}

FUNCTIONS = {
    "sqrt": math.sqrt, "exp": math.exp, "ln": math.log, "log": math.log10, "abs": abs,
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos,
    "atan": math.atan, "atan2": math.atan2, "ceil": math.ceil, "floor": math.floor,
    "round": lambda x: math.floor(x + 0.5), "min": min, "max": max,
    "random": lambda low, high, seed: random.Random(int(seed)).uniform(low, high),
    "normal": lambda mean, deviation, seed: random.Random(int(seed)).gauss(mean, deviation)}


class Dynamic(Exception):
    """The value of this word exists only in a run."""


class Malformed(BadWords):
    """The expression has a fault: the sentence."""


class Expression:
    """`variable(name)` gives the value of another variable, `keyword(name)` the value of a
    thermo keyword; both raise Dynamic where there is none."""

    def __init__(self, text, variable, keyword):
        self.text, self.variable, self.keyword = text, variable, keyword
        self.tokens, at = [], 0
        while text[at:].strip():
            match = TOKEN.match(text, at)
            if match is None:
                raise Malformed(f'"{text[at:].strip()}" is no number, name or operator')
            self.tokens.append((match.lastgroup, match.group(match.lastgroup)))
            at = match.end()
        self.at = 0

    def value(self):
        try:
            value = float(self._level(0))
        except RecursionError:
            raise Malformed(f'"{self.text[:20]}...": too many brackets') from None
        except (ZeroDivisionError, ValueError, OverflowError, TypeError) as error:
            raise Malformed(f'"{self.text}": {error}') from None
        if self.at < len(self.tokens):
            raise Malformed(f'"{self.text}": {self.tokens[self.at][1]} is not expected')
        if not math.isfinite(value):
            raise Malformed(f'"{self.text}": the value is not finite')
        return value

    def _next(self):
        if self.at == len(self.tokens):
            raise Malformed(f'"{self.text}" ends too early')
        self.at += 1
        return self.tokens[self.at - 1]

    def _is(self, *operators):
        return self.at < len(self.tokens) and self.tokens[self.at][0] == "operator" and \
            self.tokens[self.at][1] in operators

    def _expect(self, operator):
        if not self._is(operator):
            raise Malformed(f'"{self.text}": {operator} is missing')
        self.at += 1

    def _level(self, level):
        if level == len(LEVELS):
            return self._single()
        value = self._level(level + 1)
        while self._is(*LEVELS[level]):
            operator = self._next()[1]
            value = OPERATORS[operator](value, self._level(level + 1))
        return value

    def _single(self):
        kind, text = self._next()
        if kind == "number":
            return float(text)
        if kind == "operator":
            if text == "(":
                value = self._level(0)
                self._expect(")")
                return value
            if text in "-+!":
                value = self._single()
                return {"-": -value, "+": value, "!": float(value == 0)}[text]
            raise Malformed(f'"{self.text}": {text} is not expected')
        if self._is("["):
            raise Dynamic(text + "[]")
        if self._is("("):
            return self._call(text)
        if text == "PI":
            return math.pi
        if text[:2] in ("c_", "f_"):
            raise Dynamic(text)
        return self.variable(text[2:]) if text[:2] == "v_" else self.keyword(text)

    def _call(self, name):
        if name not in FUNCTIONS:
            raise Dynamic(name + "()")
        self._expect("(")
        values = [self._level(0)]
        while self._is(","):
            self.at += 1
            values.append(self._level(0))
        self._expect(")")
        return FUNCTIONS[name](*values)
