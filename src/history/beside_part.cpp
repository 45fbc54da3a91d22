#include "history/beside_part.hpp"

#include <algorithm>

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

std::span<const std::byte> bytesOf(const BytesRef& ref) {
  return ref ? std::span<const std::byte>(*ref) : std::span<const std::byte>();
}

BytesRef copyOf(std::span<const std::byte> a, std::span<const std::byte> b = {}) {
  if (a.empty() && b.empty()) return nullptr;
  Bytes bytes(a.begin(), a.end());
  bytes.insert(bytes.end(), b.begin(), b.end());
  return std::make_shared<const Bytes>(std::move(bytes));
}

// Supports end with their sculptures, which most steps keep: what both end with is written once.
Bytes encodeBytesPart(const BytesRef& before, const BytesRef& after) {
  ByteWriter out;
  const auto old = bytesOf(before), now = bytesOf(after);
  if (std::ranges::equal(old, now)) return out.take();
  const auto ends = std::mismatch(old.rbegin(), old.rend(), now.rbegin(), now.rend());
  const auto common = static_cast<std::size_t>(ends.first - old.rbegin());
  out.put(static_cast<std::uint32_t>(old.size() - common));
  out.put(static_cast<std::uint32_t>(now.size() - common));
  out.put(old.first(old.size() - common));
  out.put(now.first(now.size() - common));
  out.put(old.last(common));
  return out.take();
}

BytesRef bytesBeyond(const BytesRef& here, std::span<const std::byte> part, Direction direction,
                     const std::string& name) {
  if (part.empty()) return here;
  ByteReader in(part, name);
  const auto oldBytes = in.get<std::uint32_t>();
  const auto newBytes = in.get<std::uint32_t>();
  const auto old = in.take(oldBytes), now = in.take(newBytes), common = in.take(in.remaining());
  return copyOf(direction == Direction::forward ? now : old, common);
}

// Each with its length before it.
struct Parts {
  std::span<const std::byte> solid{}, supports{}, ledger{}, stiffness{};
};

Bytes joined(const Parts& parts) {
  ByteWriter out;
  const auto all = {parts.solid, parts.supports, parts.ledger, parts.stiffness};
  if (std::ranges::all_of(all, [](const auto& each) { return each.empty(); })) return out.take();
  for (const auto& each : all) {
    out.put(static_cast<std::uint32_t>(each.size()));
    out.put(each);
  }
  return out.take();
}

Parts partsOf(std::span<const std::byte> bytes, BesideForm form, const std::string& name) {
  Parts parts{bytes};
  if (form == BesideForm::solidAlone || bytes.empty()) return parts;
  ByteReader in(bytes, name);
  for (auto* part : {&parts.solid, &parts.supports, &parts.ledger, &parts.stiffness})
    *part = in.take(in.get<std::uint32_t>());
  if (in.remaining() > 0) throw Error(name + ": bytes too many beside the clay");
  return parts;
}

}  // namespace

Bytes encodeBesidePart(const Beside& before, const Beside& after) {
  const Bytes solid = encodeSolidPart(before.solid, after.solid);
  const Bytes supports = encodeBytesPart(before.supports, after.supports);
  const Bytes ledger = encodeBytesPart(before.ledger, after.ledger);
  return joined({solid, supports, ledger, encodeBytesPart(before.stiffness, after.stiffness)});
}

Beside besideBeyond(const Beside& here, std::span<const std::byte> part, Direction direction,
                    BesideForm form, const std::string& name) {
  const Parts parts = partsOf(part, form, name);
  return {solidBeyond(here.solid, parts.solid, direction, name),
          bytesBeyond(here.supports, parts.supports, direction, name),
          bytesBeyond(here.ledger, parts.ledger, direction, name),
          bytesBeyond(here.stiffness, parts.stiffness, direction, name)};
}

Bytes encodeBeside(const Beside& beside) {
  const Bytes solid = encodeSolid(beside.solid);
  return joined(
      {solid, bytesOf(beside.supports), bytesOf(beside.ledger), bytesOf(beside.stiffness)});
}

Beside decodeBeside(std::span<const std::byte> bytes, BesideForm form, const std::string& name) {
  const Parts parts = partsOf(bytes, form, name);
  return {decodeSolid(parts.solid, name), copyOf(parts.supports), copyOf(parts.ledger),
          copyOf(parts.stiffness)};
}

}  // namespace bozzetto::undo
