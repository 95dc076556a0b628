/* SPDX-License-Identifier: MIT */
/*
 * lambert diff a.png b.png: how two pictures differ. They match when 99.5 % of
 * the pixels are within 2/255 in every channel and the root mean square error is
 * at most 1.5/255; with --tolerance T when every sample is within T/255. The
 * verdict names the rule that failed.
 */
#include "commands.h"
#include "messages.h"
#include "names.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double MATCH_SHARE = 0.995, MATCH_RMSE = 1.5;
enum { FAILED_SIZE = 128 };

struct request {
	const char *pictures[2], *heatmap;
	int count;
	bool has_tolerance, quiet, json;
	double tolerance;
};

static bool wrong(const char *text, const char *argument)
{
	fprintf(stderr, "lambert diff: error: %s%s (see lambert diff --help)\n", text, argument);
	return false;
}

/* The value of --name or --name=value; NULL when the argument is another, or after a message. */
static const char *value_of(const char *name, int argc, char **argv, int *used)
{
	const size_t n = strlen(name);
	if (strncmp(argv[0], name, n) != 0 || (argv[0][n] && argv[0][n] != '='))
		return NULL;
	*used = argv[0][n] ? 1 : 2;
	return argv[0][n] ? argv[0] + n + 1 : argc > 1 ? argv[1] : NULL;
}

static bool take_tolerance(struct request *r, const char *value)
{
	char *end;
	r->tolerance = strtod(value, &end);
	r->has_tolerance = true;
	if (end == value || *end || !(r->tolerance >= 0))
		return wrong("the tolerance is a number of 255ths, not ", value);
	return true;
}

static bool take_argument(struct request *r, int argc, char **argv, int *used)
{
	const char *value;
	*used = 1;
	if (strcmp(argv[0], "--quiet") == 0)
		r->quiet = true;
	else if (strcmp(argv[0], "--json") == 0)
		r->json = true;
	else if ((value = value_of("--heatmap", argc, argv, used)))
		r->heatmap = value;
	else if ((value = value_of("--tolerance", argc, argv, used)))
		return take_tolerance(r, value);
	else if (*used == 2)
		return wrong("a value is missing after ", argv[0]);
	else if (argv[0][0] == '-' && argv[0][1])
		return wrong("there is no option ", argv[0]);
	else if (r->count == 2)
		return wrong("two pictures are compared; one too many: ", argv[0]);
	else
		r->pictures[r->count++] = argv[0];
	return true;
}

static bool read_request(struct request *r, int argc, char **argv)
{
	for (int i = 0, used; i < argc; i += used)
		if (!take_argument(r, argc - i, argv + i, &used))
			return false;
	for (int i = 0; r->heatmap && i < r->count; i++)
		if (names_same_file(r->heatmap, r->pictures[i]))
			return wrong("the heat map would overwrite ", r->pictures[i]);
	return r->count == 2 || wrong("two pictures are needed", "");
}

/* The first rule that failed, as the verdict says it; "" for a match. */
static void judge(
	const struct request *r, const struct lambert_difference *d, char failed[FAILED_SIZE])
{
	*failed = '\0';
	if (r->has_tolerance && !(d->worst <= r->tolerance))
		snprintf(failed, FAILED_SIZE,
			"a sample differs by %.4g of 255, more than the tolerance of %g", d->worst,
			r->tolerance);
	else if (r->has_tolerance)
		return;
	else if (!(d->within_2 >= MATCH_SHARE))
		snprintf(failed, FAILED_SIZE,
			"%.4g %% of the pixels are within 2 of 255, fewer than %g %%",
			floor(1e4 * d->within_2) / 100, 100 * MATCH_SHARE);
	else if (!(d->rmse_all <= MATCH_RMSE))
		snprintf(failed, FAILED_SIZE, "the RMSE is %.4g of 255, more than %g", d->rmse_all,
			MATCH_RMSE);
}

static void print_text(const struct lambert_difference *d, const char *failed)
{
	static const char *const names[4] = { "red", "green", "blue", "alpha" };
	printf("size          %u x %u\n", d->width, d->height);
	printf("compared      %s\n", d->as_stored ? "as stored" : "as sRGB");
	for (int c = 0; c < 4; c++)
		printf("%-6s        maximum %.4g, RMSE %.4f\n", names[c], d->maximum[c],
			d->rmse[c]);
	printf("RMSE          %.4f of 255\n", d->rmse_all);
	printf("PSNR          %.2f dB\n", d->psnr);
	printf("within 1      %.4f %% of the pixels\n", 100 * d->within_1);
	printf("within 2      %.4f %%\n", 100 * d->within_2);
	printf("within 8      %.4f %%\n", 100 * d->within_8);
	printf("lowest SSIM   %.6f\n", d->lowest_ssim);
	printf("worst pixel   %u, %u: %.4g\n", d->worst_x, d->worst_y, d->worst);
	printf("%s%s\n", *failed ? "no match: " : "match", failed);
}

/* Infinity has no spelling in JSON: null. */
static void print_number(const char *name, double value)
{
	if (isfinite(value))
		printf("\"%s\": %.9g, ", name, value);
	else
		printf("\"%s\": null, ", name);
}

static void print_json(const struct lambert_difference *d, const char *failed)
{
	static const char *const names[4] = { "maximum_red", "maximum_green", "maximum_blue",
		"maximum_alpha" };
	printf("{\"width\": %u, \"height\": %u, ", d->width, d->height);
	for (int c = 0; c < 4; c++)
		print_number(names[c], d->maximum[c]);
	print_number("rmse", d->rmse_all);
	print_number("psnr", d->psnr);
	print_number("within_1", d->within_1);
	print_number("within_2", d->within_2);
	print_number("within_8", d->within_8);
	print_number("lowest_ssim", d->lowest_ssim);
	print_number("worst", d->worst);
	printf("\"worst_x\": %u, \"worst_y\": %u, \"as_stored\": %s, ", d->worst_x, d->worst_y,
		d->as_stored ? "true" : "false");
	if (*failed)
		printf("\"match\": false, \"failed\": \"%s\"}\n", failed);
	else
		printf("\"match\": true}\n");
}

static void take_message(void *user, const struct lambert_message *message)
{
	(void)user;
	fprintf(stderr, "lambert diff: error: %s\n", message->text);
}

int command_diff(int argc, char **argv)
{
	struct request r = { .count = 0 };
	struct lambert_difference d;
	if (!read_request(&r, argc, argv) ||
		!lambert_compare(r.pictures[0], r.pictures[1], r.heatmap, &d, take_message, NULL))
		return STATUS_ERROR;
	char failed[FAILED_SIZE];
	judge(&r, &d, failed);
	if (r.json)
		print_json(&d, failed);
	else if (!r.quiet)
		print_text(&d, failed);
	return *failed ? STATUS_ERROR : STATUS_OK;
}
