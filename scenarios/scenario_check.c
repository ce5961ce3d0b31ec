/* SPDX-License-Identifier: MIT */
/* Checks of a scenario that look at registries, at more than one key or at the compiled path. */
#include "mechanization/mechanization.h"
#include "scenarios/reader.h"
#include "scenarios/source_count.h"
#include "scenarios/sources.h"
#include "scenarios/vertical.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Names of data sets are open: GeographicLib finds what is installed. A near miss of a known name
 * is a slip all the same, and a name is not a path. */
/* A name, perhaps with a degree: egm96:120. Returned as schuler_field_open wants it, in the folder that
 * the scenario names. */
static const char *check_gravity(schuler_reading *r, const schuler_node *node, const char *what,
                                 const char *folder)
{
    static const char *const known[] = { "wgs84", "grs80", "egm84", "egm96", "egm2008" };
    enum { COUNT = sizeof known / sizeof known[0], BUILT_IN = 2 };
    if (!node) return known[0];
    const char *text = schuler_read_scalar(r, node, what, "the name of a gravity model");
    if (!text) return known[0];
    const size_t length = strcspn(text, ":");
    const char *const name = schuler_arena_printf(r->arena, "%.*s", (int)length, text);
    const char *const whole =
        schuler_arena_printf(r->arena, "%s%s%s", folder ? folder : "", folder ? "/" : "", text);
    if (!name || !whole) return known[0];
    bool is_known = false, is_built_in = false;
    for (int i = 0; i < COUNT; i++) {
        if (strcmp(name, known[i]) != 0) continue;
        is_known = true;
        is_built_in = i < BUILT_IN;
    }
    const char *const degree = text[length] ? text + length + 1 : NULL;
    const bool is_number = degree && strspn(degree, "0123456789") == strlen(degree) &&
                           strlen(degree) > 0 && strlen(degree) < 6 && atoi(degree) >= 2;
    if (degree && (is_built_in || !is_number)) {
        schuler_diagnose(
            r->d, SCHULER_ERR_INPUT, &node->place,
            "%s: '%.60s': a degree is a whole number from 2 on behind the name of a data "
            "set, as in egm96:120",
            what, text);
        return known[0];
    }
    if (is_known) return is_built_in ? text : whole;
    const bool is_name = name[strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                           "0123456789_-")] == '\0';
    const bool is_variant = strncmp(name, "egm2008-", 8) == 0 || strncmp(name, "egm96-", 6) == 0;
    if (is_name && (is_variant || !schuler_nearest(name, known, COUNT))) return whole;
    char lead[200];
    snprintf(lead, sizeof lead, "%s: unknown gravity model '%.60s'", what, text);
    schuler_diagnose_unknown(r, &node->place, lead, name, known, COUNT);
    return known[0];
}

/* Where data sets are looked for: relative to the scenario; NULL: where GeographicLib looks. */
static const char *gravity_folder(schuler_reading *r, const schuler_scenario_file *file,
                                  const schuler_scenario *s)
{
    const char *const path = file->truth.gravity_path;
    if (!path || path[0] == '/') return path;
    return schuler_arena_printf(r->arena, "%s%s", s->folder, path);
}

static int check_frame(schuler_reading *r, const schuler_node *node)
{
    const char *const text =
        node ? schuler_read_scalar(r, node, "navigation.frame", "the name of a frame") : "ecef";
    const int index = text ? schuler_mechanization_find(text) : -1;
    if (index >= 0 || !text) return index;
    const schuler_mechanization *const *all = schuler_mechanizations(SCHULER_ISA_SCALAR);
    const char *names[64];
    size_t count = 0;
    for (; all[count] && count < 64; count++) names[count] = all[count]->name;
    char lead[160];
    snprintf(lead, sizeof lead, "navigation.frame: there is no frame '%.60s'", text);
    schuler_diagnose_unknown(r, node ? &node->place : NULL, lead, text, names, count);
    return index;
}

