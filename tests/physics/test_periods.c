/* SPDX-License-Identifier: MIT */
/* The periods of a navigator's errors, read off the simulation: Schuler, Foucault, a sidereal day.
 *
 * With z = north + i east the level channels are z'' = -ws^2 z + 2 i s z', s = W sin(lat), so that z holds two
 * lines at s +- sqrt(ws^2 + s^2): half their sum is the Foucault rate, half their difference the Schuler
 * frequency, whose ws is row E1b's (reference, error propagation). R_M and R_P differ, so the axes' own
 * frequencies are 2 d apart; the mean is kept and the split becomes sqrt(s^2 + d^2), 2e-4 more.
 */
#include "core/earth.h"
#include "mission.h"

static const char mission[] =
    "scenario: periods\nruns: 1\n"
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m}, for: %s}\n"
    "report: {every: %s}\n"
    "imu: {rate: 1 Hz, accel: {model: linear}, gyro: {model: linear}}\n"
    "initial: {%s}\n";

static mission_trace errors_of(const char *duration, const char *every, const char *initial,
                               const char *source)
{
    char text[1024];
    snprintf(text, sizeof text, mission, duration, every, initial);
    schuler_scenario *s = mission_text(text);
    const mission_trace t = mission_errors(s, source);
    schuler_scenario_free(s);
    return t;
}

/* Size of the part of z that turns with w, through a Hann window to the fourth, whose side lobes fall with the
 * fifth power: lines eighty of its widths away do not count. */
static double line(const mission_trace *t, double w)
{
    double real = 0.0, imaginary = 0.0;
    const double T_s = t->rows[t->count - 1].time_s;
    for (size_t i = 0; i < t->count; i++) {
        const double time_s = t->rows[i].time_s, x = w * time_s;
        const double window = pow(sin(SCHULER_PI * time_s / T_s), 4.0);
        const double north = t->rows[i].r_n[0], east = t->rows[i].r_n[1];
        real += window * (north * cos(x) + east * sin(x));
        imaginary += window * (east * cos(x) - north * sin(x));
    }
    return hypot(real, imaginary);
}

typedef double objective(const mission_trace *t, double w);

/* Golden-section search for a maximum. */
static double highest(objective *f, const mission_trace *t, double low, double high)
{
    const double golden = 0.5 * (sqrt(5.0) - 1.0);
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double f_a = f(t, a), f_b = f(t, b);
    for (int i = 0; i < 40; i++)
        if (f_a > f_b) {
            high = b, b = a, f_b = f_a;
            a = high - golden * (high - low), f_a = f(t, a);
        } else {
            low = a, a = b, f_a = f_b;
            b = low + golden * (high - low), f_b = f(t, b);
        }
    return 0.5 * (low + high);
}

static void schuler_and_foucault_periods_are_those_of_the_reference(void **state)
{
    (void)state;
    const double ws = 0.00123995129568463, s = SCHULER_OMEGA_IE_RADPS * sin(SCHULER_PI / 4.0);
    CHECK_REL(2.0 * SCHULER_PI / ws, 5067.28395627055, 1e-13);         /* E1b */
    CHECK_REL(2.0 * SCHULER_PI / s / 3600.0, 33.8484554752204, 1e-13); /* E2  */
    mission_trace t =
        errors_of("60 h", "2 min", "velocity: [0.1 m/s, 0 m/s, 0 m/s]", "initial.velocity");
    const double split = 2.0 * SCHULER_PI / t.rows[t.count - 1].time_s;
    const double fast = highest(line, &t, s + ws - split, s + ws + split);
    const double slow = highest(line, &t, s - ws - split, s - ws + split);
    print_message("Schuler %.3f s, expected %.3f s; Foucault %.4f h, expected %.4f h\n",
                  4.0 * SCHULER_PI / (fast - slow), 2.0 * SCHULER_PI / hypot(ws, s),
                  4.0 * SCHULER_PI / (fast + slow) / 3600.0, 2.0 * SCHULER_PI / s / 3600.0);
    /* g of the whole ellipsoid against gamma/R: the gradient of gravity along the meridian counts as in
     * the test of the equator, 1e-5. d^2 itself is known to its own next order, s^2/ws^2 = 2e-3. */
    const double lat_rad = SCHULER_PI / 4.0, radii = sqrt(schuler_earth_transverse_radius(lat_rad) /
                                                          schuler_earth_meridian_radius(lat_rad));
    const double d = 0.5 * ws * (sqrt(radii) - 1.0 / sqrt(radii));
    CHECK_REL(0.5 * (fast - slow), hypot(ws, s), 1e-5);
    CHECK_REL(0.5 * (fast + slow), hypot(s, d), 1e-5);
    free(t.rows);
}

/* How well a constant, a line at w and the two of Schuler explain the error north: minus the squares that are
 * left by linear least squares. */
static double day(const mission_trace *t, double w)
{
    enum { N = 7 };
    const double ws = 0.00123995129568463, s = SCHULER_OMEGA_IE_RADPS * sin(SCHULER_PI / 4.0);
    const double up = hypot(ws, s) + s, down = hypot(ws, s) - s;
    double A[N][N + 1] = { { 0 } }, squares = 0.0;
    for (size_t i = 0; i < t->count; i++) {
        const double x = t->rows[i].time_s, y = t->rows[i].r_n[0];
        const double base[N] = { 1.0,         cos(w * x),    sin(w * x),   cos(up * x),
                                 sin(up * x), cos(down * x), sin(down * x) };
        for (int r = 0; r < N; r++) {
            for (int c = 0; c < N; c++) A[r][c] += base[r] * base[c];
            A[r][N] += base[r] * y;
        }
        squares += y * y;
    }
    double b[N];
    for (int r = 0; r < N; r++) b[r] = A[r][N];
    for (int p = 0; p < N; p++)
        for (int r = 0; r < N; r++) {
            if (r == p) continue;
            const double k = A[r][p] / A[p][p];
            for (int c = p; c <= N; c++) A[r][c] -= k * A[p][c];
        }
    for (int r = 0; r < N; r++) squares -= b[r] * A[r][N] / A[r][r];
    return -squares;
}

/* psi stands still among the stars, so the earth sees it turn once a sidereal day: exactly, but for terms of
 * second order in the heading error of 1e-5 rad. What is not in the fit, harmonics and 1e-5 of the Schuler
 * lines' frequencies, changes the rate by less than 1e-4. */
static void a_heading_error_swings_once_a_sidereal_day(void **state)
{
    (void)state;
    const double W = SCHULER_OMEGA_IE_RADPS;
    CHECK_REL(2.0 * SCHULER_PI / W / 3600.0, 23.9344723992193, 1e-13); /* E2 */
    mission_trace t = errors_of("96 h", "5 min", "heading: 0.01 mrad", "initial.heading");
    const double w = highest(day, &t, 0.9 * W, 1.1 * W);
    print_message("earth-rate mode %.4f h, expected %.4f h\n", 2.0 * SCHULER_PI / w / 3600.0,
                  2.0 * SCHULER_PI / W / 3600.0);
    CHECK_REL(w, W, 1e-4);
    free(t.rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(schuler_and_foucault_periods_are_those_of_the_reference),
        cmocka_unit_test(a_heading_error_swings_once_a_sidereal_day),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
