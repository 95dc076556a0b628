/* SPDX-License-Identifier: MIT */
/*
 * Meshes: faces and vertices go straight into arrays of numbers, without a
 * node each.
 */
#include "build.h"

#include <string.h>

/* -- Growing arrays ----------------------------------------------------------------------- */

enum {
	/* The count in the text is trusted for that many elements; more grow as they come. */
	TRUSTED_COUNT = 4000000
};

static double *grow(struct parser *p, const double *old, size_t count, size_t capacity)
{
	double *values = ARENA_ARRAY(p->tree, capacity, double);
	if (count)
		memcpy(values, old, count * sizeof *values);
	return values;
}

static void reserve(struct parser *p, struct doubles *d, size_t more)
{
	if (d->count + more <= d->capacity)
		return;
	size_t capacity = d->capacity ? 2 * d->capacity : 64;
	while (capacity < d->count + more)
		capacity *= 2;
	d->values = grow(p, d->values, d->count, capacity);
	if (d->extra)
		d->extra = grow(p, d->extra, d->count, capacity);
	d->capacity = capacity;
}

struct doubles *doubles_new(struct parser *p, double expected, unsigned stride)
{
	struct doubles *d = ARENA_NEW(p->tree, struct doubles);
	d->stride = stride;
	if (expected >= 1)
		reserve(p, d,
			stride * (expected < TRUSTED_COUNT ? (size_t)expected
							   : (size_t)TRUSTED_COUNT));
	return d;
}

void doubles_add(struct parser *p, struct doubles *d, struct number number, span where)
{
	double v[5];
	reserve(p, d, d->stride);
	if (number.terms == d->stride)
		memcpy(v, number.v, sizeof v);
	else
		number_to_vector(p, number, d->stride, where, v);
	memcpy(d->values + d->count, v, d->stride * sizeof *v);
	d->count += d->stride;
}

static void no_textures(struct doubles *d, size_t from)
{
	for (size_t i = from; i < d->count; i++)
		d->extra[i] = -1;
}

void doubles_face(struct parser *p, struct doubles *d, struct number number, span where)
{
	if (number.terms != 1) {
		doubles_add(p, d, number, where);
		if (d->extra)
			no_textures(d, d->count - 3);
		d->textures = 0;
		return;
	}
	if (!d->count || d->textures == 3) {
		parser_error(p, where, "a face needs three vertex indices <a, b, c>");
		return;
	}
	if (!d->extra) {
		d->extra = ARENA_ARRAY(p->tree, d->capacity, double);
		no_textures(d, 0);
	}
	d->extra[d->count - 3 + d->textures++] = number.v[0];
}

/* As many plain vectors as follow each other: the bulk of a large mesh. */
void doubles_add_rows(struct parser *p, struct doubles *d)
{
	for (;;) {
		reserve(p, d, d->stride);
		if (!expand_plain_row(p, d->stride, d->values + d->count))
			return;
		d->count += d->stride;
	}
}

void doubles_face_rows(struct parser *p, struct doubles *d)
{
	const size_t before = d->count;
	doubles_add_rows(p, d);
	if (d->count == before)
		return;
	if (d->extra)
		no_textures(d, before);
	d->textures = 0;
}

/* -- mesh --------------------------------------------------------------------------------- */

struct mesh_items *mesh_items_new(struct parser *p)
{
	return ARENA_NEW(p->tree, struct mesh_items);
}

/* Writes the vectors above `start` to `out`; false: their number is wrong. */
static bool take_face(
	struct parser *p, enum keyword keyword, span word, size_t start, double out[18])
{
	struct grammar *g = p->grammar;
	const size_t wanted = keyword == K_TRIANGLE ? 3 : 6, found = g->arg_count - start;
	const char *needs =
		keyword == K_TRIANGLE ? "three corners" : "three corners, each with its normal";
	for (size_t i = 0; i < found && i < wanted; i++) {
		double v[5];
		number_to_vector(p, g->args[start + i].number, 3, g->args[start + i].span, v);
		memcpy(out + 3 * i, v, 3 * sizeof *v);
	}
	g->arg_count = start;
	if (found != wanted)
		parser_error(p, word, "%s needs %s, found %zu vectors", keyword_name(keyword),
			needs, found);
	return found == wanted;
}

static size_t face_size(enum keyword keyword)
{
	return keyword == K_TRIANGLE ? 9 : 18;
}

struct node *mesh_face(struct parser *p, enum keyword keyword, span whole, span word, size_t start,
	struct node_list tail)
{
	double *values = ARENA_ARRAY(p->tree, 18, double);
	take_face(p, keyword, word, start, values);
	struct node *node = node_args(
		p, keyword, whole, word, args_push_array(p, values, face_size(keyword), 3, whole));
	node->children = tail.first;
	return node;
}

struct mesh_items *mesh_add(struct mesh_items *mesh, struct node *item)
{
	mesh->items = list_add(mesh->items, item);
	mesh->run_node = NULL;
	return mesh;
}

/* A face that goes on where the present run ends, or begins a new one. */
struct mesh_items *mesh_add_face(struct parser *p, struct mesh_items *mesh, enum keyword keyword,
	span word, span last, size_t start)
{
	double values[18];
	if (!take_face(p, keyword, word, start, values))
		return mesh;
	if (!mesh->run_node || mesh->run_node->keyword != keyword) {
		struct node *node = node_new(p, keyword, word, word);
		mesh_add(mesh, node);
		mesh->run_node = node;
		mesh->run_arg = ARENA_NEW(p->tree, struct arg);
		mesh->run_arg->kind = ARG_ARRAY;
		mesh->run_arg->array.stride = 3;
		mesh->run = (struct doubles){ .values = NULL };
		node->args = mesh->run_arg;
		node->arg_count = 1;
	}
	reserve(p, &mesh->run, face_size(keyword));
	memcpy(mesh->run.values + mesh->run.count, values, face_size(keyword) * sizeof *values);
	mesh->run.count += face_size(keyword);
	mesh->run_arg->array.values = mesh->run.values;
	mesh->run_arg->array.count = mesh->run.count;
	mesh->run_node->span = mesh->run_arg->span = span_join(mesh->run_node->span, last);
	return mesh;
}

/* -- mesh2 -------------------------------------------------------------------------------- */

struct node *mesh2_list(struct parser *p, enum keyword keyword, span whole, span word,
	double declared, span count_span, const struct doubles *d, unsigned stride)
{
	const size_t found = d->count / stride;
	if (!(declared >= 1))
		parser_error(p, count_span, "%s needs at least one entry", keyword_name(keyword));
	else if ((size_t)declared != found)
		parser_error(p, count_span, "%s says %g entries, but %zu follow",
			keyword_name(keyword), declared, found);
	const size_t start = args_push_number(p, number_float(declared), count_span);
	args_push_array(p, d->values, d->count, stride, whole);
	if (d->extra)
		args_push_array(p, d->extra, d->count, stride, whole);
	return node_args(p, keyword, whole, word, start);
}

struct node *mesh2_node(struct parser *p, struct node_list items, span whole, span word)
{
	struct node *node = node_block(p, K_MESH2, whole, word, items);
	if (!node_child(node, K_VERTEX_VECTORS))
		parser_error(p, word, "mesh2 needs vertex_vectors");
	else if (!node_child(node, K_FACE_INDICES))
		parser_error(p, word, "mesh2 needs face_indices");
	return node;
}
