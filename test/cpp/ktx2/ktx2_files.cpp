#include "ktx2/ktx2_files.h"

#include <algorithm>

namespace telar::test {
namespace {

constexpr std::size_t HEADER_BYTES = 80, LEVEL_BYTES = 24, DESCRIPTOR_BYTES = 44;

File bytesOfHex(const std::string& hex) {
  File out;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    out.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return out;
}

template <class Call>
Error errorOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return Error("", "");
}

}  // namespace

void put(File& file, std::size_t offset, std::uint64_t value, unsigned bytes) {
  for (unsigned i = 0; i < bytes; ++i) file.at(offset + i) = static_cast<std::byte>(value >> (8 * i));
}

File Ktx2Fields::write() const {
  const std::size_t descriptor = HEADER_BYTES + LEVEL_BYTES * levels.size();
  File out(descriptor + DESCRIPTOR_BYTES);
  const std::uint8_t identifier[] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
  std::transform(std::begin(identifier), std::end(identifier), out.begin(), [](auto b) { return std::byte{b}; });
  std::size_t at = sizeof identifier;
  for (const std::uint32_t field : {vkFormat, 1u, width, height, depth, layers, faces, levelCount, supercompression,
                                    static_cast<std::uint32_t>(descriptor), std::uint32_t{DESCRIPTOR_BYTES}}) {
    put(out, at, field, 4);
    at += 4;
  }
  put(out, descriptor, DESCRIPTOR_BYTES, 4);
  const std::uint8_t facts[] = {model, primaries, transfer};
  for (std::size_t i = 0; i < 3; ++i) put(out, descriptor + 12 + i, facts[i], 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::uint64_t entry[] = {out.size(), levels[i].bytes.size(), levels[i].uncompressed};
    for (std::size_t k = 0; k < 3; ++k) put(out, HEADER_BYTES + LEVEL_BYTES * i + 8 * k, entry[k], 8);
    out.insert(out.end(), levels[i].bytes.begin(), levels[i].bytes.end());
  }
  return out;
}

File solidBlock(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
  constexpr std::uint64_t SOLID = 0x17;  // in 5 bits
  File out(16);
  const std::uint64_t color = std::uint64_t{a} << 24 | std::uint64_t{b} << 16 | std::uint64_t{g} << 8 | r;
  put(out, 0, SOLID | color << 5, 8);
  return out;
}

Ktx2Fields oneBlock() {
  Ktx2Fields out;
  out.levels.push_back({solidBlock(10, 20, 30, 40), 16});
  return out;
}

File etc1sFile() {
  return bytesOfHex(
      "ab4b5458203230bb0d0a1a0a000000000100000008000000040000000000000000000000010000000100000001000000680000003c000000"
      "0000000000000000a800000000000000a5000000000000005001000000000000040000000000000000000000000000003c00000000000000"
      "02003800a301020003030000000000000000000000007f000000000000000000ffffffff00007f0f0000000000000000ffffffff00000000"
      "0400030036000000190000002e00000000000000000000000000000002000000020000000200000001400500000000000002f000aa000800"
      "00008200c01104ad7ee4015409000000000041002f4c0e00150002000000000850eed18cab022807ea06080000008200c03e68efa7fe5f83"
      "00a8d4ff914977104045000000000000023830005400000000008020800d800a00010000802000a876005001000000000080000800000000"
      "2d01af03");
}

ZeroedBytes etc1sTexels() {
  return {
      99,  181, 82,  251, 99,  181, 82,  231, 99,  181, 82,  213, 99,  181, 82,  193, 132, 157, 82,  177, 132, 157,
      82,  157, 132, 157, 82,  139, 132, 157, 82,  119, 99,  181, 82,  251, 105, 187, 88,  231, 105, 187, 88,  213,
      105, 187, 88,  193, 138, 163, 88,  177, 138, 163, 88,  157, 138, 163, 88,  139, 138, 163, 88,  119, 109, 191,
      92,  251, 109, 191, 92,  231, 109, 191, 92,  213, 115, 197, 98,  193, 142, 167, 92,  177, 142, 167, 92,  157,
      148, 173, 98,  139, 148, 173, 98,  119, 115, 197, 98,  251, 115, 197, 98,  231, 115, 197, 98,  213, 115, 197,
      98,  193, 148, 173, 98,  177, 148, 173, 98,  157, 148, 173, 98,  139, 148, 173, 98,  119,
  };
}

std::string codeOf(const File& file) {
  return errorOf([&] { ktx2::decode(file, {}, {}); }).code;
}

std::string messageOf(const File& file) {
  return errorOf([&] { ktx2::decode(file, {}, {}); }).what();
}

}  // namespace telar::test
