"""command.py -- a command in Python beside the program dem: its options, its errors as one sentence, its
exit status.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import difflib
import sys

from ._arguments import SunaError


class Refused(Exception):
    """What a command cannot do: the sentence."""


def unknown(what, word, known):
    near = difflib.get_close_matches(word, known, 1, 0.5)
    return Refused(f'unknown {what} "{word}"' + (f"; did you mean {near[0]}?" if near else ";")
                   + f" known: {', '.join(known)}")


def read_options(arguments, command, values, flags=()):
    """Options by name, and the other words. -set takes two words or PATH=VALUE, and may be repeated."""
    given, plain, rest = {"-set": []}, [], list(arguments)
    while rest:
        word = rest.pop(0)
        if word in flags:
            given[word] = True
        elif word not in values:
            if word.startswith("-"):
                raise unknown("option", word, (*values, *flags, "-help"))
            plain.append(word)
        elif not rest or word == "-set" and "=" not in rest[0] and len(rest) < 2:
            raise Refused(f"{word} lacks its value; see {command} -help")
        elif word == "-set":
            given[word].append(rest.pop(0).split("=", 1) if "=" in rest[0]
                               else (rest.pop(0), rest.pop(0)))
        else:
            given[word] = rest.pop(0)
    return given, plain


def command(program, name, arguments):
    """Runs the command that a module is, by its HELP and main(arguments); returns the exit status."""
    try:
        if arguments and arguments[0] in ("-help", "-h"):
            print(program.HELP, end="")
        else:
            program.main(arguments)
        sys.stdout.flush()
    except OSError as error:
        print(f"{name}: {error.filename or 'standard output'}: {error.strerror}", file=sys.stderr)
        sys.stdout = None  # what is left in it cannot be written at the exit either
        return 1
    except (Refused, SunaError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"{name}: interrupted", file=sys.stderr)
        return 130
    return 0
