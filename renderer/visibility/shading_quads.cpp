#include "visibility/shading_quads.h"

#include <algorithm>

namespace telar::visibility {
namespace {

constexpr unsigned PIXELS = 4;
/// Of the numbers below 16.
constexpr std::array<std::uint8_t, 16> BITS{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

bool shareVertex(const Corners& a, const Corners& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t u) { return u == b[0] || u == b[1] || u == b[2]; });
}

}  // namespace

void ShadingQuads::show(Owner owner) {
  std::uint8_t& shown = isShown_[numberOf(owner)];
  shown_ += shown == 0;
  shown = 1;
}

void ShadingQuads::join(const SampleOwners& owners) {
  std::array<Corners, PIXELS * SAMPLES> corners;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    if (!owners.meshes()[part.triangle.mesh].smooth) continue;
    corners[i] = cornersOf(owners.meshes()[part.triangle.mesh], part.triangle.number);
    for (std::size_t k = 0; k < i; ++k) {
      const Part& other = parts_[k];
      if (other.surface == part.surface || other.triangle.mesh != part.triangle.mesh ||
          ((other.owner ^ part.owner) & COUNTER_CLOCKWISE) != 0 || !shareVertex(corners[i], corners[k]))
        continue;
      const std::uint16_t from = std::max(part.surface, other.surface), to = std::min(part.surface, other.surface);
      for (std::size_t j = 0; j <= i; ++j) {
        if (parts_[j].surface == from) parts_[j].surface = to;
      }
    }
  }
}

void ShadingQuads::emit(int x, int y) {
  for (std::size_t surface = 0; surface < parts_.size(); ++surface) {
    if (parts_[surface].surface != surface) continue;
    ShadingQuad quad{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0, {}};
    std::array<int, PIXELS> most{};
    for (std::size_t i = surface; i < parts_.size(); ++i) {
      const Part& part = parts_[i];
      if (part.surface != surface) continue;
      quad.samples = static_cast<std::uint16_t>(quad.samples | part.samples);
      for (unsigned pixel = 0; pixel < PIXELS; ++pixel) {
        const int count = BITS[part.in(pixel)];
        if (count <= most[pixel]) continue;
        most[pixel] = count;
        quad.owners[pixel] = part.ofMesh();
      }
    }
    // A pixel without a sample of it shows how the triangle beside it runs on: to the left or right, else above or
    // below.
    for (unsigned pixel = 0; pixel < PIXELS; ++pixel) {
      if (most[pixel] > 0) continue;
      for (const unsigned other : {pixel ^ 1u, pixel ^ 2u, pixel ^ 3u}) {
        if (most[other] == 0) continue;
        quad.owners[pixel] = quad.owners[other];
        break;
      }
    }
    found_[parts_[surface].triangle.mesh].quads.push_back(quad);
  }
}

void ShadingQuads::add(const SampleOwners& owners, int x, int y, bool merge) {
  // Owner of each sample of each pixel: SAMPLES of them, or the one that stands for them.
  const bool ofOneSample = owners.grid().cell == 2;
  std::array<Owner, PIXELS * SAMPLES> all;
  const unsigned each = ofOneSample ? 1 : SAMPLES;
  if (ofOneSample) {
    std::copy_n(owners.of(x, y), PIXELS, all.begin());
  } else {
    for (unsigned i = 0; i < PIXELS; ++i)
      std::copy_n(owners.of(x + static_cast<int>(i & 1), y + static_cast<int>(i >> 1)), SAMPLES, &all[i * SAMPLES]);
  }
  parts_.clear();
  for (unsigned i = 0; i < PIXELS * each; ++i) {
    if (all[i] == NO_OWNER) continue;
    const auto bits = static_cast<std::uint16_t>(ofOneSample ? 15u << (4 * i) : 1u << i);
    const auto known = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.owner == all[i]; });
    if (known != parts_.end()) {
      known->samples = static_cast<std::uint16_t>(known->samples | bits);
    } else {
      parts_.push_back({all[i], bits, static_cast<std::uint16_t>(parts_.size()), owners.triangle(all[i])});
      show(all[i]);
    }
  }
  if (merge && parts_.size() > 1) join(owners);
  emit(x, y);
}

bool ShadingQuads::isSettled(const SampleOwners& owners, std::span<const std::uint8_t> settled, int x, int y) {
  const SampleGrid& grid = owners.grid();
  for (int up = y; up < std::min(y + 2, grid.height); ++up) {
    const std::uint8_t* row =
        &settled[static_cast<std::size_t>(grid.height - 1 - up) * static_cast<std::size_t>(grid.width)];
    for (int right = x; right < std::min(x + 2, grid.width); ++right) {
      if (row[right] == 0) return false;
    }
  }
  return true;
}

void ShadingQuads::find(const SampleOwners& owners, const Wanted& wanted, const CancelToken& cancel) {
  found_.resize(owners.meshes().size());
  sorted_.resize(owners.meshes().size());
  for (Found& found : found_) found.quads.clear();
  isShown_.assign(owners.triangles(), 0);
  shown_ = 0;
  const Pixels& covered = owners.covered();
  for (int y = covered.fromY; y < covered.toY; y += 2) {
    cancel.check();
    for (int x = covered.fromX; x < covered.toX; x += 2) {
      if (wanted.settled.empty() || !isSettled(owners, wanted.settled, x, y)) add(owners, x, y, wanted.merge);
    }
  }
  for (std::size_t mesh = 0; mesh < found_.size(); ++mesh) sort(mesh, trianglesOf(owners.meshes()[mesh]));
}

void ShadingQuads::sort(std::size_t mesh, std::size_t triangles) {
  auto& [quads, places] = found_[mesh];
  ends_.assign(triangles, 0);
  for (const ShadingQuad& quad : quads) ++ends_[numberOf(quad.owners[0])];
  std::uint32_t end = 0;
  for (std::uint32_t& count : ends_) {
    end += count;
    count = end;
  }
  places.resize(quads.size());
  sorted_[mesh].resize(quads.size());
  for (std::size_t i = quads.size(); i-- > 0;) {
    places[i] = --ends_[numberOf(quads[i].owners[0])];
    sorted_[mesh][places[i]] = quads[i];
  }
}

std::size_t ShadingQuads::memory() const {
  std::size_t bytes = bytesOf(ends_) + bytesOf(isShown_);
  for (const auto& quads : sorted_) bytes += bytesOf(quads);
  for (const Found& found : found_) bytes += bytesOf(found.quads) + bytesOf(found.places);
  return bytes;
}

}  // namespace telar::visibility
