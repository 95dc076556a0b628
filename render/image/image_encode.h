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

/* Codes 0 … 2^bits - 1, row-major, channels interleaved: bytes for up to 8 bits, else uint16_t.
 * `codes` holds width * height * encode_channels() of them. */
void encode_codes(const struct film *, const struct image_encoding *, void *codes);

/* Linear light for formats that store numbers; premultiplied, without clipping or dithering. */
void encode_linear(const struct film *, const struct image_encoding *, float *samples);

/* One number of the working space as a file stores it, before quantisation, and back. */
float encode_value(const struct image_encoding *, float value);
float encode_inverse(const struct image_encoding *, float encoded);

#endif
