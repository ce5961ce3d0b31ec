/* SPDX-License-Identifier: MIT */
/* Text within XML and HTML. */
#ifndef SCHULER_TOOLS_XML_H
#define SCHULER_TOOLS_XML_H

#include <stdio.h>

/** Write a text, between tags or within quotes; what XML cannot hold in it becomes '?'. NULL
 *  writes nothing. */
void xml_text(FILE *out, const char *text);

#endif
