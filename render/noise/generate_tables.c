/* SPDX-License-Identifier: MIT */
/*
 * Writes the constant tables of hashing, noise and cellular patterns as a C file;
 * run by the build. Every table follows from a short rule given at its function.
 */

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HASH_COUNT = 4096, REAL_COUNT = 267, GRADIENT_COUNT = 2048, UNIFORM_COUNT = 4098 };

/* One step of the linear congruential generator: 15 bits. */
static unsigned lcg(uint32_t *state)
{
	*state = 1812433253u * *state + 12345u;
	return (*state >> 16) & 0x7fff;
}

/* A permutation: from the last place to the first each is exchanged with a random one. And the low
 * bytes of that. */
static void write_hash(FILE *out)
{
	static unsigned hash[HASH_COUNT];
	uint32_t state = 0;
	for (unsigned i = 0; i < HASH_COUNT; i++)
		hash[i] = i;
	for (unsigned i = HASH_COUNT; i-- > 0;) {
		const unsigned j = lcg(&state) % HASH_COUNT, kept = hash[i];
		hash[i] = hash[j];
		hash[j] = kept;
	}
	fputs("const uint16_t hash_table[4096] = {", out);
	for (unsigned i = 0; i < HASH_COUNT; i++)
		fprintf(out, "%s%u,", i % 16 ? "" : "\n\t", hash[i]);
	fputs("\n};\n\nconst uint8_t hash_low[4096] = {", out);
	for (unsigned i = 0; i < HASH_COUNT; i++)
		fprintf(out, "%s%u,", i % 16 ? "" : "\n\t", hash[i] & 0xffu);
	fputs("\n};\n\n", out);
}

/* CRC-16 with the reflected polynomial 0xA001. */
static unsigned crc16(const unsigned char *bytes, size_t count)
{
	unsigned crc = 0;
	for (size_t i = 0; i < count; i++) {
		crc ^= bytes[i];
		for (int bit = 0; bit < 8; bit++)
			crc = crc & 1 ? crc >> 1 ^ 0xa001u : crc >> 1;
	}
	return crc;
}

/* Checksums of single bytes, without their highest bit, in -1/2 to 1/2 with six decimals,
 * halves rounded away from 0. */
static void write_jitter(FILE *out)
{
	fputs("const float jitter_table[256] = {\n", out);
	for (int i = 0; i < 256; i++) {
		const unsigned char byte = (unsigned char)i;
		const double entry = (crc16(&byte, 1) & 0x7fff) / 32768.0 - 0.5;
		fprintf(out, "\t%.6ff,\n", round(1e6 * entry) / 1e6);
	}
	fputs("};\n\n", out);
}

/* Checksums of the multiples of 0.12345, as numbers of six digits in -1 to 1. */
static void write_reals(FILE *out)
{
	fputs("const double noise_reals[267] = {\n", out);
	for (int i = 0; i < REAL_COUNT; i++) {
		const double seed = 0.12345 * i;
		uint64_t bits;
		unsigned char bytes[24];
		char digits[32];
		memcpy(&bits, &seed, sizeof bits);
		for (int j = 0; j < 24; j++)
			bytes[j] = (unsigned char)(bits >> (56 - 8 * (j % 8)));
		snprintf(digits, sizeof digits, "%g", crc16(bytes, 24) * 2.0 / 65535 - 1);
		fprintf(out, "\t%a,\n", strtod(digits, NULL));
	}
	fputs("};\n\n", out);
}

static double signed_unit(uint32_t *state)
{
	return ((int)(lcg(state) % 4096) - 2048) / 2048.0;
}

/* Unit gradients and a permutation, both from one run of the generator. Only the even positions
 * are visited, and the first exchange loses the value at its partner's place. */
static void write_gradients(FILE *out)
{
	static unsigned permutation[GRADIENT_COUNT + 1];
	uint32_t state = 1;
	fputs("const double noise_gradients[2048][3] = {\n", out);
	for (int i = 0; i < GRADIENT_COUNT; i++) {
		double x, y, z, length2;
		do {
			x = signed_unit(&state);
			y = signed_unit(&state);
			z = signed_unit(&state);
			length2 = x * x + y * y + z * z;
		} while (length2 > 1 || length2 < 1e-5);
		const double length = sqrt(length2);
		fprintf(out, "\t{ %a, %a, %a },\n", x / length, y / length, z / length);
	}
	for (unsigned i = 0; i < GRADIENT_COUNT; i++)
		permutation[i] = i;
	for (unsigned i = GRADIENT_COUNT; i >= 2; i -= 2) {
		const unsigned j = lcg(&state) % GRADIENT_COUNT, kept = permutation[i];
		permutation[i] = permutation[j];
		permutation[j] = kept;
	}
	fputs("};\n\nconst uint16_t noise_permutation[2048] = {", out);
	for (unsigned i = 0; i < GRADIENT_COUNT; i++)
		fprintf(out, "%s%u,", i % 16 ? "" : "\n\t", permutation[i]);
	fputs("\n};\n\n", out);
}

/* The Mersenne Twister with its default seed, of which cells index the first 4098 outputs. */
static void write_uniforms(FILE *out)
{
	enum { N = 624, M = 397 };
	uint32_t mt[N];
	mt[0] = 5489;
	for (uint32_t i = 1; i < N; i++)
		mt[i] = 1812433253u * (mt[i - 1] ^ mt[i - 1] >> 30) + i;
	fputs("const double cell_uniforms[4098] = {\n", out);
	for (int k = 0; k < UNIFORM_COUNT; k++) {
		if (k % N == 0)
			for (int i = 0; i < N; i++) {
				const uint32_t y =
					(mt[i] & 0x80000000u) | (mt[(i + 1) % N] & 0x7fffffffu);
				mt[i] = mt[(i + M) % N] ^ y >> 1 ^ (y & 1 ? 0x9908b0dfu : 0);
			}
		uint32_t y = mt[k % N];
		y ^= y >> 11;
		y ^= y << 7 & 0x9d2c5680u;
		y ^= y << 15 & 0xefc60000u;
		y ^= y >> 18;
		fprintf(out, "\t%a,\n", y / 4294967296.0);
	}
	fputs("};\n", out);
}

int main(int argc, char **argv)
{
	FILE *out = argc == 2 ? fopen(argv[1], "w") : NULL;
	if (!out) {
		fprintf(stderr, "usage: generate_tables FILE\n");
		return 1;
	}
	fputs("/* Written by generate_tables.c. */\n#include \"noise/tables.h\"\n\n", out);
	write_hash(out);
	write_jitter(out);
	write_reals(out);
	write_gradients(out);
	write_uniforms(out);
	return fclose(out) == 0 ? 0 : 1;
}
