/* SPDX-License-Identifier: MIT */
/*
 * Text as JSON strings.
 */
#ifndef LAMBERT_BASE_JSON_H
#define LAMBERT_BASE_JSON_H

#include <stdio.h>

/* Prints a text as a JSON string, with its quotes. JSON is UTF-8 whatever the text is: a byte that
 * belongs to no UTF-8 sequence counts as a character of Latin-1. */
void json_print_string(FILE *, const char *text);

#endif
