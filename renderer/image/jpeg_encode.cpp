#include <cstdio>
// jpeglib.h needs size_t and FILE from <cstdio>.
#include <jpeglib.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdlib>
#include <string>

#include "image/effort.h"
#include "image/encoders.h"

namespace telar::image {
namespace {

constexpr int FULL_CHROMA_QUALITY = 90;  // below, half-resolution chroma; saturated cloth bleeds over its edge there

struct JpegContext {
  jpeg_error_mgr errors;
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX] = {};
};

[[noreturn]] void onError(j_common_ptr jpeg) {
  auto* context = static_cast<JpegContext*>(jpeg->client_data);
  jpeg->err->format_message(jpeg, context->message);
  std::longjmp(context->jump, 1);
}

void onOutput(j_common_ptr) {}

/// Owns the libjpeg struct and the file that grows; step() runs C calls so that an error comes out as telar::Error.
class JpegWriter {
 public:
  JpegWriter() {
    jpeg_.err = jpeg_std_error(&context_.errors);
    jpeg_.client_data = &context_;
    context_.errors.error_exit = onError;
    context_.errors.output_message = onOutput;
  }
  ~JpegWriter() {
    jpeg_destroy_compress(&jpeg_);
    std::free(file_);
  }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;

  /// `calls` must own nothing: longjmp runs no destructors.
  template <class Calls>
  void step(const Calls& calls) {
    if (setjmp(context_.jump))
      throw Error("X_OUTPUT", std::string("writing the JPEG image failed: ") + context_.message);
    calls(jpeg_);
  }

  void open() {
    step([this](jpeg_compress_struct& jpeg) {
      jpeg_create_compress(&jpeg);
      jpeg_mem_dest(&jpeg, &file_, &size_);
    });
  }

  std::vector<std::byte> file() const {
    const auto* begin = reinterpret_cast<const std::byte*>(file_);
    return {begin, begin + size_};
  }

 private:
  JpegContext context_ = {};
  jpeg_compress_struct jpeg_ = {};
  unsigned char* file_ = nullptr;
  unsigned long size_ = 0;
};

void configure(jpeg_compress_struct& jpeg, const Frame& frame, const OutputOptions& options) {
  jpeg.image_width = frame.width;
  jpeg.image_height = frame.height;
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_EXT_RGBX;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, options.quality, TRUE);
  jpeg.dct_method = JDCT_ISLOW;
  jpeg.optimize_coding = levelsOf(options.effort).ownHuffman ? TRUE : FALSE;
  if (options.quality >= FULL_CHROMA_QUALITY) jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;
  if (levelsOf(options.effort).progressive) jpeg_simple_progression(&jpeg);
  if (options.ppi > 0) {
    jpeg.density_unit = 1;  // per inch
    jpeg.X_density = jpeg.Y_density = UINT16(std::lround(std::min(options.ppi, 65535.0)));
  }
}

/// @param pixels  straight RGBA
bool isOpaque(const JSAMPLE* pixels, std::size_t bytes) {
  for (std::size_t i = 3; i < bytes; i += 4) {
    if (pixels[i] != 255) return false;
  }
  return true;
}

/// @param pixels  straight RGBA, as many bytes as `row` has
void rowOverBlack(const JSAMPLE* pixels, std::vector<JSAMPLE>& row) {
  for (std::size_t i = 0; i < row.size(); i += 4) {
    const int alpha = pixels[i + 3];
    for (std::size_t k = 0; k < 3; ++k) row[i + k] = static_cast<JSAMPLE>((pixels[i + k] * alpha + 127) / 255);
    row[i + 3] = pixels[i + 3];
  }
}

}  // namespace

std::vector<std::byte> encodeJpeg(const Frame& frame, const OutputOptions& options, std::span<const std::byte> profile,
                                  const CancelToken& cancel) {
  JpegWriter writer;
  writer.open();
  writer.step([&](jpeg_compress_struct& jpeg) {
    configure(jpeg, frame, options);
    jpeg_start_compress(&jpeg, TRUE);
    if (!profile.empty()) jpeg_write_icc_profile(&jpeg, data(profile), unsigned(profile.size()));
  });
  const std::size_t rowBytes = std::size_t{frame.width} * 4;
  std::vector<JSAMPLE> row(rowBytes);
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    if (y % 64 == 0) cancel.check();
    const auto* pixels = reinterpret_cast<const JSAMPLE*>(frame.pixels.data() + y * rowBytes);
    const bool opaque = isOpaque(pixels, rowBytes);
    if (!opaque) rowOverBlack(pixels, row);
    writer.step([&](jpeg_compress_struct& jpeg) {
      JSAMPLE* first = opaque ? const_cast<JSAMPLE*>(pixels) : row.data();  // libjpeg only reads it
      jpeg_write_scanlines(&jpeg, &first, 1);
    });
  }
  writer.step([](jpeg_compress_struct& jpeg) { jpeg_finish_compress(&jpeg); });
  return writer.file();
}

}  // namespace telar::image
