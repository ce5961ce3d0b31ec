/* SPDX-License-Identifier: MIT */
#include "tools/sweep_axis.h"
#include "core/units.h"
#include "scenarios/source_size.h"
#include "tools/messages.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static exit_code refuse(const char *text)
{
    return say_bad_input("'%s': write SOURCE=FROM..TO, for example gyro.bias=0.001..0.1 deg/h",
                         text);
}

/* "0.001..0.1 deg/h": FROM without a unit has that of TO. */
static exit_code read_range(const char *text, const char *range, schuler_dim dim, sweep_axis *axis,
                            double ends[2])
{
    static const char number[] = " +-.0123456789eE";
    const char *const dots = strstr(range, "..");
    if (!dots || dots == range || !dots[2] || strlen(range) > 100) return refuse(text);
    snprintf(axis->unit, sizeof axis->unit, "%s", dots + 2 + strspn(dots + 2, number));
    char from[160], one[64];
    snprintf(from, sizeof from, "%.*s", (int)(dots - range), range);
    if (from[strspn(from, number)] == '\0')
        snprintf(from, sizeof from, "%.*s %s", (int)(dots - range), range, axis->unit);
    snprintf(one, sizeof one, "1 %s", axis->unit);
    const struct {
        const char *text;
        double *si;
    } parts[] = { { dots + 2, &ends[1] }, { from, &ends[0] }, { one, &axis->unit_si } };
    for (int i = 0; i < 3; i++) {
        schuler_error error = { 0 };
        if (schuler_quantity_parse(parts[i].text, dim, parts[i].si, &error) != SCHULER_OK)
            return say_bad_input("'%s': %s", text, error.message);
    }
    return EXIT_DONE;
}

exit_code sweep_axis_read(sweep_axis *axis, const schuler_scenario *s, const char *text, int points,
                          bool even)
{
    const char *const equals = strchr(text, '=');
    if (!equals || equals == text || (size_t)(equals - text) >= sizeof axis->id)
        return refuse(text);
    *axis = (sweep_axis){ .points = points };
    snprintf(axis->id, sizeof axis->id, "%.*s", (int)(equals - text), text);
    schuler_error error = { 0 };
    double now = 0.0;
    schuler_dim dim;
    if (schuler_source_size(s, axis->id, &now, &dim, &error) != SCHULER_OK)
        return say_bad_input("%s", error.message);
    double ends[2];
    const exit_code code = read_range(text, equals + 1, dim, axis, ends);
    if (code != EXIT_DONE) return code;
    const double from = ends[0], to = ends[1];
    if (!(from >= 0.0 && to > from))
        return say_bad_input("'%s': FROM is not below TO, or negative", text);
    if (from == 0.0 && !even)
        return say_bad_input("'%s': steps of equal ratio cannot start at 0; say --even", text);
    for (int i = 0; i < points; i++) {
        const double x = (double)i / (points - 1);
        axis->size[i] = even ? from + x * (to - from) : from * pow(to / from, x);
        if (i == points - 1) axis->size[i] = to;
        axis->factor[i] = axis->size[i] / now;
    }
    return EXIT_DONE;
}
