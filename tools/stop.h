/* SPDX-License-Identifier: MIT */
/* Ctrl-C as a flag that long work looks at. */
#ifndef SCHULER_TOOLS_STOP_H
#define SCHULER_TOOLS_STOP_H

/** From here on SIGINT and SIGTERM set the flag; a second one ends the program at once. */
void stop_catch(void);
/** The flag: not 0 once the user asked to stop. */
const volatile int *stop_flag(void);

#endif
