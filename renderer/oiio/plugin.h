#pragma once
#include <cstddef>
#include <cstdint>

/// The C interface of libtelar_oiio.so, the only library of ours that links OpenImageIO, lcms2 and libtiff. It takes
/// 0.3 s and 120 MiB to load, so image/oiio_bridge loads it when a file needs it. Plain data crosses; exceptions never
/// do.
extern "C" {

constexpr std::uint32_t TELAR_OIIO_VERSION = 4;

enum TelarOiioFormat : std::uint32_t { TELAR_OIIO_PNG, TELAR_OIIO_TIFF, TELAR_OIIO_EXR };

enum TelarOiioStatus : std::uint32_t {
  TELAR_OIIO_OK,
  TELAR_OIIO_CANCELLED,
  TELAR_OIIO_NO_MEMORY,
  TELAR_OIIO_UNSUPPORTED,  ///< a well-formed file that holds no RGB picture
  TELAR_OIIO_FAILED,       ///< damaged input, or a file that could not be written
};

struct TelarOiioResult {
  TelarOiioStatus status;
  char message[160];  ///< zero-terminated, for FAILED and UNSUPPORTED
};

/// How the caller is asked whether to stop; may be called from the calling thread only.
struct TelarOiioCancel {
  const void* user;
  bool (*cancelled)(const void* user);
};

/// Takes bytes; returns false when there is no memory for them.
struct TelarOiioSink {
  void* user;
  bool (*append)(void* user, const void* bytes, std::size_t count);
};

/// Rows from the top, tightly packed, RGBA where no channels are named: bytes for PNG and TIFF (sRGB, straight alpha),
/// floats for EXR (linear Rec.709, premultiplied).
struct TelarOiioWrite {
  TelarOiioFormat format;
  std::uint32_t width, height;
  const void* pixels;
  int bitDepth;  ///< 8 or 16 integer (PNG, TIFF), 16 or 32 float (EXR)
  double ppi;    ///< 0 = not written
  int level;     ///< of deflate, 1 to 9; 0 = not compressed
  bool icc;      ///< PNG, TIFF
  TelarOiioCancel cancel;
  std::uint32_t channels;    ///< 4 where there are no names
  const char* const* names;  ///< EXR: of the channels, in place of R, G, B, A; null = these
  const int* bitDepths;      ///< EXR: of each channel that has a name; null = bitDepth
};

/// An EXR file to read: one whose size the caller took from the header and allowed.
struct TelarOiioRead {
  const void* file;
  std::size_t fileBytes;
  std::uint32_t width, height;
  float* rgba;  ///< width * height * 4 floats; R, G and B are written, A is left
  TelarOiioCancel cancel;
};

using TelarOiioVersionFunction = std::uint32_t();
using TelarOiioWriteFunction = void(const TelarOiioWrite*, const TelarOiioSink*, TelarOiioResult*);
using TelarOiioReadFunction = void(const TelarOiioRead*, TelarOiioResult*);
using TelarOiioProfileFunction = void(const TelarOiioSink*, TelarOiioResult*);

#ifdef TELAR_OIIO_PLUGIN
#define TELAR_OIIO_EXPORT __attribute__((visibility("default")))
TELAR_OIIO_EXPORT TelarOiioVersionFunction telar_oiio_version;
TELAR_OIIO_EXPORT TelarOiioWriteFunction telar_oiio_write;
TELAR_OIIO_EXPORT TelarOiioReadFunction telar_oiio_read;
/// Bytes of an ICC profile of sRGB, the same in every call.
TELAR_OIIO_EXPORT TelarOiioProfileFunction telar_oiio_srgb_profile;
#endif

}  // extern "C"
