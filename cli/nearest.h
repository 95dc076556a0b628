/* SPDX-License-Identifier: MIT */
/* The word that was probably meant. */
#ifndef LAMBERT_CLI_NEAREST_H
#define LAMBERT_CLI_NEAREST_H

#include <stddef.h>

/* How many slips turn one word into the other, whatever the letter case: letters left out, put in,
 * exchanged for another or with their neighbour. Words longer than 63 letters are far from any. */
size_t nearest_distance(const char *a, size_t a_length, const char *b);

/* Whether so few slips that a word of this length may be meant. */
static inline int nearest_is_near(size_t distance, size_t length)
{
	return distance <= 2 && 2 * distance < length;
}

#endif
