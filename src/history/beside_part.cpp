#include "history/solid_part.hpp"

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/hash.hpp"

namespace bozzetto::undo {
namespace {

std::uint64_t hashOf(const SolidRef& solid) { return hash64(encodeSolid(solid)); }

struct Half {
  std::uint64_t hash;  // of the solid that this leads to
  std::span<const std::byte> delta;
};

Half readHalf(ByteReader& in) {
  const auto hash = in.get<std::uint64_t>();
  return {hash, in.take(in.get<std::uint32_t>())};
}

void putHalf(ByteWriter& out, const SolidRef& from, const SolidRef& to) {
  const Bytes delta = encodeSolidDelta(from, to);
  out.put(hashOf(to));
  out.put(static_cast<std::uint32_t>(delta.size()));
  out.put(std::span<const std::byte>(delta));
}

}  // namespace

Bytes encodeSolidPart(const SolidRef& before, const SolidRef& after) {
  ByteWriter out;
  if (before == after || (before && after && *before == *after)) return out.take();
  putHalf(out, before, after);
  putHalf(out, after, before);
  return out.take();
}

SolidRef solidBeyond(const SolidRef& here, std::span<const std::byte> part, Direction direction,
                     const std::string& name) {
  if (part.empty()) return here;
  ByteReader in(part, name);
  const Half forward = readHalf(in);
  const Half backward = readHalf(in);
  const bool on = direction == Direction::forward;
  if (in.remaining() > 0 || hashOf(here) != (on ? backward : forward).hash) {
    throw Error(name + ": made from another solid than is there");
  }
  const Half& half = on ? forward : backward;
  SolidRef there = applySolidDelta(here, half.delta, name);
  if (hashOf(there) != half.hash) throw Error(name + ": leads to another solid than it did");
  return there;
}

}  // namespace bozzetto::undo