static const schuler_coning_algorithm *check_coning(schuler_reading *r, const schuler_node *node)
{
    const char *const text =
        node ? schuler_read_scalar(r, node, "navigation.coning", "the name of an algorithm") : NULL;
    if (!text) return &schuler_coning_algorithms[0];
    const int index = schuler_coning_algorithm_find(text);
    if (index >= 0) return &schuler_coning_algorithms[index];
    const char *names[64];
    size_t count = 0;
    for (; schuler_coning_algorithms[count].name && count < 64; count++)
        names[count] = schuler_coning_algorithms[count].name;
    char lead[160];
    snprintf(lead, sizeof lead, "navigation.coning: there is no algorithm '%.60s'", text);
    schuler_diagnose_unknown(r, &node->place, lead, text, names, count);
    return &schuler_coning_algorithms[0];
}

static void check_align(schuler_reading *r, const schuler_scenario_file *file,
                        schuler_align_spec *out)
{
    const char *const method = file->initial.align.method;
    if (!file->initial.align.place.file) return;
    *out = (schuler_align_spec){
        .given = true,
        .fine = strcmp(method, "fine") == 0,
        .place = file->initial.align.place,
        .for_s = file->initial.align.for_s,
        .sway = { file->initial.align.sway.roll_rad, file->initial.align.sway.pitch_rad,
                  file->initial.align.sway.heading_rad, file->initial.align.sway.period_s }
    };
    if (file->initial.tilt.given || file->initial.heading.given)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->initial.align.place,
                         "initial.align: tilt and heading are found by it and cannot be given too");
    const schuler_sway *const s = &out->sway;
    const bool sways = s->roll_rad > 0.0 || s->pitch_rad > 0.0 || s->heading_rad > 0.0;
    if (sways && (s->period_s < 0.5 || 3.0 * s->period_s > out->for_s))
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->initial.align.sway.place,
                         "initial.align.sway.period: %g s; allowed: 0.5 s to a third of the "
                         "alignment, %g s",
                         s->period_s, out->for_s / 3.0);
}

static void check_barometer(schuler_reading *r, const schuler_scenario_file *file,
                            schuler_scenario *s)
{
    const schuler_value *const weather = &file->baro.errors[SCHULER_BARO_GAUSS_MARKOV];
    memcpy(s->baro, file->baro.errors, sizeof s->baro);
    s->gauss_markov_time_s = file->baro.gauss_markov_time_s;
    if (weather->given && isnan(s->gauss_markov_time_s))
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &weather->place,
                         "'baro' needs the key 'gauss_markov_time' beside 'gauss_markov', for "
                         "example: 1 h");
    else if (!weather->given && !isnan(s->gauss_markov_time_s))
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->baro.place,
                         "'baro' has 'gauss_markov_time' without 'gauss_markov'");
    if (file->baro.place.file && s->vertical != SCHULER_VERTICAL_BARO)
        schuler_warn(r->d, &file->baro.place,
                     "'baro' has no effect: it acts with navigation.vertical: baro only");
}

static void check_vertical(schuler_reading *r, const schuler_scenario_file *file,
                           schuler_scenario *s)
{
    const char *const word = file->navigation.vertical;
    const double written_s = file->navigation.baro_time_s;
    s->vertical = strcmp(word, "free") == 0   ? SCHULER_VERTICAL_FREE
                  : strcmp(word, "baro") == 0 ? SCHULER_VERTICAL_BARO
                                              : SCHULER_VERTICAL_TRUTH;
    s->baro_time_s = isnan(written_s) ? SCHULER_BARO_TIME_S : written_s;
    if (!isnan(written_s) && s->vertical != SCHULER_VERTICAL_BARO)
        schuler_warn(r->d, &file->navigation.place,
                     "navigation.baro_time has no effect: it acts with vertical: baro only");
    check_barometer(r, file, s);
}

/* The loop against the interval of its updates, once the rate is known. */
static void check_baro_time(schuler_reading *r, const schuler_scenario_file *file,
                            const schuler_scenario *s)
{
    if (s->vertical != SCHULER_VERTICAL_BARO) return;
    const double interval_s =
        schuler_vertical_interval(s->imu.rate_hz, s->samples_per_update) / s->imu.rate_hz;
    if (s->baro_time_s < SCHULER_BARO_UPDATES_MIN * interval_s)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->navigation.place,
                         "navigation.baro_time: %g s is too short for navigation updates every %g "
                         "s; allowed: %g s and more",
                         s->baro_time_s, interval_s, SCHULER_BARO_UPDATES_MIN * interval_s);
}

