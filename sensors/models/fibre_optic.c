/* SPDX-License-Identifier: MIT */
/* Fibre-optic gyros: the form of IEEE Std 952, with what the Sagnac phase does to the scale factor. */
#include "sensors/gyro_params.h"
#include "sensors/optics.h"
#include <math.h>

enum {
    D_F,
    EPSILON_K,
    THETA_X,
    THETA_Y,
    SCALE_RATE,
    SCALE_RATE_2,
    SCALE_RATE_3,
    TWO_PI,
    OPEN_LOOP,
    MAGNETIC,
    FIELD,
    LENGTH,
    DIAMETER,
    WAVELENGTH,
    PHASE,
};
enum { ONE, RATE, CROSS_X, CROSS_Y, POWER_2, POWER_3, POWER_4, RESET, SINE, TERMS };

static const schuler_param params[] = {
    [D_F] = GYRO_D_F,
    [EPSILON_K] = GYRO_EPSILON_K,
    [THETA_X] = GYRO_THETA_X,
    [THETA_Y] = GYRO_THETA_Y,
    [SCALE_RATE] =
        GYRO_TERM("scale_rate", 260, GYRO_PER_RATE(1), 1.0, NON_LINEAR, "0.5 ppm/(deg/s)",
                  "scale-factor error in proportion to |omega_i|", "c1 |omega_i| omega_i"),
    [SCALE_RATE_2] =
        GYRO_TERM("scale_rate_2", 261, GYRO_PER_RATE(2), 1.0, NON_LINEAR, "0.01 ppm/(deg/s)^2",
                  "scale-factor error in proportion to omega_i^2", "c2 omega_i^3"),
    [SCALE_RATE_3] =
        GYRO_TERM("scale_rate_3", 262, GYRO_PER_RATE(3), 1.0, NON_LINEAR, "1e-4 ppm/(deg/s)^3",
                  "scale-factor error in proportion to omega_i^3", "c3 omega_i^4"),
    [TWO_PI] = GYRO_TERM("two_pi_error", 263, SCHULER_DIM_NONE, 0.5, NON_LINEAR, "20 ppm",
                         "scale-factor error that repeats with the Sagnac phase, from the reset of "
                         "the ramp",
                         "A sin(phi + two_pi_phase) omega_i"),
    [OPEN_LOOP] = GYRO_TERM("open_loop", 264, SCHULER_DIM_NONE, 1.0, NON_LINEAR, "1",
                            "1: no closed loop, the output is the sine of the Sagnac phase, "
                            "ambiguous beyond half a turn",
                            "sin(phi)/phi omega_i - omega_i"),
    [MAGNETIC] = { .key = "magnetic_sensitivity",
                   .number = 265,
                   .dim = { 0, -2, 2, 0, 0, -2 },
                   .components = 9,
                   .min = -1e3,
                   .max = 1e3,
                   .acts = SCHULER_ACTS_CONSTANT,
                   .example = "0.01 deg/h/gauss",
                   .doc = "drift in a magnetic field along x, y, z, of the x gyro, of y, of z",
                   .formula = "D_H . H",
                   .companion = "magnetic_field" },
    [FIELD] = { .key = "magnetic_field",
                .dim = { 0, 0, 0, 0, 0, 2 },
                .components = 3,
                .min = -1e2,
                .max = 1e2,
                .example = "[0.2 gauss, 0 gauss, 0.4 gauss]",
                .doc = "the magnetic field at the gyros, body axes, constant there" },
    [LENGTH] = GYRO_SETTING("fibre_length", SCHULER_DIM_LENGTH, 1000.0, 1e-3, 1e6, "1000 m",
                            "length of the fibre"),
    [DIAMETER] = GYRO_SETTING("coil_diameter", SCHULER_DIM_LENGTH, 0.1, 1e-4, 1e2, "0.1 m",
                              "diameter of the coil"),
    [WAVELENGTH] = GYRO_SETTING("wavelength", SCHULER_DIM_LENGTH, 1550e-9, 1e-7, 1e-5, "1.55e-6 m",
                                "of the light, in vacuum"),
    [PHASE] = GYRO_SETTING("two_pi_phase", SCHULER_DIM_ANGLE, 0.0, -10.0, 10.0, "30 deg",
                           "phase of two_pi_error at rest"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double w = x->omega[0];
    const double gain =
        schuler_fibre_gain(setup_setting(s, LENGTH, 0), setup_setting(s, DIAMETER, 0),
                           setup_setting(s, WAVELENGTH, 0));
    B[ONE] = 1.0;
    B[RATE] = w;
    B[CROSS_X] = x->omega[1];
    B[CROSS_Y] = x->omega[2];
    B[POWER_2] = w * fabs(w);
    B[POWER_3] = w * w * w;
    B[POWER_4] = w * w * w * w;
    B[RESET] = w * sin(gain * w + setup_setting(s, PHASE, 0));
    B[SINE] = sin(gain * w) / gain - w;
}

/* [I + E + D] [1 + epsilon_K]^-1 = I + bracket I + (1 + bracket) (E + D) */
static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    const double bracket = gyro_bracket(v[EPSILON_K][axis]), gain = 1.0 + bracket;
    (void)s;
    c[ONE] = v[D_F][axis];
    for (int j = 0; j < 3; j++) c[ONE] += v[MAGNETIC][3 * axis + j] * v[FIELD][j];
    gyro_theta(v[THETA_X][axis], v[THETA_Y][axis], &c[CROSS_X], &c[CROSS_Y]);
    c[POWER_2] = v[SCALE_RATE][axis];
    c[POWER_3] = v[SCALE_RATE_2][axis];
    c[POWER_4] = v[SCALE_RATE_3][axis];
    c[RESET] = v[TWO_PI][axis];
    c[SINE] = v[OPEN_LOOP][axis];
    for (int q = 0; q < TERMS; q++) c[q] *= gain;
    c[RATE] = bracket;
}

static double noise_excess(const schuler_model_setup *s, int lane, int axis)
{
    return gyro_bracket(setup_lane(s, lane, EPSILON_K, axis));
}

TERMS_MODEL(TERMS, bases, coefficients)

MODEL(fibre_optic) = {
    .name = "fibre_optic",
    .summary = "a fibre-optic gyro by IEEE 952: scale-factor errors, open loop, magnetic field",
    .source = "IEEE Std 952-1997 (R2008); H. C. Lefevre, The Fiber-Optic Gyroscope, 2nd ed., 2014",
    .equation = "S0 (dN/dt) = [I + E + D] [1 + epsilon_K]^-1\n"
                "phi = 2 pi L D/(lambda c) omega_i\n"
                "I = omega_i + omega_x sin Theta_Y - omega_y sin Theta_X,  E = D_H . H + ...\n"
                "scale factor: c1 |omega_i| + c2 omega_i^2 + c3 omega_i^3\n"
                "              + A sin(phi + phase)\n"
                "    + open_loop (sin(phi)/phi - 1)",
    .departures =
        "written without the standard at hand, in the form that is cited from it. x, y (XRA, YRA) "
        "are the output and the third axis of each gyro. epsilon_K is a number, "
        "1e-6 epsilon_K in print; a positive one lowers the indicated rate. What depends on the "
        "rate sees omega_i without the misalignments (second order), and has the sign of a "
        "scale-factor error as in 1 + s. The Shupe effect is bias_temperature_rate, the other "
        "temperature terms are bias_temperature and scale_temperature; noise is the chain's",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
    .noise_excess = noise_excess,
};
