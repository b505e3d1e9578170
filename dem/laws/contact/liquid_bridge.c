/*
 * liquid_bridge.c -- liquid bridges between wet particles, and between wet particles and walls.
 *
 *   F_n = -2 pi R g cos(theta) X(H) - (3/2) pi mu R^2 X(h)^2/h v_n
 *   F_t = -6 pi mu R* (8/15 ln(R* over h) + 0.9588) v_t
 *   X(x) = 1 - x/sqrt(x^2 + 2 V/(pi R))        h = max(H, h_r)
 *
 *   H      gap between the surfaces; 0 in contact                  [m]
 *   V      volume of the bridge, fixed while it lasts (history)    [m3]
 *   R, R*  mean radius of Derjaguin 2 R*, reduced radius; R* = R_i at a wall      [m]
 *   g      surface tension                                         [N/m]
 *   theta  contact angle                                           [degree]
 *   mu     viscosity of the liquid                                 [Pa s]
 *   h_r    roughness: the smallest film thickness of the viscous force            [m]
 *   v_n, v_t  normal relative velocity, slip of the surfaces       [m/s]
 *
 * A bridge forms when surfaces touch, of what both partners hold on the cap that faces the other,
 * as seen from the centre:
 *
 *   V = f_i L_i + f_j L_j,    f_i = (1 - sqrt(1 - (R_j/(R_i + R_j))^2))/2
 *
 * L is the particle scalar liquidVolume, the liquid on a particle that is in no bridge. At a wall f
 * is 0.067, as for an equal sphere, and the wall gives nothing. Caps that face spheres which do
 * not overlap are disjoint, so bridges that form together take no more than there is; later ones
 * take their part of the rest. V is at most maxVolume R_min^3: what is more stays on the particles.
 * A bridge breaks when H reaches (1 + theta/2) V^(1/3), theta in rad. Each partner then gets V/2, a
 * particle at a wall all of it. Liquid is thus kept to rounding.
 *
 * Energy: the capillary force has the potential 2 pi R g cos(theta) (H - sqrt(H^2 + 2 V/(pi R))),
 * here zero at rupture. What a bridge gains when it forms, the work needed to break it, is counted
 * as lost at that moment: the loss of one loop of approach and separation.
 *
 * The viscous damper is limited to m* / (4 dt), the damper of slip to 2/7 of it, as in lubrication.c,
 * which also says why the viscous force rests while surfaces touch. With the largest step,
 * 0.2 m* / c at h_r, the limiters are never active.
 *
 * Source: capillary force: Rabinovich, Esayanur, Moudgil, Langmuir 21 (2005) 10992, without its
 * term of the wetted cap; viscous: Pitois, Moucheront, Chateau, J. Colloid Interface Sci. 231
 * (2000) 26, and Goldman, Cox, Brenner, Chem. Eng. Sci. 22 (1967) 637; rupture: Lian, Thornton,
 * Adams, J. Colloid Interface Sci. 161 (1993) 138; volume: Shi, McCarthy, Powder Technol. 184 (2008)
 * 64.
 * Not here: weight of the liquid, flow of liquid between bridges, bridges that merge, later rupture
 * at speed, evaporation. A bridge ends, too, where another facet of a wall takes over the contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/row.h"
#include <stdio.h>

struct bridge
{
    double tension, contact_angle, viscosity, roughness, max_volume, min_volume;
    int contact;
    double pull;       /* N/m  2 pi g cos(theta) */
    double extent;     /* 1    1 + theta/2 */
    double wall;       /* 1    1 at a wall, else 0 */
};

enum
{
    ACTS,
    RESTS
};
static const char *const contacts[] = {"acts", "rests", NULL};

static const double pi = 3.14159265358979324;

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(bridge, tension, "surfaceTension", "N/m", DEM_SETTING_REQUIRED, 0.0, INFINITY,
                   "of the liquid; water in air: 0.072"),
    DEM_SETTING_AS(bridge, contact_angle, "contactAngle", "degree", 0.0, 0.0, 60.0,
                   "between liquid and solid; the rupture distance is fitted up to 60 degrees"),
    DEM_SETTING(bridge, viscosity, "Pa s", 0.0, 0.0, INFINITY,
                "of the liquid; 0: no viscous force"),
    DEM_SETTING(bridge, roughness, "m", 0.0, 0.0, INFINITY,
                "height of the asperities: the thinnest film; viscosity needs it"),
    DEM_SETTING_AS(bridge, max_volume, "maxVolume", "1", 0.05, DEM_ABOVE_ZERO, 0.1,
                   "largest volume of a bridge over R^3 of the smaller particle; a larger one "
                   "widens the pair search"),
    DEM_SETTING_AS(bridge, min_volume, "minVolume", "m3", 0.0, 0.0, INFINITY,
                   "smaller bridges do not form"),
    DEM_SETTING_CHOICE(bridge, contact, "contact", RESTS, contacts,
                       "whether the viscous force acts while surfaces touch"),
    {0},
};

static const char *const history_names[] = {"bridge_volume", NULL};

