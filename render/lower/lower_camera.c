/* SPDX-License-Identifier: MIT */
/*
 * camera { … }: since language version 3.5 the items are collected and applied
 * in a fixed order; before, each acts at once, in the order written.
 */
#include "lower/draft.h"

#include "base/elementary.h"
#include "base/epsilon.h"

#define RADIANS_PER_DEGREE 0.017453292519943296

struct camera_items {
	const struct camera_class *kind;
	vec3 location, right, up, direction, sky, look_at;
	bool has_right, has_up, has_angle, has_look_at;
	double angle;
	transform place;
	bool is_unsupported; /* of a type that is refused, which may see further */
};

static const struct camera_items camera_defaults = {
	.right = { 1.33, 0, 0 },
	.up = { 0, 1, 0 },
	.direction = { 0, 0, 1 },
	.sky = { 0, 1, 0 },
	.look_at = { 0, 0, 1 },
	.place = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } },
		{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } } },
};

static void apply_angle(struct camera_items *c)
{
	if (c->angle <= 0)
		return;
	const double length =
		vec_length(c->right) / (2 * elementary_tan(c->angle * RADIANS_PER_DEGREE / 2));
	c->direction = vec_scale(vec_normalize(c->direction), length);
}

/* Turns the camera to look_at; the lengths of the vectors stay. */
static void apply_look_at(struct lowering *l, const struct node *n, struct camera_items *c)
{
	const double right_length = vec_length(c->right);
	const double handed = vec_dot(vec_cross(c->up, c->direction), c->right);
	const double direction_length = vec_length(c->direction), up_length = vec_length(c->up);
	const vec3 sight = vec_sub(c->look_at, c->location);
	if (vec_length2(sight) < EPSILON) {
		diag_error(l->diag, n->span, "camera: look_at is the same point as location");
		return;
	}
	const vec3 d = vec_normalize(sight);
	vec3 r = vec_cross(c->sky, d);
	if (fabs(r.x) < EPSILON && fabs(r.y) < EPSILON && fabs(r.z) < EPSILON) {
		diag_warning(l->diag, n->span, "camera looks along its sky vector");
		r = c->right;
	}
	r = vec_normalize(r);
	c->direction = vec_scale(d, direction_length);
	c->up = vec_scale(vec_cross(d, r), up_length);
	c->right = vec_scale(r, handed > 0 ? right_length : -right_length);
}

/* An orthographic view shows at look_at what the perspective one would. */
static void apply_orthographic(struct camera_items *c)
{
	const double near = vec_length(c->direction);
	const double far = vec_length(vec_sub(c->look_at, c->location));
	if (near > EPSILON && far > EPSILON) {
		c->right = vec_scale(c->right, far / near);
		c->up = vec_scale(c->up, far / near);
	}
}

static void read_angle(struct lowering *l, const struct node *n, struct camera_items *c)
{
	if (!n->arg_count)
		return;
	c->angle = lower_float(l, n, 0, "an angle");
	c->has_angle = true;
	if (c->angle < 0)
		diag_error(l->diag, n->span, "camera: the angle is negative");
	else if (c->angle >= 180 && !c->is_unsupported)
		diag_error(l->diag, n->span, "camera: the angle must be below 180 degrees");
}

/* Takes one item; false: it is not one that every camera has. */
static bool read_item(struct lowering *l, const struct node *item, struct camera_items *c)
{
	const struct camera_class *kind = camera_find(keyword_name(item->keyword));
	if (kind) {
		c->kind = kind;
		return true;
	}
	switch (item->keyword) {
	case K_LOCATION:
		c->location = lower_vector(l, item, 0, "a point");
		return true;
	case K_RIGHT:
		c->right = lower_vector(l, item, 0, "a vector");
		c->has_right = true;
		return true;
	case K_UP:
		c->up = lower_vector(l, item, 0, "a vector");
		c->has_up = true;
		return true;
	case K_DIRECTION:
		c->direction = lower_vector(l, item, 0, "a vector");
		return true;
	case K_SKY:
		c->sky = lower_vector(l, item, 0, "a vector");
		return true;
	case K_LOOK_AT:
		c->look_at = lower_vector(l, item, 0, "a point");
		c->has_look_at = true;
		return true;
	case K_ANGLE:
		read_angle(l, item, c);
		return true;
	default:
		return false;
	}
}

static void compose(struct camera_items *c, const transform *t)
{
	c->place = transform_compose(&c->place, t);
}

/* Focal blur is off while aperture or blur_samples is 0. */
static void check_blur(struct lowering *l, const struct node *camera)
{
	const struct node *aperture = node_child(camera, K_APERTURE);
	const struct node *samples = node_child(camera, K_BLUR_SAMPLES);
	if (aperture && samples && lower_float(l, aperture, 0, "a size") != 0)
		lower_unsupported(l, aperture, "focal blur (aperture)");
}

