/* SPDX-License-Identifier: MIT */
/*
 * The progress bar. It is drawn at most ten times a second, and not at all for
 * pictures that are done before one would have read it. While a scene is read for
 * more than a second, the place that the reading has reached stands there.
 */
#include "progress.h"

#include "interrupt.h"
#include "names.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

static const double REDRAW = 0.1;
/* Seconds after which a user asks what the program is at. */
static const double READING_IS_LONG = 1;

double progress_clock(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static enum progress_style choose_style(const struct options *o)
{
	if (o->quiet || !o->verbose)
		return PROGRESS_OFF;
	if (!o->progress)
		return isatty(STDERR_FILENO) ? PROGRESS_BAR : PROGRESS_LINES;
	return strcmp(o->progress, "bar") == 0	   ? PROGRESS_BAR
	       : strcmp(o->progress, "lines") == 0 ? PROGRESS_LINES
						   : PROGRESS_OFF;
}

void progress_init(struct progress *p, struct messages *messages, const char *what)
{
	*p = (struct progress){ .messages = messages,
		.style = choose_style(messages->options),
		.what = what,
		.start = progress_clock() };
	p->last = p->start;
}

static int columns(void)
{
	struct winsize size;
	if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20)
		return 80;
	return size.ws_col;
}

/* "1:02:03", "2:03", "5 s" */
static void print_duration(char *out, size_t size, double seconds)
{
	const long s = seconds < 360000 ? lround(seconds) : 359999;
	if (s >= 3600)
		snprintf(out, size, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
	else if (s >= 60)
		snprintf(out, size, "%ld:%02ld", s / 60, s % 60);
	else
		snprintf(out, size, "%ld s", s);
}

static void draw_bar(struct progress *p, double share, double now)
{
	char left[32], bar[64];
	print_duration(left, sizeof left, share > 0 ? (now - p->start) * (1 - share) / share : 0);
	int width = columns() - 32;
	width = width > 50 ? 50 : width < 4 ? 4 : width;
	const int full = (int)(share * width);
	for (int i = 0; i < width; i++)
		bar[i] = i < full ? '#' : '.';
	bar[width] = 0;
	fprintf(stderr, "\r[%s] %3.0f%%  %s left\033[K", bar, floor(100 * share), left);
	fflush(stderr);
	p->messages->line_open = true;
}

static void show(struct progress *p, double share)
{
	const double now = progress_clock();
	if (p->style == PROGRESS_LINES && (int)(10 * share) > p->tenths) {
		p->tenths = (int)(10 * share);
		fprintf(stderr, "%s: %d%%\n", p->what, 10 * p->tenths);
	}
	if (p->style == PROGRESS_BAR && now - p->last >= REDRAW) {
		p->last = now;
		draw_bar(p, share, now);
	}
}

bool progress_step(void *user, double share_done)
{
	struct progress *p = user;
	if (p->style != PROGRESS_OFF)
		show(p, share_done);
	return !interrupt_requested();
}

void progress_finish(struct progress *p)
{
	messages_clear_line(p->messages);
}

/* A terminal would obey control characters in a name. */
static void print_name(const char *name, int room)
{
	for (int i = 0; name[i] && i < room; i++)
		fputc(iscntrl((unsigned char)name[i]) ? '?' : name[i], stderr);
}

/* Whether to say what a scene waits for. */
static bool is_shown(const struct messages *m, double seconds)
{
	return seconds >= READING_IS_LONG && choose_style(m->options) == PROGRESS_BAR;
}

static void end_line(struct messages *m)
{
	fputs("\033[K", stderr);
	fflush(stderr);
	m->line_open = true;
}

bool progress_reading(void *user, const struct lambert_place *place, double seconds)
{
	struct messages *m = user;
	if (!is_shown(m, seconds))
		return true;
	char time[32];
	print_duration(time, sizeof time, seconds);
	fprintf(stderr, "\rreading, %s, line %u of ", time, place->line);
	print_name(names_file_part(place->file ? place->file : ""), columns() - 40);
	end_line(m);
	return true;
}

bool progress_preparing(void *user, const char *what, double share_done, double seconds)
{
	struct messages *m = user;
	if (!is_shown(m, seconds))
		return true;
	char time[32];
	print_duration(time, sizeof time, seconds);
	fprintf(stderr, "\r%s, %s, %.0f%%", what, time, floor(100 * share_done));
	end_line(m);
	return true;
}
