#include "pass/gpu_scene.h"

#include <algorithm>
#include <bit>

namespace telar::pass {
namespace {

GLenum modeOf(Topology topology) {
  switch (topology) {
    case Topology::kPoints:
      return GL_POINTS;
    case Topology::kLines:
      return GL_LINES;
    case Topology::kLineLoop:
      return GL_LINE_LOOP;
    case Topology::kLineStrip:
      return GL_LINE_STRIP;
    case Topology::kTriangles:
      return GL_TRIANGLES;
  }
  return GL_TRIANGLES;
}

bool isSrgb(TexelCoding coding, bool colorUse) {
  return coding == TexelCoding::kByUse ? colorUse : coding == TexelCoding::kSrgb;
}

GLsizei levelCount(const Image8& image) {
  if (image.ownLevels) return static_cast<GLsizei>(1 + image.smallerLevels.size());
  return static_cast<GLsizei>(std::bit_width(std::max(image.width, image.height)));
}

/// Appends a stream to one buffer's bytes and remembers where its attribute starts.
class StreamPacker {
 public:
  template <class Vector>
  void add(GLuint location, GLint components, const std::vector<Vector>& stream) {
    if (stream.empty()) return;
    attributes_.push_back({location, components, bytes_.size()});
    const auto* from = reinterpret_cast<const std::byte*>(stream.data());
    bytes_.insert(bytes_.end(), from, from + stream.size() * sizeof(Vector));
  }
  void upload(const gl::Functions& gl) const {
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes_.size()), bytes_.data(), GL_STATIC_DRAW);
    for (const Attribute& a : attributes_) {
      gl.EnableVertexAttribArray(a.location);
      gl.VertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void*>(a.offset));
    }
  }

 private:
  struct Attribute {
    GLuint location;
    GLint components;
    std::size_t offset;
  };
  std::vector<Attribute> attributes_;
  std::vector<std::byte> bytes_;
};

}  // namespace

const GpuPrimitive& GpuScene::primitive(const Primitive& primitive) {
  const auto found = primitives_.find(&primitive);
  if (found != primitives_.end()) return found->second;
  const gl::Functions& gl = context_.gl();
  GpuPrimitive uploaded{gl::VertexArray(gl), gl::Buffer(gl)};
  gl.BindVertexArray(uploaded.vertexArray.get());
  gl.BindBuffer(GL_ARRAY_BUFFER, uploaded.vertices.get());
  StreamPacker packer;
  packer.add(POSITION, 3, primitive.positions);
  packer.add(NORMAL, 3, primitive.normals);
  packer.add(TANGENT, 4, primitive.tangents);
  packer.add(UV0, 2, primitive.uvs[0]);
  packer.add(UV1, 2, primitive.uvs[1]);
  packer.add(COLOR, 4, primitive.colors);
  packer.upload(gl);
  uploaded.mode = modeOf(primitive.topology);
  uploaded.indexed = !primitive.indices.empty();
  uploaded.count = static_cast<GLsizei>(uploaded.indexed ? primitive.indices.size() : primitive.positions.size());
  if (uploaded.indexed) {
    uploaded.indices = gl::Buffer(gl);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.indices.get());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(primitive.indices.size() * sizeof(std::uint32_t)),
                  primitive.indices.data(), GL_STATIC_DRAW);
  }
  gl.BindVertexArray(0);
  context_.check("vertex upload");
  return primitives_.emplace(&primitive, std::move(uploaded)).first->second;
}

GLuint GpuScene::texture(const Scene& scene, int image, bool colorUse, const CancelToken& cancel) {
  const bool srgb = isSrgb(scene.images[static_cast<std::size_t>(image)].coding, colorUse);
  const auto key = std::make_pair(image, srgb);
  const auto found = textures_.find(key);
  if (found != textures_.end()) return found->second.get();
  cancel.check();
  const gl::Functions& gl = context_.gl();
  const Image8& source = scene.images[static_cast<std::size_t>(image)];
  const auto width = static_cast<GLsizei>(source.width), height = static_cast<GLsizei>(source.height);
  gl::Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, levelCount(source), srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, width, height);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, source.pixels.data());
  GLint level = 0;
  for (const auto& pixels : source.smallerLevels) {
    ++level;
    gl.TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, std::max(1, width >> level), std::max(1, height >> level), GL_RGBA,
                     GL_UNSIGNED_BYTE, pixels.data());
  }
  if (!source.ownLevels) gl.GenerateMipmap(GL_TEXTURE_2D);
  context_.check("texture upload");
  return textures_.emplace(key, std::move(texture)).first->second.get();
}

GLuint GpuScene::sampler(const Sampler& wanted) {
  for (const auto& [sampler, object] : samplers_) {
    if (sampler == wanted) return object.get();
  }
  const gl::Functions& gl = context_.gl();
  gl::Sampler object(gl);
  gl.SamplerParameteri(object.get(), GL_TEXTURE_WRAP_S, static_cast<GLint>(wanted.wrapS));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_WRAP_T, static_cast<GLint>(wanted.wrapT));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(wanted.magFilter));
  gl.SamplerParameteri(object.get(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(wanted.minFilter));
  samplers_.emplace_back(wanted, std::move(object));
  return samplers_.back().second.get();
}

}  // namespace telar::pass
