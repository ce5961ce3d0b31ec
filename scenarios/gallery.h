/* SPDX-License-Identifier: MIT */
/* Scenario files to start from: the files of this folder, compiled into the library. */
#ifndef SCHULER_SCENARIOS_GALLERY_H
#define SCHULER_SCENARIOS_GALLERY_H

#include "core/embedded.h"

SCHULER_BEGIN_C

/** All scenarios, in alphabetical order, ended by name NULL. */
SCHULER_API extern const schuler_embedded schuler_gallery[];

SCHULER_END_C

#endif
