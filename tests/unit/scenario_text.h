/* SPDX-License-Identifier: MIT */
/* Scenario texts on disk for a moment, and what the reader says of them. */
#ifndef SCHULER_TESTS_SCENARIO_TEXT_H
#define SCHULER_TESTS_SCENARIO_TEXT_H

#include "check.h"
#include "scenarios/scenario.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    char dir[40], path[60];
    schuler_diagnostics d;
    schuler_scenario *s;
    schuler_status rc;
} loaded;

static inline void write_file(const char *dir, const char *name, const char *text, size_t length)
{
    char path[100];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(text, 1, length, file) != length || fclose(file) != 0)
        fail_msg("cannot write %s", path);
}

static inline void make_folder(loaded *l)
{
    memset(l, 0, sizeof *l);
    strcpy(l->dir, "/tmp/schuler-scenario-XXXXXX");
    if (!mkdtemp(l->dir)) fail_msg("no temporary folder");
    snprintf(l->path, sizeof l->path, "%s/s.yaml", l->dir);
}

static inline void load(loaded *l, const char *text, const schuler_overrides *o)
{
    make_folder(l);
    write_file(l->dir, "s.yaml", text, strlen(text));
    l->rc = schuler_scenario_load(&l->s, l->path, o, &l->d);
    assert_int_equal(l->rc == SCHULER_OK, l->d.errors == 0);
    assert_int_equal(l->rc == SCHULER_OK, l->s != NULL);
}

static inline void load_good(loaded *l, const char *text, const schuler_overrides *o)
{
    load(l, text, o);
    for (size_t i = 0; i < l->d.kept; i++)
        if (!l->d.items[i].is_warning) fail_msg("%s", l->d.items[i].message);
}

static inline void unload(loaded *l)
{
    schuler_scenario_free(l->s);
    schuler_diagnostics_free(&l->d);
    unlink(l->path);
    rmdir(l->dir);
}

/* The index of the parameter of a triad, which must exist. */
static inline int param_index(const schuler_triad *triad, const char *key)
{
    const schuler_param *params = triad->params;
    for (int i = 0; params[i].key; i++)
        if (strcmp(params[i].key, key) == 0) return i;
    fail_msg("no parameter %s", key);
    return -1;
}

static inline const schuler_value *value_of(const schuler_imu *imu, schuler_instrument instrument,
                                            const char *key)
{
    const schuler_triad *triad = &imu->triad[instrument];
    return &triad->values[param_index(triad, key)];
}

#define TRAJECTORY                                                                                 \
    "trajectory: {kind: static, start: {lat: 45 deg, lon: 7 deg, height: 0 m}, for: 2 h}\n"

#endif
