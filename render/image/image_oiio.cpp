/* SPDX-License-Identifier: MIT */
/*
 * The module for pictures other than PNG: OpenImageIO behind the C interface of
 * image_format.h. It is the only C++ here, and a program meets it only when such
 * a picture is read or written, because starting OpenImageIO costs more than
 * many a scene. No exception leaves it.
 */
#include "image/image_format.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <vector>

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

namespace
{

/* As for PNG: no scene needs more, and damaged headers ask for it. */
const size_t SAMPLES_MAX = size_t(1) << 31;

bool fail(char *reason, const std::string &text)
{
	std::snprintf(reason, REASON_SIZE, "%s", text.c_str());
	return false;
}

TypeDesc sample_type(const raster &r)
{
	return r.sample_bits == 8    ? TypeDesc::UINT8
	       : r.sample_bits == 16 ? TypeDesc::UINT16
				     : TypeDesc::FLOAT;
}

ImageSpec describe(const raster &r, const std::string &format, const char *compression)
{
	const TypeDesc stored = format == "openexr" ? TypeDesc(TypeDesc::HALF) : sample_type(r);
	ImageSpec spec(int(r.width), int(r.height), int(r.channels), stored);
	if (r.channels == 2)
		spec.channelnames = { "Y", "A" };
	spec.alpha_channel = r.channels == 2 ? 1 : r.channels == 4 ? 3 : -1;
	if (*compression)
		spec.attribute("compression", compression);
	/* Otherwise the time of day gets into some files. */
	spec.attribute("DateTime", "");
	if (!r.is_premultiplied)
		spec.attribute("oiio:UnassociatedAlpha", 1);
	if (r.sample_bits != 32)
		spec.attribute("oiio:ColorSpace", r.is_srgb ? "sRGB" : "GammaCorrected");
	if (r.sample_bits != 32 && !r.is_srgb)
		spec.attribute("oiio:Gamma", r.gamma);
	if (format == "jpeg") {
		spec.attribute("CompressionQuality", r.quality);
		spec.attribute("jpeg:subsampling", "4:4:4");
	}
	return spec;
}

/* A multiple of the rows that formats compress together. */
const unsigned ROWS = 64;

bool write_rows(ImageOutput &out, const raster &r)
{
	std::vector<unsigned char> rows(r.row_bytes * std::min(ROWS, r.height));
	for (unsigned y = 0; y < r.height; y += ROWS) {
		const unsigned end = std::min(y + ROWS, r.height);
		for (unsigned i = y; i < end; i++)
			if (!r.row(r.source, i, &rows[(i - y) * r.row_bytes]))
				return false;
		if (!out.write_scanlines(int(y), int(end), 0, sample_type(r), rows.data()))
			return false;
	}
	return true;
}

bool write_picture(const char *path, const char *format, const char *compression, const raster *r,
	char *reason)
{
	try {
		auto out = ImageOutput::create(format);
		if (!out)
			return fail(reason, std::string("OpenImageIO cannot write ") + format);
		if (!out->open(path, describe(*r, format, compression)))
			return fail(reason, out->geterror());
		if (!write_rows(*out, *r) || !out->close())
			return fail(reason, out->geterror());
		return true;
	} catch (const std::exception &e) {
		return fail(reason, e.what());
	}
}

int bits_of(const ImageSpec &spec)
{
	return spec.format.basetype == TypeDesc::UINT8 || spec.format.basetype == TypeDesc::INT8 ? 8
	       : spec.format.basetype == TypeDesc::UINT16 || spec.format.basetype == TypeDesc::INT16
		       ? 16
		       : 32;
}

bool read_picture(const char *path, module_picture *picture, char *reason)
{
	try {
		ImageSpec config;
		config.attribute("oiio:UnassociatedAlpha", 1);
		auto in = ImageInput::open(path, &config);
		if (!in)
			return fail(reason, OIIO::geterror());
		const ImageSpec &spec = in->spec();
		if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 ||
			size_t(spec.width) * size_t(spec.height) > SAMPLES_MAX / 4)
			return fail(reason, "the size of the picture makes no sense");
		const int channels = spec.nchannels < 4 ? spec.nchannels : 4;
		const size_t count = size_t(spec.width) * size_t(spec.height) * size_t(channels);
		picture->samples = static_cast<float *>(std::malloc(count * sizeof(float)));
		if (!picture->samples)
			return fail(reason, "there is not enough memory for the picture");
		picture->width = unsigned(spec.width);
		picture->height = unsigned(spec.height);
		picture->channels = unsigned(channels);
		picture->bits = bits_of(spec);
		/* OpenImageIO leaves the alpha of a BMP as it is, and does not say so. */
		picture->is_premultiplied = spec.alpha_channel >= 0 &&
					    std::strcmp(in->format_name(), "bmp") != 0 &&
					    !spec.get_int_attribute("oiio:UnassociatedAlpha", 0);
		picture->is_srgb = spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
		picture->gamma = spec.get_float_attribute("oiio:Gamma", 0);
		picture->is_greymap = channels == 1 && std::strcmp(in->format_name(), "pnm") == 0;
		const bool ok =
			in->read_image(0, 0, 0, channels, TypeDesc::FLOAT, picture->samples);
		if (!ok) {
			std::free(picture->samples);
			picture->samples = nullptr;
			return fail(reason, in->geterror());
		}
		return true;
	} catch (const std::exception &e) {
		std::free(picture->samples);
		picture->samples = nullptr;
		return fail(reason, e.what());
	}
}

void release_picture(module_picture *picture)
{
	std::free(picture->samples);
	picture->samples = nullptr;
}

} // namespace

extern "C" __attribute__((visibility("default"))) const image_module lambert_image_module = {
	write_picture,
	read_picture,
	release_picture,
};
