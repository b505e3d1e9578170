/*
 * fluid.cl -- a particle in a fluid: what its laws read, the kick with drag, and the impulses that are
 * passed to the fluid. step/sweep_bodies.c has the formulas, and the same operations in the same
 * order.
 *
 * The host defines COLUMN_<NAME>, the place of each column of the scene (device_columns.c), and
 * WHOLE_DRAG.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fluid/drag.h"

#define SCALAR(name) columns[(size_t)(COLUMN_##name)*n + i]
#define VECTOR(name, k) columns[(size_t)(COLUMN_##name)*n + 3*(size_t)i + (k)]
#define LOAD_VECTOR(name, x, y, z)                                                             \
    do                                                                                         \
    {                                                                                          \
        r->x = VECTOR(name, 0);                                                                \
        r->y = VECTOR(name, 1);                                                                \
        r->z = VECTOR(name, 2);                                                                \
    } while (0)

/* What the laws read; forces begin with the contacts' and the impulse carried over. */
static void dem_fluid_begin(global const double *restrict columns, uint n, uint i,
                            double over_window, struct dem_body_row *r)
{
    r->sphericity = r->crosswise = r->lengthwise = 1.0;
    r->volume = 4.0/3.0*3.14159265358979323846*r->radius*r->radius*r->radius;
    r->drag = r->drag_ux = r->drag_uy = r->drag_uz = r->rx = r->ry = r->rz = 0.0;
    r->spin_drag = r->spin_drag_wx = r->spin_drag_wy = r->spin_drag_wz = 0.0;
    LOAD_VECTOR(FLUID_VELOCITY, ux, uy, uz);
#ifdef COLUMN_OWN_WAKE
    global const double *const wake =
        columns + (size_t)COLUMN_OWN_WAKE*n + DEM_DEVICE_WAKE*(size_t)i;

    r->ux -= wake[0];
    r->uy -= wake[1];
    r->uz -= wake[2];
#endif
    LOAD_VECTOR(PRESSURE_GRADIENT, gx, gy, gz);
#ifdef COLUMN_FLUID_ACCELERATION
    LOAD_VECTOR(FLUID_ACCELERATION, ax, ay, az);
#endif
#ifdef COLUMN_VORTICITY
    LOAD_VECTOR(VORTICITY, ox, oy, oz);
#endif
#ifdef COLUMN_STRESS
    LOAD_VECTOR(STRESS, sx, sy, sz);
#endif
#ifdef COLUMN_TENSION
    LOAD_VECTOR(TENSION, tension_x, tension_y, tension_z);
    r->interface_distance = SCALAR(INTERFACE_DISTANCE);
#endif
    r->void_fraction = SCALAR(VOID_FRACTION);
    r->density = SCALAR(FLUID_DENSITY);
#ifdef COLUMN_MEAN_DIAMETER
    r->mean_diameter = SCALAR(MEAN_DIAMETER);
#endif
#ifdef COLUMN_ADDED_MASS
    r->added_mass = SCALAR(ADDED_MASS);
#endif
#ifdef COLUMN_VISCOSITY
    r->viscosity = SCALAR(VISCOSITY);
#endif
#ifdef COLUMN_VOIDAGE_FACTOR_FIRST
    r->voidage_factor[0] = SCALAR(VOIDAGE_FACTOR_FIRST);
    r->voidage_factor[1] = SCALAR(VOIDAGE_FACTOR_SECOND);
#endif
    r->fx += over_window*VECTOR(CARRIED_OVER_IMPULSE, 0);
    r->fy += over_window*VECTOR(CARRIED_OVER_IMPULSE, 1);
    r->fz += over_window*VECTOR(CARRIED_OVER_IMPULSE, 2);
}

#ifdef COLUMN_EDDY
#include "laws/fluid/eddy.h"

/* The fluid's velocity has the eddy's, which has advanced by this step (0: before); after
   dem_fluid_begin. */
static void dem_fluid_eddy(global double *columns, uint n, uint i, double dt, ulong step, ulong id,
                           struct dem_body_row *r)
{
    global double *const eddy = columns + (size_t)COLUMN_EDDY*n + 4*(size_t)i;
    global const double *const k = columns + (size_t)COLUMN_TURBULENCE*n + 2*(size_t)i;
    const double speed = dem_eddy_speed(k[0]);
    const struct dem_eddies model = {EDDIES};
    double e[4] = {eddy[0], eddy[1], eddy[2], eddy[3]};

    if (step > 0)
    {
        const double x = speed*e[0] + (VECTOR(FLUID_VELOCITY, 0) - r->vx),
                     y = speed*e[1] + (VECTOR(FLUID_VELOCITY, 1) - r->vy),
                     z = speed*e[2] + (VECTOR(FLUID_VELOCITY, 2) - r->vz);

        e[3] -= dt*dem_eddy_rate(&model, k[0], k[1], sqrt(x*x + y*y + z*z));
        if (e[3] <= 0.0)
        {
            dem_eddy_begin(&model, id, step, e);
        }
        for (int m = 0; m < 4; m++)
        {
            eddy[m] = e[m];
        }
    }
    r->ux += speed*e[0];
    r->uy += speed*e[1];
    r->uz += speed*e[2];
}
#endif

