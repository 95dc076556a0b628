/* SPDX-License-Identifier: MIT */
/*
 * Writes portable pixmaps and greymaps: a one-line header with the largest code,
 * then the codes, two bytes each (high byte first) when they need it.
 */
#include "image/image_format.h"

#include "base/arena.h"

#include <stdint.h>
#include <stdlib.h>

/* Codes of two bytes, in place. */
static void put_high_bytes_first(void *row, size_t count)
{
	const uint16_t *codes = row;
	unsigned char *out = row;
	for (size_t i = 0; i < count; i++) {
		const unsigned code = codes[i];
		out[2 * i] = (unsigned char)(code >> 8);
		out[2 * i + 1] = (unsigned char)(code & 255);
	}
}

bool pnm_write(FILE *file, const struct raster *r, char *reason)
{
	const size_t count = (size_t)r->width * r->channels;
	void *row = memory_alloc(r->row_bytes, 1);
	bool ok = fprintf(file, "P%c\n%u %u\n%u\n", r->channels == 1 ? '5' : '6', r->width,
			  r->height, (1u << r->bits) - 1) > 0;
	for (unsigned y = 0; ok && y < r->height; y++) {
		ok = r->row(r->source, y, row);
		if (r->sample_bits == 16)
			put_high_bytes_first(row, count);
		ok = ok && fwrite(row, 1, r->row_bytes, file) == r->row_bytes;
	}
	free(row);
	if (!ok)
		snprintf(reason, REASON_SIZE, "the file cannot be written completely");
	return ok;
}
