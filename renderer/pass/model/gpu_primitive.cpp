#include "pass/model/gpu_primitive.h"

#include <numeric>

namespace telar::pass {
namespace {

constexpr GLuint MATRIX_COLUMNS = 4;

const void* offsetOf(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class Item>
void append(std::vector<std::byte>& bytes, const std::vector<Item>& items) {
  const auto* from = reinterpret_cast<const std::byte*>(items.data());
  bytes.insert(bytes.end(), from, from + items.size() * sizeof(Item));
}

gl::Buffer uploaded(const gl::Functions& gl, GLenum target, const void* data, std::size_t bytes) {
  gl::Buffer buffer(gl);
  gl.BindBuffer(target, buffer.get());
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

GLenum modeOf(Topology topology) {
  switch (topology) {
    case Topology::kPoints:
      return GL_POINTS;
    case Topology::kLines:
      return GL_LINES;
    case Topology::kLineLoop:  // with its first vertex again as the last
    case Topology::kLineStrip:
      return GL_LINE_STRIP;
    case Topology::kTriangles:
      return GL_TRIANGLES;
  }
  return GL_TRIANGLES;
}

/// Empty = the vertices in their order. A part of a strip can be drawn alone, a part of a loop cannot: it becomes a
/// strip that ends where it began.
std::vector<std::uint32_t> loopIndices(const Primitive& primitive) {
  std::vector<std::uint32_t> indices = primitive.indices;
  if (indices.empty()) {
    indices.resize(primitive.positions.size());
    std::iota(indices.begin(), indices.end(), 0u);
  }
  indices.push_back(indices.front());
  return indices;
}

}  // namespace

VertexStreams::VertexStreams(const gl::Context& context, const Primitive& primitive)
    : mode_(modeOf(primitive.topology)) {
  const gl::Functions& gl = context.gl();
  std::vector<std::span<const std::byte>> streams;
  std::size_t bytes = 0;
  const auto add = [&](GLuint location, GLint components, const auto& stream) {
    if (stream.empty()) return;
    attributes_.push_back({location, components, bytes});
    streams.push_back(std::as_bytes(std::span(stream)));
    bytes += streams.back().size();
  };
  add(POSITION, 3, primitive.positions);
  add(NORMAL, 3, primitive.normals);
  add(TANGENT, 4, primitive.tangents);
  add(UV0, 2, primitive.uvs[0]);
  add(UV1, 2, primitive.uvs[1]);
  add(COLOR, 4, primitive.colors);
  add(VISIBILITY, 4, primitive.visibility[0]);
  add(VISIBILITY_BACK, 4, primitive.visibility[1]);
  gl.BindVertexArray(0);  // an index buffer binds to the vertex array of the moment
  vertices_ = uploaded(gl, GL_ARRAY_BUFFER, nullptr, bytes);
  for (std::size_t i = 0; i < streams.size(); ++i) {
    gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(attributes_[i].offset),
                     static_cast<GLsizeiptr>(streams[i].size()), streams[i].data());
  }
  const bool loop = primitive.topology == Topology::kLineLoop && !primitive.positions.empty();
  const std::vector<std::uint32_t> closed = loop ? loopIndices(primitive) : std::vector<std::uint32_t>();
  const auto& indices = loop ? closed : primitive.indices;
  count_ = static_cast<GLsizei>(indices.empty() ? primitive.positions.size() : indices.size());
  if (!indices.empty()) {
    indices_ = uploaded(gl, GL_ELEMENT_ARRAY_BUFFER, indices.data(), indices.size() * sizeof(std::uint32_t));
  }
  context.check("vertex upload");
}

void VertexStreams::attach(const gl::Functions& gl) const {
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  for (const Attribute& a : attributes_) {
    gl.EnableVertexAttribArray(a.location);
    gl.VertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, 0, offsetOf(a.offset));
  }
  if (indices_) gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
}

InstanceStreams::InstanceStreams(const gl::Context& context, const Instances& instances)
    : count_(static_cast<GLsizei>(instances.matrices.size())), colored_(!instances.colors.empty()) {
  std::vector<std::byte> bytes;
  append(bytes, instances.matrices);
  append(bytes, instances.colors);
  buffer_ = uploaded(context.gl(), GL_ARRAY_BUFFER, bytes.data(), bytes.size());
  context.check("instance upload");
}

void InstanceStreams::attach(const gl::Functions& gl, GLsizei first) const {
  const auto skipped = static_cast<std::size_t>(first);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.get());
  const auto add = [&](GLuint location, GLint components, std::size_t stride, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), offsetOf(offset));
    gl.VertexAttribDivisor(location, 1);
  };
  for (GLuint column = 0; column < MATRIX_COLUMNS; ++column) {
    add(INSTANCE_MATRIX + column, 4, sizeof(glm::mat4), skipped * sizeof(glm::mat4) + column * sizeof(glm::vec4));
  }
  if (colored_) {
    add(INSTANCE_COLOR, 3, sizeof(glm::vec3),
        static_cast<std::size_t>(count_) * sizeof(glm::mat4) + skipped * sizeof(glm::vec3));
  }
}

void GpuPrimitive::draw(const gl::Functions& gl, GLint first, GLsizei number, GLsizei firstInstance,
                        GLsizei drawn) const {
  gl.BindVertexArray(vertexArray.get());
  const void* from = offsetOf(static_cast<std::size_t>(first) * sizeof(std::uint32_t));
  if (!instances) {
    indices ? gl.DrawElements(mode, number, GL_UNSIGNED_INT, from) : gl.DrawArrays(mode, first, number);
    return;
  }
  // OpenGL ES 3.0 cannot begin at an instance.
  if (firstInstance > 0) instances->attach(gl, firstInstance);
  indices ? gl.DrawElementsInstanced(mode, number, GL_UNSIGNED_INT, from, drawn)
          : gl.DrawArraysInstanced(mode, first, number, drawn);
  if (firstInstance > 0) instances->attach(gl);
}

void GpuPrimitive::drawOnly(const gl::Functions& gl, GLuint buffer, std::size_t byte, GLsizei number) const {
  gl.BindVertexArray(vertexArray.get());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.DrawElements(mode, number, GL_UNSIGNED_INT, offsetOf(byte));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
}

}  // namespace telar::pass
