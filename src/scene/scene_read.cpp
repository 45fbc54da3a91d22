#include "scene/scene_read.hpp"

#include <algorithm>
#include <cstring>

#include "bozzetto/base/file.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/scene/stiffness_bytes.hpp"
#include "bozzetto/scene/support_bytes.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "scene/chunk_codec.hpp"
#include "scene/database.hpp"
#include "scene/layout.hpp"
#include "scene/page_check.hpp"
#include "scene/parts_codec.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

std::uint32_t bigEndian(std::span<const std::byte> file, std::size_t at, int bytes) {
  std::uint32_t value = 0;
  for (int n = 0; n < bytes; ++n) value = value << 8 | std::to_integer<std::uint32_t>(file[at + n]);
  return value;
}

struct HeaderField {
  std::size_t at;
  int bytes;
  std::uint32_t expected;
  const char* what;
};

// SQLite's own header, as our saves leave it; SQLite reads no file that strays from this.
void requireHeader(std::span<const std::byte> file, const std::string& name) {
  constexpr char kMagic[] = "SQLite format 3";
  if (file.size() < kPageBytes || std::memcmp(file.data(), kMagic, sizeof kMagic) != 0) {
    throw Error(name + ": not a bozzetto scene (" + std::to_string(file.size()) +
                " bytes, an SQLite database expected)");
  }
  const HeaderField fields[] = {
      {68, 4, kApplicationId, "application id"},
      {60, 4, kFormatVersion, "format version"},
      {16, 2, kPageBytes, "page size"},
      {18, 2, 0x0101, "journal format"},
      {20, 1, kPageCheckBytes, "reserved bytes a page"},
      {56, 4, 1, "text encoding"},
      {28, 4, static_cast<std::uint32_t>(file.size() / kPageBytes), "pages"},
  };
  for (const HeaderField& field : fields) {
    const std::uint32_t found = bigEndian(file, field.at, field.bytes);
    if (found == field.expected) continue;
    throw Error(name + ": byte " + std::to_string(field.at) + ": " + field.what + " " +
                std::to_string(found) + ", " + std::to_string(field.expected) + " expected");
  }
  if (file.size() % kPageBytes != 0) {
    throw Error(name + ": " + std::to_string(file.size()) + " bytes, whole pages of " +
                std::to_string(kPageBytes) + " expected");
  }
}

void requireSchema(Database& database) {
  Statement schema(database, "SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY rowid");
  std::size_t n = 0;
  for (; schema.step(); ++n) {
    const bool good = n < kTableTexts.size() && schema.text(0) == "table" &&
                      schema.text(1) == kTableTexts[n].name &&
                      schema.text(2) == kTableTexts[n].name &&
                      schema.text(3) == kTableTexts[n].create;
    if (!good)
      throw Error(database.name() + ": sqlite_schema row " + std::to_string(n + 1) +
                  ": not a table of a bozzetto scene");
  }
  if (n != kTableTexts.size()) {
    throw Error(database.name() + ": " + std::to_string(n) + " tables, " +
                std::to_string(kTableTexts.size()) + " expected");
  }
}

void requireSound(Database& database) {
  const std::string fault = database.ask("PRAGMA quick_check(1)");
  if (fault == "ok") return;
  throw Error(database.name() + ": damaged database: " +
              fault.substr(0, std::min<std::size_t>(200, fault.find('\n'))));
}

struct Row {
  std::int64_t id, hash;
  Bytes content;
};

std::vector<Row> rowsOf(Database& database, Table table) {
  const std::string sql =
      "SELECT id, hash, content FROM " + std::string(nameOf(table)) + " ORDER BY id";
  Statement rows(database, sql.c_str());
  std::vector<Row> result;
  while (rows.step()) {
    const auto content = rows.bytes(2);
    result.push_back({rows.number(0), rows.number(1), {content.begin(), content.end()}});
  }
  return result;
}

std::string rowName(const Database& database, Table table, std::int64_t id) {
  return database.name() + ": " + std::string(nameOf(table)) + " row " + std::to_string(id);
}

void requireHash(const std::string& name, Table table, const Row& row) {
  const auto found = static_cast<std::uint64_t>(rowHash(table, row.id, row.content));
  if (found == static_cast<std::uint64_t>(row.hash)) return;
  throw Error(name + ": content has hash " + hexDigits(found) + ", " +
              hexDigits(static_cast<std::uint64_t>(row.hash)) + " expected");
}

// The digest covers which rows there are.
void requireDigest(Database& database, const std::array<std::vector<Row>, 3>& tables) {
  ByteWriter list;
  for (const Table table : kTables) {
    for (const Row& row : tables[static_cast<std::size_t>(table)]) {
      list.put(static_cast<std::uint8_t>(table));
      list.put(row.id);
      list.put(row.hash);
    }
  }
  Statement digest(database, "SELECT hash FROM digest WHERE id = 1");
  const bool there = digest.step();
  const auto found = hash64(list.bytes());
  if (there && static_cast<std::uint64_t>(digest.number(0)) == found) return;
  throw Error(database.name() + ": digest row 1: rows have digest " + hexDigits(found) + ", " +
              (there ? hexDigits(static_cast<std::uint64_t>(digest.number(0))) : "none") +
              " found");
}

