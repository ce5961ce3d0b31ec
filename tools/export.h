/* SPDX-License-Identifier: MIT */
/* A result in the formats of other programs. */
#ifndef SCHULER_TOOLS_EXPORT_H
#define SCHULER_TOOLS_EXPORT_H

#include "scenarios/result_file.h"
#include <stdio.h>

/** Each run of each source: source,run,end_m,max_m,drift_nmi_per_h,velocity_rms_mps.
 *  Errors   none; the owner of the stream checks it */
schuler_status export_csv(FILE *out, const schuler_result_file *result);

/** The true track, and around its end the circles in which 50 % and 95 % of the navigators end, as KML 2.2.
 *  Heights are above the ellipsoid. Circles of less than a millimetre or more than an eighth of the earth's
 *  circumference are left out.
 *  Errors   SCHULER_ERR_MEMORY, the text then is of no use */
schuler_status export_kml(FILE *out, const schuler_result_file *result);

#endif
