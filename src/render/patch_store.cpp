#include "render/patch_store.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bozzetto {
namespace {

constexpr int kChunkShift = 6;
constexpr int kChunkCells = 1 << kChunkShift;

std::int16_t signed16(float v) {
  return std::int16_t(std::lround(std::clamp(v, -1.f, 1.f) * 32767));
}
std::uint8_t unsigned8(float v) { return std::uint8_t(std::lround(std::clamp(v, 0.f, 1.f) * 255)); }

glm::vec3 difference(Key a, Key b) {
  return {float(std::int64_t{a.i} - b.i), float(std::int64_t{a.j} - b.j),
          float(std::int64_t{a.k} - b.k)};
}

CellBounds boundsOf(const PatchVertices& patch) {
  glm::vec3 low = patch.positions[0], high = low;
  for (const glm::vec3& p : patch.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 corner(patch.origin.i, patch.origin.j, patch.origin.k);
  return {corner + glm::dvec3(low), corner + glm::dvec3(high)};
}

// False when all corners of the box lie beyond one side of the view.
bool touchesClip(const glm::vec3& low, const glm::vec3& high, const glm::mat4& clip) {
  int outside[6] = {};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 upper(corner & 4, corner & 2, corner & 1);
    const glm::vec4 p = clip * glm::vec4(glm::mix(low, high, upper), 1);
    for (int axis = 0; axis < 3; ++axis) {
      outside[2 * axis] += p[axis] < -p.w;
      outside[2 * axis + 1] += p[axis] > p.w;
    }
  }
  return std::none_of(outside, outside + 6, [](int count) { return count == 8; });
}

void attribute(GLuint location, GLint count, GLenum type, std::size_t offset, GLsizei stride) {
  glVertexAttribPointer(location, count, type, type != GL_FLOAT, stride,
                        reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(location);
}

}  // namespace

Key PatchStore::chunkOf(Key origin) {
  return {origin.i >> kChunkShift, origin.j >> kChunkShift, origin.k >> kChunkShift};
}

std::vector<PatchStore::Vertex> PatchStore::packed(const PatchVertices& patch, glm::vec3 shift) {
  std::vector<Vertex> packed(patch.positions.size());
  for (std::size_t n = 0; n < packed.size(); ++n) {
    const glm::vec3 normal = patch.normals[n];
    VertexLight light = patch.light.empty() ? VertexLight{} : patch.light[n];
    if (light.bent == glm::vec3(0)) light.bent = normal;
    const Colour colour = n < patch.colours.size() ? patch.colours[n] : Colour{};
    const glm::vec3 bent = light.bent * .5f + .5f;
    packed[n] = {
        patch.positions[n] + shift,
        {signed16(normal.x), signed16(normal.y), signed16(normal.z), signed16(light.cavity)},
        {colour.r, colour.g, colour.b,
         std::uint8_t(255 - (patch.hold.empty() ? 0 : patch.hold[n]))},
        {unsigned8(bent.x), unsigned8(bent.y), unsigned8(bent.z), unsigned8(light.open)},
        {patch.stiffness.empty() ? std::int8_t{0} : patch.stiffness[n], 0, 0, 0}};
  }
  return packed;
}

CellBounds PatchStore::upload(const PatchVertices& patch, std::int64_t& bytes) {
  if (patch.indices.empty()) return remove(patch.origin, bytes);
  const Key key = chunkOf(patch.origin);
  const glm::vec3 shift = difference(patch.origin, key * kChunkCells);
  Chunk& chunk = chunks_[key];
  CellBounds changed = chunk.remove(patch.origin, bytes);
  Slot& slot =
      chunk.put(patch.origin, packed(patch, shift), {patch.indices.begin(), patch.indices.end()});
  slot.bounds = boundsOf(patch);
  changed.add(slot.bounds);
  chunk.bounds.add(slot.bounds);
  bytes += std::int64_t(slot.vertexCount * sizeof(Vertex) + slot.indexCount * 4);
  return changed;
}

CellBounds PatchStore::remove(Key origin, std::int64_t& bytes) {
  const auto chunk = chunks_.find(chunkOf(origin));
  if (chunk == chunks_.end()) return {};
  const CellBounds changed = chunk->second.remove(origin, bytes);
  if (chunk->second.slots.empty()) chunks_.erase(chunk);
  return changed;
}

std::size_t PatchStore::triangleCount() const {
  std::size_t sum = 0;
  for (const auto& [key, chunk] : chunks_) sum += chunk.triangles;
  return sum;
}

std::vector<PatchStore::Seen> PatchStore::seen(Key anchor, const glm::mat4& clipFromCells) const {
  std::vector<Seen> seen;
  for (const auto& [key, chunk] : chunks_) {
    const glm::vec3 origin = difference(key * kChunkCells, anchor);
    const glm::dvec3 eye(anchor.i, anchor.j, anchor.k);
    const glm::vec3 low(chunk.bounds.low - eye), high(chunk.bounds.high - eye);
    if (!touchesClip(low, high, clipFromCells)) continue;
    const glm::vec3 middle = origin + kChunkCells / 2.f;
    seen.push_back({origin, &chunk, glm::dot(middle, middle)});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
  return seen;
}

void PatchStore::draw(const gl::Program& program, std::span<const Seen> chunks) {
  const GLint place = program.at("chunkOrigin");
  for (const auto& [origin, chunk, distance] : chunks) {
    glUniform3f(place, origin.x, origin.y, origin.z);
    glBindVertexArray(chunk->array.get());
    glDrawElements(GL_TRIANGLES, GLsizei(chunk->indexRanges.size()), GL_UNSIGNED_INT, nullptr);
  }
  glBindVertexArray(0);
}

bool PatchStore::GrowingBuffer::reserve(std::size_t bytes) {
  if (bytes <= capacity) return false;
  const std::size_t wanted = std::max(bytes, capacity + capacity / 2);
  gl::Buffer larger = gl::newBuffer();
  glBindBuffer(GL_COPY_WRITE_BUFFER, larger.get());
  glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(wanted), nullptr, GL_DYNAMIC_DRAW);
  if (capacity > 0) {
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.get());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(capacity));
  }
  buffer = std::move(larger);
  capacity = wanted;
  return true;
}

