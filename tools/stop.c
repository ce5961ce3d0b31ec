/* SPDX-License-Identifier: MIT */
#include "tools/stop.h"
#include <signal.h>
#include <stddef.h>

/* The one variable of the program that is not on a stack: a signal handler has no other way out. */
static volatile sig_atomic_t asked;

static void ask(int signal_number)
{
    (void)signal_number;
    asked = 1;
}

void stop_catch(void)
{
    struct sigaction action = { .sa_handler = ask, .sa_flags = (int)SA_RESETHAND | SA_RESTART };
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

const volatile int *stop_flag(void)
{
    return &asked;
}
