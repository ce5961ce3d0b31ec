/* SPDX-License-Identifier: MIT */
/* A ship in long-crested deep-water waves: the spectrum of a fully developed or growing sea, the place
 * follows the water, roll and pitch answer to the wave's slope like damped oscillators. Strip-theory is
 * not attempted; the periods and dampings of the ship are keys. Waves meet the ship at their own
 * frequency (no Doppler shift by its speed). */
#include "core/overlays/keys.h"

typedef struct {
    schuler_place place;
    int64_t state;
    double height_m, period_s, from_rad;
    double roll_period_s, pitch_period_s, roll_damping, pitch_damping, draught_m;
    int64_t lines, seed;
    schuler_overlay_times times;
} sea_spec;

/* Significant height: middle of the WMO code's range (table 3700); modal period: the most probable one
 * in the North Atlantic (NATO STANAG 4194, as widely reprinted). */
static const struct {
    double height_m, period_s;
} sea_states[] = {
    { 0.05, 4.0 }, { 0.3, 6.3 },  { 0.88, 7.5 }, { 1.88, 8.8 },
    { 3.25, 9.7 }, { 5.0, 12.4 }, { 7.5, 15.0 }, { 11.5, 16.4 },
};

static const schuler_field fields[] = {
    { .key = "state",
      .kind = SCHULER_FIELD_INTEGER,
      .offset = offsetof(sea_spec, state),
      .def = 0,
      .min = 0,
      .max = 8,
      .example = "5",
      .doc = "sea state of the WMO code, 1 to 8; or give height and period" },
    FIELD_OPTIONAL("height", sea_spec, height_m, SCHULER_DIM_LENGTH, NAN, 0.0, 30.0, "3.25 m",
                   "significant wave height: four times the elevation's rms"),
    FIELD_OPTIONAL("period", sea_spec, period_s, SCHULER_DIM_TIME, NAN, 1.0, 60.0, "9.7 s",
                   "modal period of the waves"),
    FIELD_OPTIONAL("direction", sea_spec, from_rad, SCHULER_DIM_ANGLE, 0.25 * SCHULER_PI,
                   -SCHULER_PI, SCHULER_PI, "45 deg",
                   "where the waves come from: 0 ahead, 90 deg from the right"),
    FIELD_OPTIONAL("roll_period", sea_spec, roll_period_s, SCHULER_DIM_TIME, 12.0, 1.0, 60.0,
                   "12 s", "natural period of roll"),
    FIELD_OPTIONAL("pitch_period", sea_spec, pitch_period_s, SCHULER_DIM_TIME, 6.0, 1.0, 60.0,
                   "6 s", "natural period of pitch"),
    { .key = "roll_damping",
      .kind = SCHULER_FIELD_NUMBER,
      .offset = offsetof(sea_spec, roll_damping),
      .def = 0.15,
      .min = 0.01,
      .max = 2.0,
      .example = "0.15",
      .doc = "damping ratio of roll" },
    { .key = "pitch_damping",
      .kind = SCHULER_FIELD_NUMBER,
      .offset = offsetof(sea_spec, pitch_damping),
      .def = 0.4,
      .min = 0.01,
      .max = 2.0,
      .example = "0.4",
      .doc = "damping ratio of pitch" },
    FIELD_OPTIONAL("draught", sea_spec, draught_m, SCHULER_DIM_LENGTH, 6.0, 0.0, 500.0, "6 m",
                   "depth whose water the ship follows: waves fade with exp(-k depth)"),
    OVERLAY_LINES(sea_spec),
    OVERLAY_TIMES(sea_spec),
    { 0 },
};

extern const schuler_object schuler_overlay_sea_object;
const schuler_object schuler_overlay_sea_object = {
    .name = "sea",
    .doc = "a ship in waves: roll, pitch, heave, surge and sway",
    .size = sizeof(sea_spec),
    .fields = fields,
};

typedef struct {
    double height_m, modal_Hz;
} sea;

