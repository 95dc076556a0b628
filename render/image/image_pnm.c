/* SPDX-License-Identifier: MIT */
/*
 * Writes portable pixmaps and greymaps: a one-line header with the largest code,
 * then the codes, two bytes each (high byte first) when they need it.
 */
#include "image/image_format.h"

#include "base/arena.h"

#include <stdint.h>
#include <stdlib.h>

static void put_row(unsigned char *out, const struct raster *r, size_t first, size_t count)
{
	if (r->sample_bits == 8) {
		const uint8_t *codes = (const uint8_t *)r->samples + first;
		for (size_t i = 0; i < count; i++)
			out[i] = codes[i];
		return;
	}
	const uint16_t *codes = (const uint16_t *)r->samples + first;
	for (size_t i = 0; i < count; i++) {
		out[2 * i] = (unsigned char)(codes[i] >> 8);
		out[2 * i + 1] = (unsigned char)(codes[i] & 255);
	}
}

bool pnm_write(FILE *file, const struct raster *r, char *reason)
{
	const size_t count = (size_t)r->width * r->channels;
	const size_t bytes = count * (size_t)(r->sample_bits / 8);
	unsigned char *row = memory_alloc(bytes, 1);
	bool ok = fprintf(file, "P%c\n%u %u\n%u\n", r->channels == 1 ? '5' : '6', r->width,
			  r->height, (1u << r->bits) - 1) > 0;
	for (unsigned y = 0; ok && y < r->height; y++) {
		put_row(row, r, y * count, count);
		ok = fwrite(row, 1, bytes, file) == bytes;
	}
	free(row);
	if (!ok)
		snprintf(reason, REASON_SIZE, "the file cannot be written completely");
	return ok;
}