static void other_item(struct lowering *l, const struct node *item, struct camera_items *c)
{
	if (node_is_transform(item)) {
		const transform t = lower_transform(l, item);
		compose(c, &t);
		return;
	}
	switch (item->keyword) {
	case K_APERTURE:
	case K_BLUR_SAMPLES:
	case K_FOCAL_POINT:
	case K_CONFIDENCE:
	case K_VARIANCE:
	case K_BOKEH:
		return; /* see check_blur */
	default:
		c->is_unsupported = true;
		lower_unsupported(l, item, keyword_name(item->keyword));
	}
}

static void read_items(struct lowering *l, const struct node *n, struct camera_items *c);

static void read_in_fixed_order(struct lowering *l, const struct node *n, struct camera_items *c)
{
	for (const struct node *item = n->children; item; item = item->next) {
		if (item->keyword == K_REFERENCE && !node_is_transform(item))
			read_items(l, node_resolve(item), c);
		else if (!read_item(l, item, c))
			other_item(l, item, c);
	}
	if (c->has_angle)
		apply_angle(c);
	if (c->has_look_at)
		apply_look_at(l, n, c);
	if (c->kind->is_parallel && (c->has_angle || (!c->has_right && !c->has_up)))
		apply_orthographic(c);
	/* Done: a reference to this camera only adds transformations. */
	c->has_angle = c->has_look_at = false;
	c->has_right = c->has_up = true;
}

static void transform_now(struct camera_items *c, const transform *t)
{
	c->location = transform_point(t, c->location);
	c->direction = transform_direction(t, c->direction);
	c->up = transform_direction(t, c->up);
	c->right = transform_direction(t, c->right);
}

static void read_in_written_order(struct lowering *l, const struct node *n, struct camera_items *c)
{
	for (const struct node *item = n->children; item; item = item->next) {
		if (item->keyword == K_REFERENCE && !node_is_transform(item)) {
			read_items(l, node_resolve(item), c);
		} else if (node_is_transform(item)) {
			const transform t = lower_transform(l, item);
			transform_now(c, &t);
		} else if (read_item(l, item, c)) {
			if (item->keyword == K_ANGLE && !c->kind->is_parallel)
				apply_angle(c);
			else if (item->keyword == K_LOOK_AT)
				apply_look_at(l, item, c);
			else if (item->keyword == K_ORTHOGRAPHIC)
				apply_orthographic(c);
		} else {
			other_item(l, item, c);
		}
	}
}

static void read_items(struct lowering *l, const struct node *n, struct camera_items *c)
{
	check_blur(l, n);
	if (n->state->version >= 350)
		read_in_fixed_order(l, n, c);
	else
		read_in_written_order(l, n, c);
}

static void read_defaults(struct lowering *l, const struct defaults *d, struct camera_items *c)
{
	for (; d; d = d->previous) {
		if (d->node->keyword == K_CAMERA) {
			read_defaults(l, d->previous, c);
			read_items(l, d->node, c);
			c->has_right = c->has_up = c->has_angle = c->has_look_at = false;
			return;
		}
	}
}

static bool is_usable(vec3 v)
{
	return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool are_perpendicular(vec3 a, vec3 b)
{
	return fabs(vec_dot(a, b)) <= EPSILON * vec_length(a) * vec_length(b);
}

static void place_camera(struct lowering *l, const struct node *n, const struct camera_items *items)
{
	struct camera_items c = *items;
	transform_now(&c, &items->place);
	if (n && !(is_usable(c.location) && is_usable(c.direction) && is_usable(c.right) &&
			 is_usable(c.up)))
		diag_error(l->diag, n->span, "camera: a vector is not a number or infinite");
	else if (n && !(are_perpendicular(c.right, c.up) && are_perpendicular(c.up, c.direction) &&
			      are_perpendicular(c.direction, c.right)))
		diag_warning(l->diag, n->span,
			"camera: right, up and direction are not perpendicular: the picture is "
			"sheared; look_at would turn all of them");
	l->scene->camera = (struct camera){ .kind = c.kind,
		.location = c.location,
		.right = c.right,
		.up = c.up,
		.direction = c.direction };
}

void lower_camera(struct lowering *l, const struct node *n)
{
	struct camera_items c = camera_defaults;
	c.kind = camera_find("perspective");
	read_defaults(l, n->state->defaults, &c);
	read_items(l, n, &c);
	place_camera(l, n, &c);
}

static bool has_camera(const struct defaults *d)
{
	while (d && d->node->keyword != K_CAMERA)
		d = d->previous;
	return d != NULL;
}

/* Of a scene without a camera. */
void lower_default_camera(struct lowering *l, const struct defaults *defaults)
{
	if (!has_camera(defaults) && l->scene->object_count && !diag_errors(l->diag))
		diag_warning(l->diag, NO_SPAN,
			"the scene has no camera: it is seen from the origin, towards z");
	struct camera_items c = camera_defaults;
	c.kind = camera_find("perspective");
	read_defaults(l, defaults, &c);
	place_camera(l, NULL, &c);
}