void PatchStore::GrowingBuffer::write(std::size_t at, const void* data, std::size_t bytes) {
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.get());
  glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(at), GLsizeiptr(bytes), data);
}

PatchStore::Slot& PatchStore::Chunk::put(Key origin, const std::vector<Vertex>& vertex,
                                         std::vector<std::uint32_t> index) {
  const Slot slot{vertexRanges.take(vertex.size()),
                  vertex.size(),
                  indexRanges.take(index.size()),
                  index.size(),
                  {}};
  const bool movedVertices = vertices.reserve(vertexRanges.size() * sizeof(Vertex));
  const bool movedIndices = indices.reserve(indexRanges.size() * sizeof(std::uint32_t));
  if (movedVertices || movedIndices) describeVertices();
  for (std::uint32_t& n : index) n += std::uint32_t(slot.vertex);
  vertices.write(slot.vertex * sizeof(Vertex), vertex.data(), vertex.size() * sizeof(Vertex));
  indices.write(slot.index * sizeof(std::uint32_t), index.data(),
                index.size() * sizeof(std::uint32_t));
  triangles += slot.indexCount / 3;
  return slots[origin] = slot;
}

// The hole that stays draws nothing: its triangles are points.
CellBounds PatchStore::Chunk::remove(Key origin, std::int64_t& bytes) {
  const auto found = slots.find(origin);
  if (found == slots.end()) return {};
  const Slot slot = found->second;
  const std::vector<std::uint32_t> nothing(slot.indexCount, 0);
  indices.write(slot.index * sizeof(std::uint32_t), nothing.data(),
                nothing.size() * sizeof(std::uint32_t));
  vertexRanges.free(slot.vertex, slot.vertexCount);
  indexRanges.free(slot.index, slot.indexCount);
  triangles -= slot.indexCount / 3;
  bytes += std::int64_t(slot.indexCount * 4);
  slots.erase(found);
  return slot.bounds;
}

void PatchStore::Chunk::describeVertices() {
  if (!array) array = gl::newVertexArray();
  glBindVertexArray(array.get());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.buffer.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.buffer.get());
  constexpr GLsizei stride = sizeof(Vertex);
  attribute(0, 3, GL_FLOAT, offsetof(Vertex, position), stride);
  attribute(1, 4, GL_SHORT, offsetof(Vertex, normalCavity), stride);
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(Vertex, colour), stride);
  attribute(3, 4, GL_UNSIGNED_BYTE, offsetof(Vertex, bentOpen), stride);
  attribute(4, 4, GL_BYTE, offsetof(Vertex, stiffness), stride);
  glBindVertexArray(0);
}

}  // namespace bozzetto
