/* SPDX-License-Identifier: MIT */
/* A budget as a picture, where gnuplot is installed. */
#ifndef SCHULER_TOOLS_BUDGET_PLOT_H
#define SCHULER_TOOLS_BUDGET_PLOT_H

#include "tools/budget_table.h"

/** Every source over time and its share at the end; with the covariance of all beside it unless linear is NULL.
 *  Says errors. */
exit_code budget_plot(const char *path, const schuler_result *result,
                      const schuler_covariance *linear);

#endif
