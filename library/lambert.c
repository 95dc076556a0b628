/* SPDX-License-Identifier: MIT */
/*
 * The public API over the stages: text -> AST -> scene -> film. Pictures in
 * files are in api_image.c.
 */
#include "lambert/lambert.h"

#include "base/arena.h"
#include "base/diag.h"
#include "base/json.h"
#include "base/parallel.h"
#include "hooks.h"
#include "parser/parser.h"
#include "accel/accel.h"
#include "api.h"
#include "film/film.h"
#include "prepare/prepare.h"
#include "lower/lower.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct lambert_scene {
	struct scene *scene;
	unsigned width, height;
	struct lambert_scene_stats stats;
};

static double cpu_seconds(void)
{
	struct timespec t;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double wall_seconds(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void lambert_scene_options_init(struct lambert_scene_options *o)
{
	*o = (struct lambert_scene_options){
		.width = 160, .height = 120, .quality = 9, .loop_limit = 2e10
	};
}

/* ---- messages ---- */

static struct lambert_place place_for_user(const struct place *p)
{
	return (struct lambert_place){ p->file, p->line, p->column, p->length, p->text, p->context,
		p->text_offset };
}

static void forward_message(void *user, const struct message *m)
{
	const struct lambert_scene_options *o = user;
	if (!o->message)
		return;
	struct lambert_place chain[16];
	size_t length = 0;
	for (; length < m->chain_length && length < 16; length++)
		chain[length] = place_for_user(&m->chain[length]);
	const struct lambert_message out = {
		.severity = m->severity == SEVERITY_ERROR     ? LAMBERT_ERROR
			    : m->severity == SEVERITY_WARNING ? LAMBERT_WARNING
							      : LAMBERT_NOTE,
		.text = m->text,
		.place = place_for_user(&m->place),
		.chain = chain,
		.chain_length = length,
	};
	o->message(o->user, &out);
}

static void forward_text(void *user, enum keyword stream, const char *line)
{
	const struct lambert_scene_options *o = user;
	if (o->text)
		o->text(o->user, keyword_name(stream), line);
}

/* ---- loading ---- */

/* NULL: the current one, which is also that of a scene from standard input. */
static char *folder_of(const char *path, struct arena *arena)
{
	const char *slash = strcmp(path, "/dev/stdin") == 0 ? NULL : strrchr(path, '/');
	return slash ? arena_string(arena, path, (size_t)(slash - path)) : NULL;
}

static struct parse_options parse_options_for(
	const char *path, const struct lambert_scene_options *o, struct arena *arena)
{
	struct declaration *d = ARENA_ARRAY(arena, o->declaration_count + 1, struct declaration);
	for (size_t i = 0; i < o->declaration_count; i++)
		d[i] = (struct declaration){ o->declarations[i].name, o->declarations[i].string,
			o->declarations[i].number };
	return (struct parse_options){
		.library_paths = o->library_paths,
		.library_path_count = o->library_path_count,
		.scene_folder = folder_of(path, arena),
		.declarations = d,
		.declaration_count = o->declaration_count,
		.include_header = o->include_header,
		.clock = o->clock,
		.clock_on = o->clock_on,
		.version = o->version ? (int)o->version : 370,
		.version_set = o->version != 0,
		.max_loop_tokens = o->loop_limit,
		.no_file_io = o->no_file_io,
		.read_paths = o->read_paths,
		.read_path_count = o->read_path_count,
		.write_paths = o->write_paths,
		.write_path_count = o->write_path_count,
		.kept_paths = o->kept_paths,
		.kept_path_count = o->kept_path_count,
		.text = forward_text,
		.text_user = (void *)(uintptr_t)o,
	};
}

static unsigned thread_count(unsigned wanted)
{
	return wanted ? wanted : parallel_processors();
}

static void add_tree_statistics(struct lambert_scene_stats *stats, const struct scene *s)
{
	const struct accel_stats a = accel_statistics(s->accel);
	stats->unbounded_objects = a.unbounded;
	stats->accel_bytes = a.bytes;
}

/* A scene on its way from text to something to render. */
struct reading {
	const char *path;
	const struct lambert_scene_options *options;
	struct scene *scene; /* NULL after an error */
	struct lambert_scene_stats stats;
	double start, told; /* seconds: began; when a pass was last told of */
	atomic_bool asked;  /* where the reading is */
	FILE *out;	    /* where a tree is printed */
	bool printed;
	/* Gone when the text is read. */
	struct diag *diag;
	struct arena *arena, *passing; /* for the text and its tree; for the statements at hand */
	struct parse_options files;
	bool writes_nothing; /* what the scene writes stays in memory */
	struct lower_options lower_options;
	struct lowering lowering;
};

/* From another thread than the one that reads: it answers at the next directive. */
static void ask_place(void *user)
{
	struct reading *r = user;
	atomic_store_explicit(&r->asked, true, memory_order_relaxed);
}

static bool tell_place(void *user, span where)
{
	struct reading *r = user;
	const struct place p = diag_place(r->diag, where);
	const struct lambert_place place = place_for_user(&p);
	return r->options->progress(r->options->user, &place, wall_seconds() - r->start);
}

static void reading_begin(struct reading *r)
{
	r->diag = diag_create(forward_message, (void *)(uintptr_t)r->options);
	r->arena = arena_create(1 << 20);
	r->passing = arena_create(2 * PASSING_BYTES);
	r->files = parse_options_for(r->path, r->options, r->arena);
	if (r->writes_nothing)
		r->files.scratch = scratch_create();
	if (r->options->progress) {
		r->files.asked = &r->asked;
		r->files.reached = tell_place;
		r->files.reached_user = r;
	}
}

static void reading_end(struct reading *r)
{
	diag_show_unsupported(r->diag);
	scratch_destroy(r->files.scratch);
	arena_destroy(r->passing);
	arena_destroy(r->arena);
	diag_destroy(r->diag);
}

/* The renderer answers the questions of the language while the text is read. */
static const struct ast *parse(struct reading *r)
{
	struct hooks *hooks = hooks_create(r->diag, &r->files, r->scene);
	r->files.hooks = hooks_table(hooks);
	const struct ast *ast = parse_scene(r->path, NULL, 0, &r->files, r->diag, r->arena);
	hooks_destroy(hooks);
	return ast;
}

static void lowering_begin(struct reading *r)
{
	const struct lambert_scene_options *o = r->options;
	r->lower_options = (struct lower_options){
		.width = o->width,
		.height = o->height,
		.quality = o->quality,
		.frame = o->frame,
		.output_alpha = o->output_alpha,
		.working_version = (int)o->version,
		.files = &r->files,
	};
	r->scene = scene_create();
	lowering_init(&r->lowering, &r->lower_options, r->diag, r->scene);
}

/* The end of lowering; without a tree there was an error. */
static void lowering_end(struct reading *r, const struct ast *ast)
{
	const bool fine = ast && lower_end(&r->lowering, &ast->final);
	lowering_release(&r->lowering);
	r->stats.tokens = ast ? ast->token_count : 0;
	r->stats.objects = r->scene->object_count;
	r->stats.lights = r->scene->light_count;
	if (fine)
		return;
	scene_destroy(r->scene);
	r->scene = NULL;
}

static void lower(void *user, const struct node *statements)
{
	struct reading *r = user;
	const double start = cpu_seconds();
	lower_statements(&r->lowering, statements);
	r->stats.lower_cpu += cpu_seconds() - start;
}

static bool lower_part(void *user, span word, const struct node *members)
{
	struct reading *r = user;
	const double start = cpu_seconds();
	const bool free = lower_members(&r->lowering, word, members);
	r->stats.lower_cpu += cpu_seconds() - start;
	return free;
}

/* Text to tree to scene; where there is much of it, statements are lowered while the text is read. */
static void read_scene(void *user)
{
	struct reading *r = user;
	const double start = cpu_seconds();
	reading_begin(r);
	r->files.statements = lower;
	r->files.members = lower_part;
	r->files.statements_user = r;
	r->files.passing = r->passing;
	lowering_begin(r);
	const struct ast *ast = parse(r);
	if (ast)
		lower(r, ast->statements);
	lowering_end(r, ast);
	reading_end(r);
	r->stats.parse_cpu = cpu_seconds() - start - r->stats.lower_cpu;
}

static void print_tree(void *user)
{
	struct reading *r = user;
	reading_begin(r);
	const struct ast *ast = parse(r);
	if (ast)
		ast_print_json(ast, r->diag, r->out);
	r->printed = ast != NULL;
	reading_end(r);
}

/* Of which only what is used takes memory. */
#define DEEP_STACK ((size_t)512 << 20)

/* A scene may nest as deep as the parser allows, and what reads it recurses as deep. */
static void with_deep_stack(void (*run)(void *), struct reading *r)
{
	r->start = wall_seconds();
	parallel_with_stack(DEEP_STACK, run, r->options->progress ? ask_place : NULL, r);
}

/* Seconds between two calls that tell of the same pass. */
#define TELLING_PAUSE 0.25

static bool tell_pass(void *user, const char *pass, double share_done)
{
	struct reading *r = user;
	const struct lambert_scene_options *o = r->options;
	const double now = wall_seconds();
	if (!o->preparing || (share_done > 0 && now - r->told < TELLING_PAUSE))
		return true;
	r->told = now;
	return o->preparing(o->user, pass, share_done, now - r->start);
}

static void prepare(struct reading *r)
{
	const struct lambert_scene_options *o = r->options;
	const double start = cpu_seconds();
	const struct preparation p = { r->scene, o->width, o->height, thread_count(o->threads),
		tell_pass, r };
	if (!scene_prepare(&p)) {
		scene_destroy(r->scene);
		r->scene = NULL;
		return;
	}
	r->stats.build_cpu = cpu_seconds() - start;
	add_tree_statistics(&r->stats, r->scene);
}

static void read_and_prepare(void *user)
{
	struct reading *r = user;
	read_scene(r);
	if (r->scene)
		prepare(r);
}

lambert_scene *lambert_scene_load(const char *path, const struct lambert_scene_options *o)
{
	struct reading r = { .path = path, .options = o };
	with_deep_stack(read_and_prepare, &r);
	if (!r.scene)
		return NULL;
	lambert_scene *handle = memory_alloc(1, sizeof *handle);
	*handle = (lambert_scene){ r.scene, o->width, o->height, r.stats };
	return handle;
}

bool lambert_scene_check(
	const char *path, const struct lambert_scene_options *o, struct lambert_scene_stats *stats)
{
	struct reading r = { .path = path, .options = o, .writes_nothing = true };
	with_deep_stack(read_scene, &r);
	const bool fine = r.scene != NULL;
	*stats = r.stats;
	scene_destroy(r.scene);
	return fine;
}

bool lambert_scene_print_ast(const char *path, const struct lambert_scene_options *o, FILE *out)
{
	struct reading r = { .path = path, .options = o, .out = out, .writes_nothing = true };
	with_deep_stack(print_tree, &r);
	return r.printed;
}

void lambert_scene_destroy(lambert_scene *s)
{
	if (!s)
		return;
	scene_destroy(s->scene);
	free(s);
}

void lambert_print_json_string(const char *text, FILE *file)
{
	json_print_string(file, text);
}

void lambert_scene_statistics(const lambert_scene *s, struct lambert_scene_stats *stats)
{
	*stats = s->stats;
}

/* ---- rendering ---- */

void lambert_render_options_init(struct lambert_render_options *o)
{
	*o = (struct lambert_render_options){
		.antialias_threshold = 0.3,
		.antialias_depth = 3,
		.antialias_jitter = 1,
		.antialias_gamma = 2.5,
		.block_size = 32,
	};
}

static bool forward_progress(void *user, unsigned done, unsigned all)
{
	const struct lambert_render_options *o = user;
	return !o->progress || o->progress(o->user, all ? (double)done / all : 1);
}

static unsigned smaller(unsigned a, unsigned b)
{
	return a < b ? a : b;
}

/* What lies in the picture; a region that ends before it starts is none. */
static struct block region_of(const lambert_scene *s, const struct lambert_render_options *o)
{
	const bool whole = !(o->left | o->top | o->right | o->bottom);
	const struct block r = { o->left, o->top, whole ? s->width : smaller(o->right, s->width),
		whole ? s->height : smaller(o->bottom, s->height) };
	return r.left < r.right && r.top < r.bottom ? r : (struct block){ 0, 0, 0, 0 };
}

static struct exposure exposure_for(const lambert_scene *s, const struct lambert_render_options *o)
{
	return (struct exposure){
		.sampling = sampling_of_method(o->antialias_method),
		.antialias = { o->antialias_threshold, o->antialias_depth, o->antialias_jitter,
			o->antialias_gamma },
		.region = region_of(s, o),
		.block_size = o->block_size,
		.threads = thread_count(o->threads),
		.progress = forward_progress,
		.user = (void *)(uintptr_t)o,
	};
}

/* A picture on its way. */
struct rendering {
	const lambert_scene *scene;
	const struct lambert_render_options *options;
	struct film *film;
	struct trace_stats stats;
	bool complete;
};

static void render(void *user)
{
	struct rendering *r = user;
	const struct exposure e = exposure_for(r->scene, r->options);
	r->film = film_create_part(r->scene->width, r->scene->height, e.region);
	r->complete = film_expose(r->film, r->scene->scene, &e, &r->stats);
}

static struct lambert_render_stats render_stats(
	const struct trace_stats *stats, double cpu, double wall)
{
	return (struct lambert_render_stats){
		.camera_rays = stats->camera_rays,
		.reflected_rays = stats->reflected_rays,
		.refracted_rays = stats->refracted_rays,
		.transmitted_rays = stats->transmitted_rays,
		.shadow_rays = stats->shadow_rays,
		.max_level = stats->max_level,
		.trace_cpu = cpu,
		.trace_wall = wall,
	};
}

/* The caller's stack may be small: no ray is followed on it. */
lambert_image *lambert_render(const lambert_scene *s, const struct lambert_render_options *o)
{
	const double cpu = cpu_seconds(), wall = wall_seconds();
	struct rendering r = { .scene = s, .options = o };
	parallel_with_stack(PARALLEL_STACK, render, NULL, &r);
	if (o->stats)
		*o->stats = render_stats(&r.stats, cpu_seconds() - cpu, wall_seconds() - wall);
	if (!r.complete) {
		film_destroy(r.film);
		return NULL;
	}
	lambert_image *image = memory_alloc(1, sizeof *image);
	*image = (lambert_image){ r.film, s->scene->settings.working,
		s->scene->settings.output_alpha };
	return image;
}
