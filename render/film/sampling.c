/* SPDX-License-Identifier: MIT */
/*
 * What all strategies of sampling share; see sampling.h.
 */
#include "sampling.h"

#include "base/arena.h"
#include "film/sums.h"
#include "noise/tables.h"

#include <stdlib.h>

/* By the numbers the language gives them. */
static const struct sampling_class *const methods[] = {
	&sampling_plain,
	&sampling_neighbours,
	&sampling_recursive,
};

const struct sampling_class *sampling_of_method(int method)
{
	const int count = sizeof methods / sizeof *methods;
	return methods[method >= 0 && method < count ? method : 0];
}

void sampler_init(struct sampler *s, const struct sampling_class *strategy,
	const struct antialias *settings, const struct working_space *working,
	sample_source *source, void *user)
{
	*s = (struct sampler){ .strategy = strategy, .source = source, .user = user };
	s->self = memory_zeroed(1, strategy->size);
	if (strategy->init)
		strategy->init(s->self, settings, working);
}

void sampler_finish(struct sampler *s)
{
	if (s->strategy->finish)
		s->strategy->finish(s->self);
	free(s->self);
}

uint64_t sampler_plan(const struct sampler *s, struct film *film, unsigned pass, struct block b,
	struct block region)
{
	const struct block inner = block_common(b, region);
	uint64_t sum = 0;
	for (unsigned y = inner.top; y < inner.bottom; y++) {
		for (unsigned x = inner.left; x < inner.right; x++) {
			const uint32_t wanted =
				s->strategy->wanted(s->self, film->sums, pass, x, y);
			film_sum(film->sums, x, y)->wanted = wanted;
			sum += wanted;
		}
	}
	return sum;
}

void sampler_take(struct sampler *s, struct film *film, struct block b, struct block region)
{
	s->strategy->take(s->self, s, film, b, block_common(b, region));
}

void sampler_row(
	const struct sampler *s, int32_t x, int32_t y, double shift, size_t count, colour *out)
{
	enum { TOGETHER = 64 };
	struct position at[TOGETHER];
	for (size_t done = 0; done < count; done += TOGETHER) {
		const size_t n = count - done < TOGETHER ? count - done : TOGETHER;
		for (size_t i = 0; i < n; i++) {
			const int32_t column = x + (int32_t)(done + i);
			at[i] = (struct position){ column + shift, y + shift, { column, y, 0 } };
		}
		s->source(s->user, n, at, out + done);
	}
}

/* ---- displacement ---- */

/* Truncates toward zero; positions are a few pixels outside a picture at most. */
static uint32_t lattice(double v)
{
	return (uint32_t)(int32_t)v;
}

static double jitter_entry(uint32_t column, uint32_t row)
{
	const uint32_t cell = hash_table[column & 4095] ^ row;
	return (double)jitter_table[hash_table[cell & 4095] & 255];
}

struct position sample_jitter(struct position p)
{
	return (struct position){ jitter_entry(lattice(1021 * p.x), lattice(1019 * p.y)),
		jitter_entry(lattice(1019 * p.x), lattice(1021 * p.y)), p.place };
}
