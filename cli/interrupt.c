/* SPDX-License-Identifier: MIT */
/*
 * Signals that ask for an end. While a scene is read nothing needs cleaning up
 * and nothing looks at a flag, so the program ends at once. While a picture is
 * made or written the handler sets the flag that the progress callbacks look at,
 * between the rows of a block and of the file. A single ray may take longer than
 * anybody wants to wait, and asking it to look at a flag would cost every ray:
 * instead the handler sets a timer, and when that runs out the program ends
 * where it stands. Who asks twice does not wait at all.
 */
#include "interrupt.h"

#include <signal.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Milliseconds that the work has to come to an end by itself. */
enum { PATIENCE = 400 };

static volatile sig_atomic_t requested, deferred;
static const char *volatile last_words;
static timer_t patience;
static bool has_timer;

static void end(void)
{
	const char *text = last_words;
	if (deferred && text && write(STDERR_FILENO, text, strlen(text)) < 0)
		_exit(2);
	_exit(2);
}

static void handle(int signal_number)
{
	const struct itimerspec once = { .it_value.tv_nsec = PATIENCE * 1000000L };
	(void)signal_number;
	if (!deferred || requested || !has_timer || timer_settime(patience, 0, &once, NULL) != 0)
		end();
	requested = 1;
}

static void handle_timer(int signal_number)
{
	(void)signal_number;
	end();
}

static void set_handler(int signal_number, void (*handler)(int))
{
	struct sigaction action = { .sa_handler = handler, .sa_flags = SA_RESTART };
	sigemptyset(&action.sa_mask);
	sigaction(signal_number, &action, NULL);
}

/* nohup, and shells that start a program in the background, have signals ignored. */
static bool is_ignored(int signal_number)
{
	struct sigaction action;
	return sigaction(signal_number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

void interrupt_init(void)
{
	static const int signals[] = { SIGINT, SIGTERM, SIGQUIT, SIGHUP, SIGPIPE };
	struct sigevent event = { .sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGALRM };
	has_timer = timer_create(CLOCK_MONOTONIC, &event, &patience) == 0;
	set_handler(SIGALRM, handle_timer);
	for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
		if (!is_ignored(signals[i]))
			set_handler(signals[i], handle);
}

void interrupt_defer(bool on, const char *text)
{
	last_words = text;
	deferred = on;
}

bool interrupt_requested(void)
{
	return requested != 0;
}
