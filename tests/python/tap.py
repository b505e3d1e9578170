"""tap.py -- runs functions as tests, named by their docstrings, and prints TAP.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import traceback


def run_tests(*tests):
    """Runs all tests, also after a failure; True if one has failed."""
    failed = 0
    print(f"1..{len(tests)}")
    for number, test in enumerate(tests, 1):
        name = " ".join(test.__doc__.split())
        try:
            test()
            print(f"ok {number} - {name}", flush=True)
        except Exception:       # noqa: B902
            failed += 1
            print(f"not ok {number} - {name}")
            print("".join("#   " + line + "\n" for line in traceback.format_exc().splitlines()),
                  flush=True)
    return failed > 0
