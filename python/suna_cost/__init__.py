"""suna_cost -- accuracy against cost: errors and processor time over refinement series of a scene or
of a coupled case.

A series varies one parameter: time step, contact stiffness, law of friction, or each
effect left out; interval of exchange, kernel, cells. Each level of a series is run several times
over the same window of simulated time.

    refinement.py   convergence study of one quantity: reference, errors, observed order
    study.py        series, levels and runs; errors of all quantities, processor times, Pareto front
    scene.py        the series of a scene of the program dem
    closed_forms.py head-on impact of two bodies
    case.py, case_study.py, case_results.py     an OpenFOAM case, its series, results of a run
    case_command.py, __main__.py, options.py    the commands demCost and dem cost
    report.py       tables on the terminal, cost.csv, the picture
    target.py       the search for a target error
    best_buy.py     the longest step within the target error, in one sentence

SPDX-License-Identifier: GPL-3.0-or-later
"""
