/* SPDX-License-Identifier: MIT */
#include "tools/result_directory.h"
#include "scenarios/result_netcdf.h"
#include "tools/messages.h"
#include "tools/result_csv.h"
#include "tools/result_json.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Without its library there is no such file, and the rest is as good as ever. */
static bool netcdf_usable(const simulation_arguments *a)
{
    schuler_error error = { 0 };
    if (schuler_result_netcdf_usable(&error) == SCHULER_OK) return true;
    if (!a->quiet) say_warning("no result.nc: %s", error.message);
    return false;
}

static exit_code write_netcdf(const outdir *dir, const schuler_result *result,
                              const schuler_covariance *linear, const char *switches)
{
    outfile file = { 0 };
    schuler_error error = { 0 };
    char *command;
    if (asprintf(&command, "schuler run SCENARIO%s", switches) < 0)
        return say_failure("out of memory");
    exit_code code = outdir_file(dir, &file, "result.nc");
    if (code == EXIT_DONE &&
        schuler_result_netcdf_write(file.partial, result, linear, command, &error) != SCHULER_OK)
        code = say_failure("cannot write %s: %s (%s)", file.target, strerror(outfile_reason(&file)),
                           error.message);
    if (code == EXIT_DONE) code = outfile_publish(&file);
    outfile_drop(&file);
    free(command);
    return code;
}

exit_code result_directory_write(outdir *dir, outfile *errors, const schuler_result *result,
                                 const schuler_covariance *linear, const simulation_arguments *a,
                                 bool *netcdf)
{
    *netcdf = netcdf_usable(a);
    outfile budget = { 0 }, json = { 0 }, scenario = { 0 };
    char *switches = simulation_switches(a);
    exit_code code = switches ? outfile_publish(errors) : say_failure("out of memory");
    if (code == EXIT_DONE) code = outdir_file(dir, &budget, "budget.csv");
    if (code == EXIT_DONE) {
        budget_csv(budget.file, result, linear);
        code = outfile_publish(&budget);
    }
    if (code == EXIT_DONE) code = outdir_file(dir, &json, "result.json");
    if (code == EXIT_DONE) code = json_put(result_json(result, linear), json.file);
    if (code == EXIT_DONE) code = outfile_publish(&json);
    if (code == EXIT_DONE && *netcdf) code = write_netcdf(dir, result, linear, switches);
    if (code == EXIT_DONE) code = outdir_file(dir, &scenario, "scenario.yaml");
    if (code == EXIT_DONE) {
        scenario_copy(scenario.file, result->scenario, switches);
        code = outfile_publish(&scenario);
    }
    if (code == EXIT_DONE) code = outdir_publish(dir);
    outfile_drop(&budget);
    outfile_drop(&json);
    outfile_drop(&scenario);
    free(switches);
    return code;
}
