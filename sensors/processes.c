/* SPDX-License-Identifier: MIT */
#include "sensors/processes.h"
#include "core/earth.h"
#include "sensors/markov_integral.h"
#include <math.h>

double schuler_process_quantization(double Q, double tau_s)
{
    return 3.0 * (Q / tau_s) * (Q / tau_s);
}

double schuler_process_white(double N, double tau_s)
{
    return N * N / tau_s;
}

double schuler_process_flicker(double B, double tau_s)
{
    (void)tau_s;
    return 2.0 * M_LN2 / SCHULER_PI * B * B;
}

double schuler_process_random_walk(double K, double tau_s)
{
    return K * K * tau_s / 3.0;
}

double schuler_process_ramp(double R, double tau_s)
{
    return 0.5 * (R * tau_s) * (R * tau_s);
}

double schuler_process_gauss_markov(double sigma, double T_s, double tau_s)
{
    const double x = tau_s / T_s;
    return sigma * sigma * markov_q22(x) / (x * x);
}

/* The integral over t has the variance 2 sigma^2 T^2 v(t/T), v(x) = 2x - 3 + (3 + x) e^-x: twice the
 * integral of (x - u)(1 + u) e^-u. An Allan variance is (4 V(tau) - V(2 tau))/(2 tau^2). For small x
 * the closed form cancels down to x^4/2, so the power series is summed: v is the sum of
 * (-x)^n (3 - n)/n! over n >= 2, of which n = 2 and 3 drop out of the difference. */
double schuler_process_gauss_markov_2(double sigma, double T_s, double tau_s)
{
    const double x = tau_s / T_s;
    double sum = 0.0;
    if (x > 1.0) {
        sum = 4.0 * x - 9.0 + 4.0 * (3.0 + x) * exp(-x) - (3.0 + 2.0 * x) * exp(-2.0 * x);
    } else {
        double power = -x * x * x / 6.0, two = 8.0;
        for (int n = 4; n <= 30; n++) { /* (2x)^31/31! is below 1e-24 */
            power *= -x / n;
            two *= 2.0;
            sum += power * (3 - n) * (4.0 - two);
        }
    }
    return sigma * sigma * sum / (x * x);
}

double schuler_process_sinusoid(double amplitude, double f_hz, double tau_s)
{
    const double x = SCHULER_PI * f_hz * tau_s;
    if (x == 0.0) return 0.0;
    const double s = sin(x) * sin(x) / x;
    return amplitude * amplitude * s * s;
}

schuler_flicker_bank schuler_flicker_bank_of(double shortest_s, double longest_s, double dt_s)
{
    const double least = dt_s / 16.0;
    schuler_flicker_bank bank = { fmax(shortest_s, least), 4.0, 0, shortest_s < least };
    const double last = fmax(longest_s, bank.shortest_s) * 1.0000001;
    for (double T = bank.shortest_s; T <= last && bank.members < SCHULER_MARKOV_MAX;
         T *= bank.ratio)
        bank.members++;
    return bank;
}

schuler_markov_process schuler_flicker_bank_member(const schuler_flicker_bank *bank, double B,
                                                   int i)
{
    const double r = bank->ratio, sigma = B * schuler_flicker_bank_sigma(r);
    double T = bank->shortest_s;
    for (int k = 0; k < i; k++) T *= r;
    if (i > 0 || !bank->endless) return (schuler_markov_process){ T, sigma };
    return (schuler_markov_process){ T * r / (r + 1.0), sigma * sqrt((r + 1.0) / (r - 1.0)) };
}

double schuler_flicker_bank_sigma(double ratio)
{
    return sqrt(log(ratio) / SCHULER_PI);
}

double schuler_process_flicker_bank(const schuler_flicker_bank *bank, double B, double tau_s)
{
    double sum = 0.0;
    for (int i = 0; i < bank->members; i++) {
        const schuler_markov_process p = schuler_flicker_bank_member(bank, B, i);
        sum += schuler_process_gauss_markov(p.sigma, p.T_s, tau_s);
    }
    return sum;
}

schuler_process_step schuler_gauss_markov_step(double sigma, double T_s, double dt_s)
{
    const double x = dt_s / T_s, one_minus_phi = -expm1(-x), variance = sigma * sigma;
    schuler_process_step s = { .phi = exp(-x), .gain = T_s * one_minus_phi };
    s.q11 = variance * -expm1(-2.0 * x);
    s.q12 = variance * T_s * one_minus_phi * one_minus_phi;
    s.q22 = variance * T_s * T_s * markov_q22(x);
    s.l11 = sqrt(s.q11);
    s.l21 = s.l11 > 0.0 ? s.q12 / s.l11 : 0.0;
    s.l22 = sqrt(fmax(0.0, s.q22 - s.l21 * s.l21));
    return s;
}

schuler_process_step schuler_random_walk_step(double K, double dt_s)
{
    const double root = sqrt(dt_s);
    schuler_process_step s = { .phi = 1.0, .gain = dt_s };
    s.l11 = K * root;
    s.l21 = 0.5 * K * dt_s * root;
    s.l22 = K * dt_s * root / sqrt(12.0);
    s.q11 = K * K * dt_s;
    s.q12 = 0.5 * K * K * dt_s * dt_s;
    s.q22 = K * K * dt_s * dt_s * dt_s / 3.0;
    return s;
}

void schuler_fractional_weights(double *h, size_t n)
{
    if (n > 0) h[0] = 1.0;
    for (size_t k = 1; k < n; k++) h[k] = h[k - 1] * ((double)k - 0.5) / (double)k;
}
