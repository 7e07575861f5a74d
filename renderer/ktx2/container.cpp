#include "ktx2/container.h"

#include <algorithm>
#include <bit>

namespace telar::ktx2 {
namespace {

constexpr std::uint8_t IDENTIFIER[12] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};

enum Supercompression : std::uint32_t { NONE = 0, BASIS_LZ = 1, ZSTD = 2, ZLIB = 3 };

// Values of the Khronos Data Format Specification.
constexpr std::uint8_t MODEL_ETC1S = 163, MODEL_UASTC = 166;
constexpr std::uint8_t PRIMARIES_BT709 = 1, PRIMARIES_DISPLAY_P3 = 10;
constexpr std::uint8_t TRANSFER_SRGB = 2;
constexpr std::size_t DESCRIPTOR_BYTES = 28, SAMPLE_BYTES = 16;

/// Whatever the limits say: below it, no product of sides and bytes wraps.
constexpr std::uint32_t SIDE_MAX = 1u << 28;

struct Header {
  std::uint32_t vkFormat, typeSize, width, height, depth, layers, faces, levels, supercompression;
  std::uint32_t descriptorOffset, descriptorBytes, keysOffset, keysBytes;
  std::uint64_t globalOffset, globalBytes;
};

struct Descriptor {
  std::uint8_t model, primaries, transfer;
  std::size_t samples;
};

struct FormatRange {
  std::uint32_t first, last;
  const char* name;
};

/// Block and other formats that people meet, by the values of VkFormat.
constexpr FormatRange REFUSED_FORMATS[] = {{23, 36, "RGB8"},
                                           {70, 83, "16-bit R or RG"},
                                           {84, 97, "RGB16 or RGBA16"},
                                           {98, 109, "32-bit"},
                                           {122, 123, "packed"},
                                           {131, 134, "BC1"},
                                           {135, 136, "BC2"},
                                           {137, 138, "BC3"},
                                           {139, 140, "BC4"},
                                           {141, 142, "BC5"},
                                           {143, 144, "BC6H"},
                                           {145, 146, "BC7"},
                                           {147, 152, "ETC2"},
                                           {153, 156, "EAC"},
                                           {157, 184, "ASTC"},
                                           {1000054000, 1000054007, "PVRTC"},
                                           {1000066000, 1000066013, "ASTC HDR"}};

/// Components of the uncompressed formats that three.js's loader shows with 8 bits; 0 = another format.
unsigned componentsOf(std::uint32_t vkFormat) {
  constexpr std::uint32_t R8 = 9, R8_SRGB = 15, RG8 = 16, RG8_SRGB = 22, RGBA8 = 37, RGBA8_SRGB = 43;
  if (vkFormat == R8 || vkFormat == R8_SRGB) return 1;
  if (vkFormat == RG8 || vkFormat == RG8_SRGB) return 2;
  return vkFormat == RGBA8 || vkFormat == RGBA8_SRGB ? 4 : 0;
}

std::string nameOf(std::uint32_t vkFormat) {
  for (const FormatRange& range : REFUSED_FORMATS) {
    if (vkFormat >= range.first && vkFormat <= range.last) return range.name;
  }
  return "VkFormat " + std::to_string(vkFormat);
}

Header readHeader(ByteReader& from) {
  Header out{};
  for (std::uint32_t* field :
       {&out.vkFormat, &out.typeSize, &out.width, &out.height, &out.depth, &out.layers, &out.faces, &out.levels,
        &out.supercompression, &out.descriptorOffset, &out.descriptorBytes, &out.keysOffset, &out.keysBytes}) {
    *field = from.u32();
  }
  out.globalOffset = from.u64();
  out.globalBytes = from.u64();
  return out;
}

void checkShape(const Header& header, const Limits& limits) {
  const std::uint32_t side = std::max(header.width, header.height);
  checkLimit("L_IMAGE_DIMENSION", static_cast<double>(limits.imageDimension), side);
  if (side > SIDE_MAX) throw corrupt("its size is one that no texture has");
  if (header.width == 0) throw corrupt("its width is 0");
  if (header.height == 0) throw unsupported("is one-dimensional");
  if (header.depth != 0) throw unsupported("is a 3D texture");
  if (header.layers > 1) throw unsupported("is an array of " + std::to_string(header.layers) + " layers");
  if (header.faces == 6) throw unsupported("is a cube map");
  if (header.faces != 1) throw corrupt("its number of faces is neither 1 nor 6");
  if (header.levels > static_cast<std::uint32_t>(std::bit_width(side))) {
    throw corrupt("it has more mip levels than its size allows");
  }
}

Descriptor readDescriptor(Bytes bytes) {
  if (bytes.size() < DESCRIPTOR_BYTES + SAMPLE_BYTES) throw corrupt("its data format descriptor is too short");
  ByteReader from(bytes);
  from.take(12);  // total size, vendor, type, version, block size
  Descriptor out{};
  out.model = from.u8();
  out.primaries = from.u8();
  out.transfer = from.u8();
  out.samples = (bytes.size() - DESCRIPTOR_BYTES) / SAMPLE_BYTES;
  return out;
}

/// As three.js's KTX2Loader reads it; a use as a colour makes it sRGB whatever the file says. The flag for
/// premultiplied alpha changes nothing there, since it does not act on compressed uploads.
TexelCoding codingOf(const Descriptor& descriptor) {
  const bool known = descriptor.primaries == PRIMARIES_BT709 || descriptor.primaries == PRIMARIES_DISPLAY_P3;
  return known && descriptor.transfer == TRANSFER_SRGB ? TexelCoding::kSrgb : TexelCoding::kByUse;
}

void readPayload(const Header& header, const Descriptor& descriptor, Container& out) {
  if (header.supercompression == ZLIB) throw unsupported("is compressed by zlib");
  if (header.supercompression > ZLIB) {
    throw unsupported("has the supercompression " + std::to_string(header.supercompression));
  }
  out.zstd = header.supercompression == ZSTD;
  out.coding = codingOf(descriptor);
  if (header.vkFormat != 0) {
    out.payload = Payload::kRaw;
    out.components = componentsOf(header.vkFormat);
    if (out.components == 0) throw unsupported("is in the format " + nameOf(header.vkFormat));
    if (out.components < 4) out.coding = TexelCoding::kLinear;
    if (header.supercompression == BASIS_LZ) throw corrupt("it is uncompressed and BasisLZ at once");
  } else if (descriptor.model == MODEL_ETC1S) {
    out.payload = Payload::kEtc1s;
    out.alphaSlices = descriptor.samples == 2;
    if (header.supercompression != BASIS_LZ) throw corrupt("it is ETC1S without BasisLZ");
  } else if (descriptor.model == MODEL_UASTC) {
    out.payload = Payload::kUastc;
    if (header.supercompression == BASIS_LZ) throw corrupt("it is UASTC and BasisLZ at once");
  } else {
    throw unsupported("has the colour model " + std::to_string(descriptor.model));
  }
}

void readLevels(Bytes file, const Header& header, ByteReader& index, Container& out) {
  const std::size_t count = std::max(header.levels, 1u);
  for (std::size_t level = 0; level < count; ++level) {
    const std::uint64_t offset = index.u64(), bytes = index.u64(), uncompressed = index.u64();
    out.levels.push_back(rangeOf(file, offset, bytes));
    if (bytes == 0) throw corrupt("a mip level is empty");
    if (out.payload == Payload::kEtc1s) continue;
    const std::uint64_t expected = levelBytes(out, level);
    if (uncompressed != expected || (!out.zstd && bytes != expected)) {
      throw corrupt("a mip level has another number of bytes than its size needs");
    }
  }
}

}  // namespace

