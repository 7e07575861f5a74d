#include "asset/accessor/accessor.h"

#include <algorithm>

#include "asset/check/number.h"
#include "asset/check/pointer.h"
#include "core/unaligned.h"

namespace telar::asset {
namespace {

constexpr std::uint64_t ELEMENTS_PER_CANCEL_CHECK = 65'536;

/// Where elements lie; checked by Accessors::check().
struct Layout {
  std::span<const std::byte> bytes;
  std::uint64_t offset = 0, stride = 0;
  unsigned components = 1;
  int componentType = COMPONENT_F32;
  bool normalized = false;
  Normalizing normalizing = Normalizing::kDivided;
};

double loadComponent(const std::byte* from, int componentType) {
  switch (componentType) {
    case COMPONENT_I8:
      return loadUnaligned<std::int8_t>(from);
    case COMPONENT_U8:
      return loadUnaligned<std::uint8_t>(from);
    case COMPONENT_I16:
      return loadUnaligned<std::int16_t>(from);
    case COMPONENT_U16:
      return loadUnaligned<std::uint16_t>(from);
    case COMPONENT_U32:
      return loadUnaligned<std::uint32_t>(from);
    default:
      return loadUnaligned<float>(from);
  }
}

void put(double value, const Layout& layout, float& out) {
  out = fromComponent(value, layout.componentType, layout.normalized, layout.normalizing);
}
void put(double value, const Layout&, std::uint32_t& out) { out = static_cast<std::uint32_t>(value); }

/// Copies element `from` of the layout to element `to` of `out`.
template <typename Out>
void copyElement(const Layout& layout, std::uint64_t from, std::uint64_t to, std::span<Out> out) {
  const unsigned bytes = componentBytes(layout.componentType);
  const std::byte* source = layout.bytes.data() + layout.offset + from * layout.stride;
  for (unsigned c = 0; c < layout.components; ++c) {
    put(loadComponent(source + std::size_t{c} * bytes, layout.componentType), layout, out[to * layout.components + c]);
  }
}

unsigned componentsOf(const tinygltf::Accessor& accessor) {
  return static_cast<unsigned>(
      std::max(0, tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type))));
}

std::uint64_t elementBytes(const tinygltf::Accessor& accessor) {
  return std::uint64_t{componentsOf(accessor)} * componentBytes(accessor.componentType);
}

struct Sparse {
  Layout indices, values;
  std::uint64_t count = 0;
};

Sparse sparseOf(const tinygltf::Accessor& accessor, const Resources& resources) {
  const auto& source = accessor.sparse;
  Sparse out;
  out.count = static_cast<std::uint64_t>(source.count);
  out.indices.bytes = resources.view(source.indices.bufferView);
  out.indices.offset = static_cast<std::uint64_t>(source.indices.byteOffset);
  out.indices.componentType = source.indices.componentType;
  out.indices.stride = componentBytes(source.indices.componentType);
  out.values.bytes = resources.view(source.values.bufferView);
  out.values.offset = static_cast<std::uint64_t>(source.values.byteOffset);
  out.values.componentType = accessor.componentType;
  out.values.components = componentsOf(accessor);
  out.values.stride = elementBytes(accessor);
  out.values.normalized = accessor.normalized;
  return out;
}

void checkSparse(const tinygltf::Accessor& accessor, const Resources& resources, const std::string& where) {
  const auto& source = accessor.sparse;
  const int type = source.indices.componentType;
  if (type != COMPONENT_U8 && type != COMPONENT_U16 && type != COMPONENT_U32) {
    fail("E_SPARSE", "sparse indices must be unsigned integers", where + "/sparse/indices/componentType");
  }
  const Sparse sparse = sparseOf(accessor, resources);
  if (sparse.count > accessor.count) {
    fail("E_SPARSE", "the accessor has more sparse values than elements", where + "/sparse/count");
  }
  if (!fits(sparse.indices.bytes.size(), sparse.indices.offset, sparse.count, sparse.indices.stride,
            sparse.indices.stride)) {
    fail("E_SPARSE", "the sparse indices reach past the end of their buffer view", where + "/sparse/indices");
  }
  if (!fits(sparse.values.bytes.size(), sparse.values.offset, sparse.count, sparse.values.stride,
            sparse.values.stride)) {
    fail("E_SPARSE", "the sparse values reach past the end of their buffer view", where + "/sparse/values");
  }
}

void checkIndexViews(const tinygltf::Model& model) {
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      if (primitive.indices < 0) continue;
      const int view = model.accessors[static_cast<std::size_t>(primitive.indices)].bufferView;
      if (view < 0 || model.bufferViews[static_cast<std::size_t>(view)].byteStride == 0) continue;
      fail("E_STRIDE", "a buffer view of indices must not have a byteStride",
           pointer("bufferViews", view, "byteStride"));
    }
  }
}

