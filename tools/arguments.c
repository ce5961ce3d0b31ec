/* SPDX-License-Identifier: MIT */
#include "tools/arguments.h"
#include "core/error.h"
#include "tools/names.h"
#include "tools/verbs.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Options that argp adds by itself. */
static const struct argp_option own_options[] = {
    { "help", '?', NULL, 0, NULL, 0 },
    { "usage", 'u', NULL, 0, NULL, 0 },
    { "version", 'V', NULL, 0, NULL, 0 },
    { 0 },
};

static size_t add_options(const struct argp_option *option, const struct argp_option **out,
                          size_t n, size_t max)
{
    for (; option && (option->name || option->key || option->doc); option++)
        if (option->name && n < max) out[n++] = option;
    return n;
}

/* The option that argp would take for `--name`, an unambiguous beginning being enough; NULL: none.
 */
static const struct argp_option *find_option(const struct argp_option *const *options, size_t count,
                                             const char *name, size_t length)
{
    const struct argp_option *found = NULL;
    for (size_t i = 0; i < count; i++) {
        if (strncmp(options[i]->name, name, length) != 0) continue;
        if (options[i]->name[length] == '\0') return options[i];
        if (!found) found = options[i];
    }
    return found;
}

/* argp only says "unrecognized option". Look before it does. */
static void check_long_options(const struct argp *argp, int argc, char **argv)
{
    enum { MAX = 64 };
    const struct argp_option *options[MAX];
    size_t count = add_options(argp->options, options, 0, MAX);
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        count = add_options(child->argp->options, options, count, MAX);
    count = add_options(own_options, options, count, MAX);
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (strncmp(argv[i], "--", 2) != 0) continue;
        const char *name = argv[i] + 2;
        const size_t length = strcspn(name, "=");
        const struct argp_option *option = find_option(options, count, name, length);
        if (option && option->arg && name[length] == '\0') i++; /* the next word is its value */
        if (option) continue;
        char written[64];
        snprintf(written, sizeof(written), "%.*s", (int)(length < 60 ? length : 60), name);
        const char *known[MAX];
        for (size_t k = 0; k < count; k++) known[k] = options[k]->name;
        const char *nearest = schuler_nearest(written, known, count);
        fprintf(stderr, "%s: unknown option '--%s'", argv[0], written);
        if (nearest) fprintf(stderr, "; did you mean '--%s'?", nearest);
        fprintf(stderr, "\nTry '%s --help' for what there is.\n", argv[0]);
        exit(EXIT_INPUT);
    }
}

void arguments_parse(const struct argp *argp, int argc, char **argv, void *input)
{
    argp_err_exit_status = EXIT_INPUT;
    check_long_options(argp, argc, argv);
    const error_t status = argp_parse(argp, argc, argv, 0, NULL, input);
    if (status == 0) return;
    fprintf(stderr, "%s: %s\n", argv[0], strerror(status));
    exit(EXIT_FAILED);
}

int64_t arguments_integer(struct argp_state *state, const char *option, const char *text,
                          int64_t min, int64_t max)
{
    char *end;
    errno = 0;
    const long long value = strtoll(text, &end, 10);
    if (end == text || *end || errno || value < min || value > max)
        argp_error(state, "%s: '%s' is not a whole number from %lld to %lld", option, text,
                   (long long)min, (long long)max);
    return value;
}

void arguments_unknown(struct argp_state *state, const char *what, const char *written,
                       const char *const *known)
{
    char hint[NAMES_HINT_MAX];
    names_hint(hint, written, known);
    argp_error(state, "unknown %s '%s'%s", what, written, hint);
}

double arguments_quantity(struct argp_state *state, const char *option, const char *text,
                          schuler_dim dim, double least, double most)
{
    schuler_error error = { 0 };
    double si = 0.0;
    if (schuler_quantity_parse(text, dim, &si, &error) != SCHULER_OK)
        argp_error(state, "%s: %s", option, error.message);
    if (!(si >= least && si <= most))
        argp_error(state, "%s: '%s' is not from %g to %g (SI)", option, text, least, most);
    return si;
}

int arguments_choice(struct argp_state *state, const char *option, const char *text,
                     const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], text) == 0) return i;
    char what[64];
    snprintf(what, sizeof(what), "value of %s", option);
    arguments_unknown(state, what, text, words);
    return -1;
}
