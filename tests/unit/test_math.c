/*
 * test_math.c -- exp, log, pow and related functions: accuracy, traps, reproducibility.
 *
 * - Within two units in the last place; no trap.
 * - The same bits in a scalar call, in a vector loop, at any optimisation and from any compiler.
 *
 * The reference of accuracy is the C library's long double functions: with 64-bit mantissas their
 * last place is 1/2048 of a double's. The reference of bits is a stored hash over 40000 results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/math.h"
#include "core/random.h"

enum
{
    ARGUMENTS = 200000,
    ROW = 128
};

typedef double function_1(double);
typedef long double reference_1(long double);

static function_1 call_exp, call_expm1, call_phi, call_log, call_log10;

static double call_exp(double x)
{
    return dem_exp(x);
}

static double call_expm1(double x)
{
    return dem_expm1(x);
}

static double call_phi(double x)
{
    return dem_phi(x);
}

static double call_log(double x)
{
    return dem_log(x);
}

static double call_log10(double x)
{
    return dem_log10(x);
}

static long double reference_phi(long double z)
{
    return -expm1l(-z)/z;
}

/* between a and b, or with equal probability per decade */
static double between(double a, double b, uint64_t i)
{
    return a + (b - a)*dem_random_unit(6, i, 0, 0);
}

static double decades(double a, double b, uint64_t i)
{
    return exp2(between(log2(a), log2(b), i));
}

/* units in the last place of the reference, which is a normal double */
static double error_in_ulps(double value, long double exact)
{
    int exponent;

    frexpl(exact, &exponent);
    return (double)(fabsl((long double)value - exact)/ldexpl(1.0L, exponent - DBL_MANT_DIG));
}

static void accurate(const char *what, function_1 *f, reference_1 *reference,
                     double (*argument)(double, double, uint64_t),
                     double a, double b, double allowed)
{
    double worst = 0.0, at = 0.0;

    for (uint64_t i = 0; i < ARGUMENTS; i++)
    {
        const double x = argument(a, b, i);
        const double error = error_in_ulps(f(x), reference((long double)x));

        at = error > worst ? x : at;
        worst = error > worst ? error : worst;
    }
    TAP_OK(worst < allowed, "%s for x from %g to %g: %.3f ulp at %a, %g allowed", what, a, b, worst,
           at, allowed);
}

static double minus_decades(double a, double b, uint64_t i)
{
    return -decades(a, b, i);
}

/* the limit is the requirement: two units in the last place; one for exp and log near 1, the range
   of the laws */
static void accuracy(void)
{
    accurate("exp", call_exp, expl, between, -708.3, 709.7, 1.1);
    accurate("exp", call_exp, expl, between, -1.0, 1.0, 1.1);
    accurate("expm1", call_expm1, expm1l, between, -2.0, 2.0, 2.0);
    accurate("expm1", call_expm1, expm1l, between, -60.0, 709.7, 2.0);
    accurate("expm1", call_expm1, expm1l, decades, 1e-300, 1.0, 2.0);
    accurate("expm1 of minus", call_expm1, expm1l, minus_decades, 1e-300, 1.0, 2.0);
    accurate("phi", call_phi, reference_phi, decades, 1e-300, 1e300, 2.0);
    accurate("phi", call_phi, reference_phi, between, 1e-3, 10.0, 2.0);
    accurate("log", call_log, logl, decades, 1e-307, 1e307, 1.1);
    accurate("log", call_log, logl, between, 0.5, 2.0, 1.1);
    accurate("log", call_log, logl, between, 1.0 - 1e-6, 1.0 + 1e-6, 1.1);
    accurate("log10", call_log10, log10l, decades, 1e-307, 1e307, 2.1);
    accurate("log10", call_log10, log10l, between, 0.5, 2.0, 2.1);
}

/* the relative error of pow must be below 1e-14; powl's is below 1e-18 */
static void accuracy_of_pow(void)
{
    double worst = 0.0, worst_square = 0.0;

    for (uint64_t i = 0; i < ARGUMENTS; i++)
    {
        const double x = decades(1e-12, 1e12, i), y = 24.0*dem_random_unit(6, i, 0, 1) - 12.0;
        const long double exact = powl((long double)x, (long double)y);
        const double error = (double)fabsl(((long double)dem_pow(x, y) - exact)/exact);
        const double square = error_in_ulps(dem_pow(x, 2.0), (long double)x*(long double)x);

        worst = error > worst ? error : worst;
        worst_square = square > worst_square ? square : worst_square;
    }
    TAP_OK(worst < 1e-14,
           "pow for x from 1e-12 to 1e12, |y| to 12: relative error %.2e, 1e-14 allowed", worst);
    TAP_OK(worst_square < 2.0, "pow(x, 2) is x x: %.3f ulp, 2 allowed", worst_square);
}

