/* SPDX-License-Identifier: MIT */
/* Questions about the picture formats of the library. */
#ifndef LAMBERT_CLI_FORMATS_H
#define LAMBERT_CLI_FORMATS_H

#include "text.h"

#include "lambert/lambert.h"

/* By POV-Ray's letter; false: there is none. */
bool formats_find_letter(char letter, struct lambert_format *);
/* By the extension of a path; false: it has none, or one that is not known. */
bool formats_find_path(const char *path, struct lambert_format *);
/* The usual extension, with its dot. */
const char *formats_extension(struct text_pool *, const struct lambert_format *);

/* For messages: "png, ppm, ..."; ".png .ppm ..."; "N is png, P ppm, ...". */
const char *formats_names(struct text_pool *);
const char *formats_extensions(struct text_pool *);
const char *formats_letters(struct text_pool *);
const char *formats_dithers(struct text_pool *);

#endif
