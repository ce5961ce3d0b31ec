/* SPDX-License-Identifier: MIT */
/* Between geographic_data.c and the door to GeographicLib. Private to core. */
#ifndef SCHULER_CORE_GEOGRAPHIC_DATA_H
#define SCHULER_CORE_GEOGRAPHIC_DATA_H

#include "core/geographic.h"

SCHULER_BEGIN_C

/** Description and release of the data set d->name in a folder, or the problem it has. */
void schuler_field_describe(const char *folder, schuler_field_data *d);

SCHULER_END_C

#endif
