/* SPDX-License-Identifier: MIT */
/* Text files compiled into the library: made by core/embed.cmake. */
#ifndef SCHULER_CORE_EMBEDDED_H
#define SCHULER_CORE_EMBEDDED_H

#include "core/api.h"
#include <stddef.h>

SCHULER_BEGIN_C

typedef struct {
    const char *name; /* of the file, without folder and ending */
    const char *text; /* NUL-terminated                         */
    size_t length;    /* without the NUL                        */
} schuler_embedded;

SCHULER_END_C

#endif
