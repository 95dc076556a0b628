/* SPDX-License-Identifier: MIT */
/*
 * Finds and opens the module that knows picture formats other than PNG: in the
 * build folder for programs that run from there, else in the library folder of the
 * installation that the program is in, else in the one that was configured. A
 * program that stands elsewhere opens nothing from where it was once built: others
 * might be able to put something there.
 * The dynamic loader keeps one copy per process, so nothing is remembered here.
 */
#include "image/image_format.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef LAMBERT_MODULE_DIR
#define LAMBERT_MODULE_DIR "/usr/local/lib/lambert"
#endif
#ifndef LAMBERT_LIBRARY_FOLDER /* seen from the prefix */
#define LAMBERT_LIBRARY_FOLDER "lib"
#endif
#ifndef LAMBERT_BUILD_DIR
#define LAMBERT_BUILD_DIR LAMBERT_MODULE_DIR
#endif

/* Whether it is the build folder or one below. */
static bool is_in_build(const char *folder)
{
	char outer[PATH_MAX];
	if (!realpath(LAMBERT_BUILD_DIR, outer))
		return false;
	const size_t n = strlen(outer);
	return strncmp(folder, outer, n) == 0 && (folder[n] == 0 || folder[n] == '/');
}

/* The folder of the running program, "" if the system does not tell. */
static void program_folder(char *folder, size_t size)
{
	const ssize_t n = readlink("/proc/self/exe", folder, size - 1);
	folder[n > 0 ? n : 0] = 0;
	char *slash = strrchr(folder, '/');
	if (slash)
		*slash = 0;
}

static void *open_in(const char *folder, const char *below)
{
	char path[PATH_MAX + 64];
	const int n = snprintf(path, sizeof path, "%s%s/%s", folder, below, IMAGE_MODULE_FILE);
	if (n < 0 || (size_t)n >= sizeof path || access(path, R_OK) != 0)
		return NULL;
	return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}

const struct image_module *image_module_open(char *reason)
{
	char folder[PATH_MAX];
	program_folder(folder, sizeof folder);
	void *module = is_in_build(folder) ? open_in(LAMBERT_BUILD_DIR, "") : NULL;
	if (!module)
		module = open_in(folder, "/../" LAMBERT_LIBRARY_FOLDER "/lambert");
	if (!module)
		module = open_in(LAMBERT_MODULE_DIR, "");
	const struct image_module *found = module ? dlsym(module, IMAGE_MODULE_SYMBOL) : NULL;
	if (!found) {
		const char *error = dlerror();
		snprintf(reason, REASON_SIZE,
			"the module " IMAGE_MODULE_FILE " for this format cannot be opened (%s)",
			error ? error : "not found");
	}
	return found;
}
