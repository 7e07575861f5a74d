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
constexpr FormatRange REFUSED_FORMATS[] = {{9, 22, "R8 or RG8 of integers or signed numbers"},
                                           {23, 36, "RGB8"},
                                           {37, 50, "RGBA8 of integers or signed numbers, or BGRA8"},
                                           {70, 83, "R16 or RG16"},
                                           {84, 90, "RGB16"},
                                           {91, 97, "RGBA16 of integers or signed numbers"},
                                           {98, 109, "RGB32F, or 32-bit integers"},
                                           {135, 136, "BC2"},
                                           {143, 144, "BC6H"},
                                           {147, 147, "ETC2 without sRGB"},
                                           {149, 151, "ETC2 without sRGB, or with one bit of alpha"},
                                           {159, 184, "ASTC in blocks other than 4x4 and 6x6"}};

/// Formats that three.js hands to a GPU that reads them, which is none that a server has.
constexpr FormatRange FOREIGN_FORMATS[] = {{1000054000, 1000054007, "PVRTC"}, {1000066000, 1000066013, "ASTC HDR"}};

template <std::size_t N>
const char* nameIn(const FormatRange (&list)[N], std::uint32_t vkFormat) {
  for (const FormatRange& range : list) {
    if (vkFormat >= range.first && vkFormat <= range.last) return range.name;
  }
  return nullptr;
}

[[noreturn]] void refuseFormat(std::uint32_t vkFormat) {
  if (const char* foreign = nameIn(FOREIGN_FORMATS, vkFormat))
    throw unsupported(std::string("is in the format ") + foreign);
  const char* name = nameIn(REFUSED_FORMATS, vkFormat);
  throw refusedByClients("is in the format " + (name ? std::string(name) : "VkFormat " + std::to_string(vkFormat)));
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

/// A file whose format is Vulkan's, not one of Basis Universal.
void readPlainFormat(const Header& header, Container& out) {
  out.raw = rawFormatOf(header.vkFormat);
  out.blocks = blockLayoutOf(header.vkFormat);
  if (!out.raw && !out.blocks) refuseFormat(header.vkFormat);
  if (header.supercompression == BASIS_LZ) throw corrupt("it has a format of its own and is BasisLZ at once");
  out.payload = out.raw ? Payload::kRaw : Payload::kBlocks;
  const bool decodesSrgb =
      out.raw ? out.raw->components == 4 && out.raw->type() == TexelType::kByte : out.blocks->coloured;
  if (!decodesSrgb) out.coding = TexelCoding::kLinear;
  if (out.blocks && out.blocks->wholeBlocks() && (header.width % 4 != 0 || header.height % 4 != 0)) {
    throw refusedByClients(std::string("is in the format ") + out.blocks->name +
                           " with sides that are no multiples of 4");
  }
}

void readPayload(const Header& header, const Descriptor& descriptor, Container& out) {
  if (header.supercompression == ZLIB) throw refusedByClients("is compressed by zlib");
  if (header.supercompression > ZLIB) {
    throw refusedByClients("has the supercompression " + std::to_string(header.supercompression));
  }
  out.zstd = header.supercompression == ZSTD;
  out.coding = codingOf(descriptor);
  if (header.vkFormat != 0) {
    readPlainFormat(header, out);
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
    if (out.payload == Payload::kRaw && !out.zstd && offset % out.raw->alignment() != 0) {
      throw corrupt("a mip level does not start where numbers of its format may");
    }
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
  std::string out = "KTX2 ";
  if (container.payload == Payload::kEtc1s) return out + "ETC1S";
  out += container.payload == Payload::kUastc ? "UASTC" : container.raw ? container.raw->name : container.blocks->name;
  return container.zstd ? out + " zstd" : out;
}

std::uint64_t levelBytes(const Container& container, std::size_t level) {
  const std::uint32_t width = sideOf(container.width, level), height = sideOf(container.height, level);
  if (container.payload == Payload::kRaw) return std::uint64_t{width} * height * container.raw->bytes();
  const std::uint32_t side = container.blocks ? container.blocks->side : 4;
  const std::uint32_t bytes = container.blocks ? container.blocks->bytes : 16;
  return std::uint64_t{blocksOf(width, side)} * blocksOf(height, side) * bytes;
}

}  // namespace telar::ktx2