static const struct dem_scalar liquid = {
    .name = "liquidVolume",
    .unit = "m3",
    .default_value = 0.0,
    .min = 0.0,
    .max = 1e9,
    .help = "volume of the liquid on a particle that is in no bridge",
    .flags = DEM_SCALAR_PARTNERS | DEM_SCALAR_RATE | DEM_SCALAR_WRITTEN | DEM_SCALAR_AMOUNT,
};

static const struct dem_scalar *const scalars[] = {&liquid, NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct bridge *const l = of;
    const double angle = l->contact_angle*(pi/180.0);

    DEM_REQUIRE(l->viscosity == 0.0 || l->roughness > 0.0, DEM_ERROR_INPUT,
                "liquidBridge between %s and %s: viscosity %g Pa s needs roughness, the smallest "
                "film thickness, which is %g m; give it, for example 1e-3 of the radius",
                pair->a->name, pair->b->name, l->viscosity, l->roughness);
    l->pull = 2.0*pi*l->tension*cos(angle);
    l->extent = 1.0 + 0.5*angle;
    l->wall = pair->with_wall ? 1.0 : 0.0;
    return DEM_OK;
}

/* Rupture distance of the largest bridge. */
static double reach(const void *of, const struct dem_pair_class *pair)
{
    const struct bridge *const l = of;
    const double R = pair->with_wall ? pair->max_radius_sum : 0.5*pair->max_radius_sum;

    return l->extent*cbrt(l->max_volume)*R;
}

/* kg/s: of slip, over 6 pi mu R* */
DEM_MATH double slip_factor(double R, double h)
{
    return 8.0/15.0*dem_log(R/h) + 0.9588;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct bridge *const l = of;
    const double R = pair->min_radius, c = 6.0*pi*l->viscosity*R;

    *why = "0.2 of the time in which the thinnest film stops a particle (liquidBridge)";
    return c > 0.0 ? 0.2*pair->min_mass/
                         (c*fmax(R/l->roughness, 3.5*slip_factor(R, l->roughness)))
                   : DBL_MAX;
}

/* ---- the force ------------------------------------------------------------------------------- */

struct capillary
{
    double force;     /* N  attraction */
    double energy;    /* J  potential, up to a constant */
};

/* At a gap, of a bridge with pull = 2 pi R g cos(theta) [N] and square = 2 V/(pi R) [m2]. */
DEM_MATH struct capillary capillary_at(double gap, double pull, double square)
{
    const double H = dem_select(gap > 0.0, gap, 0.0), overlap = H - gap,
                 root = sqrt(H*H + square);

    return (struct capillary){
        .force = pull*(1.0 - H/dem_select(root > 0.0, root, 1.0)),
        .energy = pull*(H - root - overlap),
    };
}

/* Both dampers, on forces and loss; `holds`: 1 for a bridge. */
DEM_MATH void viscous_row(const struct bridge *l, struct dem_contact_row *r, double holds,
                          double square)
{
    const double lowest = dem_select(l->contact == RESTS, 0.0, -INFINITY);
    const double R = r->reduced_radius, m = r->reduced_mass, vn = r->vn;
    const double acts = dem_select((l->viscosity > 0.0) & (r->gap > lowest), holds, 0.0);
    const double thin = dem_select(r->gap > l->roughness, r->gap, l->roughness),
                 h = dem_select(acts > 0.0, thin, 1.0),
                 X = 1.0 - h/sqrt(h*h + square), scale = acts*6.0*pi*l->viscosity*R;
    const double squeeze = scale*R*X*X/h,
                 drag = scale*slip_factor(dem_select(acts > 0.0, R, 1.0), h);
    const double limit = m/(4.0*r->max_dt), slip_limit = 2.0/7.0*limit;
    const double cn = dem_select(squeeze < limit, squeeze, limit),
                 ct = dem_select(drag < slip_limit, drag, slip_limit);
    const double some_m = dem_select(m > 0.0, m, 1.0),
                 slip = r->sx*r->sx + r->sy*r->sy + r->sz*r->sz;

    r->fn -= cn*vn;
    r->fx -= ct*r->sx;
    r->fy -= ct*r->sy;
    r->fz -= ct*r->sz;
    /* exact for an isolated pair */
    r->lost += cn*vn*vn*r->dt*(1.0 - 0.5*cn*r->dt/some_m)
               + ct*slip*r->dt*(1.0 - 1.75*ct*r->dt/some_m);
}

