/* SPDX-License-Identifier: MIT */
#include "sensors/optics.h"
#include <math.h>

double schuler_ring_pulse(double wavelength_m, double perimeter_m, double area_m2)
{
    return wavelength_m * perimeter_m / (4.0 * area_m2);
}

double schuler_ring_triangle_area(double perimeter_m)
{
    return sqrt(3.0) / 36.0 * perimeter_m * perimeter_m;
}

double schuler_lock_in_rate(double omega_radps, double lock_in_radps)
{
    const double a = fabs(omega_radps);
    if (!(a > lock_in_radps)) return 0.0;
    return copysign(sqrt((a - lock_in_radps) * (a + lock_in_radps)), omega_radps);
}

double schuler_lock_in_random_walk(double lock_in_radps, double pulse_rad, double dither_radps)
{
    return lock_in_radps * sqrt(pulse_rad / (2.0 * M_PI * dither_radps));
}

double schuler_fibre_gain(double length_m, double diameter_m, double wavelength_m)
{
    return 2.0 * M_PI * length_m * diameter_m / (wavelength_m * SCHULER_LIGHT_MPS);
}
