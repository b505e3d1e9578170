"""tap.py -- claims of a test in Python, printed as TAP.

    from tap import claim, finish, run_tests, skip
    claim("the mass is conserved", abs(error) < 1e-12, f"error {error}")    notes are for failures
    claim("the table is there", lambda: read(table))    one that raises an exception fails alone
    skip("two ranks", "no mpi4py")
    run_tests(bounce, friction) functions whose docstrings name them; one fails that raises
    finish()                    prints the plan and ends the program; status 1 if a claim has failed

Its folder has to be in sys.path or PYTHONPATH.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
import traceback

claims = failures = 0


def claim(name, condition, *notes):
    """Prints "ok" when the condition, or what it returns, is true; else "not ok" and the notes, texts or lists of
    lines. A condition that raises an exception is false. Returns the condition."""
    global claims, failures
    claims += 1
    if callable(condition):
        try:
            condition = condition()
        except Exception:       # noqa: B902
            condition = False
            notes += (traceback.format_exc(),)
    failures += not condition
    print(f"{'ok' if condition else 'not ok'} {claims} - {name}")
    if not condition:
        for note in notes:
            for line in note if isinstance(note, list) else str(note).splitlines():
                print(f"#   {line}")
    sys.stdout.flush()
    return bool(condition)


def skip(name, why):
    claim(f"{name} # SKIP {why}", True)


def run_tests(*tests):
    for test in tests:
        name = " ".join(test.__doc__.split())
        try:
            test()
            claim(name, True)
        except Exception:       # noqa: B902
            claim(name, False, traceback.format_exc())


def finish():
    print(f"1..{claims}", flush=True)
    sys.exit(failures > 0 or claims == 0)
