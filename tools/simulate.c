/* SPDX-License-Identifier: MIT */
#include "tools/simulate.h"
#include "tools/messages.h"
#include "tools/result_csv.h"
#include "tools/stop.h"
#include "tools/terminal.h"

/* What the engine's callbacks write to. */
typedef struct {
    progress *progress;
    FILE *errors; /* or NULL */
} sink;

static void on_progress(void *user, double fraction)
{
    const sink *s = user;
    progress_show(s->progress, fraction);
}

static schuler_status on_errors(void *user, const char *id, int run, const schuler_error_row *rows,
                                size_t count)
{
    const sink *s = user;
    errors_csv_rows(s->errors, id, run, rows, count);
    return ferror(s->errors) ? SCHULER_ERR_FILE : SCHULER_OK; /* a full disk: stop at once */
}

schuler_run_options simulation_options(const simulation_arguments *a)
{
    return (schuler_run_options){ .truth = a->truth,
                                  .threads = a->threads,
                                  .rows = a->rows,
                                  .has_isa = a->has_isa,
                                  .isa = a->isa,
                                  .stop = stop_flag() };
}

exit_code simulation_status(schuler_status status, const schuler_error *error)
{
    if (status == SCHULER_ERR_INTERRUPTED)
        fputs("schuler: interrupted; nothing was written\n", stderr);
    else if (status != SCHULER_OK)
        say_error(error);
    return exit_of(status);
}

exit_code simulate(const schuler_scenario *scenario, const simulation_arguments *a, outfile *errors,
                   schuler_result **out)
{
    schuler_error error = { 0 };
    progress bar = progress_start(a->quiet);
    bar.note = a->note;
    sink s = { &bar, errors ? errors->file : NULL };
    if (s.errors) errors_csv_header(s.errors);
    schuler_run_options wanted = simulation_options(a);
    wanted.progress = on_progress;
    wanted.errors = s.errors ? on_errors : NULL;
    wanted.user = &s;
    const schuler_status status = schuler_simulate(scenario, &wanted, out, &error);
    progress_end(&bar);
    if (status == SCHULER_ERR_FILE && s.errors && ferror(s.errors))
        return outfile_complete(errors); /* says which file and why */
    return simulation_status(status, &error);
}

exit_code simulate_linear(const schuler_scenario *scenario, const simulation_arguments *a,
                          schuler_covariance **out)
{
    schuler_error error = { 0 };
    const schuler_run_options wanted = simulation_options(a);
    return simulation_status(schuler_covariance_run(scenario, &wanted, out, &error), &error);
}

exit_code simulation_truth(const schuler_scenario *scenario, simulation_arguments *a,
                           schuler_truth **out)
{
    schuler_error error = { 0 };
    const schuler_status status = schuler_scenario_truth(scenario, out, &error);
    if (status == SCHULER_OK) a->truth = *out;
    return simulation_status(status, &error);
}