void schuler_scenario_check(schuler_reading *r, const schuler_scenario_file *file,
                            schuler_scenario *s)
{
    s->name = file->name;
    s->seed = (uint64_t)file->seed;
    s->runs = (int)file->runs;
    const char *const folder = gravity_folder(r, file, s);
    s->truth_gravity = check_gravity(r, file->truth.gravity, "truth.gravity", folder);
    s->nav_gravity = check_gravity(r, file->navigation.gravity, "navigation.gravity", folder);
    s->frame = check_frame(r, file->navigation.frame);
    check_vertical(r, file, s);
    s->coning = check_coning(r, file->navigation.coning);
    s->order = s->coning->order;
    s->samples_per_update = *file->navigation.samples_per_update - '0'; /* by its choices */
    if (s->coning->samples > 1 && s->samples_per_update > 1)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->navigation.coning->place,
                         "navigation.coning: '%s' has groups of its own and needs "
                         "samples_per_update: 1",
                         s->coning->name);
    s->position = file->initial.position;
    s->velocity = file->initial.velocity;
    s->tilt = file->initial.tilt;
    s->heading = file->initial.heading;
    check_align(r, file, &s->align);
    s->only = file->errors.only;
    s->without = file->errors.without;
    schuler_read_requirement(r, file, &s->requirement);
}

/* Round figures, so that times in tables are round too. */
static double usual_interval(double duration_s)
{
    enum { REPORTS = 720 };
    static const double steps[] = { 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600 };
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++)
        if (duration_s <= REPORTS * steps[i]) return steps[i];
    return 3600.0 * ceil(duration_s / (REPORTS * 3600.0));
}

/* The path must stay where the frame is good. */
static void check_frame_reach(schuler_reading *r, const schuler_scenario_file *file,
                              const schuler_scenario *s)
{
    enum { LOOKS = 16 }; /* in a piece: 16 s of flight at most, some kilometres */
    const schuler_mechanization *const frame = schuler_mechanizations(SCHULER_ISA_SCALAR)[s->frame];
    if (frame->latitude_max_rad == 0.0) return;
    for (size_t i = 0; i < s->path.count; i++)
        for (int j = 0; j <= LOOKS; j++) {
            const schuler_piece *const piece = &s->path.pieces[i];
            const schuler_vec3 r_e = schuler_piece_at(piece, 2.0 * j / LOOKS - 1.0).r_e;
            if (!schuler_mechanization_ends(frame, r_e)) continue;
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->navigation.frame->place,
                             "navigation.frame: '%s' ends at %g deg of latitude and the trajectory "
                             "is at %.3f deg at %.9g s; use wander or ecef",
                             frame->name, frame->latitude_max_rad / SCHULER_RAD_PER_DEG,
                             schuler_llh_from_ecef(r_e).lat_rad / SCHULER_RAD_PER_DEG,
                             piece->t0_s + piece->duration_s * j / LOOKS);
            return;
        }
}

void schuler_scenario_check_duration(schuler_reading *r, const schuler_scenario_file *file,
                                     schuler_scenario *s)
{
    enum { REPORTS_MAX = 100000 };
    const double schuler_period_s = 84.4 * 60.0, duration_s = s->path.duration_s;
    const double every_s = file->report.every_s;
    check_baro_time(r, file, s);
    check_frame_reach(r, file, s);
    s->report_s = isnan(every_s) ? usual_interval(duration_s) : every_s;
    if (s->report_s > duration_s) s->report_s = duration_s;
    const schuler_motion start = schuler_path_at(&s->path, 0.0);
    if (s->align.given && schuler_vec3_norm(start.v_e) > 1e-6)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &s->align.place,
                         "initial.align: the mission starts at %.3g m/s; self-alignment needs a "
                         "vehicle at rest",
                         schuler_vec3_norm(start.v_e));
    const double lat_rad = schuler_llh_from_ecef(start.r_e).lat_rad;
    if (s->align.given && fabs(lat_rad) > 89.0 * SCHULER_RAD_PER_DEG)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &s->align.place,
                         "initial.align: there is no north to be found at a latitude of %.2f deg; "
                         "allowed: up to 89 deg",
                         lat_rad / SCHULER_RAD_PER_DEG);
    if (duration_s / s->report_s > REPORTS_MAX)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->report.place,
                         "report.every: this gives %.0f reports in %.0f s; allowed: %d",
                         duration_s / s->report_s, duration_s, REPORTS_MAX);
    if (s->report_s * s->imu.rate_hz < 1.0 - 1e-6)
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, &file->report.place,
                         "report.every: %g s is shorter than the interval of the samples, %g s",
                         s->report_s, 1.0 / s->imu.rate_hz);
    if (s->requirement.given && schuler_scenario_source_count(s) == 0 &&
        (s->without.count > 0 ||
         (s->only.count > 0 && !schuler_source_selected(s, "numerical", "numerical"))))
        schuler_diagnose(
            r->d, SCHULER_ERR_INPUT, &s->requirement.place,
            "there is nothing to hold the requirement against: the selection of error sources "
            "(errors.only, errors.without) leaves none that this scenario has");
    if (s->requirement.position_m > 0.0)
        s->requirement.drift_mps = s->requirement.position_m / duration_s;
    if (s->requirement.given && s->requirement.position_m == 0.0 && duration_s < schuler_period_s)
        schuler_warn(r->d, &s->requirement.place,
                     "the mission of %.0f s is shorter than one Schuler period (84.4 min), so the "
                     "drift depends on its length",
                     duration_s);
}

