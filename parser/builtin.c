/* SPDX-License-Identifier: MIT */
/*
 * The float and vector functions of ordinary expressions, evaluated at once.
 * What needs geometry or patterns is asked of the renderer through the hooks.
 */
#include "build.h"

#include "base/elementary.h"
#include "base/transform.h"
#include "base/vec3.h"
#include "grammar.tab.h"

#include <math.h>
#include <string.h>

/* -- Numbers of arguments ----------------------------------------------------------------- */

bool arguments_fit(
	struct parser *p, const char *name, size_t found, size_t least, size_t most, span where)
{
	if (found >= least && found <= most)
		return true;
	const size_t wanted = found < least ? least : most;
	parser_error(p, where, "%s needs %zu argument%s, found %zu", name, wanted,
		wanted == 1 ? "" : "s", found);
	if (found < least)
		note_sign(p, where);
	return false;
}

bool builtin_fits(struct parser *p, enum keyword word, size_t found, span where)
{
	size_t least = 1, most = 1;
	switch (word) {
	case K_ATAN2:
	case K_DIV:
	case K_MOD:
	case K_POW:
	case K_VCROSS:
	case K_VDOT:
	case K_VROTATE:
		least = most = 2;
		break;
	case K_VAXIS_ROTATE:
		least = most = 3;
		break;
	case K_VTURBULENCE:
		least = most = 4;
		break;
	case K_SELECT:
		least = 3;
		most = 4;
		break;
	case K_BITWISE_AND:
	case K_BITWISE_OR:
	case K_BITWISE_XOR:
	case K_MAX:
	case K_MIN:
		most = SIZE_MAX;
		break;
	default:
		break;
	}
	return arguments_fit(p, keyword_name(word), found, least, most, where);
}

/* -- Random streams ----------------------------------------------------------------------- */

static double seed(struct parser *p, double value)
{
	if ((p->seed_count & (p->seed_count - 1)) == 0)
		p->seeds = memory_grow(
			p->seeds, p->seed_count ? 2 * p->seed_count : 1, sizeof *p->seeds);
	p->seeds[p->seed_count] = (uint32_t)number_truncate(value);
	return (double)p->seed_count++;
}

static double next_random(struct parser *p, double stream, span where)
{
	const int i = number_truncate(stream);
	if (i < 0 || (size_t)i >= p->seed_count) {
		parser_error(
			p, where, "there is no random stream %d: rand needs a result of seed", i);
		return 0;
	}
	p->seeds[i] = 1812433253u * p->seeds[i] + 12345u;
	return p->seeds[i] / 4294967295.0;
}

/* -- One float ---------------------------------------------------------------------------- */

static double clamp_unit(struct parser *p, enum keyword word, double a, span where)
{
	if (a >= -1 && a <= 1)
		return a;
	parser_warning(p, where, "%s of a value outside -1 to 1", keyword_name(word));
	return a > 1 ? 1 : a < -1 ? -1 : a;
}

static double positive(struct parser *p, enum keyword word, bool ok, double a, span where)
{
	if (!ok)
		parser_error(p, where, "%s of %g is not defined", keyword_name(word), a);
	return ok ? a : 1;
}

struct number builtin_float(struct parser *p, enum keyword word, struct number n, span where)
{
	const double a = number_to_float(p, n, where);
	double r = 0;
	/* clang-format off */
	switch (word) {
	case K_ABS:     r = fabs(a); break;
	case K_ACOS:    r = elementary_acos(clamp_unit(p, word, a, where)); break;
	case K_ASIN:    r = elementary_asin(clamp_unit(p, word, a, where)); break;
	case K_ATAN:    r = elementary_atan(a); break;
	case K_ACOSH:   r = elementary_acosh(a); break;
	case K_ASINH:   r = elementary_asinh(a); break;
	case K_ATANH:   r = elementary_atanh(a); break;
	case K_CEIL:    r = ceil(a); break;
	case K_FLOOR:   r = floor(a); break;
	case K_COS:     r = elementary_cos(a); break;
	case K_SIN:     r = elementary_sin(a); break;
	case K_TAN:     r = elementary_tan(a); break;
	case K_COSH:    r = elementary_cosh(a); break;
	case K_SINH:    r = elementary_sinh(a); break;
	case K_TANH:    r = elementary_tanh(a); break;
	case K_EXP:     r = elementary_exp(a); break;
	case K_LN:      r = elementary_log(positive(p, word, !(a <= 0), a, where)); break;
	case K_LOG:     r = elementary_log10(positive(p, word, !(a <= 0), a, where)); break;
	case K_SQRT:    r = sqrt(positive(p, word, !(a < 0), a, where)); break;
	case K_INT:     r = number_truncate(a); break;
	case K_DEGREES: r = a / (M_PI / 180); break;
	case K_RADIANS: r = a * (M_PI / 180); break;
	case K_SEED:    r = seed(p, a); break;
	case K_RAND:    r = next_random(p, a, where); break;
	default: break;
	}
	/* clang-format on */
	return number_float(r);
}

