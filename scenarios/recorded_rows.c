/* SPDX-License-Identifier: MIT */
#include "scenarios/recorded_rows.h"
#include "scenarios/trajectory_file.h"
#include <stdlib.h>

static schuler_status append(schuler_recorded_samples *out, size_t *capacity,
                             const schuler_trajectory_row *row)
{
    if (out->count == *capacity) {
        const size_t more = *capacity ? 2 * *capacity : 1024;
        schuler_recorded_sample *const items = realloc(out->items, more * sizeof *items);
        if (!items) return SCHULER_ERR_MEMORY;
        out->items = items;
        *capacity = more;
    }
    const schuler_nav_state s = schuler_trajectory_state(row);
    out->items[out->count++] = (schuler_recorded_sample){ row->t_s, s.r_e, s.v_e, s.q_b_e };
    return SCHULER_OK;
}

schuler_status schuler_recorded_rows(schuler_recorded_samples *out, const char *path,
                                     schuler_diagnostics *d)
{
    enum {
        ROWS_MAX = 5000000
    }; /* a gigabyte or two with what is built on it; no trajectory is longer */
    schuler_csv *csv = NULL;
    schuler_error err = { 0 };
    size_t capacity = 0;
    int got_row = 1;
    *out = (schuler_recorded_samples){ .file = path };
    schuler_status status = schuler_csv_open(&csv, path, SCHULER_TRAJECTORY_HEADER, &err);
    while (status == SCHULER_OK && got_row && out->count < ROWS_MAX) {
        schuler_trajectory_row row;
        status = schuler_trajectory_next(csv, &row, &got_row, &err);
        if (status == SCHULER_OK && got_row && append(out, &capacity, &row) != SCHULER_OK)
            status = schuler_fail(&err, SCHULER_ERR_MEMORY, NULL, "out of memory for %.200s", path);
    }
    schuler_csv_close(csv);
    if (status != SCHULER_OK) schuler_diagnose_error(d, &err);
    return status;
}
