/* SPDX-License-Identifier: MIT */
/* Any bytes as a scenario file and as a sensor file: a complete scenario or errors, never both or
 * neither. */
#include "scenarios/scenario.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int truth)
{
    if (!truth) abort();
}

static void check_diagnostics(const schuler_diagnostics *d)
{
    require(d->kept <= SCHULER_DIAGNOSTICS_MAX && d->kept <= d->errors + d->warnings);
    for (size_t i = 0; i < d->kept; i++) {
        require(d->items[i].message[0] != '\0');
        require(d->items[i].place.line >= 0 && d->items[i].place.column >= 0);
    }
}

static void try_scenario(const char *path)
{
    schuler_diagnostics d = { 0 };
    schuler_scenario *s = NULL;
    if (schuler_scenario_load(&s, path, NULL, &d) == SCHULER_OK) {
        require(s != NULL && d.errors == 0);
        require(isfinite(s->path.duration_s) && s->path.duration_s > 0.0 && s->path.count > 0);
        require(s->runs >= 1 && s->imu.rate_hz > 0.0 && s->report_s > 0.0);
    } else {
        require(s == NULL && d.errors > 0);
    }
    check_diagnostics(&d);
    schuler_scenario_free(s);
    schuler_diagnostics_free(&d);
}

static void try_part(const char *path)
{
    schuler_diagnostics d = { 0 };
    schuler_part *part = NULL;
    if (schuler_part_load(&part, path, &d) == SCHULER_OK)
        require(part != NULL && d.errors == 0);
    else
        require(part == NULL && d.errors > 0);
    check_diagnostics(&d);
    schuler_part_free(part);
    schuler_diagnostics_free(&d);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    /* A file that lives in memory only, but has a name to open. */
    const int fd = memfd_create("fuzz", 0);
    require(fd >= 0 && write(fd, data, size) == (ssize_t)size);
    char path[64];
    snprintf(path, sizeof(path), "/proc/self/fd/%d", fd);
    try_scenario(path);
    try_part(path);
    close(fd);
    return 0;
}