/* -- Several arguments -------------------------------------------------------------------- */

/* The arguments of the call being evaluated. */
struct call {
	struct parser *p;
	enum keyword word;
	const struct arg *args;
	size_t count;
	span where;
};

static double arg_float(const struct call *c, size_t i)
{
	return number_to_float(c->p, c->args[i].number, c->args[i].span);
}

static vec3 arg_vector(const struct call *c, size_t i)
{
	double v[5];
	number_to_vector(c->p, c->args[i].number, 3, c->args[i].span, v);
	return (vec3){ v[0], v[1], v[2] };
}

static struct number from_vector(vec3 v)
{
	return number_vector(v.x, v.y, v.z);
}

static double two_floats(const struct call *c)
{
	const double a = arg_float(c, 0), b = arg_float(c, 1);
	switch (c->word) {
	case K_ATAN2:
		if (fabs(a) <= EPSILON && fabs(b) <= EPSILON)
			parser_error(c->p, c->where, "atan2(0, 0) is not defined");
		return elementary_atan2(a, b);
	case K_POW:
		if (a == 0 && b == 0)
			parser_error(c->p, c->where, "pow(0, 0) is not defined");
		return elementary_pow(a, b);
	case K_DIV:
		return number_truncate(a / b);
	default:
		return fmod(a, b);
	}
}

static double fold(const struct call *c)
{
	double r = arg_float(c, 0);
	for (size_t i = 1; i < c->count; i++) {
		const double b = arg_float(c, i);
		if (c->word == K_MAX)
			r = r < b ? b : r;
		else
			r = b < r ? b : r;
	}
	return r;
}

static double fold_bits(const struct call *c)
{
	int r = number_truncate(arg_float(c, 0));
	for (size_t i = 1; i < c->count; i++) {
		const int b = number_truncate(arg_float(c, i));
		r = c->word == K_BITWISE_AND ? r & b : c->word == K_BITWISE_OR ? r | b : r ^ b;
	}
	return r;
}

static double choose(const struct call *c)
{
	const double a = arg_float(c, 0), n = arg_float(c, 1);
	const double z = arg_float(c, 2), last = arg_float(c, c->count - 1);
	return a < 0 ? n : c->count == 4 && a == 0 ? z : last;
}

static struct number normalize(const struct call *c)
{
	const vec3 v = arg_vector(c, 0);
	if (v.x == 0 && v.y == 0 && v.z == 0) {
		if (c->p->state->version >= 350)
			parser_warning(c->p, c->where, "vnormalize of a zero vector");
		return number_vector(0, 0, 0);
	}
	return from_vector(vec_scale(v, 1 / sqrt(vec_dot(v, v))));
}

static struct number turbulence(const struct call *c)
{
	const struct render_hooks *hooks = &c->p->options->hooks;
	const vec3 at = arg_vector(c, 3);
	const double point[3] = { at.x, at.y, at.z };
	int octaves = number_truncate(arg_float(c, 2));
	octaves = octaves < 1 ? 1 : octaves > 10 ? 10 : octaves;
	double r[3] = { 0 };
	if (!hooks->turbulence || !hooks->turbulence(hooks->user, arg_float(c, 0), arg_float(c, 1),
					  octaves, point, r))
		parser_error(c->p, c->where, "not supported yet: vturbulence");
	return number_vector(r[0], r[1], r[2]);
}