/* Bretschneider's two-parameter spectrum of the elevation. */
static double elevation(const void *user, double f_Hz)
{
    const sea *const w = user;
    const double x = w->modal_Hz / f_Hz, x4 = x * x * x * x;
    return 0.3125 * w->height_m * w->height_m * x4 / f_Hz * exp(-1.25 * x4);
}

/* Adds size |H| sin(w t + phase - delay) to a channel, H that of a damped oscillator. */
static void answer(overlay_line *line, int channel, double size, double phase_rad, double period_s,
                   double damping)
{
    const double r = (double)line->frequency_Hz * period_s;
    const double in_phase = 1.0 - r * r, across = 2.0 * damping * r;
    const double gain = size / hypot(in_phase, across), at = phase_rad - atan2(across, in_phase);
    line->in_phase[channel] += gain * sin(at);
    line->in_quadrature[channel] += gain * cos(at);
}

static void set_line(overlay_line *line, const sea_spec *s, overlay_sinusoid wave)
{
    static const double g_mps2 = 9.80665;
    const double omega = 2.0 * SCHULER_PI * (double)wave.frequency_Hz, k = omega * omega / g_mps2;
    const double a_m = wave.amplitude * exp(-k * s->draught_m), phase = wave.phase_rad;
    const double ahead = cos(s->from_rad), right = sin(s->from_rad);
    line->frequency_Hz = wave.frequency_Hz;
    /* Elevation a cos(w t + phase), water moves on circles: a sin(w t + phase) with the waves. */
    line->in_phase[OVERLAY_HEAVE] = -a_m * cos(phase);
    line->in_quadrature[OVERLAY_HEAVE] = a_m * sin(phase);
    line->in_phase[OVERLAY_SURGE] = -ahead * a_m * sin(phase);
    line->in_quadrature[OVERLAY_SURGE] = -ahead * a_m * cos(phase);
    line->in_phase[OVERLAY_SWAY] = -right * a_m * sin(phase);
    line->in_quadrature[OVERLAY_SWAY] = -right * a_m * cos(phase);
    answer(line, OVERLAY_ROLL, right * k * a_m, phase, s->roll_period_s, s->roll_damping);
    answer(line, OVERLAY_PITCH, -ahead * k * a_m, phase, s->pitch_period_s, s->pitch_damping);
}

static schuler_status add(const void *spec, schuler_overlay *o, schuler_diagnostics *d)
{
    const sea_spec *const s = spec;
    const bool has_both = !isnan(s->height_m) && !isnan(s->period_s);
    const bool has_none = isnan(s->height_m) && isnan(s->period_s);
    if (s->state > 0 ? !has_none : !has_both) {
        schuler_diagnose(d, SCHULER_ERR_INPUT, &s->place,
                         "sea: either 'state', or 'height' and 'period'");
        return SCHULER_ERR_INPUT;
    }
    const sea w = { s->state > 0 ? sea_states[s->state - 1].height_m : s->height_m,
                    1.0 / (s->state > 0 ? sea_states[s->state - 1].period_s : s->period_s) };
    /* But for 1 % of the power at the low end and 1.5 % at the high one all of it. */
    const overlay_spectrum spectrum = { 0.7 * w.modal_Hz, 3.0 * w.modal_Hz, elevation, &w };
    overlay_group *const group =
        schuler_overlay_group(o, &s->times, (size_t)s->lines, &s->place, d);
    if (!group) return SCHULER_ERR_INPUT;
    for (size_t i = 0; i < group->count; i++) {
        const overlay_luck luck = { (uint64_t)s->seed, o->index, 0 };
        set_line(&group->lines[i], s, schuler_spectrum_line(&spectrum, i, group->count, luck));
    }
    return SCHULER_OK;
}

extern const schuler_overlay_kind schuler_overlay_sea;
const schuler_overlay_kind schuler_overlay_sea = {
    .object = &schuler_overlay_sea_object,
    .source =
        "C. L. Bretschneider 1959 (spectrum); O. M. Faltinsen, Sea Loads on Ships, 1990 (wave "
        "slope and orbital motion)",
    .add = add,
};
