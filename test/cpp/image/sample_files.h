#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "telar/codec.h"

/// Files and frames that the tests of this folder share, made from nothing.
namespace sample {

using File = std::vector<std::byte>;

/// A test sees libtelar_oiio.so where the build put it, unless the caller says otherwise.
void useBuiltLibrary();

/// RGBA8 with slopes, noise and every alpha; the same for the same size.
telar::Frame frame8(std::uint32_t width, std::uint32_t height, bool opaque = false);
/// Premultiplied linear RGBA fp32 with values from 0 to about 40.
telar::Frame frame32(std::uint32_t width, std::uint32_t height);

File encoded(const telar::Frame& frame, telar::OutputOptions::Format format, int bitDepth = 8, int quality = 90);

File bytes(const std::string& text);
File concat(std::initializer_list<File> parts);
File cut(const File& file, std::size_t size);

/// A PNG chunk with its CRC.
File pngChunk(const std::string& type, const File& data);
File pngHeader(std::uint32_t width, std::uint32_t height, int depth, int colorType);
File be32(std::uint32_t value);

/// A .hdr file with a flat body of RGBE quadruples.
File flatHdr(int width, int height, const std::vector<std::uint8_t>& rgbe);

/// Code of the telar::Error that `call` throws; "" when it throws none.
std::string codeOf(const std::function<void()>& call);

inline std::uint8_t at(const File& file, std::size_t i) { return std::uint8_t(file[i]); }

}  // namespace sample
