// Undo-files from strangers. The first byte chooses: a file, a record without compression and
// hashes, a head.
#include <algorithm>
#include <cstdlib>

#include "history/record_codec.hpp"
#include "history/undo_file.hpp"

namespace {

using namespace bozzetto;

Clay someClay() {
  Clay clay;
  Edit<CornerBlock<8>> edit(clay.tree);
  edit.replace({{0, 0, 0}, 4}, CornerBlock<8>::uniform(1, 0x102030));
  edit.write({0, 0, 2}).value[17] = 0.5f;
  edit.commit();
  return clay;
}

void readFile(std::span<const std::byte> bytes, const Clay& clay) {
  const undo::UndoFile<8> file(bytes, "fuzz");
  for (const Direction direction : {Direction::forward, Direction::backward}) {
    Clay changed = clay;
    file.unpack(clay.tree, direction).apply(changed.tree, direction);
    if (validate(changed)) std::abort();
    file.beside({}, direction);
  }
}

void readRecord(std::span<const std::byte> raw, const Clay& clay) {
  const auto record = undo::decodeRecord<8>(raw, "fuzz");
  if (!std::ranges::equal(undo::encodeRecord(record), raw)) std::abort();
  undo::unpack(record, clay.tree, Direction::forward, "fuzz");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const Clay clay = someClay();
  const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
  try {
    if (data[0] == 0) readFile(bytes, clay);
    if (data[0] == 1) readRecord(bytes, clay);
    if (data[0] == 2) undo::decodeHead(bytes, "fuzz");
  } catch (const Error&) {
  }
  return 0;
}
