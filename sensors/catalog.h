/* SPDX-License-Identifier: MIT */
/* The catalog of real parts: one YAML file each in sensors/catalog/, compiled into the library. */
#ifndef SCHULER_SENSORS_CATALOG_H
#define SCHULER_SENSORS_CATALOG_H

#include "core/embedded.h"

SCHULER_BEGIN_C

typedef schuler_embedded schuler_catalog_entry;

/** All parts, in alphabetical order, ended by name NULL. */
SCHULER_API extern const schuler_catalog_entry schuler_catalog[];

SCHULER_END_C

#endif
