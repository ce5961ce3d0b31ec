/* SPDX-License-Identifier: MIT */
/* Allan deviations drawn by gnuplot, where it is installed. */
#include "tools/allan_report.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static void put_column(FILE *out, const allan_report *r, int i)
{
    double si;
    const schuler_identified *const f = r->found;
    const schuler_identified_column *const c = &f->column[i];
    allan_rate_unit(r->recording->column[i].instrument, &si);
    fprintf(out, "$c%d << EOD\n", i);
    for (int p = 0; p < f->points; p++)
        if (c->sigma2[p] > 0.0)
            fprintf(out, "%.9g %.9g %.9g %.9g %.9g\n", f->tau_s[p], sqrt(c->sigma2[p]) / si,
                    sqrt(c->limits[p][0]) / si, sqrt(c->limits[p][1]) / si, sqrt(c->model[p]) / si);
    fputs("EOD\n", out);
}

/* One picture for each instrument, side by side. Names come from the header of a file: what is
 * special in a quoted text is left out. */
static void put_script(FILE *out, const allan_report *r, const char *terminal)
{
    const schuler_identified *const f = r->found;
    int shown[SCHULER_INSTRUMENTS] = { 0 };
    for (int i = 0; i < f->columns; i++) {
        shown[r->recording->column[i].instrument]++;
        put_column(out, r, i);
    }
    const int both = shown[SCHULER_ACCEL] && shown[SCHULER_GYRO];
    fprintf(out, "set terminal %s size %d,600\n", terminal, both ? 1400 : 800);
    fputs("set logscale xy\nset grid\nset key noenhanced\nset xlabel 'tau, s'\n", out);
    if (both) fputs("set multiplot layout 1,2\n", out);
    for (int k = SCHULER_INSTRUMENTS - 1; k >= 0; k--) {
        double si;
        if (!shown[k]) continue;
        fprintf(out, "set ylabel 'Allan deviation, %s'\nplot ",
                allan_rate_unit((schuler_instrument)k, &si));
        const char *comma = "";
        for (int i = 0; i < f->columns; i++) {
            if ((int)r->recording->column[i].instrument != k) continue;
            fprintf(out, "%s$c%d using 1:2:3:4 with yerrorbars pt 7 ps 0.4 lc %d title '", comma, i,
                    i + 1);
            for (const char *p = r->recording->column[i].name; *p; p++)
                if (*p != '\'' && *p != '\\' && *p >= ' ') fputc(*p, out);
            fprintf(out, "', $c%d using 1:5 with lines lc %d notitle", i, i + 1);
            comma = ", ";
        }
        fputc('\n', out);
    }
    if (both) fputs("unset multiplot\n", out);
}

/* gnuplot with the script as its input and the picture as its output. */
static exit_code draw(FILE *script, FILE *picture)
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

exit_code allan_plot(const allan_report *r, const char *path)
{
    const char *const end = strrchr(path, '.');
    const char *const terminal = end && strcmp(end, ".png") == 0 ? "pngcairo" : "svg";
    outfile picture = { 0 };
    FILE *const script = tmpfile();
    if (!script) return say_failure("--plot: %s", strerror(errno));
    put_script(script, r, terminal);
    rewind(script);
    exit_code code = ferror(script) ? say_failure("--plot: cannot write to a temporary file")
                                    : outfile_open(&picture, path);
    if (code == EXIT_DONE) code = draw(script, picture.file);
    if (code == EXIT_DONE) code = outfile_publish(&picture);
    outfile_drop(&picture);
    fclose(script);
    return code;
}
