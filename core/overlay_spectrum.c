/* SPDX-License-Identifier: MIT */
#include "core/overlay_spectrum.h"
#include "core/earth.h"
#include "core/random.h"

/* In the numbers that sources are known by; those of sensors end far below. */
enum { SOURCE_OVERLAY = 60000 };

/* Power between two frequencies: Simpson's rule in log frequency, in which spectra are smooth. */
static double power(const overlay_spectrum *s, double low_Hz, double high_Hz)
{
    enum { INTERVALS = 32 };
    const double step = log(high_Hz / low_Hz) / INTERVALS;
    double sum = 0.0;
    for (int i = 0; i <= INTERVALS; i++) {
        const double f_Hz = low_Hz * exp(step * i);
        const double weight = i == 0 || i == INTERVALS ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * f_Hz * s->density(s->user, f_Hz);
    }
    return sum * step / 3.0;
}

overlay_sinusoid schuler_spectrum_line(const overlay_spectrum *s, size_t i, size_t n,
                                       overlay_luck luck)
{
    const double step = log(s->high_Hz / s->low_Hz) / (double)n;
    const double low_Hz = s->low_Hz * exp(step * (double)i), high_Hz = low_Hz * exp(step);
    const schuler_stream stream = { luck.seed, luck.overlay, SOURCE_OVERLAY + luck.use, 0,
                                    SCHULER_USE_DRAW };
    const double where = 0.5 + 0.5 * schuler_stream_uniform(stream, 2 * i);
    return (overlay_sinusoid){
        .frequency_Hz = low_Hz * exp(step * where),
        .amplitude = sqrt(2.0 * power(s, low_Hz, high_Hz)),
        .phase_rad = SCHULER_PI * schuler_stream_uniform(stream, 2 * i + 1),
    };
}
