/* SPDX-License-Identifier: MIT */
#include "tools/scenario_input.h"
#include "tools/messages.h"
#include "tools/stop.h"
#include <stdio.h>

exit_code scenario_input(const char *file, const schuler_overrides *overrides, bool quiet,
                         schuler_scenario **out)
{
    schuler_diagnostics d = { 0 };
    *out = NULL;
    stop_catch();
    const schuler_status status = schuler_scenario_load(out, file, overrides, &d);
    say_diagnostics(&d, !quiet);
    schuler_diagnostics_free(&d);
    if (*stop_flag()) {
        schuler_scenario_free(*out);
        *out = NULL;
        fputs("schuler: interrupted; nothing was written\n", stderr);
        return EXIT_INTERRUPTED;
    }
    if (status == SCHULER_OK) return EXIT_DONE;
    return status == SCHULER_ERR_MEMORY ? EXIT_FAILED : EXIT_INPUT;
}
