/* SPDX-License-Identifier: MIT */
/* The table of the catalog. */
#include "sensors/catalog.h"
#include "tools/json.h"
#include "tools/messages.h"
#include "tools/outfile.h"
#include "tools/page.h"
#include "tools/sensor_part.h"
#include <stdlib.h>
#include <string.h>

const char *const sensor_kinds[] = { "imu", "accelerometer", "gyro", NULL };
const char *const sensor_grades[] = { "consumer",   "industrial", "tactical",
                                      "navigation", "strategic",  NULL };

/* What a row says of each triad: the bias and the noise, whatever the model calls them. */
static const char *const bias_keys[] = { "bias", "K0", "D_F", "bias_of_span", NULL };
static const char *const noise_keys[] = { "angle_random_walk", "velocity_random_walk", NULL };
enum { FIGURES = 4, NAME_COLUMNS = 27 };
static const struct {
    const char *name, *head;
    schuler_instrument instrument;
    const char *const *keys;
    int columns;
} figures[FIGURES] = {
    { "gyro_bias", "gyro bias", SCHULER_GYRO, bias_keys, 15 },
    { "gyro_noise", "gyro noise", SCHULER_GYRO, noise_keys, 22 },
    { "accel_bias", "accel bias", SCHULER_ACCEL, bias_keys, 12 },
    { "accel_noise", "accel noise", SCHULER_ACCEL, noise_keys, 18 },
};

typedef struct {
    schuler_part **part;
    size_t count;
} part_list;

static int position(const char *word, const char *const *words)
{
    int i = 0;
    while (words[i] && (!word || strcmp(words[i], word) != 0)) i++;
    return i;
}

static bool passes(const schuler_part *p, const sensor_filter *f)
{
    return (!f->kind || strcmp(f->kind, sensor_part_kind(p)) == 0) &&
           (!f->grade || (p->grade && strcmp(f->grade, p->grade) == 0)) &&
           (!f->technology || (p->technology && strcasestr(p->technology, f->technology))) &&
           (!f->maker || (p->maker && strcasestr(p->maker, f->maker)));
}

static int by_kind_and_grade(const void *x, const void *y)
{
    const schuler_part *const a = *(schuler_part *const *)x, *const b = *(schuler_part *const *)y;
    const int kinds =
        position(sensor_part_kind(a), sensor_kinds) - position(sensor_part_kind(b), sensor_kinds);
    const int grades = position(a->grade, sensor_grades) - position(b->grade, sensor_grades);
    return kinds ? kinds : grades ? grades : strcmp(a->imu.name, b->imu.name);
}

static void release(part_list *l)
{
    for (size_t i = 0; i < l->count; i++) schuler_part_free(l->part[i]);
    free(l->part);
}

static exit_code load(part_list *l, const sensor_filter *filter)
{
    size_t all = 0;
    while (schuler_catalog[all].name) all++;
    l->part = calloc(all, sizeof *l->part);
    if (!l->part) return say_failure("out of memory");
    for (size_t i = 0; i < all; i++) {
        schuler_part *part = NULL;
        schuler_diagnostics d = { 0 };
        const schuler_status status = schuler_part_load(&part, schuler_catalog[i].name, &d);
        say_diagnostics(&d, false);
        schuler_diagnostics_free(&d);
        if (status != SCHULER_OK)
            return EXIT_FAILED; /* the catalog is ours: no mistake of a user */
        if (passes(part, filter))
            l->part[l->count++] = part;
        else
            schuler_part_free(part);
    }
    qsort(l->part, l->count, sizeof(schuler_part *), by_kind_and_grade);
    return EXIT_DONE;
}

static const char *figure_of(const schuler_part *p, int k)
{
    const schuler_value *const v = sensor_part_figure(p, figures[k].instrument, figures[k].keys);
    return v && v->text ? v->text : NULL;
}

/* Columns of instruments that a part does not have are left out. */
static bool shown(const schuler_part *p, int k)
{
    return p->imu.triad[figures[k].instrument].model != NULL;
}

