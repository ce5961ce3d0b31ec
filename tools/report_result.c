/* SPDX-License-Identifier: MIT */
#include "tools/messages.h"
#include "tools/report.h"
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static bool has_rows(const json_t *budget, json_error_t *error)
{
    size_t i;
    json_t *row;
    json_array_foreach(budget, i, row)
    {
        if (json_unpack_ex(row, error, JSON_VALIDATE_ONLY,
                           "{s:s, s:s, s:o, s:b, s:{s:F, s:F}, s:o, s:o}", "source", "group",
                           "value", "assumed", "horizontal_rms_m", "at_end", "max",
                           "drift_cep_nmi_per_h", "share") != 0)
            return false;
    }
    return true;
}

static bool has_requirement(json_t *requirement, json_error_t *error)
{
    return !requirement ||
           json_unpack_ex(requirement, error, JSON_VALIDATE_ONLY,
                          "{s:F, s:s, s:F, s:o, s:o, s:F, s:s}", "limit_nmi_per_h", "statistic",
                          "value_nmi_per_h", "lower", "upper", "confidence", "verdict") == 0;
}

/* Everything that the page reads without asking whether it is there. */
static bool is_result(json_t *root, json_error_t *error)
{
    if (json_unpack_ex(root, error, JSON_VALIDATE_ONLY,
                       "{s:s, s:s, s:{s:o, s:s}, s:o, s:i, s:i, s:F, s:o, s:{s:{s:F, s:F}, s:o, "
                       "s:o}, s:{s:{s:F, s:F}}, s:{s:{s:F}}}",
                       "format", "version", "scenario", "name", "sha256", "imu", "seed", "runs",
                       "duration_s", "budget", "all", "horizontal_rms_m", "at_end", "max",
                       "drift_cep_nmi_per_h", "drift_r95_nmi_per_h", "none", "horizontal_rms_m",
                       "at_end", "max", "rss", "horizontal_rms_m", "at_end") != 0)
        return false;
    const json_t *const budget = json_object_get(root, "budget");
    const json_int_t runs = json_integer_value(json_object_get(root, "runs"));
    if (runs >= 1 && runs <= INT32_MAX && json_is_array(budget))
        return has_rows(budget, error) &&
               has_requirement(json_object_get(root, "requirement"), error);
    snprintf(error->text, sizeof(error->text), "'runs' or 'budget' is not what a result has");
    return false;
}

exit_code report_result_read(const char *path, json_t **out)
{
    static const char format[] = "schuler-result-1";
    json_error_t error;
    *out = json_load_file(path, JSON_REJECT_DUPLICATES, &error);
    if (!*out && error.line > 0)
        return say_bad_input("%s:%d:%d: %s", path, error.line, error.column, error.text);
    if (!*out) return say_bad_input("cannot read %s: %s", path, strerror(errno));
    const char *is = json_string_value(json_object_get(*out, "format"));
    exit_code code = EXIT_DONE;
    if (!is || strcmp(is, format) != 0)
        code = say_bad_input("%s: the format is %.60s, not %s", path, is ? is : "not said", format);
    else if (!is_result(*out, &error))
        code = say_bad_input("%s: not a result: %s", path, error.text);
    const char *const rows = json_string_value(json_object_get(*out, "rows"));
    if (code == EXIT_DONE && rows && strcmp(rows, "without") == 0)
        code = say_bad_input(
            "%s: a budget of all but one source does not add up; 'schuler run' without "
            "--rows makes one that does",
            path);
    if (code == EXIT_DONE) return code;
    json_decref(*out);
    *out = NULL;
    return code;
}

static exit_code unreadable(const char *path, FILE *file)
{
    const exit_code code = say_bad_input("cannot read %s: %s", path, strerror(errno));
    if (file) fclose(file);
    return code;
}

exit_code report_scenario_read(const char *path, const json_t *result, char **out)
{
    FILE *file = fopen(path, "re");
    if (!file) return unreadable(path, NULL);
    size_t length = 0;
    errno = 0;
    if (getdelim(out, &length, '\0', file) < 0 && ferror(file)) return unreadable(path, file);
    fclose(file);
    const char *sha256 =
        json_string_value(json_object_get(json_object_get(result, "scenario"), "sha256"));
    if (*out && strstr(*out, sha256)) return EXIT_DONE;
    return say_bad_input("%s: not the scenario of this result.json, whose sha256 is %.64s", path,
                         sha256);
}
