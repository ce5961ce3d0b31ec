/* SPDX-License-Identifier: MIT */
/* The verbs of the command, and what its exit status means. */
#ifndef SCHULER_TOOLS_VERBS_H
#define SCHULER_TOOLS_VERBS_H

/* Part of the interface: never changed. */
typedef enum {
    EXIT_DONE = 0,
    EXIT_NOT_MET = 1,
    EXIT_INPUT = 2,
    EXIT_FAILED = 3,
    EXIT_INCONCLUSIVE = 4,
    EXIT_INTERRUPTED = 130,
} exit_code;

/* argv[0] is "schuler VERB", as usage messages show it. */
typedef struct {
    const char *name, *summary;
    exit_code (*run)(int argc, char **argv);
} verb;

exit_code verb_run(int argc, char **argv);
exit_code verb_verify(int argc, char **argv);
exit_code verb_solve(int argc, char **argv);
exit_code verb_sweep(int argc, char **argv);
exit_code verb_compare(int argc, char **argv);
exit_code verb_report(int argc, char **argv);
exit_code verb_check(int argc, char **argv);
exit_code verb_sensors(int argc, char **argv);
exit_code verb_models(int argc, char **argv);
exit_code verb_explain(int argc, char **argv);
exit_code verb_export(int argc, char **argv);
exit_code verb_truth(int argc, char **argv);
exit_code verb_allan(int argc, char **argv);
exit_code verb_characterize(int argc, char **argv);
exit_code verb_navigate(int argc, char **argv);
exit_code verb_bench(int argc, char **argv);
exit_code verb_init(int argc, char **argv);

#endif
