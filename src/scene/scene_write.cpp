#include "scene/scene_write.hpp"

#include <algorithm>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/scene/stiffness_bytes.hpp"
#include "bozzetto/scene/support_bytes.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "scene/layout.hpp"
#include "scene/page_check.hpp"
#include "scene/parts_codec.hpp"
#include "scene/tiles.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kBatch = 128;  // chunks in memory at a time

// Rolls back what was not committed.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database_.run("BEGIN IMMEDIATE");
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!done_) sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  void commit() {
    database_.run("COMMIT");
    done_ = true;
  }

 private:
  Database& database_;
  bool done_ = false;
};

class RowWriter {
 public:
  RowWriter(Database& database, Table table)
      : table_(table),
        put_(database, ("REPLACE INTO " + std::string(nameOf(table)) + " VALUES(?, ?, ?)").c_str()),
        erase_(database, ("DELETE FROM " + std::string(nameOf(table)) + " WHERE id = ?").c_str()) {}

  std::size_t put(std::int64_t id, std::span<const std::byte> content) {
    put_.bind(0, id).bind(1, rowHash(table_, id, content)).bind(2, content).run();
    return content.size();
  }
  void erase(std::int64_t id) { erase_.bind(0, id).run(); }

 private:
  Table table_;
  Statement put_, erase_;
};

// Parts that are empty have no row.
std::size_t putAny(RowWriter& rows, Part part, const Bytes& content) {
  const auto row = static_cast<std::int64_t>(part);
  if (!content.empty()) return rows.put(row, content);
  rows.erase(row);
  return 0;
}

// Decoding is the proof that what we write can be read.
std::size_t writeParts(Database& database, const Document& document) {
  const SceneParts& parts = document.parts;
  const std::string& name = database.name();
  RowWriter rows(database, Table::parts);
  const Bytes head = encodeHead({document.field.scale, parts.identity, parts.settings});
  const Bytes view = encodeView(parts.view);
  decodeHead(head, name + ": cannot save settings");
  decodeView(view, name + ": cannot save view");
  std::size_t bytes = rows.put(static_cast<std::int64_t>(Part::head), head);
  bytes += rows.put(static_cast<std::int64_t>(Part::view), view);
  bytes += rows.put(static_cast<std::int64_t>(Part::thumbnail),
                    checkedThumbnail(parts.thumbnail, name + ": cannot save thumbnail"));
  decodeSolid(parts.solid, name + ": cannot save solid");
  bytes += putAny(rows, Part::solid, parts.solid);
  const Bytes supports = encodeSupports(parts.supports);
  decodeSupports(supports, name + ": cannot save supports");
  bytes += putAny(rows, Part::supports, parts.supports.empty() ? Bytes() : supports);
  const Bytes stiffness = encodeStiffness(parts.stiffness);
  if (!stiffness.empty()) decodeStiffness(stiffness, name + ": cannot save stiffness");
  bytes += putAny(rows, Part::stiffness, stiffness);
  database.run("DELETE FROM shelf");
  RowWriter shelf(database, Table::shelf);
  for (std::size_t n = 0; n < parts.shelf.size(); ++n) {
    const Bytes item = encodeItem(parts.shelf[n]);
    decodeItem(item, name + ": cannot save shelf item " + std::to_string(n + 1));
    bytes += shelf.put(static_cast<std::int64_t>(n) + 1, item);
  }
  return bytes;
}

// The rows of a scene's chunks while they are written.
class ChunkRows {
 public:
  ChunkRows(Database& database, std::map<Key, std::int64_t>& rows)
      : writer_(database, Table::chunks), rows_(rows) {
    for (const auto& [tile, row] : rows) last_ = std::max(last_, row);
  }

  /// Bytes written; an empty chunk gives up its row.
  std::size_t put(Key tile, const Bytes& chunk) {
    const auto row = rows_.find(tile);
    if (chunk.empty()) {
      if (row != rows_.end()) writer_.erase(row->second);
      if (row != rows_.end()) rows_.erase(row);
      return 0;
    }
    const std::int64_t id = row != rows_.end() ? row->second : ++last_;
    rows_[tile] = id;
    return writer_.put(id, chunk);
  }

 private:
  RowWriter writer_;
  std::map<Key, std::int64_t>& rows_;
  std::int64_t last_ = 0;
};

std::vector<Bytes> encodedChunks(const Clay& clay, std::span<const Key> tiles) {
  std::vector<Bytes> encoded(tiles.size());
  parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const Chunk chunk = chunkAt(clay.tree, tiles[n]);
      encoded[n] = chunk.runs.empty() ? Bytes() : encodeChunk(chunk);
    }
  });
  return encoded;
}

// Chunks are encoded on threads, batch by batch; SQLite stays on this one.
void writeChunks(ChunkRows rows, const Clay& clay, std::span<const Key> tiles, SaveReport& report,
                 Progress& progress) {
  for (std::size_t first = 0; first < tiles.size(); first += kBatch) {
    progress.step("save", static_cast<double>(first) / static_cast<double>(tiles.size()));
    const auto batch = tiles.subspan(first, std::min(kBatch, tiles.size() - first));
    const std::vector<Bytes> encoded = encodedChunks(clay, batch);
    for (std::size_t n = 0; n < batch.size(); ++n) {
      report.bytesWritten += rows.put(batch[n], encoded[n]);
      if (!encoded[n].empty()) ++report.chunksWritten;
    }
  }
}

void writeDigest(Database& database) {
  ByteWriter list;
  for (const Table table : kTables) {
    Statement rows(database,
                   ("SELECT id, hash FROM " + std::string(nameOf(table)) + " ORDER BY id").c_str());
    while (rows.step()) {
      list.put(static_cast<std::uint8_t>(table));
      list.put(rows.number(0));
      list.put(rows.number(1));
    }
  }
  Statement digest(database, "REPLACE INTO digest VALUES(1, ?)");
  digest.bind(0, static_cast<std::int64_t>(hash64(list.bytes()))).run();
}

}  // namespace

void makeTables(Database& database) {
  database.run(("PRAGMA page_size=" + std::to_string(kPageBytes)).c_str());
  int reserved = static_cast<int>(kPageCheckBytes);
  sqlite3_file_control(database.get(), "main", SQLITE_FCNTL_RESERVE_BYTES, &reserved);
  database.run(("PRAGMA application_id=" + std::to_string(kApplicationId)).c_str());
  database.run(("PRAGMA user_version=" + std::to_string(kFormatVersion)).c_str());
  for (const TableText& table : kTableTexts) database.run(table.create);
}

SaveReport writeScene(Database& database, const Document& document, const TileChanges& changes,
                      std::map<Key, std::int64_t>& rows, Progress& progress) {
  SaveReport report;
  std::map<Key, std::int64_t> newRows = rows;
  Transaction transaction(database);
  if (changes.parts) report.bytesWritten += writeParts(database, document);
  writeChunks(ChunkRows(database, newRows), document.field, changes.written, report, progress);
  writeDigest(database);
  progress.step("save", 1);
  transaction.commit();
  rows = std::move(newRows);
  report.chunks = rows.size();
  return report;
}

}  // namespace bozzetto
