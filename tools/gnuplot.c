/* SPDX-License-Identifier: MIT */
#include "tools/gnuplot.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include <errno.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

void gnuplot_check(struct argp_state *state, const char *path)
{
    const char *const end = strrchr(path, '.');
    if (!end || (strcmp(end, ".svg") != 0 && strcmp(end, ".png") != 0))
        argp_error(state, "--plot: '%s' must end with .svg or .png", path);
}

void gnuplot_quote(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text; text++)
        if (*text != '\'' && *text != '\\' && *text >= ' ') fputc(*text, out);
    fputc('\'', out);
}

/* gnuplot with the script as its input and the picture as its output. */
static exit_code run(FILE *script, FILE *picture)
{
    extern char **environ;
    char program[] = "gnuplot", *const arguments[] = { program, NULL };
    posix_spawn_file_actions_t actions;
    pid_t child;
    int state = 0;
    if (posix_spawn_file_actions_init(&actions) != 0) return say_failure("out of memory");
    posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(picture), STDOUT_FILENO);
    const int wrong = posix_spawnp(&child, program, &actions, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (wrong == ENOENT) return say_failure("--plot: gnuplot is not installed");
    if (wrong) return say_failure("--plot: gnuplot cannot be started: %s", strerror(wrong));
    while (waitpid(child, &state, 0) < 0)
        if (errno != EINTR) return say_failure("--plot: %s", strerror(errno));
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) return say_failure("--plot: gnuplot failed");
    return EXIT_DONE;
}

/* Twelve line colours that are told apart on white; later lines begin anew. */
static void put_colours(FILE *script)
{
    static const char *const colours[] = { "#1f77b4", "#d62728", "#2ca02c", "#ff7f0e",
                                           "#9467bd", "#8c564b", "#e377c2", "#7f7f7f",
                                           "#bcbd22", "#17becf", "#000000", "#00429d" };
    enum { COUNT = sizeof colours / sizeof colours[0] };
    for (int i = 0; i < COUNT; i++)
        fprintf(script, "set linetype %d lc rgb '%s'\n", i + 1, colours[i]);
    fprintf(script, "set linetype cycle %d\n", COUNT);
}

exit_code gnuplot_draw(const char *path, int width, int height, void (*put)(FILE *, const void *),
                       const void *what)
{
    const char *const end = strrchr(path, '.');
    outfile picture = { 0 };
    FILE *const script = tmpfile();
    if (!script) return say_failure("--plot: %s", strerror(errno));
    fprintf(script, "set terminal %s size %d,%d\n",
            end && strcmp(end, ".png") == 0 ? "pngcairo" : "svg", width, height);
    put_colours(script);
    put(script, what);
    rewind(script);
    exit_code code = ferror(script) ? say_failure("--plot: cannot write to a temporary file")
                                    : outfile_open(&picture, path);
    if (code == EXIT_DONE) code = run(script, picture.file);
    if (code == EXIT_DONE) code = outfile_publish(&picture);
    outfile_drop(&picture);
    fclose(script);
    return code;
}
