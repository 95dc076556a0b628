/* SPDX-License-Identifier: MIT */
/*
 * The parser alone: parse_bench SCENE [LIBRARY PATH] prints the CPU seconds from text to AST. For
 * tests/bench/parse.
 */
#include "parser/parser.h"

#include <time.h>

static double now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void show(void *user, const struct message *m)
{
	(void)user;
	if (m->severity == SEVERITY_ERROR)
		fprintf(stderr, "%s:%u: error: %s\n", m->place.file ? m->place.file : "",
			m->place.line, m->text);
}

int main(int argc, char **argv)
{
	if (argc < 2)
		return 2;
	const char *const *library = (const char *const *)argv + 2;
	const struct parse_options options = { .library_paths = library,
		.library_path_count = argc > 2 ? (size_t)argc - 2 : 0 };
	struct arena *arena = arena_create(1 << 20);
	struct diag *diag = diag_create(show, NULL);
	const double start = now();
	const struct ast *ast = parse_scene(argv[1], NULL, 0, &options, diag, arena);
	const double end = now();
	if (ast)
		printf("%.6f\n", end - start);
	diag_destroy(diag);
	arena_destroy(arena);
	return ast ? 0 : 1;
}
