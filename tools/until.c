/* SPDX-License-Identifier: MIT */
#include "tools/until.h"
#include "scenarios/metrics.h"
#include "tools/messages.h"
#include "tools/result_units.h"
#include "tools/simulate.h"
#include "tools/terminal.h"
#include <math.h>

static void on_progress(void *user, double fraction)
{
    progress_show(user, fraction);
}

static schuler_requirement asked_of(const schuler_scenario *s)
{
    return (schuler_requirement){ .given = true,
                                  .statistic = s->requirement.given ? s->requirement.statistic
                                                                    : SCHULER_STAT_CEP,
                                  .confidence = 0.95 };
}

static exit_code joint_runs(const schuler_scenario *s, const simulation_arguments *a,
                            schuler_judgement *out)
{
    schuler_error error = { 0 };
    schuler_result *result = NULL;
    progress bar = progress_start(a->quiet);
    bar.note = a->note;
    schuler_run_options wanted = simulation_options(a);
    wanted.rows = SCHULER_ROWS_NONE;
    wanted.progress = on_progress;
    wanted.user = &bar;
    schuler_status status = schuler_simulate(s, &wanted, &result, &error);
    progress_end(&bar);
    if (status == SCHULER_OK) {
        const schuler_requirement asked = asked_of(s);
        status = schuler_judge(&asked, &result->all, out);
        if (status != SCHULER_OK) schuler_fail(&error, status, NULL, "out of memory");
        schuler_result_free(result);
    }
    return simulation_status(status, &error);
}

/* Half the width of the limits over the drift; INFINITY: too few runs for limits. */
static double precision_of(const schuler_judgement *j)
{
    const double half_mps = 0.5 * (j->upper_mps - j->lower_mps);
    return half_mps > 0.0 ? half_mps / j->value_mps : 0.0;
}

static void put_note(simulation_arguments *a, const schuler_scenario *s, const schuler_judgement *j)
{
    const double value = nmi_per_h(j->value_mps), precision = precision_of(j);
    if (isfinite(precision))
        snprintf(a->note, sizeof a->note, "%.4g nmi/h %s %s %.2g %%", value,
                 statistic_name(asked_of(s).statistic), terminal_utf8() ? "±" : "+-",
                 100.0 * precision);
}

exit_code until_runs(schuler_scenario *scenario, simulation_arguments *a)
{
    enum { TELLING = 100 }; /* runs whose limits are good enough to foresee how many it takes */
    schuler_scenario tried = *scenario;
    for (;;) {
        schuler_judgement j;
        const exit_code code = joint_runs(&tried, a, &j);
        if (code != EXIT_DONE) return code;
        put_note(a, scenario, &j);
        const double precision = precision_of(&j), times = precision / a->until;
        if (precision <= a->until) break;
        const double needed = tried.runs * times * times;
        if (tried.runs == SIMULATION_RUNS_MAX ||
            (tried.runs >= TELLING && needed > 4.0 * SIMULATION_RUNS_MAX))
            return say_bad_input("--until %g%%: after %d runs the drift is known to %.3g %%; about "
                                 "%.2g runs would be needed, and there can be %d",
                                 100.0 * a->until, tried.runs, 100.0 * precision, needed,
                                 SIMULATION_RUNS_MAX);
        tried.runs = tried.runs > SIMULATION_RUNS_MAX / 2 ? SIMULATION_RUNS_MAX : 2 * tried.runs;
    }
    scenario->runs = a->overrides.runs = tried.runs;
    a->overrides.has_runs = 1;
    return EXIT_DONE;
}
