/* SPDX-License-Identifier: MIT */
/* The scenario file as its table has it, and the checks that look at more than one key. Private to
 * the scenario reader. */
#ifndef SCHULER_SCENARIOS_READER_H
#define SCHULER_SCENARIOS_READER_H

#include "core/schema_private.h"
#include "scenarios/scenario.h"

typedef struct {
    schuler_place place;
    const char *name;
    int64_t seed, runs;
    struct {
        schuler_place place;
        const schuler_node *gravity;
        const char *gravity_path;
    } truth;
    const schuler_node *trajectory, *imu;
    struct {
        schuler_place place;
        schuler_value position, velocity, tilt, heading;
        struct {
            schuler_place place;
            double for_s;
            const char *method;
            struct {
                schuler_place place;
                double roll_rad, pitch_rad, heading_rad, period_s;
            } sway;
        } align;
    } initial;
    struct {
        schuler_place place;
        const schuler_node *frame, *gravity;
        const char *vertical, *samples_per_update;
        double baro_time_s; /* NAN = not given */
        const schuler_node *coning;
    } navigation;
    struct {
        schuler_place place;
        schuler_value errors[SCHULER_BARO_ERRORS];
        double gauss_markov_time_s; /* NAN = not given */
    } baro;
    struct {
        schuler_place place;
        schuler_text_list only, without;
    } errors;
    struct {
        schuler_place place;
        double drift_mps, position_m; /* NAN = not given */
        const schuler_node *statistic;
        const char *metric;
    } requirement;
    struct {
        schuler_place place;
        double every_s; /* NAN = not given */
    } report;
} schuler_scenario_file;

extern const schuler_object schuler_scenario_object;
/** The requirement, with all that is wrong with it; a position has no rate yet. */
void schuler_read_requirement(schuler_reading *r, const schuler_scenario_file *file,
                              schuler_requirement *out);

extern const char *const schuler_metric_names[]; /* in the order of schuler_metric */

/** Everything that can be checked without the compiled trajectory, moved into the scenario. */
void schuler_scenario_check(schuler_reading *r, const schuler_scenario_file *file,
                            schuler_scenario *s);

/** What depends on the duration: the report interval, doubts about the requirement. */
void schuler_scenario_check_duration(schuler_reading *r, const schuler_scenario_file *file,
                                     schuler_scenario *s);

/** Every name in errors.only and errors.without is a source or a group of this scenario. */
void schuler_scenario_check_sources(schuler_reading *r, const schuler_scenario *s);

/** Split "a, b" at commas. */
void schuler_split_words(schuler_reading *r, const char *text, const char *shown,
                         schuler_text_list *out);

#endif
