/* SPDX-License-Identifier: MIT */
/* IEEE Std 836: the model of centrifuge tests. */
#include "sensors/accel_params.h"
#include "sensors/terms.h"

enum { K0, K2, K3, K_IP, K_IO, K_PO, DELTA_O, DELTA_P, K_PP, K_PPP, K_OO, K_OOO, TERMS };

static const schuler_param params[] = {
    [K0] = IEEE_K0,
    [K2] = IEEE_K2,
    [K3] = IEEE_K3,
    [K_IP] = IEEE_K_IP,
    [K_IO] = IEEE_K_IO,
    [K_PO] = IEEE_K_PO,
    [DELTA_O] = IEEE_DELTA_O,
    [DELTA_P] = IEEE_DELTA_P,
    [K_PP] = IEEE_K_PP,
    [K_PPP] = ACCEL_TERM("K_ppp", 158, ACCEL_PER(2), 1e-2, NON_LINEAR, "1 ug/g^3",
                         "cubic non-linearity of the pendulous axis", "K_ppp a_p^3"),
    [K_OO] = IEEE_K_OO,
    [K_OOO] = ACCEL_TERM("K_ooo", 159, ACCEL_PER(2), 1e-2, NON_LINEAR, "1 ug/g^3",
                         "cubic non-linearity of the output axis", "K_ooo a_o^3"),
    { 0 },
};

static void bases(const schuler_model_setup *s, const term_input *x, double *B)
{
    const double i = x->a[0], p = x->a[1], o = x->a[2];
    (void)s;
    B[K0] = 1.0;
    B[K2] = i * i;
    B[K3] = i * i * i;
    B[K_IP] = i * p;
    B[K_IO] = i * o;
    B[K_PO] = p * o;
    B[DELTA_O] = p;
    B[DELTA_P] = -o;
    B[K_PP] = p * p;
    B[K_PPP] = p * p * p;
    B[K_OO] = o * o;
    B[K_OOO] = o * o * o;
}

TERMS_MODEL(TERMS, bases, NULL)

MODEL(ieee836) = {
    .name = "ieee836",
    .summary = "centrifuge model: cubic in all three axes",
    .source = "IEEE Std 836-2009; eq 10 of T. L. Grigorie et al.",
    .equation = "E/K1 = K0 + a_i + K2 a_i^2 + K3 a_i^3 + K_ip a_i a_p\n"
                "       + K_io a_i a_o + K_po a_p a_o + delta_o a_p - delta_p a_o\n"
                "       + K_pp a_p^2 + K_ppp a_p^3 + K_oo a_o^2 + K_ooo a_o^3",
    .departures =
        "the paper says that its eq 8 was completed; this extends eq 7, with one K1. K_op of the "
        "print is called K_po as in IEEE 1293: the same coefficient",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = sizeof(terms),
    .signals = TERMS,
    .observe = observe,
    .setup = setup,
    .apply = apply,
};
