/* SPDX-License-Identifier: MIT */
#include "scenarios/simulation.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    schuler_diagnostics mistakes = { 0 };
    schuler_scenario *scenario;
    if (argc != 2 || schuler_scenario_load(&scenario, argv[1], NULL, &mistakes) != SCHULER_OK)
        return 2;
    const schuler_run_options options = { .threads = 1 };
    schuler_result *result;
    if (schuler_simulate(scenario, &options, &result, NULL) != SCHULER_OK) return 3;
    printf("%s: %.2f m after %g s\n", scenario->name, result->all.rms_end_m, result->duration_s);
    schuler_result_free(result);
    schuler_scenario_free(scenario);
    return 0;
}
