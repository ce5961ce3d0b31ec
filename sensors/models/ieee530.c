/* SPDX-License-Identifier: MIT */
/* IEEE Std 530: pendulous accelerometer with digital torque balance, whose scale factor differs with
 * the sign of the input. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"

enum { K0, K2, K3, DELTA_O, DELTA_P, K_IP, K_IO, TERMS, K1_PLUS = TERMS, K1_MINUS, SWITCH };

static const char *const switches[] = { "input", "output", NULL };

static const schuler_param params[] = {
    [K0] = IEEE_K0,
    [K2] = IEEE_K2,
    [K3] = IEEE_K3,
    [DELTA_O] = IEEE_DELTA_O,
    [DELTA_P] = IEEE_DELTA_P,
    [K_IP] = IEEE_K_IP,
    [K_IO] = IEEE_K_IO,
    [K1_PLUS] = ACCEL_TERM("K1_plus", 162, SCHULER_DIM_NONE, 0.5, SCALE, "50 ppm",
                           "error of the scale factor for positive input", "k+ (K0 + a_i + ...)"),
    [K1_MINUS] = ACCEL_TERM("K1_minus", 163, SCHULER_DIM_NONE, 0.5, SCALE, "-50 ppm",
                            "error of the scale factor for negative input", "k- (K0 + a_i + ...)"),
    [SWITCH] = PARAM_CHOICE("switch", switches, "output",
                            "whose sign chooses: the input's (as printed) or the output's"),
    { 0 },
};

typedef struct {
    terms sum;
    lanes c[3][TERMS], plus[3], minus[3];
    int two_sided, by_output;
} ieee530;

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double i = x->a[0], p = x->a[1], o = x->a[2];
    (void)s;
    B[K0] = 1.0;
    B[K2] = i * i;
    B[K3] = i * i * i;
    B[DELTA_O] = p;
    B[DELTA_P] = -o;
    B[K_IP] = i * p;
    B[K_IO] = i * o;
}

static void observe(const schuler_model_setup *s, const schuler_view *v, double *signals)
{
    terms_observe(s, v, TERMS, bases, signals);
}

static int setup(void *state, const schuler_model_setup *s)
{
    ieee530 *m = state;
    (void)terms_setup(&m->sum, s, TERMS, NULL);
    for (int axis = 0; axis < 3; axis++) {
        for (int q = 0; q < TERMS; q++) m->c[axis][q] = setup_value(s, q, axis);
        m->plus[axis] = setup_value(s, K1_PLUS, axis);
        m->minus[axis] = setup_value(s, K1_MINUS, axis);
    }
    m->two_sided = setup_any(s, K1_PLUS, 3) || setup_any(s, K1_MINUS, 3);
    m->by_output = setup_setting(s, SWITCH, 0) == 1.0;
    return 1;
}

/* k+ or k- times everything, instant by instant. */
static void add_scale(const ieee530 *m, const schuler_model_block *b, int axis)
{
    const schuler_view *const v = b->view;
    double *const out = b->out + axis * b->stride * SCHULER_LANES;
    const lanes zero = lanes_set(0.0);
    for (int k = 0; k < b->n; k++) {
        lanes sum = zero;
        for (int j = 0; j < v->nodes; j++) {
            term_input x = { .a = { 0 } };
            double B[TERMS];
            for (int i = 0; i < 3; i++) x.a[i] = v->f[axis][i][j * SCHULER_BLOCK + k];
            bases(NULL, &x, B);
            lanes net = lanes_set(x.a[0]);
            for (int q = 0; q < TERMS; q++) net += m->c[axis][q] * lanes_set(B[q]);
            const lanes sign = m->by_output ? net : lanes_set(x.a[0]);
            const lanes error =
                lanes_select(lanes_greater(zero, sign), m->minus[axis], m->plus[axis]);
            sum += lanes_set(v->weight[j] * b->dt_s) * (error * net);
        }
        lanes_store(out + k * SCHULER_LANES, lanes_load(out + k * SCHULER_LANES) + sum);
    }
}

static void apply(void *state, const schuler_model_block *b)
{
    const ieee530 *m = state;
    terms_apply(&m->sum, b, TERMS, 1);
    for (int axis = 0; axis < 3 && m->two_sided; axis++) add_scale(m, b, axis);
}

MODEL(ieee530) = {
    .name = "ieee530",
    .summary = "pendulous accelerometer with digital torque balance, two-sided scale factor",
    .source = "IEEE Std 530-1978; eqs 8-9 of T. L. Grigorie et al.",
    .equation = "conventional: E/K1 = K0 + a_i + K2 a_i^2 + K3 a_i^3\n"
                "              + delta_o a_p - delta_p a_o + K_ip a_i a_p + K_io a_i a_o\n"
                "asymmetric: E/(K1 z+ + K1' z-) = K0 + a_i\n"
                "              + delta_o a_p - delta_p a_o\n"
                "z+ = 1 for a_i >= 0, z- = 1 for a_i < 0\n"
                "K1 = K1n (1 + K1_plus), K1' = K1n (1 + K1_minus)",
    .departures =
        "the print has K1 twice, K1 z+ + K1 z-, which leaves no asymmetry: the second is K1' as "
        "its "
        "text says. a_i = 0, left open, counts as positive. The computer divides E by the nominal "
        "scale factor K1n. Both variants are one sum here, so that each can be taken with the "
        "other's terms",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(ieee530),
    .needs_view = 1,
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};
