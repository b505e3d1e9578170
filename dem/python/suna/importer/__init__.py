"""suna.importer -- `dem import`: input of other codes translated into scenes and cases of Suna.

    report.py       what was translated, approximated, left out as harmless; what cannot be translated

SPDX-License-Identifier: GPL-3.0-or-later
"""
