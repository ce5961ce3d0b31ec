/* SPDX-License-Identifier: MIT */
/* How parts and triads are read. Private to the scenario reader. */
#ifndef SCHULER_SCENARIOS_PART_H
#define SCHULER_SCENARIOS_PART_H

#include "core/schema_private.h"
#include "scenarios/scenario.h"

/** Read the keys of `accel` or `gyro` over what a triad already has: what is written replaces, a
 *  different model drops all values of the old one.
 *  Given      what   path for messages: "imu.accel" */
void schuler_triad_read(schuler_reading *r, const schuler_node *node, const char *what,
                        schuler_instrument instrument, schuler_triad *triad);

/** After all layers are read: companions are there, parameters that are no sources have a value. */
void schuler_triad_finish(schuler_reading *r, const char *what, schuler_instrument instrument,
                          schuler_triad *triad);

/** The document of a part, by catalog name, else by file: in folder (may be NULL), else in the
 * working directory. Given      place    of the name, for messages Returned   out      owned by the
 * caller name     how to call the part; borrowed from the catalog or the arena strict   it is a
 * catalog part, held to its rules Errors     into r->d */
schuler_status schuler_part_open(schuler_reading *r, const char *name_or_file, const char *folder,
                                 const schuler_place *place, schuler_document **out,
                                 const char **name, bool *strict);

/** Read a part's document into members of part (all but arena and document). strict: every value
 * must name a source of the file, or be marked as assumed with a note. */
void schuler_part_read(schuler_reading *r, const schuler_document *doc, const char *name,
                       bool strict, schuler_part *part);

/** Read the `imu` section of a scenario.
 *  Given      folder     of the scenario file
 *  Returned   imu        complete
 *             document   the part's, or NULL; owned by the caller, even after an error */
void schuler_imu_read(schuler_reading *r, const schuler_node *node, const char *folder,
                      schuler_imu *imu, schuler_document **document);

#endif