static vec3 rotate_about(vec3 v, vec3 axis, double degrees)
{
	const vec3 k = vec_scale(axis, 1 / sqrt(vec_dot(axis, axis)));
	const double a = degrees * (M_PI / 180), c = elementary_cos(a), s = elementary_sin(a),
		     d = 1 - c;
	return (vec3){
		v.x * (k.x * k.x + c * (1 - k.x * k.x)) + v.y * (k.x * k.y * d - k.z * s) +
			v.z * (k.x * k.z * d + k.y * s),
		v.x * (k.x * k.y * d + k.z * s) + v.y * (k.y * k.y + c * (1 - k.y * k.y)) +
			v.z * (k.y * k.z * d - k.x * s),
		v.x * (k.x * k.z * d - k.y * s) + v.y * (k.y * k.z * d + k.x * s) +
			v.z * (k.z * k.z + c * (1 - k.z * k.z)),
	};
}

/* Through the matrix, as objects are turned: the results agree to the last bit. */
static vec3 rotate(vec3 v, vec3 degrees)
{
	const transform turn = transform_rotate(degrees);
	return transform_point(&turn, v);
}

static struct number evaluate(const struct call *c)
{
	switch (c->word) {
	case K_MAX:
	case K_MIN:
		return number_float(fold(c));
	case K_BITWISE_AND:
	case K_BITWISE_OR:
	case K_BITWISE_XOR:
		return number_float(fold_bits(c));
	case K_SELECT:
		return number_float(choose(c));
	case K_VLENGTH:
		return number_float(sqrt(vec_dot(arg_vector(c, 0), arg_vector(c, 0))));
	case K_VDOT:
		return number_float(vec_dot(arg_vector(c, 0), arg_vector(c, 1)));
	case K_VCROSS:
		return from_vector(vec_cross(arg_vector(c, 0), arg_vector(c, 1)));
	case K_VNORMALIZE:
		return normalize(c);
	case K_VROTATE:
		return from_vector(rotate(arg_vector(c, 0), arg_vector(c, 1)));
	case K_VAXIS_ROTATE:
		return from_vector(
			rotate_about(arg_vector(c, 0), arg_vector(c, 1), arg_float(c, 2)));
	case K_VTURBULENCE:
		return turbulence(c);
	default:
		return number_float(two_floats(c));
	}
}

struct number builtin_list(struct parser *p, enum keyword word, size_t start, span where)
{
	struct grammar *g = p->grammar;
	const struct call c = { p, word, g->args + start, g->arg_count - start, where };
	struct number result = number_float(0);
	if (builtin_fits(p, word, c.count, where))
		result = evaluate(&c);
	g->arg_count = start;
	return result;
}

/* -- Geometry, through the hooks ---------------------------------------------------------- */

/* The renderer could not answer. If it has said why there is nothing to add. */
static void report_unanswered(struct parser *p, span where, const char *what)
{
	if (diag_errors(p->diag))
		p->failed = true;
	else
		parser_error(p, where, "not supported yet: %s", what);
}

struct number builtin_extent(
	struct parser *p, enum keyword word, struct reference object, span where)
{
	const struct render_hooks *hooks = &p->options->hooks;
	double lo[3] = { 0 }, hi[3] = { 0 };
	if (object.node->keyword == K_PIGMENT) {
		if (word == K_MIN_EXTENT)
			parser_error(p, where, "min_extent needs an object");
		else
			report_unanswered(p, where, "max_extent of this pigment");
		return number_vector(hi[0], hi[1], hi[2]);
	}
	if (!hooks->extent || !hooks->extent(hooks->user, object.node, lo, hi))
		report_unanswered(p, where,
			word == K_MIN_EXTENT ? "min_extent of this object"
					     : "max_extent of this object");
	const double *r = word == K_MIN_EXTENT ? lo : hi;
	return number_vector(r[0], r[1], r[2]);
}

