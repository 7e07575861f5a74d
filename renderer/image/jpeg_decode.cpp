#include <cstdio>
// jpeglib.h needs size_t and FILE from <cstdio>.
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <new>
#include <utility>

#include "image/decoders.h"
#include "image/jpeg_layout.h"
#include "image/orientation.h"
#include "telar/reused_memory.h"

namespace telar::image {
namespace {

constexpr std::uint64_t PIXELS_PER_BYTE_MAX = 512;  // one DC bit for each 8 x 8 block of the largest component

/// State that libjpeg's callbacks share; lives outside every frame that longjmp leaves.
struct JpegContext {
  jpeg_error_mgr errors;
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX] = {};
  bool outOfMemory = false;
  const CancelToken* cancel = nullptr;
};

JpegContext* contextOf(j_common_ptr jpeg) { return static_cast<JpegContext*>(jpeg->client_data); }

[[noreturn]] void onError(j_common_ptr jpeg) {
  JpegContext* context = contextOf(jpeg);
  context->outOfMemory = jpeg->err->msg_code == JERR_OUT_OF_MEMORY;
  jpeg->err->format_message(jpeg, context->message);
  std::longjmp(context->jump, 1);
}

/// libjpeg goes on after damage and paints grey or garbage: here damage is an error. Oddities that leave every texel
/// defined by the file (bytes between segments, wrong JFIF or Adobe versions) are not.
void onMessage(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_ADOBE_XFORM:
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_JFIF_MAJOR:
    case JWRN_TOO_MUCH_DATA:
      return;
    default:
      onError(jpeg);
  }
}

void onOutput(j_common_ptr) {}

/// libjpeg calls this for every row of blocks, also while it collects the scans of a progressive file.
void onProgress(j_common_ptr jpeg) {
  JpegContext* context = contextOf(jpeg);
  if (context->cancel->isOver()) std::longjmp(context->jump, 1);
}

void onSourceStart(j_decompress_ptr) {}

boolean onSourceEmpty(j_decompress_ptr jpeg) {
  ERREXIT(jpeg, JERR_INPUT_EOF);
  return FALSE;
}

void onSourceSkip(j_decompress_ptr jpeg, long count) {
  if (count <= 0) return;
  if (std::size_t(count) > jpeg->src->bytes_in_buffer) ERREXIT(jpeg, JERR_INPUT_EOF);
  jpeg->src->next_input_byte += count;
  jpeg->src->bytes_in_buffer -= std::size_t(count);
}

/// Owns the libjpeg struct; step() runs C calls so that an error comes out as telar::Error.
class JpegReader {
 public:
  /// Delegates, so that the destructor runs when libjpeg fails in here.
  JpegReader(Bytes file, const CancelToken& cancel) : JpegReader() {
    size_ = file.size();
    context_.cancel = &cancel;
    context_.errors.error_exit = onError;
    context_.errors.emit_message = onMessage;
    context_.errors.output_message = onOutput;
    source_.next_input_byte = data(file);
    source_.bytes_in_buffer = file.size();
    source_.init_source = onSourceStart;
    source_.fill_input_buffer = onSourceEmpty;
    source_.skip_input_data = onSourceSkip;
    source_.resync_to_restart = jpeg_resync_to_restart;
    source_.term_source = onSourceStart;
    progress_.progress_monitor = onProgress;
    step([this](jpeg_decompress_struct& jpeg) {
      jpeg_create_decompress(&jpeg);
      jpeg.src = &source_;
      jpeg.progress = &progress_;
    });
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  /// `calls` must own nothing: longjmp runs no destructors.
  template <class Calls>
  void step(const Calls& calls) {
    if (setjmp(context_.jump)) fail();
    calls(jpeg_);
  }

 private:
  JpegReader() {
    jpeg_.err = jpeg_std_error(&context_.errors);
    jpeg_.client_data = &context_;
  }

  [[noreturn]] void fail() {
    context_.cancel->check();
    if (context_.outOfMemory) throw std::bad_alloc();
    throw corrupt("JPEG", context_.message).atOffset(size_ - source_.bytes_in_buffer);
  }

  std::size_t size_ = 0;
  JpegContext context_ = {};
  jpeg_source_mgr source_ = {};
  jpeg_progress_mgr progress_ = {};
  jpeg_decompress_struct jpeg_ = {};
};

/// Adobe writes CMYK inverted (0 = full ink), which is what every such file in use does; so R = C K / 255,
/// rounded down as Chromium does. In place.
void cmykToRgba(ZeroedBytes& pixels) {
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    for (std::size_t c = i; c < i + 3; ++c) pixels[c] = std::uint8_t(pixels[c] * pixels[i + 3] / 255);
    pixels[i + 3] = 255;
  }
}

/// Coding processes that browsers decode: Huffman, 8 bit, baseline / extended / progressive.
void checkSupported(const JpegLayout& layout) {
  if (layout.frame > 0xc2 || layout.precision != 8) {
    throw Error("E_IMAGE_FORMAT",
                "the JPEG image is lossless, arithmetic-coded or not 8 bit; export it as baseline or "
                "progressive JPEG");
  }
}

}  // namespace

ImageHeader readJpegHeader(Bytes file) {
  const JpegLayout layout = readJpegLayout(file, false);
  checkSupported(layout);
  ImageHeader header{layout.width, layout.height, "image/jpeg"};
  if (swapsSides(layout.orientation)) std::swap(header.width, header.height);
  return header;
}

Image8 decodeJpeg(Bytes file, const Limits& limits, const CancelToken& cancel) {
  const JpegLayout layout = readJpegLayout(file, true);
  checkLimit("L_IMAGE_SCANS", double(limits.imageScans), double(layout.scans));
  if (std::uint64_t{layout.width} * layout.height / PIXELS_PER_BYTE_MAX > file.size()) {
    throw corrupt("JPEG", "the file is too short for its size");
  }
  JpegReader reader(file, cancel);
  ImageHeader header;
  bool cmyk = false;
  reader.step([&](jpeg_decompress_struct& jpeg) {
    jpeg_read_header(&jpeg, TRUE);
    cmyk = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    jpeg.out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg.dct_method = JDCT_ISLOW;
    jpeg.do_fancy_upsampling = TRUE;
    jpeg.do_block_smoothing = TRUE;
    jpeg_start_decompress(&jpeg);
    header.width = jpeg.output_width;
    header.height = jpeg.output_height;
  });

  Image8 image = [&] {
    const ReusesMemory yes;  // each row is written, or this throws
    return blank(header);
  }();
  const std::size_t rowBytes = std::size_t{header.width} * 4;
  reader.step([&](jpeg_decompress_struct& jpeg) {
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = image.pixels.data() + jpeg.output_scanline * rowBytes;
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
  });
  if (cmyk) cmykToRgba(image.pixels);
  return upright(std::move(image), layout.orientation);
}

}  // namespace telar::image
