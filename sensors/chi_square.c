/* SPDX-License-Identifier: MIT */
#include "sensors/chi_square.h"
#include "core/earth.h"
#include <float.h>
#include <math.h>

enum { STEPS_MAX = 1000000 };

/* u - ln(1 + u), without cancellation near 0: with z = u/(2 + u), ln(1 + u) = 2 (z + z^3/3 + ...) and
 * u - 2z = u z. */
static double excess(double u)
{
    if (fabs(u) > 0.3) return u - log1p(u);
    const double z = u / (2.0 + u);
    double sum = 0.0, power = z * z * z;
    for (int k = 3; k < 41; k += 2, power *= z * z) sum += power / k;
    return u * z - 2.0 * sum;
}

/* x^a e^-x/Gamma(a). For large a the three factors are huge: Stirling's series, its error below
 * 1e-15 for a > 12, and the exponent in the form that is small near x = a. */
static double density(double a, double x)
{
    if (a <= 12.0) return exp(a * log(x) - x - lgamma(a));
    const double b = 1.0 / (a * a);
    const double stirling = (1.0 / 12.0 - b * (1.0 / 360.0 - b * (1.0 / 1260.0 - b / 1680.0))) / a;
    return sqrt(a / (2.0 * SCHULER_PI)) * exp(-a * excess(x / a - 1.0) - stirling);
}

/* P(a, x) by its power series, good for x < a + 1. */
static double lower_series(double a, double x)
{
    double term = 1.0 / a, sum = term;
    for (int k = 1; k < STEPS_MAX && term > 0.25 * DBL_EPSILON * sum; k++) {
        term *= x / (a + k);
        sum += term;
    }
    return sum * density(a, x);
}

/* Q(a, x) by its continued fraction (modified Lentz), good for x > a + 1. */
static double upper_fraction(double a, double x)
{
    double b = x + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
    for (int k = 1; k < STEPS_MAX; k++) {
        const double numerator = -k * (k - a);
        b += 2.0;
        d = numerator * d + b;
        c = b + numerator / c;
        if (fabs(d) < 1e-300) d = 1e-300;
        if (fabs(c) < 1e-300) c = 1e-300;
        d = 1.0 / d;
        h *= c * d;
        if (fabs(c * d - 1.0) < DBL_EPSILON) break;
    }
    return h * density(a, x);
}

double schuler_chi_square_probability(double dof, double x, int upper)
{
    const double a = 0.5 * dof, y = 0.5 * x;
    if (!(y > 0.0)) return upper ? 1.0 : 0.0;
    if (!(y < HUGE_VAL)) return upper ? 0.0 : 1.0;
    const int series = y < a + 1.0;
    const double part = series ? lower_series(a, y) : upper_fraction(a, y);
    return series != upper ? part : 1.0 - part;
}

/* E. B. Wilson, M. M. Hilferty: the cube root is nearly normal. Only a start, so a rough normal
 * quantile (A. & S. 26.2.23) is enough. */
static double first_guess(double dof, double p)
{
    const double tail = p < 0.5 ? p : 1.0 - p, t = sqrt(-2.0 * log(tail));
    const double size = t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                                (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    const double z = p < 0.5 ? -size : size, k = 2.0 / (9.0 * dof);
    const double root = 1.0 - k + z * sqrt(k);
    const double x = dof * root * root * root;
    if (root > 0.0 && x > 0.01 * dof) return x;
    /* the first term of the series: P = (x/2)^a/Gamma(a + 1) */
    return 2.0 * exp((log(p) + lgamma(0.5 * dof + 1.0)) / (0.5 * dof));
}

/* Newton's method on the smaller tail, in the logarithm of x (so that x stays positive) and kept
 * between bounds that are known to hold the root. */
double schuler_chi_square_quantile(double dof, double p)
{
    if (!(dof > 0.0) || !(p > 0.0) || !(p < 1.0)) return NAN;
    const int upper = p > 0.5;
    const double wanted = upper ? 1.0 - p : p;
    double low = 0.0, high = HUGE_VAL, x = first_guess(dof, p);
    for (int k = 0; k < 200 && x > 0.0; k++) {
        const double off = schuler_chi_square_probability(dof, x, upper) - wanted;
        if (upper ? off < 0.0 : off > 0.0)
            high = x;
        else
            low = x;
        /* d P/d ln x is the density times x: the function density() itself. */
        const double slope = density(0.5 * dof, 0.5 * x), step = off / slope;
        double next = x * exp(fmax(-2.0, fmin(2.0, upper ? step : -step)));
        if (!(next > low && next < high)) next = high < HUGE_VAL ? 0.5 * (low + high) : 2.0 * x;
        if (fabs(next - x) <= 1e-14 * x) return next;
        x = next;
    }
    return x;
}
