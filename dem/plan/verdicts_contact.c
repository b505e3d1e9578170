/*
 * verdicts_contact.c -- which effects of contacts a scene needs. Needed: more than 1 % of what they act on, where nothing else is said.
 *
 *   hertz             off, and solids fill more than 0.1 % of the room: spheres meet                   Elghobashi, Appl. Sci. Res. 52 (1994) 309
 *   jkr               the pull 3/2 pi w R* over the weight, or what a contact loses, 7.09 (w^5 R*^4/E*^2)^(1/3), over m* v^2/2
 *                                                                                          Johnson, Kendall, Roberts 1971; Thornton and Ning 1998
 *                     off, in a gas or dry: the pull 3/2 pi w r of asperities of r = 0.1 um with w = 0.05 J/m2 over the weight. An order of
 *                     magnitude, so called for from the weight itself on: 0.12 mm for glass, below which lie groups A and C of Geldart
 *                                                                                          Seville, Willett, Knight, Powder Technol. 113 (2000) 261
 *   sjkr              its largest pull 2/3 pi^3 w^3 (R* over E*)^2 (with hertz) over the weight, or its share 3/2 pi w sqrt(R* / d)/E* of the force of
 *                     an impact at overlap d: F = 4/3 E* sqrt(R*) d^(3/2) - 2 pi w R* d
 *   hookeHysteresis   energy that the first impact loses to yielding, 1 - k/k_2                         Walton and Braun 1986; Luding 2008
 *                     off, and a material tells its yield strength: 1 - e^2 of an impact at v above v_y, less what damping takes,
 *                     e^2 = (6 sqrt3/5) (1 - s^2/6) sqrt(s/(s + 2 sqrt(6/5 - s^2/5))), s = v_y/v        Thornton, J. Appl. Mech. 64 (1997) 383
 *   rollingConstant, rollingSpring   mu_r/mu: of the moment that friction can make, R* mu F_n          Ai, Chen, Rotter, Ooi 2011
 *   rollingViscous    A v/(R mu), of a sphere that rolls at v                                           Brilliantov and Poeschel 1998
 *   twistingSpring    its largest moment over R* mu F_n: 3 pi/16 sqrt(d/R*) mu_t/mu at the overlap d of an impact, or mu_t/mu      Marshall 2009
 *
 * Off, nothing is said of what surfaces and shapes are like, which the scene does not hold: restitution, friction, rolling and twisting
 * resistance, surface energy in a liquid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/regime.h"
#include <math.h>
#include <stddef.h>

static const double matters = 0.01, pi = 3.14159265358979323846;

static void judge_normal(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;

    if (r->chosen == 0 || r->effect[0]->stage != DEM_STAGE_NORMAL)
    {
        dem_judge(p, "hertz", p->survey.all.n > 1 ? g->phi : 0.0, 1e-3, "of the room is full of spheres, that meet from 0.1 % on (Elghobashi 1994)");
    }
}

/* ---- adhesion --------------------------------------------------------------------------------------------------- */

static void judge_jkr(struct dem_plan *p, const struct dem_regime *g)
{
    const double w = dem_regime_number(p, "jkr", "workOfAdhesion"), energy = 0.5*g->mass*g->speed*g->speed;
    const double loss = 7.09*cbrt(pow(w, 5.0)*pow(g->radius, 4.0)/(g->modulus*g->modulus));
    const double pull = g->weight > 0.0 ? 1.5*pi*w*g->radius/g->weight : 0.0;

    dem_judge(p, "jkr", fmax(pull, energy > 0.0 ? loss/energy : 0.0), matters, "of a particle's weight, or of an impact's energy, is adhesion's "
              "(Johnson, Kendall, Roberts 1971; Thornton and Ning 1998)");
}

static void judge_sjkr(struct dem_plan *p, const struct dem_regime *g)
{
    const double w = dem_regime_number(p, "sjkr", "energyDensity");
    const double pull = 2.0/3.0*pow(pi*w, 3.0)*g->radius*g->radius/(g->modulus*g->modulus);
    const double share = g->overlap > 0.0 ? 1.5*pi*w/(g->modulus*sqrt(g->overlap)) : 0.0;

    dem_judge(p, "sjkr", fmax(share, g->weight > 0.0 ? pull/g->weight : 0.0), matters,
              "of an impact's force, or of a particle's weight, is cohesion's (the law itself)");
}