/* The kick over h of velocities; v: also 1/m. j: the impulse of drag [N s]. */
static void dem_fluid_kick(global double *restrict columns, uint n, uint i, double h,
                           struct dem_body_row *r, double4 *v, double j[3])
{
    const double4 before = *v;

#if defined(COLUMN_OWN_WAKE) && !WHOLE_DRAG
    const double factor = 1.0 + columns[(size_t)COLUMN_OWN_WAKE*n + DEM_DEVICE_WAKE*(size_t)i +
                                        DEM_DEVICE_WAKE_DRAG];

    r->drag *= factor;
    r->drag_ux *= factor;
    r->drag_uy *= factor;
    r->drag_uz *= factor;
#endif
#if WHOLE_DRAG
    const double over = 1.0/dem_drag_void_fraction(r->void_fraction);

    r->drag *= over;
    r->drag_ux *= over;
    r->drag_uy *= over;
    r->drag_uz *= over;
    r->rx *= over;
    r->ry *= over;
    r->rz *= over;
#endif
#ifdef COLUMN_OTHER_IMPULSE
    r->fx += r->rx;
    r->fy += r->ry;
    r->fz += r->rz;
#endif
    const double particle_drag = r->drag, extra = (SCALAR(SLIP_FACTOR) - 1.0)*r->drag;

    r->drag += extra;
    r->drag_ux += extra*VECTOR(START_VELOCITY, 0);
    r->drag_uy += extra*VECTOR(START_VELOCITY, 1);
    r->drag_uz += extra*VECTOR(START_VELOCITY, 2);

    const double z = r->drag*h*v->w, phi = dem_phi(z), step = phi*h*v->w;
    const double dx = r->drag_ux - r->drag*v->x, dy = r->drag_uy - r->drag*v->y,
                 dz = r->drag_uz - r->drag*v->z;

    v->x += step*(r->fx + dx);
    v->y += step*(r->fy + dy);
    v->z += step*(r->fz + dz);
    j[0] = h*(phi*dx - (1.0 - phi)*r->fx);
    j[1] = h*(phi*dy - (1.0 - phi)*r->fy);
    j[2] = h*(phi*dz - (1.0 - phi)*r->fz);
    VECTOR(DRAG_IMPULSE, 0) += j[0];
    VECTOR(DRAG_IMPULSE, 1) += j[1];
    VECTOR(DRAG_IMPULSE, 2) += j[2];
    SCALAR(DECAY_FACTOR) *= 1.0 - z*phi;
    SCALAR(DRAG_INTEGRAL) += particle_drag*h;
#ifdef COLUMN_OTHER_IMPULSE
    const double added =
#ifdef COLUMN_ADDED_MASS
        r->added_mass;
#else
        0.0;
#endif
    VECTOR(OTHER_IMPULSE, 0) += h*r->rx - added*(v->x - before.x);
    VECTOR(OTHER_IMPULSE, 1) += h*r->ry - added*(v->y - before.y);
    VECTOR(OTHER_IMPULSE, 2) += h*r->rz - added*(v->z - before.z);
#endif
}

/* A law acts on the grains of a parcel of this ratio: their sizes, and its results from zero
   (step/parcel_forces.c). A law adds to its first scalar only, as in program_scalars.c. */
static void dem_to_grains(double ratio, struct dem_body_row *r)
{
    const double per_length = 1.0/ratio, per_grain = per_length*per_length*per_length;

    r->radius *= per_length;
    r->mass *= per_grain;
    r->volume *= per_grain;
    r->mean_diameter *= per_length;
    r->fx = r->fy = r->fz = r->rx = r->ry = r->rz = 0.0;
    r->drag = r->drag_ux = r->drag_uy = r->drag_uz = 0.0;
    r->scalars[0].rate = r->scalars[0].coefficient = r->scalars[0].to_target = 0.0;
}

#define OF_GRAINS(x) r->x = parcel->x + ratio*ratio*ratio*r->x

/* Add the results of its grains to the parcel. */
static void dem_to_parcel(double ratio, const struct dem_body_row *parcel, struct dem_body_row *r)
{
    r->radius = parcel->radius;
    r->mass = parcel->mass;
    r->volume = parcel->volume;
    r->mean_diameter = parcel->mean_diameter;
    OF_GRAINS(fx);
    OF_GRAINS(fy);
    OF_GRAINS(fz);
    OF_GRAINS(rx);
    OF_GRAINS(ry);
    OF_GRAINS(rz);
    OF_GRAINS(drag);
    OF_GRAINS(drag_ux);
    OF_GRAINS(drag_uy);
    OF_GRAINS(drag_uz);
    OF_GRAINS(scalars[0].rate);
    OF_GRAINS(scalars[0].coefficient);
    OF_GRAINS(scalars[0].to_target);
}

#ifdef COLUMN_ANGULAR_IMPULSE
/* The kick of one component of the spin by the contact torque M and rotational drag, whose impulse
   [N m s] joins the sum. */
static double dem_fluid_turn(global double *restrict sum, double h, double over, double drag,
                             double target, double M, double w, double *impulse)
{
    const double z = drag*h*over, phi = dem_phi(z), step = phi*h*over, by = target - drag*w;

    *impulse = h*(phi*by - (1.0 - phi)*M);
    *sum += *impulse;
    return w + step*(M + by);
}
#endif
