/* SPDX-License-Identifier: MIT */
/* Vibration of the IMU in the vehicle: a specific force, one sinusoid or a spectrum as test standards
 * write it. */
#include "core/overlays/keys.h"
#include <string.h>

typedef struct {
    schuler_place place;
    double at_Hz, density;
} profile_point;

typedef struct {
    schuler_place place;
    const char *axis;
    double amplitude_mps2, frequency_Hz, phase_rad;
    schuler_list profile;
    int64_t lines, seed;
    schuler_overlay_times times;
} vibration_spec;

static const char *const axes[] = { "all", "x", "y", "z", NULL };

static const schuler_field profile_fields[] = {
    FIELD_NEEDED("at", profile_point, at_Hz, SCHULER_DIM_FREQUENCY, 1e-3, 5000.0, "20 Hz",
                 "frequency"),
    FIELD_NEEDED("density", profile_point, density, SCHULER_DIM_ACCEL_PSD, 1e-12, 1e6,
                 "0.01 g^2/Hz", "one-sided power spectral density there"),
    { 0 },
};

static const schuler_object profile_object = {
    .name = "profile",
    .doc = "a corner of the spectrum",
    .size = sizeof(profile_point),
    .fields = profile_fields,
};

static const schuler_field fields[] = {
    { .key = "axis",
      .kind = SCHULER_FIELD_CHOICE,
      .offset = offsetof(vibration_spec, axis),
      .choices = axes,
      .example = "z",
      .doc = "forward x, right y, down z of the vehicle, or all three" },
    FIELD_OPTIONAL("amplitude", vibration_spec, amplitude_mps2, SCHULER_DIM_ACCEL, NAN, 0.0, 1e4,
                   "0.5 g", "of one sinusoid"),
    FIELD_OPTIONAL("frequency", vibration_spec, frequency_Hz, SCHULER_DIM_FREQUENCY, NAN, 1e-3,
                   5000.0, "50 Hz", "of it"),
    FIELD_OPTIONAL("phase", vibration_spec, phase_rad, SCHULER_DIM_ANGLE, 0.0, -2.0 * SCHULER_PI,
                   2.0 * SCHULER_PI, "90 deg",
                   "of it: the specific force is A sin(2 pi f t + phase)"),
    { .key = "profile",
      .kind = SCHULER_FIELD_LIST,
      .offset = offsetof(vibration_spec, profile),
      .example = "[{at: 20 Hz, density: 0.01 g^2/Hz}, {at: 200 Hz, density: 0.01 g^2/Hz}]",
      .doc = "a spectrum in place of a sinusoid; straight between its corners in log-log",
      .object = &profile_object },
    OVERLAY_LINES(vibration_spec),
    OVERLAY_TIMES(vibration_spec),
    { 0 },
};

extern const schuler_object schuler_overlay_vibration_object;
const schuler_object schuler_overlay_vibration_object = {
    .name = "vibration",
    .doc = "vibration of the IMU, by its specific force",
    .size = sizeof(vibration_spec),
    .fields = fields,
};

static double density(const void *user, double f_Hz)
{
    const schuler_list *const profile = user;
    const profile_point *p = profile->items;
    size_t i = 0;
    while (i + 2 < profile->count && p[i + 1].at_Hz < f_Hz) i++;
    const double slope = log(p[i + 1].density / p[i].density) / log(p[i + 1].at_Hz / p[i].at_Hz);
    return p[i].density * exp(slope * log(f_Hz / p[i].at_Hz));
}

/* u'' = A cos(w t + phase), so u = -A/w^2 cos(w t + phase). */
static void set_line(overlay_line *line, int channel, overlay_sinusoid force)
{
    const double omega = 2.0 * SCHULER_PI * (double)force.frequency_Hz;
    const double size_m = -force.amplitude / (omega * omega);
    line->frequency_Hz = force.frequency_Hz;
    line->in_phase[channel] = size_m * cos(force.phase_rad);
    line->in_quadrature[channel] = -size_m * sin(force.phase_rad);
}

static schuler_status check(const vibration_spec *s, schuler_diagnostics *d)
{
    const bool is_spectrum = s->profile.count > 0;
    const bool has_any = !isnan(s->amplitude_mps2) || !isnan(s->frequency_Hz);
    const profile_point *const p = s->profile.items;
    if (is_spectrum == has_any ||
        (!is_spectrum && (isnan(s->amplitude_mps2) || isnan(s->frequency_Hz)))) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place,
                         "vibration: either 'amplitude' and 'frequency', or 'profile'");
        return SCHULER_ERR_INPUT;
    }
    if (is_spectrum && s->profile.count < 2) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &p[0].place, "a profile needs two corners or more");
        return SCHULER_ERR_INPUT;
    }
    for (size_t i = 1; i < s->profile.count; i++)
        if (p[i].at_Hz <= p[i - 1].at_Hz) {
            schuler_diagnose(d, SCHULER_ERR_INPUT, &p[i].place,
                             "at: %g Hz; the frequencies of a profile must rise", p[i].at_Hz);
            return SCHULER_ERR_INPUT;
        }
    return SCHULER_OK;
}

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const vibration_spec *const s = spec;
    const schuler_status status = check(s, d);
    if (status != SCHULER_OK) return status;
    const bool is_spectrum = s->profile.count > 0, on_all = strcmp(s->axis, "all") == 0;
    const size_t each = is_spectrum ? (size_t)s->lines : 1, count = on_all ? 3 : 1;
    overlay_group *const group = schuler_overlay_group(o, &s->times, each * count, &s->place, d);
    if (!group) return SCHULER_ERR_INPUT;
    const profile_point *const p = s->profile.items;
    for (size_t a = 0; a < count; a++)
        for (size_t i = 0; i < each; i++) {
            const int channel = OVERLAY_SHAKE_X + (on_all ? (int)a : s->axis[0] - 'x');
            overlay_sinusoid force = { s->frequency_Hz, s->amplitude_mps2,
                                       s->phase_rad - 0.5 * SCHULER_PI };
            if (is_spectrum) {
                const overlay_spectrum spectrum = { p[0].at_Hz, p[s->profile.count - 1].at_Hz,
                                                    density, &s->profile };
                force = schuler_spectrum_line(
                    &spectrum, i, each, (overlay_luck){ (uint64_t)s->seed, o->index, (unsigned)a });
            }
            set_line(&group->lines[a * each + i], channel, force);
        }
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_vibration;
const schuler_overlay_kind schuler_overlay_vibration = {
    .object = &schuler_overlay_vibration_object,
    .source = "a sum of sinusoids; profiles as in MIL-STD-810 method 514 and RTCA DO-160 section 8",
    .add = add,
};
