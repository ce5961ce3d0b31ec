/* SPDX-License-Identifier: MIT */
/* Any text as a quantity and as a unit: a finite number or an error that points into the text. */
#include "core/units.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int truth)
{
    if (!truth) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const schuler_dim dims[] = {
        SCHULER_DIM_NONE, SCHULER_DIM_LENGTH, SCHULER_DIM_TIME,  SCHULER_DIM_ANGLE,
        SCHULER_DIM_RATE, SCHULER_DIM_SPEED,  SCHULER_DIM_ACCEL, SCHULER_DIM_ARW,
        SCHULER_DIM_VRW,  SCHULER_DIM_RRW,
    };
    if (size < 1) return 0;
    char *text = malloc(size);
    require(text != NULL);
    memcpy(text, data + 1, size - 1);
    text[size - 1] = '\0';

    const schuler_dim dim = dims[data[0] % (sizeof(dims) / sizeof(*dims))];
    const double untouched = -12345.5;
    double si = untouched;
    schuler_error err = { 0 };
    if (schuler_quantity_parse(text, dim, &si, &err) == SCHULER_OK) {
        require(isfinite(si));
    } else {
        require(si == untouched && err.message[0] != '\0');
        require(memchr(err.message, '\0', sizeof(err.message)) != NULL);
        require(err.place.column >= 0 && (size_t)err.place.column <= strlen(text) + 1);
    }

    schuler_dim found = SCHULER_DIM_NONE;
    if (schuler_unit_parse(text, &si, &found, NULL) == SCHULER_OK) {
        require(isfinite(si));
        const char *example = NULL;
        (void)schuler_dim_name(found, &example);
    }
    free(text);
    return 0;
}
