/* SPDX-License-Identifier: MIT */
/* Names of files: where the scene is, where the picture goes. */
#ifndef LAMBERT_CLI_NAMES_H
#define LAMBERT_CLI_NAMES_H

#include "options.h"

/* Where the scene is: as named, with .pov, in the folders of the library path. The name itself if
 * it is nowhere. */
const char *names_scene(struct options *);
/* The format of the picture; false after a message. */
bool names_format(struct options *, struct lambert_format *);
/* The name of the picture, "-" for standard output. `frame` with `digits` digits is appended to its
 * stem; digits 0: no frame number. NULL after a message. */
const char *names_picture(struct options *, int frame, int digits);
/* Whether a file of ours may be written there: not over the scene or an INI file of this run. False after
 * a message. */
bool names_may_write(struct options *, const char *path);
/* Whether both paths lead to one file, by whatever links. */
bool names_same_file(const char *a, const char *b);
/* The file part of a path. */
const char *names_file_part(const char *path);

#endif