static void edges(void)
{
    TAP_OK(dem_exp(0.0) == 1.0 && dem_exp(-0.0) == 1.0, "e^0 is 1");
    TAP_OK(dem_exp(-708.5) == 0.0 && dem_exp(-1e300) == 0.0 && dem_exp(-DBL_MAX) == 0.0,
           "e^-large is 0");
    TAP_OK(isinf(dem_exp(709.8)) && isinf(dem_exp(DBL_MAX)),
           "e^large is infinite without an overflow");
    TAP_OK(dem_expm1(0.0) == 0.0 && dem_expm1(-1e300) == -1.0 && dem_expm1(-40.0) == -1.0
           && isinf(dem_expm1(710.0)),
           "e^x - 1 at 0, -large and large");
    TAP_OK(dem_expm1(-1e-20) == -1e-20 && dem_expm1(1e-300) == 1e-300, "e^x - 1 of tiny x is x");
    TAP_OK(dem_phi(0.0) == 1.0 && dem_phi(0x1p-1074) == 1.0 && dem_phi(1e-17) == 1.0,
           "phi is 1 at and near 0");
    TAP_OK(dem_phi(1e300) == 1e-300 && dem_phi(64.0) == 0x1p-6, "phi of large z is 1/z");
    TAP_OK(dem_log(1.0) == 0.0 && dem_log10(1.0) == 0.0, "ln 1 is 0");
    TAP_OK(isinf(dem_log(0.0)) && dem_log(0.0) < 0.0 && isinf(dem_log10(-0.0)),
           "ln 0 is -infinite, no division by zero");
    TAP_OK(isnan(dem_log(-1.0)) && isnan(dem_log10(-1e300)), "ln of a negative is not a number");
    /* one ulp of 744 */
    TAP_NEAR(dem_log(0x1p-1074), -1074.0*0x1.62e42fefa39efp-1, 0x1p-43,
             "ln of the smallest double");
    TAP_OK(isinf(dem_log(INFINITY)) && isinf(dem_exp(INFINITY)) && dem_exp(-INFINITY) == 0.0,
           "infinities are passed on");
}

static void edges_of_pow(void)
{
    int ones = 1;

    for (uint64_t i = 0; i < 1000; i++)
    {
        const double x = decades(1e-300, 1e300, i);

        ones &= dem_pow(x, 0.0) == 1.0 && dem_pow(1.0, 1e3*dem_log(x)) == 1.0;
    }
    TAP_OK(ones, "x^0 and 1^y are 1 exactly");
    TAP_OK(dem_pow(0.0, 0.5) == 0.0 && dem_pow(-0.0, 1e300) == 0.0 && dem_pow(0.0, 1e-300) == 0.0,
           "0^y is 0 for y > 0");
    TAP_OK(isinf(dem_pow(0.0, -1.0)) && dem_pow(0.0, 0.0) == 1.0, "0^-1 is infinite, 0^0 is 1");
    TAP_OK(isnan(dem_pow(-1.0, 0.5)) && isnan(dem_pow(-1e300, 2.0)),
           "a negative base is not a number");
    TAP_OK(dem_pow(10.0, -400.0) == 0.0 && isinf(dem_pow(10.0, 400.0)),
           "underflow is 0, overflow infinite");
    TAP_OK(dem_pow(DBL_MAX, -DBL_MAX) == 0.0
           && isinf(dem_pow(0x1p-1074, -DBL_MAX)) && dem_pow(1.0, DBL_MAX) == 1.0,
           "at the limits of double");
    TAP_OK(dem_pow(2.0, 10.0) == 1024.0 && dem_pow(4.0, 0.5) == 2.0 &&
               dem_pow(0x1p-100, 3.0) == 0x1p-300,
           "powers of two are exact");
}

/* comparing a not-a-number raises invalid, so traps are off here; all bits of its payload are
   tested */
