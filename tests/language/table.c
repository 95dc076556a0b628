/* SPDX-License-Identifier: MIT */
/*
 * Prints docs/language.md from the rows that parser and lowering read.
 */
#include "language/shape_word.h"

#include <stdio.h>

static const char *kind(const struct parameter *p)
{
	switch (p->type) {
	case PARAMETER_FLOAT:
		return "float";
	case PARAMETER_VECTOR:
		return "vector";
	case PARAMETER_PAIR:
		return "vector of two";
	case PARAMETER_OPTIONAL:
		return "float, may be absent";
	case PARAMETER_FONT:
		return "ttf file or internal number";
	case PARAMETER_STRING:
		return "string";
	case PARAMETER_ARRAY:
		return "list";
	default:
		return "";
	}
}

static void print_arguments(const struct parameter *p)
{
	const char *before = "";
	for (; p->type != PARAMETER_END && p->type <= PARAMETER_ARRAY; p++) {
		printf("%s%s (%s)", before, p->name, kind(p));
		before = ", ";
	}
}

static void print_items(const struct parameter *p)
{
	const char *before = "";
	for (; p->type != PARAMETER_END; p++) {
		if (p->type <= PARAMETER_ARRAY)
			continue;
		printf("%s%s", before, keyword_name(p->word));
		before = ", ";
	}
}

int main(void)
{
	puts("# What objects take between their braces\n\n"
	     "Made by `tests/language/run --write` from `language/shapes.def`. Behind the values "
	     "come the items that every\n"
	     "object may have (textures, transformations, ...), and those of its own. "
	     "[compatibility.md](compatibility.md) says\n"
	     "which are rendered.\n\n"
	     "| object | values | items of its own |\n|---|---|---|");
	for (enum keyword k = K_NONE; k < KEYWORD_COUNT; k++) {
		const struct shape_word *word = shape_word_of(k);
		if (!word)
			continue;
		printf("| %s | ", keyword_name(k));
		print_arguments(word->parameters);
		printf(" | ");
		print_items(word->parameters);
		puts(" |");
	}
	return 0;
}
