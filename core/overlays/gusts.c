/* SPDX-License-Identifier: MIT */
/* An aircraft in turbulence: Dryden's spectra of the vertical and the lateral gust, followed by the
 * aircraft with a time constant each. The slow end is left to whoever flies it. */
#include "core/overlays/keys.h"

typedef struct {
    schuler_place place;
    double speed_mps, scale_m, airspeed_mps, vertical_s, lateral_s, low_Hz, high_Hz;
    int64_t lines, seed;
    schuler_overlay_times times;
} gusts_spec;

static const schuler_field fields[] = {
    FIELD_NEEDED("speed", gusts_spec, speed_mps, SCHULER_DIM_SPEED, 0.0, 30.0, "1.5 m/s",
                 "rms gust: 1.5 m/s light, 3 m/s moderate, 6.4 m/s severe at altitude"),
    FIELD_OPTIONAL("scale", gusts_spec, scale_m, SCHULER_DIM_LENGTH, 533.4, 1.0, 1e4, "533.4 m",
                   "length of the turbulence: 1750 ft above 2000 ft"),
    FIELD_NEEDED("airspeed", gusts_spec, airspeed_mps, SCHULER_DIM_SPEED, 1.0, FIELD_FASTEST_MPS,
                 "230 m/s", "at which it is flown through"),
    FIELD_OPTIONAL("vertical_response", gusts_spec, vertical_s, SCHULER_DIM_TIME, 1.5, 0.01, 100.0,
                   "1.5 s", "time constant with which the aircraft follows a vertical gust"),
    FIELD_OPTIONAL("lateral_response", gusts_spec, lateral_s, SCHULER_DIM_TIME, 5.0, 0.01, 100.0,
                   "5 s", "and a lateral one"),
    FIELD_OPTIONAL("lowest", gusts_spec, low_Hz, SCHULER_DIM_FREQUENCY, 0.05, 1e-3, 10.0, "0.05 Hz",
                   "frequency below which the pilot holds the path"),
    FIELD_OPTIONAL("highest", gusts_spec, high_Hz, SCHULER_DIM_FREQUENCY, 1.1, 1e-2, 100.0,
                   "1.1 Hz", "frequency above which there is nothing"),
    OVERLAY_LINES(gusts_spec),
    OVERLAY_TIMES(gusts_spec),
    { 0 },
};

extern const schuler_object schuler_overlay_gusts_object;
const schuler_object schuler_overlay_gusts_object = {
    .name = "gusts",
    .doc = "an aircraft in turbulence: it heaves and sways",
    .size = sizeof(gusts_spec),
    .fields = fields,
};

typedef struct {
    double variance, length_s, response_s; /* scale over airspeed */
} turbulence;

/* Displacement of the aircraft: its velocity follows Dryden's transverse gust, sigma^2 2 T (1 + 3 x^2) /
 * (1 + x^2)^2 with x = 2 pi f T. */
static double displacement(const void *user, double f_Hz)
{
    const turbulence *const t = user;
    const double omega = 2.0 * SCHULER_PI * f_Hz, x = omega * t->length_s,
                 y = omega * t->response_s;
    const double gust =
        2.0 * t->variance * t->length_s * (1.0 + 3.0 * x * x) / ((1.0 + x * x) * (1.0 + x * x));
    return gust / ((1.0 + y * y) * omega * omega);
}

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const gusts_spec *const s = spec;
    if (!(s->high_Hz > s->low_Hz)) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place,
                         "gusts: 'highest', %g Hz, must be above 'lowest', %g Hz", s->high_Hz,
                         s->low_Hz);
        return SCHULER_ERR_INPUT;
    }
    const size_t n = (size_t)s->lines;
    overlay_group *const group = schuler_overlay_group(o, &s->times, 2 * n, &s->place, d);
    if (!group) return SCHULER_ERR_INPUT;
    const turbulence both[2] = {
        { s->speed_mps * s->speed_mps, s->scale_m / s->airspeed_mps, s->vertical_s },
        { s->speed_mps * s->speed_mps, s->scale_m / s->airspeed_mps, s->lateral_s },
    };
    static const int channels[2] = { OVERLAY_HEAVE, OVERLAY_SWAY };
    for (unsigned k = 0; k < 2; k++)
        for (size_t i = 0; i < n; i++) {
            const overlay_spectrum spectrum = { s->low_Hz, s->high_Hz, displacement, &both[k] };
            const overlay_luck luck = { (uint64_t)s->seed, o->index, k };
            const overlay_sinusoid x = schuler_spectrum_line(&spectrum, i, n, luck);
            overlay_line *const line = &group->lines[k * n + i];
            line->frequency_Hz = x.frequency_Hz;
            line->in_phase[channels[k]] = x.amplitude * cos(x.phase_rad);
            line->in_quadrature[channels[k]] = -x.amplitude * sin(x.phase_rad);
        }
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_gusts;
const schuler_overlay_kind schuler_overlay_gusts = {
    .object = &schuler_overlay_gusts_object,
    .source = "Dryden spectra, MIL-F-8785C section 3.7",
    .add = add,
};