static void not_numbers(void)
{
    fenv_t traps;
    int numbers = 0;

    feholdexcept(&traps);
    for (int i = 0; i < 52; i++)
    {
        const volatile double nan =
            dem_math_from_bits(UINT64_C(0x7ff8000000000000) | UINT64_C(1) << i);

        numbers += !isnan(dem_exp(nan)) + !isnan(dem_expm1(nan)) + !isnan(dem_phi(nan)) +
                   !isnan(dem_log(nan)) + !isnan(dem_log10(nan)) + !isnan(dem_pow(nan, 2.0)) +
                   !isnan(dem_pow(2.0, nan)) + !isnan(dem_pow(0.0, nan));
    }
    fesetenv(&traps);
    TAP_OK(numbers == 0, "no function returns a number for a not-a-number, %d did", numbers);
}

static uint64_t hash_in(uint64_t hash, double value)
{
    return dem_random_mix(hash ^ dem_math_bits(value));
}

/* arguments from integer operations only, so that the hash depends on the functions alone */
static void same_bits_everywhere(void)
{
    uint64_t hash = 0;

    for (uint64_t i = 0; i < 8000; i++)
    {
        const double u = dem_random_unit(7, i, 0, 0), v = dem_random_unit(7, i, 0, 1);
        const double x = 1400.0*u - 700.0, small = 4.0*u - 2.0, positive = 1e-3 + 1e3*v*v*v;

        hash = hash_in(hash, dem_exp(x));
        hash = hash_in(hash, dem_expm1(small));
        hash = hash_in(hash, dem_phi(40.0*v));
        hash = hash_in(hash, dem_log(positive) + dem_log10(positive));
        hash = hash_in(hash, dem_pow(positive, 12.0*small));
    }
    TAP_OK(hash == UINT64_C(0x56aff08c6ec9270e), "bits of 40000 results: hash %016llx",
           (unsigned long long)hash);
}

/* one binary, code for several machines, where the compiler can do that */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define KERNEL __attribute__((noinline, target_clones("default", "arch=x86-64-v3")))
#else
#define KERNEL __attribute__((noinline))
#endif

KERNEL
static void loops(const double *restrict x, const double *restrict y, double (*restrict out)[ROW])
{
    for (int i = 0; i < ROW; i++)
    {
        out[0][i] = dem_exp(y[i]);
    }
    for (int i = 0; i < ROW; i++)
    {
        out[1][i] = dem_expm1(y[i]);
    }
    for (int i = 0; i < ROW; i++)
    {
        out[2][i] = dem_phi(x[i]);
    }
    for (int i = 0; i < ROW; i++)
    {
        out[3][i] = dem_log(x[i]);
    }
    for (int i = 0; i < ROW; i++)
    {
        out[4][i] = dem_log10(x[i]);
    }
    for (int i = 0; i < ROW; i++)
    {
        out[5][i] = dem_pow(x[i], y[i]);
    }
}

static int same(double a, double b)
{
    return dem_math_bits(a) == dem_math_bits(b);
}

static void loops_equal_calls(void)
{
    function_1 *volatile f[5] = {call_exp, call_expm1, call_phi, call_log, call_log10};
    double x[ROW], y[ROW], out[6][ROW];
    int bad = 0;

    for (uint64_t row = 0; row < 100; row++)
    {
        for (uint64_t i = 0; i < ROW; i++)
        {
            x[i] = decades(1e-12, 1e12, ROW*row + i);
            y[i] = between(-30.0, 30.0, ROW*row + i + 1000000);
        }
        loops(x, y, out);
        for (int i = 0; i < ROW; i++)
        {
            for (int n = 0; n < 5; n++)
            {
                bad += !same(out[n][i], f[n](n < 2 ? y[i] : x[i]));
            }
            bad += !same(out[5][i], dem_pow(x[i], y[i]));
        }
    }
    TAP_OK(bad == 0, "loops over rows of %d give the bits of single calls, %d differ", ROW, bad);
}

int main(void)
{
    TAP_TRAPS;
    accuracy();
    accuracy_of_pow();
    edges();
    edges_of_pow();
    not_numbers();
    same_bits_everywhere();
    loops_equal_calls();
    TAP_OK(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW),
           "no floating-point exception is left");
    TAP_DONE;
}
