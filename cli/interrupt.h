/* SPDX-License-Identifier: MIT */
/* SIGINT, SIGTERM, SIGQUIT and SIGPIPE ask for an end, with exit status 2. */
#ifndef LAMBERT_CLI_INTERRUPT_H
#define LAMBERT_CLI_INTERRUPT_H

#include <stdbool.h>

/* From now on the signals are heeded: at once, until told otherwise. */
void interrupt_init(void);
/* Whether there is something to clean up: then the end comes as soon as somebody looks at
 * interrupt_requested, or at the second signal. */
void interrupt_defer(bool);
bool interrupt_requested(void);

#endif