typedef struct {
    const char *names[2 * SCHULER_PARAMS_MAX + 24];
    size_t count;
} name_list;

static void add_name(name_list *list, const char *name)
{
    if (name && list->count < sizeof list->names / sizeof list->names[0])
        list->names[list->count++] = name;
}

static void add_sensor_names(schuler_reading *r, const schuler_scenario *s, name_list *list)
{
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_triad *const triad = &s->imu.triad[i];
        const char *const group = schuler_instrument_name((schuler_instrument)i);
        add_name(list, group);
        if (!triad->model) continue;
        const schuler_param *const params = triad->params;
        for (int k = 0; params[k].key; k++)
            if (params[k].number != 0)
                add_name(list, schuler_reading_path(r, group, params[k].key));
    }
}

static void check_names(schuler_reading *r, const schuler_text_list *words, const char *what,
                        const name_list *known)
{
    for (size_t i = 0; i < words->count; i++) {
        bool found = false;
        for (size_t k = 0; k < known->count && !found; k++)
            found = strcmp(words->items[i], known->names[k]) == 0;
        if (found) continue;
        char lead[200];
        snprintf(lead, sizeof lead, "%s: no error source or group '%.60s'", what, words->items[i]);
        schuler_diagnose_unknown(r, &words->places[i], lead, words->items[i], known->names,
                                 known->count);
    }
}

void schuler_scenario_check_sources(schuler_reading *r, const schuler_scenario *s)
{
    static const char *const others[] = {
        "initial", "initial.position",    "initial.velocity", "initial.tilt", "initial.heading",
        "gravity", "gravity.disturbance", "numerical",        "baro"
    };
    /* Names of a triad whose model is not known cannot be judged. */
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++)
        if (!s->imu.triad[i].model) return;
    name_list known = { .count = 0 };
    add_sensor_names(r, s, &known);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) add_name(&known, others[i]);
    for (int i = 0; i < SCHULER_BARO_ERRORS; i++)
        add_name(&known, schuler_reading_path(r, "baro", schuler_baro_key((schuler_baro_error)i)));
    check_names(r, &s->only, "errors.only", &known);
    check_names(r, &s->without, "errors.without", &known);
}

void schuler_split_words(schuler_reading *r, const char *text, const char *shown,
                         schuler_text_list *out)
{
    size_t count = 1;
    for (const char *at = text; *at; at++) count += *at == ',';
    char *copy = schuler_reading_alloc(r, strlen(text) + 1);
    const char **items = schuler_reading_alloc(r, count * sizeof *items);
    schuler_place *places = schuler_reading_alloc(r, count * sizeof *places);
    if (!copy || !items || !places) return;
    memcpy(copy, text, strlen(text) + 1);
    *out = (schuler_text_list){ items, places, 0 };
    for (char *rest = copy, *word; (word = strsep(&rest, ",")) != NULL;) {
        word += strspn(word, " \t");
        word[strcspn(word, " \t")] = '\0';
        if (*word == '\0') continue;
        items[out->count] = word;
        places[out->count++] = (schuler_place){ shown, 0, 0, 0 };
    }
}
