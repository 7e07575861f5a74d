#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <utility>

#include "image/decoders.h"
#include "image/orientation.h"

namespace telar::image {
namespace {

constexpr std::size_t IHDR_END = 33;                   // signature 8, length 4, type 4, data 13, CRC 4
constexpr png_alloc_size_t CHUNK_BYTES_MAX = 8 << 20;  // one ancillary chunk
constexpr int CHUNKS_MAX = 128;
constexpr std::uint64_t DEFLATE_RATIO_MAX = 1032;  // 258 bytes from 2 bits: no deflate stream expands more
constexpr std::uint32_t ROWS_PER_STEP = 64;        // between two looks at the cancel token

/// State that libpng's callbacks share; lives outside every frame that longjmp leaves.
struct PngContext {
  Bytes file;
  std::size_t position = 0;
  std::jmp_buf jump;
  char message[160] = {};
  bool outOfMemory = false;
};

[[noreturn]] void onError(png_structp png, png_const_charp message) {
  auto* context = static_cast<PngContext*>(png_get_error_ptr(png));
  std::snprintf(context->message, sizeof context->message, "%s", message);
  std::longjmp(context->jump, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onRead(png_structp png, png_bytep to, png_size_t length) {
  auto* context = static_cast<PngContext*>(png_get_io_ptr(png));
  if (length > context->file.size() - context->position) png_error(png, "the file ends too early");
  std::memcpy(to, context->file.data() + context->position, length);
  context->position += length;
}

png_voidp onMalloc(png_structp png, png_alloc_size_t size) {
  void* memory = std::malloc(size);
  if (!memory) static_cast<PngContext*>(png_get_mem_ptr(png))->outOfMemory = true;
  return memory;
}

void onFree(png_structp, png_voidp memory) { std::free(memory); }

/// Owns the two libpng structs; step() runs C calls so that an error comes out as telar::Error.
class PngReader {
 public:
  explicit PngReader(Bytes file) {
    context_.file = file;
    png_ = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &context_, onError, onWarning, &context_, onMalloc, onFree);
    if (!png_) throw std::bad_alloc();
    info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Bytes that libpng has taken.
  std::size_t position() const { return context_.position; }

  /// `calls` must own nothing: longjmp runs no destructors.
  template <class Calls>
  void step(const Calls& calls) {
    if (setjmp(context_.jump)) fail();
    calls(png_, info_);
  }

 private:
  [[noreturn]] void fail() {
    if (context_.outOfMemory) throw std::bad_alloc();
    throw corrupt("PNG", context_.message).atOffset(context_.position);
  }

  PngContext context_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// Chunks that do not change texels (colour, text, time, ...) are checked and skipped, never parsed.
void setUp(png_structp png) {
  static constexpr png_byte SKIPPED[] =
      "bKGD\0cHRM\0eXIf\0gAMA\0hIST\0iCCP\0iTXt\0oFFs\0pCAL\0pHYs\0sBIT\0sCAL\0sPLT\0sRGB\0sTER\0tEXt\0tIME\0zTXt";
  png_set_read_fn(png, png_get_error_ptr(png), onRead);
  png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_set_chunk_malloc_max(png, CHUNK_BYTES_MAX);
  png_set_chunk_cache_max(png, CHUNKS_MAX);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, SKIPPED, int(sizeof SKIPPED / 5));
}

void expandToRgba8(png_structp png, png_infop info) {
  const int colorType = png_get_color_type(png, info);
  png_set_strip_16(png);
  png_set_expand(png);  // palette to RGB, 1/2/4 bit grey to 8, tRNS to alpha
  if (!(colorType & PNG_COLOR_MASK_COLOR)) png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
}

/// Orientation of an eXIf chunk before the first IDAT, which is where Chromium looks.
int pngOrientation(Bytes file) {
  for (std::size_t chunk = IHDR_END; file.size() >= chunk + 12;) {
    const std::size_t length = be32(data(file) + chunk);
    if (length > file.size() - chunk - 12 || hasAt(file, chunk + 4, "IDAT")) break;
    if (hasAt(file, chunk + 4, "eXIf")) return readOrientation(file.subspan(chunk + 8, length));
    chunk += length + 12;
  }
  return 1;
}

/// The file must be long enough to hold its pixels, before memory is taken for them.
void checkDataExists(Bytes file) {
  const std::uint8_t* p = data(file);
  const std::uint64_t bits = p[24] * std::uint64_t{be32(p + 16)} * be32(p + 20);  // one channel at least
  if (bits / 8 / DEFLATE_RATIO_MAX > file.size())
    throw corrupt("PNG", "the file is too short for its size").atOffset(16);
}

/// The chunk at `position` and those after it are whole and end with IEND. Not left to png_read_end, which would
/// inflate image data that lies behind the last row, however much there is.
void checkTail(Bytes file, std::size_t position) {
  for (std::size_t chunk = IHDR_END;;) {
    if (file.size() < chunk + 12) throw corrupt("PNG", "the file ends too early").atOffset(file.size());
    const std::uint8_t* p = data(file) + chunk;
    const std::size_t length = be32(p), end = chunk + 12 + length;
    if (end > file.size()) throw corrupt("PNG", "the file ends too early").atOffset(file.size());
    if (end > position && crc32(0, p + 4, static_cast<uInt>(length + 4)) != be32(p + 8 + length)) {
      throw corrupt("PNG", "a chunk has a CRC error").atOffset(chunk);
    }
    if (hasAt(file, chunk + 4, "IEND")) return;
    chunk = end;
  }
}

}  // namespace

ImageHeader readPngHeader(Bytes file) {
  if (file.size() < IHDR_END) throw corrupt("PNG", "the file ends too early").atOffset(file.size());
  const std::uint8_t* p = data(file);
  if (be32(p + 8) != 13 || !hasAt(file, 12, "IHDR")) throw corrupt("PNG", "the first chunk is not IHDR").atOffset(8);
  if (crc32(0, p + 12, 17) != be32(p + 29)) throw corrupt("PNG", "IHDR: CRC error").atOffset(29);
  ImageHeader header{be32(p + 16), be32(p + 20), "image/png"};
  if (!header.width || !header.height) throw corrupt("PNG", "width or height is 0").atOffset(16);
  if (swapsSides(pngOrientation(file))) std::swap(header.width, header.height);
  return header;
}

Image8 decodePng(Bytes file, const CancelToken& cancel) {
  checkDataExists(file);
  PngReader reader(file);
  ImageHeader header;
  int passes = 1;
  std::size_t rowBytes = 0;
  reader.step([&](png_structp png, png_infop info) {
    setUp(png);
    png_read_info(png, info);
    expandToRgba8(png, info);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    header.width = png_get_image_width(png, info);
    header.height = png_get_image_height(png, info);
    rowBytes = png_get_rowbytes(png, info);
  });
  if (rowBytes != std::size_t{header.width} * 4) throw corrupt("PNG", "unknown pixel layout");

  Image8 image = blank(header);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::uint32_t begin = 0; begin < header.height; begin += ROWS_PER_STEP) {
      cancel.check();
      const std::uint32_t end = std::min(header.height, begin + ROWS_PER_STEP);
      reader.step([&](png_structp png, png_infop) {
        for (std::uint32_t y = begin; y < end; ++y) png_read_row(png, image.pixels.data() + y * rowBytes, nullptr);
      });
    }
  }
  checkTail(file, reader.position());
  return upright(std::move(image), pngOrientation(file));
}

}  // namespace telar::image
