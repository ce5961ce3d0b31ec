/* SPDX-License-Identifier: MIT */
/* schuler init: a commented scenario to start from. */
#include "scenarios/gallery.h"
#include "tools/arguments.h"
#include "tools/messages.h"
#include "tools/names.h"
#include "tools/page.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    const char *name, *directory;
} init_arguments;

static error_t parse(int key, char *arg, struct argp_state *state)
{
    init_arguments *a = state->input;
    if (key != ARGP_KEY_ARG) return ARGP_ERR_UNKNOWN;
    if (!a->name)
        a->name = arg;
    else if (!a->directory)
        a->directory = arg;
    else
        argp_error(state, "too many arguments: '%s'", arg);
    return 0;
}

static const struct argp argp = {
    .parser = parse,
    .args_doc = "[TEMPLATE [DIR]]",
    .doc = "Write a commented scenario to start from: DIR/TEMPLATE.yaml. DIR is the current folder "
           "when "
           "it is not given and must exist; a file that is there is never overwritten. Without a "
           "template: list them."
           "\vExamples:\n"
           "  schuler init\n"
           "  schuler init static\n"
           "  schuler init atlantic flights\n" ARGUMENTS_EXIT_STATUS,
};

/* The value of the line "scenario: ...", which names the template. */
static void put_title(FILE *out, const char *text)
{
    static const char key[] = "scenario:";
    while (text && *text) {
        if (strncmp(text, key, sizeof(key) - 1) == 0) {
            const char *title = text + sizeof(key) - 1;
            title += strspn(title, " ");
            fprintf(out, "%.*s", (int)strcspn(title, "\r\n"), title);
            return;
        }
        text = strchr(text, '\n');
        if (text) text++;
    }
}

static exit_code list(void)
{
    page p;
    page_open(&p);
    for (int i = 0; p.out && schuler_gallery[i].name; i++) {
        fprintf(p.out, "  %-12s ", schuler_gallery[i].name);
        put_title(p.out, schuler_gallery[i].text);
        fputc('\n', p.out);
    }
    if (p.out) fputs("\n'schuler init TEMPLATE [DIR]' writes one.\n", p.out);
    return page_show(&p);
}

/* Written beside, then linked: linking does not replace a file that appeared meanwhile. */
static exit_code write_new(const char *path, const char *text, size_t length)
{
    char *partial;
    if (asprintf(&partial, "%s.partial-%ld", path, (long)getpid()) < 0)
        return say_failure("out of memory");
    exit_code code = EXIT_DONE;
    FILE *file = fopen(partial, "wxe");
    if (!file) {
        code = say_failure("cannot write %s: %s", path, strerror(errno));
    } else {
        const int failed = fwrite(text, 1, length, file) != length;
        if (fclose(file) == EOF || failed)
            code = say_failure("cannot write %s: %s", path, strerror(errno));
        else if (link(partial, path) != 0)
            code = errno == EEXIST
                       ? say_bad_input("%s is there already and is not overwritten", path)
                       : say_failure("cannot write %s: %s", path, strerror(errno));
        unlink(partial);
    }
    free(partial);
    return code;
}

static exit_code write_template(const schuler_embedded *entry, const char *directory)
{
    char *path;
    const int named = directory ? asprintf(&path, "%s/%s.yaml", directory, entry->name)
                                : asprintf(&path, "%s.yaml", entry->name);
    if (named < 0) return say_failure("out of memory");
    exit_code code = EXIT_DONE;
    if (directory && access(directory, F_OK) != 0)
        code = say_bad_input("%s: %s", directory, strerror(errno));
    if (code == EXIT_DONE) code = write_new(path, entry->text, entry->length);
    if (code == EXIT_DONE) {
        page p;
        page_open(&p);
        if (p.out)
            fprintf(p.out,
                    "Wrote %s. Try:\n"
                    "  schuler check %s\n"
                    "  schuler run %s\n"
                    "  schuler run %s --imu stim300\n",
                    path, path, path, path);
        code = page_show(&p);
    }
    free(path);
    return code;
}

exit_code verb_init(int argc, char **argv)
{
    init_arguments a = { 0 };
    arguments_parse(&argp, argc, argv, &a);
    if (!a.name) return list();
    for (int i = 0; schuler_gallery[i].name; i++)
        if (strcmp(schuler_gallery[i].name, a.name) == 0)
            return write_template(&schuler_gallery[i], a.directory);
    const char *known[NAMES_MAX];
    char hint[NAMES_HINT_MAX];
    names_of_templates(known);
    names_hint(hint, a.name, known);
    return say_bad_input("unknown template '%.60s'%s", a.name, hint);
}