void checkRange(const tinygltf::Accessor& accessor, const tinygltf::BufferView& view, const std::string& where) {
  const std::uint64_t element = elementBytes(accessor);
  if (view.byteStride != 0 && view.byteStride < element) {
    fail("E_STRIDE", "the buffer view's byteStride is smaller than one element of the accessor that uses it",
         pointer("bufferViews", accessor.bufferView, "byteStride"));
  }
  const unsigned component = componentBytes(accessor.componentType);
  if (accessor.byteOffset % component != 0 || (view.byteOffset + accessor.byteOffset) % component != 0) {
    fail("E_ACCESSOR", "the accessor's data does not start at a multiple of its component size", where + "/byteOffset");
  }
  const std::uint64_t stride = view.byteStride != 0 ? view.byteStride : element;
  if (!fits(view.byteLength, accessor.byteOffset, accessor.count, stride, element)) {
    fail("E_ACCESSOR", "the accessor reaches past the end of its buffer view", where);
  }
}

}  // namespace

unsigned componentBytes(int componentType) {
  switch (componentType) {
    case COMPONENT_I8:
    case COMPONENT_U8:
      return 1;
    case COMPONENT_I16:
    case COMPONENT_U16:
      return 2;
    case COMPONENT_U32:
    case COMPONENT_F32:
      return 4;
    default:
      return 0;
  }
}

float fromComponent(double value, int componentType, bool normalized, Normalizing normalizing) {
  const auto real = static_cast<float>(value);
  if (!normalized) return real;
  const auto part = [&](float most) {
    return normalizing == Normalizing::kFetched ? real * (1.0f / most) : real / most;
  };
  switch (componentType) {
    case COMPONENT_I8:
      return std::max(part(127.0f), -1.0f);
    case COMPONENT_U8:
      return part(255.0f);
    case COMPONENT_I16:
      return std::max(part(32767.0f), -1.0f);
    case COMPONENT_U16:
      return part(65535.0f);
    default:
      return real;
  }
}

unsigned Accessors::components(int accessor) const { return componentsOf(info(accessor)); }

void Accessors::check() const {
  const auto& model = document_.model;
  checkIndexViews(model);
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    if (i % 1024 == 0) cancel_.check();
    const auto& accessor = model.accessors[i];
    const std::string where = pointer("accessors", i);
    if (componentBytes(accessor.componentType) == 0) {
      fail("E_ACCESSOR", "the accessor has a component type that glTF does not have", where + "/componentType");
    }
    if (accessor.bufferView >= 0) {
      checkRange(accessor, model.bufferViews[static_cast<std::size_t>(accessor.bufferView)], where);
    }
    if (accessor.sparse.isSparse) checkSparse(accessor, resources_, where);
  }
}

template <typename Out>
void Accessors::read(int accessor, std::span<Out> out, Normalizing normalizing) const {
  const auto& source = info(accessor);
  const std::uint64_t count = std::min<std::uint64_t>(source.count, out.size() / componentsOf(source));
  std::fill(out.begin(), out.end(), Out{0});
  if (source.bufferView >= 0) {
    const auto& view = document_.model.bufferViews[static_cast<std::size_t>(source.bufferView)];
    const std::uint64_t stride = view.byteStride != 0 ? view.byteStride : elementBytes(source);
    const Layout layout{resources_.view(source.bufferView),
                        source.byteOffset,
                        stride,
                        componentsOf(source),
                        source.componentType,
                        source.normalized,
                        normalizing};
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i % ELEMENTS_PER_CANCEL_CHECK == 0) cancel_.check();
      copyElement(layout, i, i, out);
    }
  }
  if (!source.sparse.isSparse) return;
  Sparse sparse = sparseOf(source, resources_);
  sparse.values.normalizing = normalizing;
  std::uint64_t next = 0;  // indices must strictly increase
  for (std::uint64_t i = 0; i < sparse.count; ++i) {
    if (i % ELEMENTS_PER_CANCEL_CHECK == 0) cancel_.check();
    std::uint32_t index = 0;
    copyElement(sparse.indices, i, 0, std::span(&index, 1));
    if (index < next || index >= source.count) {
      const std::string what = "sparse index " + std::to_string(i) + " is " + std::to_string(index);
      fail("E_SPARSE",
           index < next ? what + ", which is not above " + std::to_string(next - 1) + ", the one before it"
                        : what + ", but the accessor has " + std::to_string(source.count) + " elements",
           pointer("accessors", accessor, "sparse", "indices"));
    }
    if (index < count) copyElement(sparse.values, i, index, out);
    next = std::uint64_t{index} + 1;
  }
}

void Accessors::readFloats(int accessor, std::span<float> out, Normalizing normalizing) const {
  read(accessor, out, normalizing);
}
void Accessors::readUnsigned(int accessor, std::span<std::uint32_t> out) const {
  read(accessor, out, Normalizing::kDivided);
}

}  // namespace telar::asset
