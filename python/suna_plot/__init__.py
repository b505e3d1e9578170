"""suna_plot -- pictures: their one style, and `dem plot`, which draws tables.

    style               colours, fonts, axes and small files; also of the tutorials and of docs/pictures
    view_in_paraview    a script for ParaView: particles, walls, void fraction of a run
    table               `dem plot TABLE`: columns of tables that programs write; a cost.csv goes to suna_cost.plot

SPDX-License-Identifier: GPL-3.0-or-later
"""
