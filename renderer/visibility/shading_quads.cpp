#include "visibility/shading_quads.h"

#include <algorithm>

#include "visibility/lanes.h"

namespace telar::visibility {
namespace {

constexpr unsigned PIXELS = 4;
constexpr std::uint16_t ALL_SAMPLES = 0xffff;

bool areAll(const Owner* const (&pixels)[PIXELS], Owner owner) {
  const auto value = static_cast<std::int32_t>(owner);
  const Mask one{value, value, value, value};
  Mask other{};
  for (const Owner* pixel : pixels) {
    Mask samples;
    std::memcpy(&samples, pixel, sizeof samples);
    other |= samples != one;
  }
  return !any(other);
}

}  // namespace

void ShadingQuads::put(const SampleOwners& owners, Owner owner, int x, int y, std::uint16_t samples) {
  const SampleOwners::Triangle triangle = owners.triangle(owner);
  quads_[triangle.mesh].push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), samples,
                                   (owner & COUNTER_CLOCKWISE) != 0, triangle.number});
}

void ShadingQuads::add(const SampleOwners& owners, int x, int y) {
  const Owner* pixels[PIXELS] = {owners.of(x, y), owners.of(x + 1, y), owners.of(x, y + 1), owners.of(x + 1, y + 1)};
  if (areAll(pixels, pixels[0][0])) {
    if (pixels[0][0] != NO_OWNER) put(owners, pixels[0][0], x, y, ALL_SAMPLES);
    return;
  }
  Owner known[PIXELS * SAMPLES];
  std::uint16_t samples[PIXELS * SAMPLES];
  std::size_t count = 0;
  for (unsigned i = 0; i < PIXELS * SAMPLES; ++i) {
    const Owner owner = pixels[i / SAMPLES][i % SAMPLES];
    if (owner == NO_OWNER) continue;
    std::size_t at = 0;
    while (at < count && known[at] != owner) ++at;
    if (at == count) {
      known[count] = owner;
      samples[count++] = 0;
    }
    samples[at] = static_cast<std::uint16_t>(samples[at] | 1u << i);
  }
  for (std::size_t i = 0; i < count; ++i) put(owners, known[i], x, y, samples[i]);
}

void ShadingQuads::find(const SampleOwners& owners, const CancelToken& cancel) {
  quads_.resize(owners.meshes().size());
  for (auto& quads : quads_) quads.clear();
  shown_ = 0;
  const Pixels& covered = owners.covered();
  for (int y = covered.fromY; y < covered.toY; y += 2) {
    cancel.check();
    for (int x = covered.fromX; x < covered.toX; x += 2) add(owners, x, y);
  }
  for (std::size_t mesh = 0; mesh < quads_.size(); ++mesh) sort(quads_[mesh], trianglesOf(owners.meshes()[mesh]));
}

void ShadingQuads::sort(std::vector<ShadingQuad>& quads, std::size_t triangles) {
  ends_.assign(triangles, 0);
  for (const ShadingQuad& quad : quads) ++ends_[quad.triangle];
  std::uint32_t end = 0;
  for (std::uint32_t& count : ends_) {
    shown_ += count > 0;
    end += count;
    count = end;
  }
  sorted_.resize(quads.size());
  for (std::size_t i = quads.size(); i-- > 0;) sorted_[--ends_[quads[i].triangle]] = quads[i];
  quads.swap(sorted_);
}

std::size_t ShadingQuads::memory() const {
  std::size_t bytes = bytesOf(ends_) + bytesOf(sorted_);
  for (const auto& quads : quads_) bytes += bytesOf(quads);
  return bytes;
}

}  // namespace telar::visibility