void readParts(const Database& database, const std::vector<Row>& rows, Document& document) {
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Row& row = rows[n];
    const std::string name = rowName(database, Table::parts, row.id);
    requireHash(name, Table::parts, row);
    const bool known = n < 3 ? row.id == static_cast<std::int64_t>(n) + 1 : row.id <= kLastPart;
    if (!known) throw Error(name + ": unknown part");
    if (row.id == static_cast<std::int64_t>(Part::head)) {
      SceneHead head = decodeHead(row.content, name);
      document.field.scale = head.scale;
      document.parts.identity = head.identity;
      document.parts.settings = std::move(head.settings);
    }
    if (row.id == static_cast<std::int64_t>(Part::view)) {
      document.parts.view = decodeView(row.content, name);
    }
    if (row.id == static_cast<std::int64_t>(Part::thumbnail)) {
      document.parts.thumbnail = checkedThumbnail(row.content, name);
    }
    if (row.id == static_cast<std::int64_t>(Part::solid)) {
      if (decodeSolid(row.content, name) == nullptr) throw Error(name + ": no solid found");
      document.parts.solid = row.content;
    }
    if (row.id == static_cast<std::int64_t>(Part::supports)) {
      document.parts.supports = decodeSupports(row.content, name);
      if (document.parts.supports.empty()) throw Error(name + ": no supports found");
    }
    if (row.id == static_cast<std::int64_t>(Part::stiffness)) {
      document.parts.stiffness = decodeStiffness(row.content, name);
    }
  }
  if (rows.size() < 3) {
    throw Error(database.name() + ": " + std::to_string(rows.size()) + " parts, 3 to 6 expected");
  }
}

void readShelf(const Database& database, const std::vector<Row>& rows, Document& document) {
  for (const Row& row : rows) {
    const std::string name = rowName(database, Table::shelf, row.id);
    requireHash(name, Table::shelf, row);
    document.parts.shelf.push_back(decodeItem(row.content, name));
  }
}

std::vector<Chunk> readChunks(const Database& database, const std::vector<Row>& rows,
                              Progress& progress) {
  constexpr std::size_t kBatch = 128;
  std::vector<Chunk> chunks(rows.size());
  for (std::size_t first = 0; first < rows.size(); first += kBatch) {
    progress.step("load", static_cast<double>(first) / static_cast<double>(rows.size()));
    parallelFor(std::min(kBatch, rows.size() - first), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = first + begin; n < first + end; ++n) {
        const std::string name = rowName(database, Table::chunks, rows[n].id);
        requireHash(name, Table::chunks, rows[n]);
        chunks[n] = decodeChunk(rows[n].content, name);
      }
    });
  }
  return chunks;
}

// Puts all runs into the tree; refuses tiles that come twice and runs that overlap.
void plant(const Database& database, std::vector<Chunk>& chunks, LoadedScene& scene) {
  std::vector<ChunkRun> runs;
  for (Chunk& chunk : chunks) {
    runs.insert(runs.end(), std::make_move_iterator(chunk.runs.begin()),
                std::make_move_iterator(chunk.runs.end()));
  }
  std::sort(runs.begin(), runs.end(),
            [](const ChunkRun& a, const ChunkRun& b) { return a.run.key < b.run.key; });
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const KeyRun& run = runs[n].run;
    if (n + 1 < runs.size() && !(run.key + Key{0, 0, run.length - 1} < runs[n + 1].run.key)) {
      throw Error(database.name() + ": chunks: runs overlap at block " +
                  toText(runs[n + 1].run.key));
    }
    scene.document.field.tree.put(run.key, run.length, std::move(runs[n].block));
  }
}

}  // namespace

fs::path journalOf(const fs::path& path) { return path.string() + "-journal"; }

void finishInterruptedSave(const fs::path& path, FileSystem& files) {
  const auto journal = files.info(journalOf(path));
  if (!journal || journal->bytes == 0) return;
  Database database = Database::forWriting(path, path.string(), files);
  database.ask("SELECT count(*) || '' FROM sqlite_schema");
}

LoadedScene readScene(const fs::path& path, Progress& progress, FileSystem& files) {
  progress.step("load", 0);
  finishInterruptedSave(path, files);
  const Bytes file = readFile(path, std::size_t{1} << 40, files);
  requireHeader(file, path.string());
  if (const auto page = firstBadPage(file)) {
    throw Error(path.string() + ": page " + std::to_string(*page) + " (bytes from " +
                std::to_string((*page - 1) * kPageBytes) + "): content does not match its check");
  }
  Database database = Database::ofImage(file, path.string());
  requireSound(database);
  requireSchema(database);
  std::array<std::vector<Row>, 3> tables;
  for (const Table table : kTables)
    tables[static_cast<std::size_t>(table)] = rowsOf(database, table);
  requireDigest(database, tables);
  LoadedScene scene;
  readParts(database, tables[0], scene.document);
  readShelf(database, tables[1], scene.document);
  std::vector<Chunk> chunks = readChunks(database, tables[2], progress);
  for (std::size_t n = 0; n < chunks.size(); ++n) {
    if (!scene.rowOfTile.emplace(chunks[n].tile, tables[2][n].id).second) {
      throw Error(rowName(database, Table::chunks, tables[2][n].id) + ": tile " +
                  toText(chunks[n].tile) + " comes twice");
    }
  }
  plant(database, chunks, scene);
  progress.step("load", 1);
  return scene;
}

}  // namespace bozzetto