static void judge_adhesion(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const double usual = 0.05, asperity = 1e-7;           /* J/m2, m */
    const int cohesive = dem_recipe_acts(r, "bondLinear") || dem_regime_number(p, "hookeHysteresis", "adhesion") > 0.0;

    if (dem_recipe_acts(r, "jkr"))
    {
        judge_jkr(p, g);
    }
    else if (dem_recipe_acts(r, "sjkr"))
    {
        judge_sjkr(p, g);
    }
    else if (g->weight > 0.0 && dem_recipe_acts(r, "hertz") && !cohesive && (!g->fluid || g->bed.density > 100.0*g->bed.fluid_density))
    {
        struct dem_verdict *const v = dem_judge(p, "jkr", 1.5*pi*usual*asperity/g->weight, 1.0, "of the weight is the pull of asperities of 0.1 um "
                                                "with 0.05 J/m2 (Seville, Willett, Knight 2000)");

        if (v)
        {
            v->lacks = "workOfAdhesion, of rough surfaces less than of smooth ones by the ratio of asperity and sphere";
        }
    }
}

/* ---- yielding --------------------------------------------------------------------------------------------------- */

/* Largest overlap of the first impact in units of d_lim: k d^2/2 = m v^2/2 with the spring that overlaps as with hertz. */
static double yielded(const struct dem_plan *p, const struct dem_regime *g)
{
    const double k = dem_regime_number(p, "hookeHysteresis", "stiffness"), depth = dem_regime_number(p, "hookeHysteresis", "plasticDepth");
    const double times = dem_regime_number(p, "hookeHysteresis", "unloading"), limit = times > 1.0 ? times/(times - 1.0)*2.0*depth : 0.0;
    const double d = k > 0.0 ? g->speed*sqrt(g->mass/k)/g->radius : g->overlap;

    return limit > 0.0 ? 1.0 + (times - 1.0)*fmin(1.0, d/limit) : 1.0;          /* k_2/k */
}

static double restitution(const struct dem_plan *p)
{
    const double dry = dem_regime_number(p, "dry", "restitution"), stokes = dem_regime_number(p, "stokes", "restitution");

    return isfinite(dry) ? dry : isfinite(stokes) ? stokes : dem_recipe_acts(&p->parts->recipe, "viscous") ? 0.0 : 1.0;
}

static void judge_yield(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;

    if (dem_recipe_acts(r, "hookeHysteresis"))
    {
        dem_judge(p, "hookeHysteresis", 1.0 - 1.0/yielded(p, g), matters, "of an impact's energy goes into yielding (Walton and Braun 1986)");
    }
    else if (g->yields > 0.0 && g->speed > g->yields)
    {
        const double s = g->yields/g->speed, e = restitution(p);
        const double rebounds = 1.2*sqrt(3.0)*(1.0 - s*s/6.0)*sqrt(s/(s + 2.0*sqrt(1.2 - 0.2*s*s)));
        struct dem_verdict *const v = dem_judge(p, "hookeHysteresis", e*e - rebounds, matters, "of an impact's energy goes into yielding, besides "
                                                "what damping takes (Thornton 1997)");

        if (v)
        {
            v->instead_of = r->effect[0]->name;
            v->lacks = "unloading and plasticDepth, or damping the restitution of what yields";
        }
    }
}

/* ---- rolling, twisting ------------------------------------------------------------------------------------------ */

static void judge_rolling(struct dem_plan *p, const struct dem_regime *g)
{
    static const char *const law[] = {"rollingConstant", "rollingSpring"};
    const double mu = g->friction, time = dem_regime_number(p, "rollingViscous", "time");

    for (int k = 0; k < 2; k++)
    {
        const double rolling = dem_regime_number(p, law[k], "friction");

        dem_judge(p, law[k], isfinite(rolling) && mu > 0.0 ? rolling/mu : 0.0, matters, mu > 0.0 ? "of the moment of friction resists rolling "
                  "(Ai, Chen, Rotter, Ooi 2011)" : "of what friction turns: there is none (Ai, Chen, Rotter, Ooi 2011)");
    }
    dem_judge(p, "rollingViscous", isfinite(time) && mu > 0.0 ? time*g->speed/(2.0*g->radius*mu) : 0.0, matters,
              "of the moment of friction resists rolling (Brilliantov and Poeschel 1998)");
}

static void judge_twisting(struct dem_plan *p, const struct dem_regime *g)
{
    const struct dem_recipe *const r = &p->parts->recipe;
    const double mu = dem_regime_number(p, "twistingSpring", "friction");
    const double lever = dem_recipe_word(r, "twistingSpring", "lever", "reduced") == 1 ? 1.0 : 3.0*pi/16.0*sqrt(g->overlap);

    if (isfinite(mu))
    {
        dem_judge(p, "twistingSpring", lever*mu/(g->friction > 0.0 ? g->friction : 1.0), matters,
                  "of the moment of friction resists twisting (Marshall 2009)");
    }
}

void dem_judge_contacts(struct dem_plan *p, const struct dem_regime *g)
{
    judge_normal(p, g);
    if (g->modulus > 0.0)
    {
        judge_adhesion(p, g);
        judge_yield(p, g);
        judge_rolling(p, g);
        judge_twisting(p, g);
    }
}
