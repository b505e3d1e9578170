/*
 * cell.h -- a periodic domain that deforms: its rates along the axes, given or chosen so that a stress
 * is held.
 *
 *     domain { x (0 0.02); y (0 0.02); z (0 0.02); periodic (x y z);
 *              cell { xx { stress -1e5; } yy { stress -1e5; } zz { rate -0.05; start shear; } maxRate 1; } }
 *
 *   L_k   length of the domain along axis k, from its fixed face `min` on         [m]
 *   D_k   (dL_k/dt)/L_k, zero before `start` and after `end`                      [1/s]
 *
 * Particles move with the flow D x and with a velocity u of their own, which their records hold:
 *
 *   dx/dt = u + D x      du/dt = F/m - D u
 *
 * the equations of motion of Evans and Morriss (SLLOD): Newton's while D does not change. So
 * nothing of a particle changes when it is wrapped. The relative velocity of a pair at the distance
 * r, through periodic faces too, is u_i - u_j + D r.
 *
 * Exact wrapping: L_k and positions are multiples of the unit of the domain. A particle that is n
 * lengths outside, x = x0 + n L, moves by round(dt D (x0 - min + dt u/2)) + n dL + round(dt u), so that it has
 * the same bits wherever it was wrapped.
 *
 * Simple shear, xy { rate 1; }, has the flow D_xy y along x. The images across the faces of y are displaced
 * by an offset that grows by D_xy L_y (Lees and Edwards 1972), in the same units.
 *
 * The control of a stress is in step/cell_control.c, what a cell refuses in case/scene_cell.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once


enum
{
    DEM_CELL_LISTS = 2,           /* neighbor lists, of which the lengths are kept */
    DEM_CELL_STEPS = 8            /* between measurements of the stress that is controlled */
};

struct dem_cell_axis
{
    int deforms, held;            /* 1: it has an entry; its stress is held */
    double target, rate;          /* Pa, tension positive; 1/s */
    double start, end;            /* s; infinite before their stages begin, numbers from 1 */
    int stage[2];
};

struct dem_cell
{
    int active;                   /* 0: the domain is fixed, all else is zero */
    struct dem_cell_axis axis[3];
    struct dem_cell_axis shear;   /* xy: flow along x that grows with y */
    double max_rate;              /* 1/s  of held axes */
    double first_max[3];          /* m  faces that the scene gives */
    double farthest[3];           /* m  limit of coordinates, from the unit of length */
    double list_length[DEM_CELL_LISTS][3], list_offset[DEM_CELL_LISTS];    /* m  when the lists were made */
    double flow[3], shear_flow;   /* 1/s  D of the last step */
    double strain;                /* 1    of the shear since the start */
    double rate[3], integral[3];  /* 1/s, Pa  of held axes: D until the next measurement, H */
    double backup[4][3];          /* length, rate, integral; offset and strain of the shear */
};
