/* SPDX-License-Identifier: MIT */
/* Missions for tests: a scenario written in the test, or one of the gallery, and what a simulation
 * said. */
#ifndef SCHULER_TESTS_MISSION_H
#define SCHULER_TESTS_MISSION_H

#include "check.h"
#include "scenarios/simulation.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static inline schuler_scenario *mission_file(const char *path, const schuler_overrides *overrides)
{
    schuler_scenario *s = NULL;
    schuler_diagnostics d = { 0 };
    if (schuler_scenario_load(&s, path, overrides, &d) != SCHULER_OK)
        for (size_t i = 0; i < d.kept; i++)
            print_error("%s:%d:%d: %s\n", path, d.items[i].place.line, d.items[i].place.column,
                        d.items[i].message);
    schuler_diagnostics_free(&d);
    assert_non_null(s);
    return s;
}

/* A gallery file; the tests know where the sources are. */
static inline schuler_scenario *mission_gallery(const char *name,
                                                const schuler_overrides *overrides)
{
    char path[1024];
    snprintf(path, sizeof(path), "%s/scenarios/%s.yaml", getenv("SCHULER_SOURCE_DIR"), name);
    return mission_file(path, overrides);
}

static inline schuler_scenario *mission_text(const char *text)
{
    char path[] = "/tmp/schuler-test-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(write(fd, text, strlen(text)), (ssize_t)strlen(text));
    close(fd);
    schuler_scenario *s = mission_file(path, NULL);
    unlink(path);
    return s;
}

static inline schuler_result *mission_run(const schuler_scenario *s,
                                          const schuler_run_options *options)
{
    schuler_result *r = NULL;
    schuler_error err = { 0 };
    if (schuler_simulate(s, options, &r, &err) != SCHULER_OK) print_error("%s\n", err.message);
    assert_non_null(r);
    return r;
}

static inline const schuler_budget_row *mission_row(const schuler_result *r, const char *id)
{
    if (strcmp(id, "all") == 0) return &r->all;
    if (strcmp(id, "none") == 0) return &r->none;
    for (size_t i = 0; i < r->row_count; i++)
        if (strcmp(r->rows[i].id, id) == 0) return &r->rows[i];
    fail_msg("no row '%s'", id);
    return NULL;
}

/* Keeps the report rows of one source and run. */
typedef struct {
    const char *id;
    int run;
    schuler_error_row *rows;
    size_t count;
} mission_trace;

static inline schuler_status mission_keep(void *user, const char *id, int run,
                                          const schuler_error_row *rows, size_t count)
{
    mission_trace *t = user;
    if (strcmp(id, t->id) != 0 || run != t->run) return SCHULER_OK;
    free(t->rows);
    t->rows = malloc(count * sizeof(*rows));
    if (!t->rows) return SCHULER_ERR_MEMORY;
    memcpy(t->rows, rows, count * sizeof(*rows));
    t->count = count;
    return SCHULER_OK;
}

/* The errors of one source (or "all", "none") of run 0 at every report; the caller frees rows. */
static inline mission_trace mission_errors(const schuler_scenario *s, const char *id)
{
    mission_trace t = { .id = id };
    const schuler_run_options options = { .errors = mission_keep, .user = &t };
    schuler_result_free(mission_run(s, &options));
    assert_non_null(t.rows);
    return t;
}

#endif
