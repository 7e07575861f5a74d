#include "asset/accessor/draco_decoder.h"

// First, since a header below looks at its macros and does not include it.
// clang-format off
#include <draco/draco_features.h>
#include <draco/compression/attributes/prediction_schemes/mesh_prediction_scheme_tex_coords_decoder.h>
// clang-format on
#include <draco/compression/attributes/prediction_schemes/mesh_prediction_scheme_tex_coords_portable_decoder.h>
#include <draco/compression/attributes/prediction_schemes/prediction_scheme_wrap_decoding_transform.h>
#include <draco/compression/decode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/compression/point_cloud/point_cloud_kd_tree_decoder.h>
#include <draco/compression/point_cloud/point_cloud_sequential_decoder.h>
#include <draco/mesh/corner_table.h>
#include <draco/mesh/mesh_attribute_corner_table.h>

#include <new>
#include <stdexcept>

#include "asset/check/pointer.h"

// libdraco 1.5 believes the number of orientations that texture coordinates are predicted by: 2^31 of them are 256 MiB
// and ten seconds, out of four bytes. The data gives one for each corner at most. libdraco is linked statically, and
// these definitions stand in for its own of the same members, which are templates and so are weak.
namespace draco {
namespace {

/// Reads them as libdraco's own code does: a bit each, 0 = turned against the one before.
/// @param set  called with index and orientation
template <class Set>
bool readOrientations(DecoderBuffer& buffer, std::uint32_t count, Set set) {
  RAnsBitDecoder bits;
  if (!bits.StartDecoding(&buffer)) return false;
  bool orientation = true;
  for (std::uint32_t i = 0; i < count; ++i) {
    orientation = orientation == bits.DecodeNextBit();
    set(i, orientation);
  }
  bits.EndDecoding();
  return true;
}

template <class Scheme>
bool hasCorners(const Scheme& scheme, std::uint32_t count) {
  return count <= static_cast<std::uint32_t>(scheme.corner_table()->num_corners());
}

using Transform = PredictionSchemeWrapDecodingTransform<int, int>;
using OfMesh = MeshPredictionSchemeData<CornerTable>;
using OfAttribute = MeshPredictionSchemeData<MeshAttributeCornerTable>;
template <class Data>
using Portable = MeshPredictionSchemeTexCoordsPortableDecoder<int, Transform, Data>;
template <class Data>
using Deprecated = MeshPredictionSchemeTexCoordsDecoder<int, Transform, Data>;

}  // namespace

#define TELAR_ORIENTATIONS_OF_CORNERS(Data)                                                           \
  template <>                                                                                         \
  bool Portable<Data>::DecodePredictionData(DecoderBuffer* buffer) {                                  \
    std::int32_t count = 0;                                                                           \
    if (!buffer->Decode(&count) || count < 0) return false;                                           \
    if (!hasCorners(mesh_data(), static_cast<std::uint32_t>(count))) return false;                    \
    predictor_.ResizeOrientations(count);                                                             \
    const auto set = [&](std::uint32_t i, bool orientation) {                                         \
      predictor_.set_orientation(static_cast<int>(i), orientation);                                   \
    };                                                                                                \
    if (!readOrientations(*buffer, static_cast<std::uint32_t>(count), set)) return false;             \
    return MeshPredictionSchemeDecoder<int, Transform, Data>::DecodePredictionData(buffer);           \
  }                                                                                                   \
  template <>                                                                                         \
  bool Deprecated<Data>::DecodePredictionData(DecoderBuffer* buffer) {                                \
    std::uint32_t count = 0;                                                                          \
    if (!DecodeVarint(&count, buffer) || count == 0 || !hasCorners(mesh_data(), count)) return false; \
    orientations_.resize(count);                                                                      \
    const auto set = [&](std::uint32_t i, bool orientation) { orientations_[i] = orientation; };      \
    if (!readOrientations(*buffer, count, set)) return false;                                         \
    return MeshPredictionSchemeDecoder<int, Transform, Data>::DecodePredictionData(buffer);           \
  }

TELAR_ORIENTATIONS_OF_CORNERS(OfMesh)
TELAR_ORIENTATIONS_OF_CORNERS(OfAttribute)

#undef TELAR_ORIENTATIONS_OF_CORNERS

}  // namespace draco

namespace telar::asset {
namespace {

[[noreturn]] void refuse(const char* why, const std::string& where) {
  fail("E_DRACO", std::string("the Draco data ") + why, where);
}

/// One of libdraco's decoders that looks at the cancel flag between its steps, and at the attributes that the data
/// declares before any value of theirs is decoded.
template <class Decoder>
class GuardedDecoder final : public Decoder {
 public:
  GuardedDecoder(MemoryBudget::Loan& loan, const CancelToken& cancel, const std::string& where)
      : loan_(loan), cancel_(cancel), where_(where) {}

 protected:
  bool DecodeGeometryData() override {
    cancel_.check();
    return Decoder::DecodeGeometryData();
  }

  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    std::uint64_t bytes = 0;
    for (int i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      // Bytes of any value would be read as bool, which has two.
      if (attribute.data_type() == draco::DT_BOOL) refuse("has an attribute of booleans", where_);
      bytes += std::uint64_t{cloud.num_points()} * attribute.num_components() * bytesOfValue(attribute);
    }
    loan_.growTo(bytes, where_);
    for (int i = 0; i < this->num_attributes_decoders(); ++i) {
      cancel_.check();
      // libdraco hands the decoder out as const alone; it is this object's own.
      auto* group = const_cast<draco::AttributesDecoderInterface*>(this->attributes_decoder(i));
      if (!group->DecodeAttributes(this->buffer())) return false;
    }
    return true;
  }

 private:
  /// A value is there as the data has it, an integer, and as the attribute has it.
  static std::uint64_t bytesOfValue(const draco::PointAttribute& attribute) {
    return sizeof(std::int32_t) + static_cast<std::uint64_t>(draco::DataTypeLength(attribute.data_type()));
  }

  MemoryBudget::Loan& loan_;
  const CancelToken& cancel_;
  const std::string& where_;
};

template <class Decoder, class Geometry>
std::unique_ptr<draco::PointCloud> decodeAs(draco::DecoderBuffer& buffer, MemoryBudget::Loan& loan,
                                            const CancelToken& cancel, const std::string& where) {
  auto out = std::make_unique<Geometry>();
  const draco::DecoderOptions options;
  GuardedDecoder<Decoder> decoder(loan, cancel, where);
  if (!decoder.Decode(options, &buffer, out.get()).ok()) refuse("is damaged", where);
  return out;
}

}  // namespace

std::unique_ptr<draco::PointCloud> decodeDraco(std::span<const std::byte> data, const DracoCounts& counts,
                                               MemoryBudget::Loan& loan, const CancelToken& cancel,
                                               const std::string& where) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
  try {
    if (counts.points) {
      return counts.sequential
                 ? decodeAs<draco::PointCloudSequentialDecoder, draco::PointCloud>(buffer, loan, cancel, where)
                 : decodeAs<draco::PointCloudKdTreeDecoder, draco::PointCloud>(buffer, loan, cancel, where);
    }
    return counts.sequential ? decodeAs<draco::MeshSequentialDecoder, draco::Mesh>(buffer, loan, cancel, where)
                             : decodeAs<draco::MeshEdgebreakerDecoder, draco::Mesh>(buffer, loan, cancel, where);
  } catch (const std::bad_alloc&) {
    refuse("asks for more memory than there is", where);
  } catch (const std::length_error&) {
    refuse("asks for more memory than there is", where);
  }
}

}  // namespace telar::asset