bool isKtx2(Bytes file) {
  return file.size() >= sizeof IDENTIFIER && std::memcmp(file.data(), IDENTIFIER, sizeof IDENTIFIER) == 0;
}

Container readContainer(Bytes file, const Limits& limits) {
  if (!isKtx2(file)) throw corrupt("the file does not start as KTX2 does");
  ByteReader from(file);
  from.take(sizeof IDENTIFIER);
  const Header header = readHeader(from);
  checkShape(header, limits);
  Container out;
  out.width = header.width;
  out.height = header.height;
  readPayload(header, readDescriptor(rangeOf(file, header.descriptorOffset, header.descriptorBytes)), out);
  readLevels(file, header, from, out);
  if (out.payload == Payload::kEtc1s) out.globalData = rangeOf(file, header.globalOffset, header.globalBytes);
  return out;
}

std::string formatName(const Container& container) {
  constexpr const char* RAW[] = {"", "R8", "RG8", "", "RGBA8"};
  std::string out = "KTX2 ";
  if (container.payload == Payload::kEtc1s) return out + "ETC1S";
  out += container.payload == Payload::kUastc ? "UASTC" : RAW[container.components];
  return container.zstd ? out + " zstd" : out;
}

std::uint64_t levelBytes(const Container& container, std::size_t level) {
  const std::uint32_t width = sideOf(container.width, level), height = sideOf(container.height, level);
  if (container.payload == Payload::kRaw) return std::uint64_t{width} * height * container.components;
  return std::uint64_t{blocksOf(width)} * blocksOf(height) * 16;
}

}  // namespace telar::ktx2
