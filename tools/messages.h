/* SPDX-License-Identifier: MIT */
/* Errors and warnings on standard error, and the exit status they lead to. */
#ifndef SCHULER_TOOLS_MESSAGES_H
#define SCHULER_TOOLS_MESSAGES_H

#include "core/error.h"
#include "tools/verbs.h"
#include <stdbool.h>

/** "schuler: error: ..."; returns EXIT_FAILED or EXIT_INPUT, so that leaving is one line. */
exit_code say_failure(const char *format, ...) __attribute__((format(printf, 1, 2)));
exit_code say_bad_input(const char *format, ...) __attribute__((format(printf, 1, 2)));
/** Standard output cannot be written, errno says why. Silent when its reader went away or it was
 * closed. */
exit_code say_unwritable(int reason);
void say_warning(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** file:line:column: error: message, then the line with a caret. */
void say_error(const schuler_error *error);
/** All of them; warnings only when wanted. */
void say_diagnostics(const schuler_diagnostics *d, bool warnings);

/** What a library status means for the exit status. */
exit_code exit_of(schuler_status status);

#endif