/* A heading for each kind and grade. */
static void put_heading(FILE *out, const schuler_part *p)
{
    static const char *const kinds[] = { "IMUs", "Accelerometers", "Gyros", "Other" };
    char text[80];
    snprintf(text, sizeof text, "%s, %s", kinds[position(sensor_part_kind(p), sensor_kinds)],
             p->grade ? p->grade : "no grade");
    fputc('\n', out);
    page_cell(out, text, NAME_COLUMNS + 2);
    for (int k = 0; k < FIGURES; k++)
        if (shown(p, k)) fprintf(out, " %-*s", figures[k].columns, figures[k].head);
    fputc('\n', out);
}

static bool same_heading(const schuler_part *a, const schuler_part *b)
{
    return strcmp(sensor_part_kind(a), sensor_part_kind(b)) == 0 &&
           position(a->grade, sensor_grades) == position(b->grade, sensor_grades);
}

static void put_table(FILE *out, const part_list *l)
{
    for (size_t i = 0; i < l->count; i++) {
        const schuler_part *const p = l->part[i];
        if (i == 0 || !same_heading(p, l->part[i - 1])) put_heading(out, p);
        fputs("  ", out);
        page_cell(out, p->imu.name, NAME_COLUMNS);
        for (int k = 0; k < FIGURES; k++) {
            const char *const text = figure_of(p, k);
            if (!shown(p, k)) continue;
            fputc(' ', out);
            page_cell(out, text ? text : "-", figures[k].columns);
        }
        fputc('\n', out);
    }
    fprintf(out, "\n%zu part%s. 'schuler sensors show NAME' shows every figure with its source.\n",
            l->count, l->count == 1 ? "" : "s");
}

static json_t *as_json(const part_list *l)
{
    json_t *list = json_array();
    for (size_t i = 0; list && i < l->count; i++) {
        const schuler_part *const p = l->part[i];
        json_t *row = json_pack("{s:o, s:o, s:s, s:o, s:o, s:o}", "name", json_of_text(p->imu.name),
                                "title", json_of_text(p->imu.title), "kind", sensor_part_kind(p),
                                "grade", json_of_text(p->grade), "maker", json_of_text(p->maker),
                                "technology", json_of_text(p->technology));
        for (int k = 0; row && k < FIGURES; k++)
            json_object_set_new(row, figures[k].name, json_of_text(figure_of(p, k)));
        json_array_append_new(list, row);
    }
    return json_pack("{s:s, s:s, s:o}", "format", "schuler-sensors-1", "version", SCHULER_VERSION,
                     "sensors", list);
}

static void put_field(FILE *out, const char *text)
{
    fputc('"', out);
    for (; text && *text; text++) {
        if (*text == '"') fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

static void put_csv(FILE *out, const void *list)
{
    const part_list *const l = list;
    fputs("name,title,kind,grade,maker,technology", out);
    for (int k = 0; k < FIGURES; k++) fprintf(out, ",%s", figures[k].name);
    fputc('\n', out);
    for (size_t i = 0; i < l->count; i++) {
        const schuler_part *const p = l->part[i];
        const char *const texts[] = { p->imu.name, p->imu.title, sensor_part_kind(p),
                                      p->grade,    p->maker,     p->technology };
        for (int k = 0; k < 6; k++) {
            if (k) fputc(',', out);
            put_field(out, texts[k]);
        }
        for (int k = 0; k < FIGURES; k++) {
            fputc(',', out);
            put_field(out, figure_of(p, k));
        }
        fputc('\n', out);
    }
}

static exit_code print(const part_list *l)
{
    page p;
    page_open(&p);
    if (p.out) put_table(p.out, l);
    return page_show(&p);
}

static bool is_output(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

exit_code sensor_list(const sensor_filter *filter, const char *csv, const char *json)
{
    part_list l = { 0 };
    exit_code code = load(&l, filter);
    if (code == EXIT_DONE && l.count == 0)
        code = say_bad_input("no part of the catalog is all of that; 'schuler sensors' lists them");
    if (code == EXIT_DONE && csv) code = outfile_write(csv, put_csv, &l);
    if (code == EXIT_DONE && json) code = json_write(as_json(&l), json);
    if (code == EXIT_DONE && !is_output(csv) && !is_output(json)) code = print(&l);
    release(&l);
    return code;
}
