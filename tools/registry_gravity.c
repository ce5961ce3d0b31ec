/* SPDX-License-Identifier: MIT */
/* Gravity models of `schuler models`: built in, known by name, and installed as data sets. */
#include "core/geographic.h"
#include "tools/page.h"
#include "tools/registry.h"
#include <string.h>

static const struct {
    registry_entry entry;
    bool built_in;
} known[] = {
    { { "wgs84", "normal gravity of the WGS84 ellipsoid, built in",
        "GeographicLib NormalGravity; NIMA TR8350.2" },
      true },
    { { "grs80", "normal gravity of the GRS80 ellipsoid, built in",
        "GeographicLib NormalGravity; H. Moritz, Geodetic Reference System 1980" },
      true },
    { { "egm96", "the real field to degree 360, a data set",
        "GeographicLib GravityModel; F. G. Lemoine et al., NASA/TP-1998-206861" },
      false },
    { { "egm2008", "the real field to degree 2190, a data set",
        "GeographicLib GravityModel; N. K. Pavlis et al., J. Geophys. Res. 117, 2012" },
      false },
};
enum { KNOWN = sizeof known / sizeof known[0], FOLDER_MAX = 1024 };

static const char installing[] = "geographiclib-get-gravity";

typedef struct {
    char folder[FOLDER_MAX];
    schuler_field_data sets[REGISTRY_GRAVITIES_MAX - KNOWN];
    int count;
} installed;

static void look(installed *i)
{
    enum { ROOM = sizeof i->sets / sizeof i->sets[0] };
    schuler_field_folder(i->folder, sizeof i->folder);
    const size_t count = schuler_field_data_sets(NULL, i->sets, ROOM);
    i->count = count < ROOM ? (int)count : (int)ROOM;
}

static const schuler_field_data *find(const installed *in, const char *name)
{
    for (int i = 0; i < in->count; i++)
        if (strcmp(in->sets[i].name, name) == 0) return &in->sets[i];
    return NULL;
}

static int find_known(const char *name)
{
    int k = 0;
    while (k < KNOWN && strcmp(known[k].entry.name, name) != 0) k++;
    return k;
}

void registry_gravity_known(registry_gravity_names *out)
{
    installed in;
    look(&in);
    out->count = 0;
    for (int k = 0; k < KNOWN; k++)
        snprintf(out->names[out->count++], sizeof out->names[0], "%s", known[k].entry.name);
    for (int i = 0; i < in.count; i++)
        if (find_known(in.sets[i].name) == KNOWN)
            snprintf(out->names[out->count++], sizeof out->names[0], "%s", in.sets[i].name);
}

static void state_of(const installed *in, const char *name, char *text, size_t size)
{
    const schuler_field_data *const d = find(in, name);
    if (!d)
        snprintf(text, size, "not installed: %s %s", installing, name);
    else if (d->degree)
        snprintf(text, size, "installed, to degree %d", d->degree);
    else
        snprintf(text, size, "cannot be read: %s", d->problem);
}

void registry_gravity_list(FILE *out)
{
    installed in;
    char text[512], state[256];
    look(&in);
    for (int k = 0; k < KNOWN; k++) {
        const registry_entry *const e = &known[k].entry;
        state_of(&in, e->name, state, sizeof state);
        snprintf(text, sizeof text, "%s; %s", e->summary, state);
        registry_row(out, e->name, known[k].built_in ? e->summary : text);
    }
    for (int i = 0; i < in.count; i++) {
        if (find_known(in.sets[i].name) < KNOWN) continue;
        state_of(&in, in.sets[i].name, state, sizeof state);
        snprintf(text, sizeof text, "%s; %s", in.sets[i].description, state);
        registry_row(out, in.sets[i].name, in.sets[i].description[0] ? text : state);
    }
    fputs("  ", out);
    snprintf(text, sizeof text,
             "Data sets are looked for in %.300s (GEOGRAPHICLIB_GRAVITY_PATH, "
             "truth.gravity_path).",
             in.folder);
    page_wrap(out, text, 2, 2);
}

static void show_state(FILE *out, const installed *in, const char *name)
{
    char text[FOLDER_MAX + 300];
    const schuler_field_data *const d = find(in, name);
    if (d && d->degree) {
        snprintf(text, sizeof text, "%s/%s.egm, to degree and order %d%s%s", in->folder, name,
                 d->degree, d->release[0] ? ", of " : "", d->release);
        fputs("  installed: ", out);
        page_wrap(out, text, 13, 13);
        snprintf(text, sizeof text, "%s:%d is the field to degree %d", name, d->degree / 2,
                 d->degree / 2);
        fputs("  in part: ", out);
        page_wrap(out, text, 11, 11);
        return;
    }
    fputs(d ? "  cannot be read: " : "  not installed: ", out);
    snprintf(text, sizeof text, "there is no %s.egm in %s", name, in->folder);
    page_wrap(out, d ? d->problem : text, 17, 17);
    snprintf(text, sizeof text,
             "%s %s (Debian package geographiclib-tools, as root), or set "
             "GEOGRAPHICLIB_GRAVITY_PATH or truth.gravity_path to a folder that has it",
             installing, name);
    fputs("  install: ", out);
    page_wrap(out, text, 11, 11);
}

bool registry_gravity_show(FILE *out, const char *name)
{
    static const char what[] = "a gravity model", from[] = "GeographicLib GravityModel";
    installed in;
    look(&in);
    const int k = find_known(name);
    const schuler_field_data *const d = find(&in, name);
    if (k == KNOWN && !d) return false;
    if (k < KNOWN)
        registry_head(out, what, name, known[k].entry.summary, known[k].entry.source);
    else
        registry_head(out, what, name, d->description[0] ? d->description : "a data set", from);
    if (k == KNOWN || !known[k].built_in) show_state(out, &in, name);
    return true;
}

static json_t *row(const installed *in, const char *name, const char *summary, const char *source,
                   bool built_in)
{
    const schuler_field_data *const d = built_in ? NULL : find(in, name);
    const bool is_installed = d && d->degree;
    char file[FOLDER_MAX + 80], install[120];
    snprintf(file, sizeof file, "%s/%s.egm", in->folder, name);
    snprintf(install, sizeof install, "%s %s", installing, name);
    return json_pack("{s:o, s:o, s:o, s:b, s:b, s:o, s:o, s:o, s:o}", "name", json_of_text(name),
                     "summary", json_of_text(summary), "source", json_of_text(source), "built_in",
                     built_in, "installed", is_installed, "file",
                     json_of_text(is_installed ? file : NULL), "degree",
                     is_installed ? json_integer(d->degree) : json_null(), "problem",
                     json_of_text(d && !is_installed ? d->problem : NULL), "install",
                     json_of_text(built_in ? NULL : install));
}

json_t *registry_gravity_json(void)
{
    installed in;
    look(&in);
    json_t *const list = json_array();
    for (int k = 0; list && k < KNOWN; k++)
        json_array_append_new(list, row(&in, known[k].entry.name, known[k].entry.summary,
                                        known[k].entry.source, known[k].built_in));
    for (int i = 0; list && i < in.count; i++)
        if (find_known(in.sets[i].name) == KNOWN)
            json_array_append_new(list, row(&in, in.sets[i].name, in.sets[i].description,
                                            "GeographicLib GravityModel", false));
    return list;
}
