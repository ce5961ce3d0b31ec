/* SPDX-License-Identifier: MIT */
/* Ring laser gyros: the form of IEEE Std 647, and lock-in. */
#include "sensors/gyro_params.h"
#include "sensors/instant.h"
#include "sensors/optics.h"
#include "sensors/white.h"

enum {
    D_F,
    EPSILON_K,
    THETA_X,
    THETA_Y,
    LOCK_IN,
    UNDITHERED,
    QUANTUM,
    PULSE,
    DITHER,
};
enum { ONE, CROSS_X, CROSS_Y, TERMS };
enum { LOCK_IN_NUMBER = 253, QUANTUM_NUMBER = 255 };

static const schuler_param params[] = {
    [D_F] = GYRO_D_F,
    [EPSILON_K] = GYRO_EPSILON_K,
    [THETA_X] = GYRO_THETA_X,
    [THETA_Y] = GYRO_THETA_Y,
    [LOCK_IN] =
        PARAM_SOURCE("lock_in", LOCK_IN_NUMBER, RATE, 0.0, 1.0, WHITE, "0.05 deg/s",
                     "lock-in rate Omega_L under a dither with injected noise: a random "
                     "walk",
                     "N = Omega_L sqrt(K/(2 pi Omega_D)), y = x + N sqrt(dt) w", .noisy = 1),
    [UNDITHERED] = PARAM_SOURCE("lock_in_undithered", 254, RATE, 0.0, 1.0, NON_LINEAR, "0.05 deg/s",
                                "lock-in rate Omega_L without dither: the square-root law, nothing "
                                "within Omega_L; in place of lock_in",
                                "sgn(W) sqrt(W^2 - Omega_L^2), W = I + D", .noisy = 0),
    [QUANTUM] =
        PARAM_SOURCE("quantum_limit", QUANTUM_NUMBER, ARW, 0.0, 1e2, WHITE, "0.0005 deg/sqrt(h)",
                     "angle random walk of the light itself, beside that of lock-in",
                     "y = x + N sqrt(dt) w", .noisy = 1),
    [PULSE] =
        GYRO_SETTING("pulse_angle", SCHULER_DIM_ANGLE, 9.69627362219072e-6, 1e-12, 1.0, "2 arcsec",
                     "K, the angle of one turn of the beat phase, lambda L/(4 A); it does "
                     "not quantize: quantization does"),
    [DITHER] = GYRO_SETTING("dither_rate", SCHULER_DIM_RATE, 1.7453292519943296, 1e-6, 1e4,
                            "100 deg/s", "peak rate Omega_D of the dither"),
    { 0 },
};

typedef struct {
    terms drift;
    lanes lock[3], scale[3]; /* Omega_L without dither; 1/(1 + epsilon_K) - 1 */
    white_noise lock_in, quantum;
    int locks;
} ring_laser;

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    (void)s;
    B[ONE] = 1.0;
    B[CROSS_X] = x->omega[1];
    B[CROSS_Y] = x->omega[2];
}

static void coefficients(const schuler_model_setup *s, term_values v, int axis, double *c)
{
    (void)s;
    c[ONE] = v[D_F][axis];
    gyro_theta(v[THETA_X][axis], v[THETA_Y][axis], &c[CROSS_X], &c[CROSS_Y]);
}

static double noise_excess(const schuler_model_setup *s, int lane, int axis)
{
    return gyro_bracket(setup_lane(s, lane, EPSILON_K, axis));
}

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    terms_observe(s, v, TERMS, bases, signals);
}

static int setup(void *state, const schuler_model_setup *s)
{
    ring_laser *const m = state;
    const double walk =
        schuler_lock_in_random_walk(1.0, setup_setting(s, PULSE, 0), setup_setting(s, DITHER, 0));
    (void)terms_setup(&m->drift, s, TERMS, coefficients);
    white_setup(&m->lock_in, s, LOCK_IN, LOCK_IN_NUMBER);
    white_setup(&m->quantum, s, QUANTUM, QUANTUM_NUMBER);
    m->locks = setup_any(s, UNDITHERED, 3);
    for (int i = 0; i < 3; i++) {
        double scale[SCHULER_LANES] __attribute__((aligned(64)));
        for (int l = 0; l < SCHULER_LANES; l++) scale[l] = noise_excess(s, l, i);
        m->scale[i] = lanes_load(scale);
        m->lock[i] = setup_value(s, UNDITHERED, i);
        m->lock_in.sigma[i] *= lanes_set(walk);
    }
    return 1;
}

/* What lock-in takes away in each step. Above Omega_L that is W - sqrt(W^2 - Omega_L^2), written
 * without a difference of nearly equal numbers; a lane without lock-in loses exactly nothing. */
static void lock(const ring_laser *m, const schuler_model_block *b, int axis)
{
    const schuler_view *const v = b->view;
    const lanes L = m->lock[axis], zero = lanes_set(0.0);
    double *const out = b->out + axis * b->stride * SCHULER_LANES;
    for (int k = 0; k < b->n; k++) {
        const lanes y = lanes_load(out + k * SCHULER_LANES);
        const lanes error = instant_error(b, SCHULER_GYRO, axis, k, y);
        lanes sum = zero;
        for (int j = 0; j < v->nodes; j++) {
            const lanes W = instant_value(b, SCHULER_GYRO, axis, k, j, error), a = lanes_abs(W);
            const lanes root = lanes_sqrt(lanes_max((a - L) * (a + L), zero));
            const lanes lost = lanes_select(lanes_greater(a, L), L * L / (a + root), a);
            sum += lanes_set(v->weight[j] * b->dt_s) * lanes_copysign(lost, W);
        }
        lanes_store(out + k * SCHULER_LANES, y - sum);
    }
}

static void apply(void *state, const schuler_model_block *b)
{
    ring_laser *const m = state;
    terms_apply(&m->drift, b, TERMS, 1);
    for (int axis = 0; axis < 3; axis++) {
        double *const out = b->out + axis * b->stride * SCHULER_LANES;
        if (m->locks) lock(m, b, axis);
        for (int k = 0; k < b->n; k++) {
            const lanes y = lanes_load(out + k * SCHULER_LANES);
            lanes_store(out + k * SCHULER_LANES, y + m->scale[axis] * y);
        }
    }
    /* Their deviations have the bracket already. */
    white_add(&m->lock_in, b);
    white_add(&m->quantum, b);
}

MODEL(ring_laser) = {
    .name = "ring_laser",
    .summary = "a ring laser gyro by IEEE 647, with lock-in",
    .source = "IEEE Std 647; F. Aronowitz, Fundamentals of the ring laser gyro, RTO-AG-339",
    .equation = "S0 (dN/dt) = [I + E + D] [1 + epsilon_K]^-1\n"
                "I = omega_i + omega_x sin Theta_Y - omega_y sin Theta_X,  D = D_F + noise",
    .departures =
        "written without the standard at hand, in the form that is cited from it. x, y (XRA, YRA) "
        "are the output and the third axis of each gyro. epsilon_K is a number, "
        "1e-6 epsilon_K in print; a positive one lowers the indicated rate. The temperature terms "
        "of E are bias_temperature and bias_temperature_rate, noise and instability of D the "
        "chain's, counts of K its quantization. Lock-in, not in the equation of the standard, acts "
        "on I + D. Dither is taken as removed from the output without rest",
    .params = { [SCHULER_GYRO] = params },
    .state_size = sizeof(ring_laser),
    .needs_view = 1,
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
    .noise_excess = noise_excess,
};
