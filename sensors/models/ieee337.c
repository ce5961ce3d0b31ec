/* SPDX-License-Identifier: MIT */
/* IEEE Std 337: pendulous accelerometer with analog torque balance. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"

enum { K0, K2, K3, DELTA_O, DELTA_P, K_IP, K_IO, TERMS };

static const schuler_param params[] = {
    [K0] = IEEE_K0,           [K2] = IEEE_K2,     [K3] = IEEE_K3,     [DELTA_O] = IEEE_DELTA_O,
    [DELTA_P] = IEEE_DELTA_P, [K_IP] = IEEE_K_IP, [K_IO] = IEEE_K_IO, { 0 },
};

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

TERMS_MODEL(TERMS, bases, NULL)

MODEL(ieee337) = {
    .name = "ieee337",
    .summary = "pendulous accelerometer with analog torque balance",
    .source = "IEEE Std 337-1972; eq 7 of T. L. Grigorie et al.",
    .equation = "E/K1 = K0 + a_i + K2 a_i^2 + K3 a_i^3 + delta_o a_p - delta_p a_o\n"
                "       + K_ip a_i a_p + K_io a_i a_o",
    .departures = "none; the noise its prose speaks of is the chain's white noise",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};
