/* SPDX-License-Identifier: MIT */
/* The command: picks the verb. */
#include "core/error.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/terminal.h"
#include "tools/verbs.h"
#include <argp.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *argp_program_version = "schuler " SCHULER_VERSION;

static const verb verbs[] = {
    { "run", "simulate a scenario: error budget per source, drift, verdict", verb_run },
    { "verify", "does it meet the requirement? several files, as exit status", verb_verify },
    { "solve", "how large a source may be for the requirement to be met", verb_solve },
    { "sweep", "drift against the size of one or two sources", verb_sweep },
    { "compare", "several IMUs on one mission: ranking, ratios, budgets", verb_compare },
    { "report", "one HTML page of a result: verdict, charts, sources to tick off", verb_report },
    { "check", "validate scenario files; every mistake with its place", verb_check },
    { "sensors", "the catalog of real parts: list, show NAME", verb_sensors },
    { "models", "sensor models, trajectories, frames, gravity: list, show NAME", verb_models },
    { "explain", "an error source: formula, growth of its position error, its size", verb_explain },
    { "export", "a result for other programs: CSV of its runs, KML of its track", verb_export },
    { "truth", "write exact increments and the true trajectory of a scenario", verb_truth },
    { "navigate", "navigate over recorded increments, compare with a reference", verb_navigate },
    { "allan", "noise coefficients and a sensor file from recorded data at rest", verb_allan },
    { "characterize", "sensors on a test stand: mean, spread, noise, Allan deviation",
      verb_characterize },
    { "bench", "how fast this machine computes, for each instruction set", verb_bench },
    { "init", "a commented scenario to start from; without a name: what there is", verb_init },
};
enum { VERBS = sizeof(verbs) / sizeof(verbs[0]) };

static void print_help(FILE *out)
{
    fputs("Usage: schuler VERB [OPTION...]\n"
          "How far does an inertial navigator drift, which error is to blame, does it meet\n"
          "the requirement?\n\n",
          out);
    for (int i = 0; i < VERBS; i++) fprintf(out, "  %-12s %s\n", verbs[i].name, verbs[i].summary);
    fputs("\nschuler VERB --help says more, schuler --version which version this is.\n\n"
          "Examples:\n"
          "  schuler init                          list the scenarios to start from\n"
          "  schuler init static && schuler run static.yaml\n"
          "  schuler run static.yaml --imu stim300 --only gyro\n\n"
          "Exit status: 0 done, requirement met if there is one; 1 not met; 2 bad command\n"
          "line or input; 3 failed while running; 4 too few runs to tell; 130 interrupted.\n",
          out);
}

static exit_code unknown_verb(const char *written)
{
    const char *known[VERBS + 1];
    char hint[NAMES_HINT_MAX];
    for (int i = 0; i < VERBS; i++) known[i] = verbs[i].name;
    known[VERBS] = NULL;
    names_hint(hint, written, known);
    say_bad_input("unknown %s '%.60s'%s", written[0] == '-' ? "option" : "verb", written,
                  written[0] == '-' ? "" : hint);
    fputs("Try 'schuler --help' for what there is.\n", stderr);
    return EXIT_INPUT;
}

/* Files that are opened must not land on a standard stream that the caller has closed. /dev/null is
 * opened the wrong way round, so that using the stream fails as if it were closed. */
static void occupy_standard_streams(void)
{
    for (int fd = 0; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0 && errno == EBADF)
            if (open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) _exit(EXIT_FAILED);
}

/* What is still in the buffer at the end, as after --help, is checked too. */
static void close_output(void)
{
    const int failed = ferror(stdout);
    if (fclose(stdout) == EOF || failed) {
        if (!failed) say_unwritable(errno);
        _exit(EXIT_FAILED);
    }
}

static exit_code run_verb(const verb *v, int argc, char **argv)
{
    static char name[32]; /* argp keeps it until the program ends */
    snprintf(name, sizeof(name), "schuler %s", v->name);
    argv[0] = name;
    return v->run(argc, argv);
}

static exit_code dispatch(int argc, char **argv)
{
    if (argc < 2) {
        print_help(stderr);
        return EXIT_INPUT;
    }
    const bool help_wanted = strcmp(argv[1], "help") == 0;
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 ||
        strcmp(argv[1], "-?") == 0 || (help_wanted && argc == 2)) {
        print_help(stdout);
        return EXIT_DONE;
    }
    if (strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "-V") == 0) {
        printf("%s\n", argp_program_version);
        return EXIT_DONE;
    }
    const char *wanted = help_wanted ? argv[2] : argv[1];
    for (int i = 0; i < VERBS; i++) {
        if (strcmp(wanted, verbs[i].name) != 0) continue;
        if (!help_wanted) return run_verb(&verbs[i], argc - 1, argv + 1);
        char help[] = "--help", *help_argv[] = { NULL, help, NULL };
        return run_verb(&verbs[i], 2, help_argv);
    }
    return unknown_verb(wanted);
}

int main(int argc, char **argv)
{
    occupy_standard_streams();
    signal(SIGPIPE, SIG_IGN); /* a write that fails is an error like any other */
    terminal_start();
    atexit(close_output);
    return (int)dispatch(argc, argv);
}
