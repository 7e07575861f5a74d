#include "oiio/tiff_writer.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

#include "oiio/srgb_profile.h"

namespace telar::oiio {
namespace {

constexpr std::uint64_t STRIP_BYTES = 1 << 16;  // rows that are compressed together, about

/// What libtiff writes to, and what it says. Nothing thrown may cross libtiff.
struct Memory {
  TiffFile file;
  std::size_t at = 0;
  bool full = false;
  char message[128] = "";
};

Memory& memoryOf(thandle_t handle) { return *static_cast<Memory*>(handle); }

tmsize_t readBytes(thandle_t handle, void* out, tmsize_t count) {
  Memory& memory = memoryOf(handle);
  const std::size_t size = memory.file.bytes.size();
  const std::size_t taken = std::min(size - std::min(memory.at, size), static_cast<std::size_t>(count));
  std::copy_n(memory.file.bytes.data() + memory.at, taken, static_cast<std::uint8_t*>(out));
  memory.at += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t writeBytes(thandle_t handle, void* from, tmsize_t count) {
  Memory& memory = memoryOf(handle);
  const std::size_t end = memory.at + static_cast<std::size_t>(count);
  try {
    if (end > memory.file.bytes.size()) memory.file.bytes.resize(end);
  } catch (const std::bad_alloc&) {
    memory.full = true;
    return -1;
  }
  std::copy_n(static_cast<const std::uint8_t*>(from), count, memory.file.bytes.data() + memory.at);
  memory.at = end;
  return count;
}

toff_t seekTo(thandle_t handle, toff_t offset, int from) {
  Memory& memory = memoryOf(handle);
  const std::size_t base = from == SEEK_CUR ? memory.at : from == SEEK_END ? memory.file.bytes.size() : 0;
  return memory.at = base + offset;
}

int keepOpen(thandle_t) { return 0; }

toff_t sizeOf(thandle_t handle) { return memoryOf(handle).file.bytes.size(); }

/// Keeps the first message: libtiff's own handler prints.
int hear(TIFF*, void* user, const char*, const char* format, va_list values) {
  char(&message)[128] = static_cast<Memory*>(user)->message;
  if (!message[0]) std::vsnprintf(message, sizeof message, format, values);
  return 1;
}

int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFCleanup)>;

Tiff openTiff(Memory& memory) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), hear, &memory);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore, nullptr);
  // "l": little-endian whatever the machine is.
  return {TIFFClientOpenExt("memory.tiff", "wl", &memory, readBytes, writeBytes, seekTo, keepOpen, sizeOf, nullptr,
                            nullptr, options.get()),
          TIFFCleanup};
}

std::uint32_t rowsInStrip(const TelarOiioWrite& job) {
  const std::uint64_t rowBytes = std::uint64_t{job.width} * 4 * (job.bitDepth / 8);
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(STRIP_BYTES / rowBytes, 1, job.height));
}

bool describe(TIFF* tiff, const TelarOiioWrite& job) {
  const std::uint16_t extra[] = {EXTRASAMPLE_UNASSALPHA};
  bool ok = TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, job.width) && TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, job.height);
  ok = ok && TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, job.bitDepth) && TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 4);
  ok = ok && TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, extra) &&
       TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
  ok = ok && TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  ok = ok && TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  ok = ok && TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rowsInStrip(job));
  if (job.level > 0) {
    ok = ok && TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    ok = ok && TIFFSetField(tiff, TIFFTAG_ZIPQUALITY, job.level);
    ok = ok && TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  }
  if (ok && job.ppi > 0) {
    ok = TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH) && TIFFSetField(tiff, TIFFTAG_XRESOLUTION, job.ppi) &&
         TIFFSetField(tiff, TIFFTAG_YRESOLUTION, job.ppi);
  }
  if (ok && job.icc) {
    const std::vector<std::uint8_t> profile = srgbProfile();
    ok = TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
  }
  return ok;
}

/// Writes every strip. libtiff takes differences in the bytes that it is given: each strip is a copy.
bool writeStrips(TIFF* tiff, const TelarOiioWrite& job, bool& cancelled) {
  const std::uint32_t rows = rowsInStrip(job);
  const std::size_t rowValues = std::size_t{job.width} * 4;
  const auto* from = static_cast<const std::uint8_t*>(job.pixels);
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;
  for (std::uint32_t y = 0; y < job.height; y += rows) {
    cancelled = job.cancel.cancelled(job.cancel.user);
    if (cancelled) return false;
    const std::size_t values = rowValues * std::min(rows, job.height - y);
    bytes.assign(from + y * rowValues, from + y * rowValues + values);
    words.assign(bytes.begin(), bytes.end());
    for (std::uint16_t& word : words) word = static_cast<std::uint16_t>(word * 257);
    const bool wide = job.bitDepth == 16;
    void* data = wide ? static_cast<void*>(words.data()) : bytes.data();
    const auto size = static_cast<tmsize_t>(wide ? values * 2 : values);
    if (TIFFWriteEncodedStrip(tiff, y / rows, data, size) != size) return false;
  }
  return true;
}

}  // namespace

TiffFile writeTiff(const TelarOiioWrite& job) {
  Memory memory;
  bool written = false;
  {
    const Tiff tiff = openTiff(memory);
    written = tiff && describe(tiff.get(), job) && writeStrips(tiff.get(), job, memory.file.cancelled) &&
              TIFFFlush(tiff.get());
  }
  if (memory.full) throw std::bad_alloc();
  if (!written) memory.file.failure = memory.message[0] ? memory.message : "libtiff gives no reason";
  return std::move(memory.file);
}

}  // namespace telar::oiio