struct number builtin_inside(
	struct parser *p, struct reference object, struct number at, span where)
{
	const struct render_hooks *hooks = &p->options->hooks;
	double point[5];
	bool answer = false;
	number_to_vector(p, at, 3, where, point);
	if (!hooks->inside || !hooks->inside(hooks->user, object.node, point, &answer))
		report_unanswered(p, where, "inside() of this object");
	return number_float(answer);
}

struct number builtin_trace(struct parser *p, struct reference object, struct number origin,
	struct number direction, struct symbol *normal_symbol, span where)
{
	const struct render_hooks *hooks = &p->options->hooks;
	double from[5], to[5], point[3] = { 0 }, normal[3] = { 0 };
	bool found = false;
	number_to_vector(p, origin, 3, where, from);
	number_to_vector(p, direction, 3, where, to);
	const struct value *before = normal_symbol ? symbol_value(normal_symbol) : NULL;
	if (before && before->kind == VALUE_NUMBER && before->number.terms != 3)
		parser_error(p, where,
			"trace puts the normal into a vector of 3 components, '%s' "
			"has %d",
			normal_symbol->text, before->number.terms);
	if (!hooks->trace ||
		!hooks->trace(hooks->user, object.node, from, to, point, normal, &found))
		report_unanswered(p, where, "trace() of this object");
	if (normal_symbol) {
		const struct value value = { .kind = VALUE_NUMBER,
			.number = found ? number_vector(normal[0], normal[1], normal[2])
					: number_vector(0, 0, 0) };
		symbol_assign(p, normal_symbol, &value);
	}
	return found ? number_vector(point[0], point[1], point[2]) : number_vector(0, 0, 0);
}

/* -- Arrays and files --------------------------------------------------------------------- */

struct number builtin_dimensions(struct parser *p, const struct symbol *symbol, span where)
{
	const struct value *value = symbol_value(symbol);
	if (value->kind == VALUE_ARRAY)
		return number_float(value->array->dimensions);
	parser_error(p, where, "dimensions needs an array");
	return number_float(0);
}

struct number builtin_dimension_size(
	struct parser *p, const struct symbol *symbol, double which, span where)
{
	const struct value *value = symbol_value(symbol);
	const int k = number_truncate(which);
	if (value->kind != VALUE_ARRAY)
		parser_error(p, where, "dimension_size needs an array");
	else if (k >= 1 && k <= (int)value->array->dimensions)
		return number_float((double)value->array->size[k - 1]);
	return number_float(0);
}

struct number builtin_file_exists(struct parser *p, const char *name, span where)
{
	static const char *const extensions[] = { "", NULL };
	bool courtesy = false;
	const char *path = file_find(p->options, name, extensions, &courtesy, p->arena);
	const char *refusal = path ? file_may_read(p->options, path, p->arena) : NULL;
	if (refusal)
		parser_error(p, where, "%s", refusal);
	return number_float(path != NULL);
}

/* -- User-defined functions --------------------------------------------------------------- */

static bool call(struct parser *p, const struct function *f, const struct arg *args,
	double result[5], unsigned *terms)
{
	const struct render_hooks *hooks = &p->options->hooks;
	double arguments[FUNCTION_PARAMETERS_MAX];
	for (unsigned i = 0; i < f->parameter_count; i++)
		arguments[i] = number_to_float(p, args[i].number, args[i].span);
	if (p->failed || (p->trial && p->refused))
		return true; /* a faulty argument, which is what there is to say */
	if (!hooks->call || !hooks->call(hooks->user, f, arguments, result, terms))
		return false;
	if (!pointer_map_find(&p->called, f))
		pointer_map_add(&p->called, f, p);
	return true;
}

struct number builtin_call(struct parser *p, struct callee callee, size_t start, span where)
{
	const struct function *f = callee.function;
	struct grammar *g = p->grammar;
	double result[5] = { 0 };
	unsigned terms = 1;
	if (arguments_fit(p, callee.name, g->arg_count - start, f->parameter_count,
		    f->parameter_count, where) &&
		!call(p, f, g->args + start, result, &terms))
		report_unanswered(p, where, "calling this function while the scene is read");
	g->arg_count = start;
	struct number out = { .terms = (uint8_t)terms };
	memcpy(out.v, result, sizeof out.v);
	return out;
}
