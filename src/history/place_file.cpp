#include "history/place_file.hpp"

#include <cstring>

#include "bozzetto/base/hash.hpp"

namespace bozzetto::undo {
namespace {

constexpr std::string_view kMagic = "bzzplac1";

}  // namespace

Bytes encodePlace(const PlaceRecord& record) {
  ByteWriter out;
  out.put(kMagic);
  for (const std::uint8_t byte : record.identity) out.put(byte);
  out.put(record.place.place);
  out.put(record.place.tip);
  out.put(record.place.mark);
  out.put(record.place.moment);
  out.put(record.savedMoment);
  out.put(hash64(out.bytes()));
  return out.take();
}

PlaceRecord decodePlace(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  if (std::memcmp(in.take(kMagic.size()).data(), kMagic.data(), kMagic.size()) != 0) {
    throw Error(name + ": not a place in a history");
  }
  PlaceRecord record;
  for (std::uint8_t& byte : record.identity) byte = in.get<std::uint8_t>();
  record.place.place = in.get<std::uint32_t>();
  record.place.tip = in.get<std::uint32_t>();
  record.place.mark = in.get<std::uint64_t>();
  record.place.moment = in.get<std::uint64_t>();
  record.savedMoment = in.get<std::uint64_t>();
  const std::uint64_t hash = hash64(bytes.first(in.position()));
  if (in.get<std::uint64_t>() != hash || in.remaining() > 0) {
    throw Error(name + ": content does not match its hash");
  }
  return record;
}

}  // namespace bozzetto::undo
