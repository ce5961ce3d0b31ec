/* SPDX-License-Identifier: MIT */
/* Which data sets of gravity models a folder has. */
#include "core/geographic_data.h"
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_MOST = 1024 };

/* The file of coefficients begins with eight bytes of its name, then its degree, least byte first. */
static int degree_in(const char *folder, const char *name)
{
    char path[PATH_MOST];
    unsigned char head[12];
    if (snprintf(path, sizeof path, "%s/%s.egm.cof", folder, name) >= PATH_MOST) return 0;
    FILE *const in = fopen(path, "rb");
    if (!in) return 0;
    const size_t got = fread(head, 1, sizeof head, in);
    (void)fclose(in);
    const unsigned degree = head[8] | (unsigned)head[9] << 8 | (unsigned)head[10] << 16;
    return got == sizeof head && head[11] == 0 ? (int)degree : 0;
}

/* NAME.egm, and NAME such as schuler_field_open takes. */
static int is_data_set(const struct dirent *entry)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    const size_t length = strspn(entry->d_name, plain);
    return length > 0 && length < sizeof((schuler_field_data *)0)->name &&
           strcmp(entry->d_name + length, ".egm") == 0;
}

size_t schuler_field_data_sets(const char *folder, schuler_field_data *out, size_t capacity)
{
    char usual[PATH_MOST];
    if (!folder) {
        schuler_field_folder(usual, sizeof usual);
        folder = usual;
    }
    struct dirent **entries = NULL;
    const int count = scandir(folder, &entries, is_data_set, alphasort);
    for (int i = 0; i < count; i++) {
        if ((size_t)i < capacity) {
            schuler_field_data *const d = &out[i];
            *d = (schuler_field_data){ 0 };
            memcpy(d->name, entries[i]->d_name, strcspn(entries[i]->d_name, "."));
            schuler_field_describe(folder, d);
            if (!d->problem[0]) d->degree = degree_in(folder, d->name);
        }
        free(entries[i]);
    }
    free(entries);
    return count > 0 ? (size_t)count : 0;
}
