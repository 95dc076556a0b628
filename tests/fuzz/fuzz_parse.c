/* SPDX-License-Identifier: MIT */
/*
 * Any bytes as a scene: reading them must end, with an AST or with messages.
 *
 * Files cannot be written, and endless loops are cut short; includes are not
 * found, for there is no library path. The preset `fuzz` builds it; tests/fuzz/run
 * runs it.
 */
#include "parser/parser.h"

static void ignore(void *user, const struct message *message)
{
	(void)user;
	(void)message;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	const struct parse_options options = {
		.version = 370,
		.no_file_io = true,
		.max_loop_tokens = 20000,
	};
	struct arena *arena = arena_create(0);
	struct diag *diag = diag_create(ignore, NULL);
	char *text = arena_string(arena, (const char *)bytes, size);

	const struct ast *ast = parse_scene("fuzz.pov", text, size, &options, diag, arena);
	if (!ast && diag_errors(diag) == 0)
		__builtin_trap(); /* failing without a word is a fault, too */
	diag_destroy(diag);
	arena_destroy(arena);
	return 0;
}