/* `offered`: what a bridge that forms takes [m3]; volume: of the bridge, history. */
DEM_MATH void row(const struct bridge *l, struct dem_contact_row *r, double offered, double *volume)
{
    const double R = 2.0*r->reduced_radius, pull = l->pull*R, third = 1.0/3.0;
    const double before = dem_select(volume[0] > 0.0, volume[0], 0.0);
    const double dry = dem_select(before > 0.0, 0.0, r->touching);
    /* in the first evaluation, dt = 0, no liquid can be exchanged */
    const double taken = dem_select((dry > 0.0) & (offered > l->min_volume) & (r->is_primary > 0.0)
                                    & (r->dt > 0.0), offered, 0.0);
    const double V = before + taken, rupture = l->extent*dem_pow(V, third),
                 square = 2.0*V/(pi*dem_select(R > 0.0, R, 1.0));
    const double within = dem_select((r->gap < rupture) & (r->is_primary > 0.0), 1.0, 0.0),
                 still = dem_select(r->dt > 0.0, within, 1.0),
                 holds = dem_select(V > 0.0, still, 0.0);

    const struct capillary now = capillary_at(r->gap, pull, square),
                           was = capillary_at(r->gap - r->dt*r->distance_rate, pull, square),
                           torn = capillary_at(rupture, pull, square);
    const double held = dem_select(before > 0.0, 1.0, 0.0), half_way = 0.5*r->dt*r->distance_rate;

    r->fn -= holds*now.force;
    r->stored += holds*(now.energy - torn.energy);
    /* the force jumps at the end of the drift, and has done half of its work, or missed half */
    r->lost += dem_select(holds > held, half_way*now.force - (now.energy - torn.energy),
                          dem_select(holds < held, half_way*was.force + was.energy - torn.energy,
                                     0.0));
    viscous_row(l, r, holds, square);
    volume[0] = holds*V;
}

/* ---- the liquid ------------------------------------------------------------------------------ */

/* 1: fraction of a sphere's surface that faces a partner */
DEM_MATH double facing(double own, double other)
{
    const double sum = own + other, sine = other/dem_select(sum > 0.0, sum, 1.0);

    return 0.5*(1.0 - sqrt(1.0 - sine*sine));
}

DEM_KERNEL
static void apply(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    const struct bridge l = *(const struct bridge *)of;
    const struct dem_scalar_rows film = b->scalars[0];
    const double inverse_dt = dem_contact_batch_inverse_dt(b);
    double *const volume = history[0];

    DEM_INDEPENDENT_ROWS
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        const double before = dem_select(volume[c] > 0.0, volume[c], 0.0);
        const double of_i = facing(film.radius_i[c], film.radius_j[c])*film.i[c],
                     of_j = (1.0 - l.wall)*facing(film.radius_j[c], film.radius_i[c])*film.j[c];
        const double limit = l.max_volume*r.min_radius*r.min_radius*r.min_radius, sum = of_i + of_j,
                     offered = dem_select(sum < limit, sum, limit),
                     part = offered/dem_select(sum > 0.0, sum, 1.0);
        double after = volume[c];

        row(&l, &r, offered, &after);

        /* formed: each gives its part; broken: each gets half, a particle at a wall all */
        const double formed = dem_select((before == 0.0) & (after > 0.0), inverse_dt, 0.0),
                     broken = dem_select((before > 0.0) & (after == 0.0), before*inverse_dt, 0.0);

        film.rate_i[c] += 0.5*(1.0 + l.wall)*broken - formed*part*of_i;
        film.rate_j[c] += 0.5*(1.0 - l.wall)*broken - formed*part*of_j;
        volume[c] = after;
        dem_contact_row_store(
            &r, DEM_SETS_FN | DEM_SETS_FORCE | DEM_SETS_STORED | DEM_SETS_LOST, b, c);
    }
}

/* ---- for `dem plan` -------------------------------------------------------------------------- */

/* N: at contact, 2 pi R g cos(theta), R = 2 R* */
static double pull_off(const void *of, const struct dem_regime *g)
{
    const struct bridge *const l = of;

    return 4.0*pi*g->radius*l->tension*cos(l->contact_angle*(pi/180.0));
}

static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    v->fraction = of && g->weight > 0.0 ? pull_off(of, g)/g->weight : 0.0;
    v->quantity = "of the weight is the capillary force of a bridge at contact (Rabinovich, "
                  "Esayanur, Moudgil 2005)";
    return of && g->weight > 0.0;
}

static int describe(const void *of, const struct dem_regime *g, char *line, size_t size)
{
    const double pull = pull_off(of, g);

    snprintf(line, size, "Bond number %.3g: capillary force of liquidBridge at contact over weight",
             pull/g->weight);
    return pull > 0.0 && g->weight > 0.0;
}

static int adhesive(const void *of)
{
    (void)of;
    return 1;
}

const struct dem_effect dem_liquid_bridge = {
    .name = "liquidBridge",
    .aliases = "capillary washino/capillary/viscous easo/capillary/viscous",
    .summary = "liquid bridges between wet particles: capillary and viscous force up to rupture",
    .source = "Rabinovich, Esayanur, Moudgil 2005; Pitois, Moucheront, Chateau 2000; Lian, "
              "Thornton, Adams 1993",
    .limitation = "liquidBridge does not count the weight of the liquid",
    .stage = DEM_STAGE_FILM,
    .needs = DEM_NEEDS_RADII,
    .excludes = "jkr sjkr lubrication stokesDamping",
    .example = "surfaceTension 0.072;",
    .size = sizeof(struct bridge),
    .settings = settings,
    .history = history_names,
    .scalars = scalars,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .apply = apply,
    .relevance = relevance,
    .describe = describe,
    .adhesive = adhesive,
    .mechanism = DEM_MECHANISM_ADHESION,
};
