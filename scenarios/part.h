/* SPDX-License-Identifier: MIT */
/* How parts and triads are read. Private to the scenario reader. */
#ifndef SCHULER_SCENARIOS_PART_H
#define SCHULER_SCENARIOS_PART_H

#include "core/schema_private.h"
#include "scenarios/scenario.h"

/* The scenario's file, and the parts that imu, imu.accel and imu.gyro may use. */
enum { SCHULER_DOCUMENTS_MAX = 2 + SCHULER_INSTRUMENTS };

/** Read the keys of `accel` or `gyro` over what a triad already has: what is written replaces, a
 *  different model drops all values of the old one.
 *  Given      what   path for messages: "imu.accel" */
void schuler_triad_read(schuler_reading *r, const schuler_node *node, const char *what,
                        schuler_instrument instrument, schuler_triad *triad);

/** After all layers are read: companions are there, parameters that are no sources have a value. */
void schuler_triad_finish(schuler_reading *r, const char *what, schuler_triad *triad);

/** The document of a part, by catalog name, else by file: in folder (may be NULL), else in the
 *  working directory.
 *  Given      place    of the name, for messages
 *  Returned   out      owned by the caller
 *             name     how to call the part; borrowed from the catalog or the arena
 *             strict   it is a catalog part, held to its rules
 *  Errors     into r->d */
schuler_status schuler_part_open(schuler_reading *r, const char *name_or_file, const char *folder,
                                 const schuler_place *place, schuler_document **out,
                                 const char **name, bool *strict);

/** Read a part's document into members of part (all but arena and document). strict: every value
 * must name a source of the file, or be marked as assumed with a note. */
void schuler_part_read(schuler_reading *r, const schuler_document *doc, const char *name,
                       bool strict, schuler_part *part);

/** Open and read the part that a `use` key names.
 *  Given      what   path for messages;  folder   of the scenario file
 *  Returned   part       as schuler_part_read leaves it
 *             documents  the part's is added;  false when there were errors, which are in r->d */
bool schuler_part_use(schuler_reading *r, const schuler_node *use, const char *what,
                      const char *folder, schuler_part *part, schuler_document *documents[],
                      size_t *count);

/** Read `imu.temperature`. Errors into r->d: false. */
bool schuler_temperature_read(schuler_reading *r, const schuler_node *node,
                              schuler_temperature *out);

/** Read the `imu` section of a scenario.
 *  Given      folder     of the scenario file
 *  Returned   imu         complete
 *             documents   those of parts are added; owned by the caller, even after an error */
void schuler_imu_read(schuler_reading *r, const schuler_node *node, const char *folder,
                      schuler_imu *imu, schuler_document *documents[], size_t *count);

#endif
