/* SPDX-License-Identifier: MIT */
/*
 * Signals that ask for an end. While a scene is read nothing needs cleaning up
 * and nothing looks at a flag, so the program ends at once; while a picture is
 * made the handler only sets the flag that the progress callback looks at, which
 * may take as long as one row of a block of the picture. Who asks twice does not want to
 * wait for that.
 */
#include "interrupt.h"

#include <signal.h>
#include <unistd.h>

static volatile sig_atomic_t requested, deferred;

static void handle(int signal_number)
{
	(void)signal_number;
	if (!deferred || requested)
		_exit(2);
	requested = 1;
}

void interrupt_init(void)
{
	static const int signals[] = { SIGINT, SIGTERM, SIGQUIT, SIGPIPE };
	struct sigaction action = { .sa_handler = handle };
	sigemptyset(&action.sa_mask);
	for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
		sigaction(signals[i], &action, NULL);
}

void interrupt_defer(bool on)
{
	deferred = on;
}

bool interrupt_requested(void)
{
	return requested != 0;
}
