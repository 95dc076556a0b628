/* SPDX-License-Identifier: MIT */
/*
 * From the numbers of the film to the codes of a file: transfer curves,
 * straight alpha, quantisation, dithering. All in single precision.
 */
#ifndef LAMBERT_IMAGE_IMAGE_ENCODE_H
#define LAMBERT_IMAGE_IMAGE_ENCODE_H

#include "image/image.h"

/* Samples per pixel of the encoded picture: 1 grey, 2 grey and alpha, 3, 4. */
unsigned encode_channels(const struct image_encoding *);

/* Encodes a film row by row: the pixels of the picture that the film does not keep are black. The film
 * outlives the encoder.
 *
 * Codes 0 … 2^bits - 1, channels interleaved: bytes for up to 8 bits, else uint16_t. Floats, for
 * formats that store numbers: linear light, premultiplied, without clipping or dithering. */
struct encoder;
struct encoder *encoder_create(const struct film *, const struct image_encoding *, bool is_float);
void encoder_destroy(struct encoder *);
/* Of an encoded row. */
size_t encoder_row_bytes(const struct encoder *);
/* Rows come in order from 0: dithering carries errors downwards. */
void encoder_row(struct encoder *, unsigned y, void *out);

/* One number of the working space as a file stores it, before quantisation, and back. */
float encode_value(const struct image_encoding *, float value);
float encode_inverse(const struct image_encoding *, float encoded);

#endif
