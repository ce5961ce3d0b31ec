/* SPDX-License-Identifier: MIT */
#include "tools/truth_files.h"
#include "scenarios/trajectory_file.h"
#include "tools/data_file.h"
#include "tools/messages.h"
#include "tools/stop.h"
#include "tools/terminal.h"
#include <stdlib.h>
#include <string.h>

char *truth_files_command(int argc, char *const *argv)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_./=:,+-@%";
    char *text = NULL;
    size_t length = 0;
    FILE *const out = open_memstream(&text, &length);
    if (!out) return NULL;
    fputs(argv[0], out); /* "schuler truth" */
    for (int i = 1; i < argc; i++) {
        const bool quoted = !argv[i][0] || argv[i][strspn(argv[i], plain)];
        fputs(quoted ? " '" : " ", out);
        for (const char *p = argv[i]; *p; p++) {
            if (*p == '\'')
                fputs("'\\''", out);
            else
                fputc(*p, out);
        }
        if (quoted) fputc('\'', out);
    }
    const bool failed = ferror(out);
    if (fclose(out) == EOF || failed) {
        free(text);
        return NULL;
    }
    return text;
}

static void put_reference(data_file *out, const schuler_truth *truth, double t_s)
{
    schuler_truth_state state;
    schuler_truth_at(truth, t_s, &state);
    const schuler_trajectory_row row = {
        t_s, state.llh, state.v_n, state.roll_rad, state.pitch_rad, state.heading_rad
    };
    double values[SCHULER_TRAJECTORY_COLUMNS];
    schuler_trajectory_values(&row, values);
    data_file_put(out, values);
}

static void put_rates(data_file *out, const schuler_truth *truth, double t_s)
{
    schuler_vec3 omega_ib_b, f_ib_b;
    schuler_truth_rates(truth, t_s, &omega_ib_b, &f_ib_b);
    const double values[SCHULER_IMU_COLUMNS] = {
        t_s,         omega_ib_b.v[0], omega_ib_b.v[1], omega_ib_b.v[2],
        f_ib_b.v[0], f_ib_b.v[1],     f_ib_b.v[2]
    };
    data_file_put(out, values);
}

static void put_increments(data_file *out, const schuler_truth_block *block, int k, double t_s)
{
    const double values[SCHULER_IMU_COLUMNS] = {
        t_s,
        block->dtheta_ib_b[0][k],
        block->dtheta_ib_b[1][k],
        block->dtheta_ib_b[2][k],
        block->dv_ib_b[0][k],
        block->dv_ib_b[1][k],
        block->dv_ib_b[2][k],
    };
    data_file_put(out, values);
}

typedef struct {
    const schuler_truth *truth;
    const truth_files *wanted;
    data_file imu, reference;
    progress bar;
} writer;

static exit_code put_rows(writer *w)
{
    const schuler_truth *const truth = w->truth;
    const int64_t steps = schuler_truth_steps(truth), every = w->wanted->every;
    const double dt_s = schuler_truth_dt(truth);
    const bool increments = w->wanted->imu && !w->wanted->rates;
    const bool rates = w->wanted->imu && w->wanted->rates;
    if (w->wanted->reference) put_reference(&w->reference, truth, 0.0);
    if (rates) put_rates(&w->imu, truth, 0.0);
    for (int64_t first = 0; first < steps; first += SCHULER_BLOCK) {
        schuler_truth_block block;
        const int n = steps - first < SCHULER_BLOCK ? (int)(steps - first) : SCHULER_BLOCK;
        if (increments) schuler_truth_block_compute(truth, schuler_isa_best(), first, n, &block);
        for (int k = 0; k < n; k++) {
            const int64_t step = first + k + 1;
            const double t_s = (double)step * dt_s;
            if (increments) put_increments(&w->imu, &block, k, t_s);
            if (rates) put_rates(&w->imu, truth, t_s);
            if (w->wanted->reference && (step % every == 0 || step == steps))
                put_reference(&w->reference, truth, t_s);
        }
        if (*stop_flag()) {
            progress_end(&w->bar);
            fputs("schuler: interrupted; nothing was written\n", stderr);
            return EXIT_INTERRUPTED;
        }
        if (data_file_failed(&w->imu) || data_file_failed(&w->reference))
            return EXIT_DONE; /* said at the end */
        if (first / SCHULER_BLOCK % 512 == 0) progress_show(&w->bar, (double)first / (double)steps);
    }
    return EXIT_DONE;
}

static exit_code open_files(writer *w, const schuler_scenario *s)
{
    size_t length;
    const schuler_netcdf_attribute attributes[] = {
        { .name = "schuler_version", .text = SCHULER_VERSION },
        { .name = "command", .text = w->wanted->command },
        { .name = "scenario_name", .text = s->name },
        { .name = "scenario_sha256", .text = s->sha256 },
        { .name = "seed", .number = s->seed },
        { .name = "truth_gravity", .text = s->truth_gravity },
        { .name = "scenario",
          .text = s->document_count ? schuler_document_text(s->documents[0], &length) : "" },
    };
    const int count = sizeof attributes / sizeof attributes[0];
    const int64_t steps = schuler_truth_steps(w->truth), every = w->wanted->every;
    exit_code code = EXIT_DONE;
    if (w->wanted->imu)
        code = data_file_open(&w->imu, w->wanted->imu,
                              w->wanted->rates ? &schuler_rates_table : &schuler_imu_table,
                              w->wanted->rates ? steps + 1 : steps, attributes, count);
    if (code == EXIT_DONE && w->wanted->reference)
        code = data_file_open(&w->reference, w->wanted->reference, &schuler_trajectory_table,
                              1 + steps / every + (steps % every != 0), attributes, count);
    return code;
}

exit_code truth_files_write(const schuler_truth *truth, const schuler_scenario *scenario,
                            const truth_files *wanted)
{
    writer w = { .truth = truth, .wanted = wanted, .bar = progress_start(wanted->quiet) };
    exit_code code = open_files(&w, scenario);
    if (code == EXIT_DONE) code = put_rows(&w);
    progress_end(&w.bar);
    if (code == EXIT_DONE) code = data_file_complete(&w.imu);
    if (code == EXIT_DONE) code = data_file_publish(&w.reference);
    if (code == EXIT_DONE) code = data_file_publish(&w.imu);
    data_file_drop(&w.imu);
    data_file_drop(&w.reference);
    return code;
}
