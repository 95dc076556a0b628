/* SPDX-License-Identifier: MIT */
/* SIGINT, SIGTERM, SIGQUIT, SIGHUP and SIGPIPE ask for an end, with exit status 2. */
#ifndef LAMBERT_CLI_INTERRUPT_H
#define LAMBERT_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the signals are heeded, but for those that the caller of the program has had ignored:
 * at once, until told otherwise. */
void interrupt_init(void);
/* Whether there is something to clean up: then the end comes as soon as somebody looks at
 * interrupt_requested, after half a second, or at the second signal. `text` (or NULL) is what is
 * printed if nobody has looked. */
void interrupt_defer(bool, const char *text);
bool interrupt_requested(void);

#endif
