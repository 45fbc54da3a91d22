// Damaged and hostile files. Damage: any byte. Hostile: files with all checks right and content
// that no save of ours would write.
#include <gtest/gtest.h>
#include <zstd.h>

#include <fstream>
#include <functional>

#include "bozzetto/base/file.hpp"
#include "scene/chunk_codec.hpp"
#include "scene/crash_disk.hpp"
#include "scene/database.hpp"
#include "scene/layout.hpp"
#include "scene/page_check.hpp"

namespace bozzetto {
namespace {

using testing::CrashFileSystem;
using testing::Folder;
using testing::kScene;
using testing::sampleDocument;

// Without waiting for the disk.
void put(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

// Sanitizers are slow: they see every 16th.
#ifdef BOZZETTO_SANITIZED
constexpr std::size_t kStride = 16;
#else
constexpr std::size_t kStride = 1;
#endif

// A small scene's file on a disk in memory, to be damaged in every way.
class EveryDamage : public ::testing::Test {
 protected:
  EveryDamage() {
    CrashFileSystem disk;
    disk.addFolder("/disk");
    saveScene(kScene, testing::smallDocument(), Progress::none(), disk);
    good_ = disk.content(kScene);
    disk_.addFolder("/disk");
  }
  bool isSeen(Bytes bytes) {
    disk_.setContent(kScene, std::move(bytes));
    return checkScene(kScene, Progress::none(), disk_).has_value();
  }
  CrashFileSystem disk_;
  Bytes good_;
};

TEST_F(EveryDamage, anyFlippedByteIsSeen) {
  ASSERT_FALSE(isSeen(good_));
  for (std::size_t at = 0; at < good_.size(); at += kStride) {
    Bytes bad = good_;
    bad[at] ^= std::byte(1u << at % 8);
    ASSERT_TRUE(isSeen(std::move(bad))) << "byte " << at;
  }
}

TEST_F(EveryDamage, anyLengthButTheRightOneIsSeen) {
  for (std::size_t size = 0; size < good_.size() + 2 * kPageBytes; size += kStride) {
    Bytes bad = good_;
    bad.resize(size);
    ASSERT_EQ(isSeen(std::move(bad)), size != good_.size()) << size << " bytes";
  }
}

TEST(Damage, exchangedPagesAreSeen) {
  const Folder folder;
  saveScene(folder / "a.bzt", sampleDocument());
  Bytes bytes = readFile(folder / "a.bzt");
  const auto page = bytes.begin() + 3 * kPageBytes;
  std::swap_ranges(page, page + kPageBytes, page + kPageBytes);
  put(folder / "a.bzt", bytes);
  EXPECT_TRUE(checkScene(folder / "a.bzt").has_value());
}

// Every single change of the chunk's bytes is refused or gives another valid chunk.
TEST(Damage, chunkDecoderStandsAnyBytes) {
  const Document document = sampleDocument();
  Chunk chunk{{0, 0, 0}, {}};
  for (const auto& [key, run] : document.field.tree) {
    if (tileOf(key) == chunk.tile) chunk.runs.push_back({{key, run.length}, run.block});
  }
  const Bytes good = encodeChunk(chunk);
  ASSERT_EQ(decodeChunk(good, "chunk").runs.size(), chunk.runs.size());
  for (std::size_t at = 0; at < good.size(); at += at < 64 ? 1 : 37) {
    Bytes bad = good;
    bad[at] ^= std::byte(1u << at % 8);
    try {
      for (const ChunkRun& run : decodeChunk(bad, "chunk").runs) ASSERT_TRUE(run.block);
    } catch (const Error&) {
    }
  }
  for (std::size_t size = 0; size < good.size(); size += 11) {
    EXPECT_THROW(decodeChunk(std::span(good).first(size), "chunk"), Error) << size;
  }
}

// A chunk whose raw bytes are given, compressed as ours are.
Bytes chunkOf(const Bytes& raw, std::optional<std::uint32_t> claimed = {}) {
  ByteWriter out;
  for (int n = 0; n < 3; ++n) out.put(std::int32_t{0});
  out.put(claimed.value_or(static_cast<std::uint32_t>(raw.size())));
  Bytes frame(ZSTD_compressBound(raw.size()));
  frame.resize(ZSTD_compress(frame.data(), frame.size(), raw.data(), raw.size(), 1));
  out.put(std::span<const std::byte>(frame));
  return out.take();
}

struct UniformRun {
  std::uint16_t place;
  std::int32_t length;
  float value;
};

Bytes rawUniform(const std::vector<UniformRun>& runs) {
  ByteWriter raw;
  raw.put(static_cast<std::uint32_t>(runs.size()));
  for (const UniformRun& run : runs) {
    raw.put(run.place);
    raw.put(std::uint8_t{1});
    raw.put(run.length);
    raw.put(run.value);
    raw.put(std::uint32_t{0x123456});
  }
  raw.put(std::uint32_t{0});
  raw.put(std::uint32_t{0});
  return raw.take();
}

TEST(Hostile, chunks) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(decodeChunk(chunkOf(rawUniform({{0, 3, 1.0f}, {9, 1, 0.5f}})), "c").runs.size(), 2u);
  const std::vector<std::pair<const char*, Bytes>> bad{
      {"no runs", chunkOf(rawUniform({}))},
      {"order", chunkOf(rawUniform({{5, 1, 1.0f}, {4, 1, 1.0f}}))},
      {"twice", chunkOf(rawUniform({{5, 1, 1.0f}, {5, 1, 1.0f}}))},
      {"place", chunkOf(rawUniform({{512, 1, 1.0f}}))},
      {"length 0", chunkOf(rawUniform({{0, 0, 1.0f}}))},
      {"length < 0", chunkOf(rawUniform({{0, -5, 1.0f}}))},
      {"beyond the rim", chunkOf(rawUniform({{0, 1 << 29, 1.0f}}))},
      {"NaN", chunkOf(rawUniform({{0, 1, nan}}))},
      {"negative", chunkOf(rawUniform({{0, 1, -1.0f}}))},
      {"zero", chunkOf(rawUniform({{0, 1, 0.0f}}))},
      {"infinite", chunkOf(rawUniform({{0, 1, std::numeric_limits<float>::infinity()}}))},
      {"2048", chunkOf(rawUniform({{0, 1, 2048.0f}}))},
      {"nothing", chunkOf({})},
      {"bomb", chunkOf(Bytes(std::size_t{64} << 20))},
      {"claims less than the bomb", chunkOf(Bytes(std::size_t{64} << 20), 1000)},
      {"claims much", chunkOf(rawUniform({{0, 1, 1.0f}}), 0xffffffff)},
  };
  for (const auto& [what, bytes] : bad) EXPECT_THROW(decodeChunk(bytes, "c"), Error) << what;
  ByteWriter many;
  many.put(0xffffffffu);
  EXPECT_THROW(decodeChunk(chunkOf(many.take()), "c"), Error);
}

// A sound scene, changed by SQL through the layer that keeps the page checks right.
std::optional<std::string> faultAfter(const std::function<void(Database&)>& change) {
  const Folder folder;
  saveScene(folder / "a.bzt", sampleDocument());
  {
    Database database = Database::forWriting(folder / "a.bzt", "a.bzt");
    change(database);
  }
  return checkScene(folder / "a.bzt");
}

std::optional<std::string> faultAfter(const char* sql) {
  return faultAfter([&](Database& database) { database.run(sql); });
}

// With the digest and row hashes made right again.
void putRow(Database& database, Table table, std::int64_t id, const Bytes& content) {
  Statement put(database,
                ("REPLACE INTO " + std::string(nameOf(table)) + " VALUES(?,?,?)").c_str());
  put.bind(0, id).bind(1, rowHash(table, id, content)).bind(2, content).run();
  ByteWriter list;
  for (const Table each : kTables) {
    Statement rows(database, ("SELECT id, hash FROM " + std::string(nameOf(each))).c_str());
    while (rows.step()) {
      list.put(static_cast<std::uint8_t>(each));
      list.put(rows.number(0));
      list.put(rows.number(1));
    }
  }
  Statement digest(database, "REPLACE INTO digest VALUES(1, ?)");
  digest.bind(0, static_cast<std::int64_t>(hash64(list.bytes()))).run();
}

TEST(Hostile, databases) {
  EXPECT_EQ(faultAfter("SELECT 1"), std::nullopt);
  for (const char* sql : {
           "DELETE FROM chunks WHERE id = 2",
           "UPDATE chunks SET content = zeroblob(100) WHERE id = 2",
           "UPDATE chunks SET hash = hash + 1 WHERE id = 2",
           "UPDATE chunks SET hash = 'text' WHERE id = 2",
           "UPDATE chunks SET content = 'text' WHERE id = 2",
           "UPDATE chunks SET id = 1000 WHERE id = 2",
           "DELETE FROM digest",
           "UPDATE digest SET hash = 0",
           "DELETE FROM parts",
           "DELETE FROM shelf WHERE id = 1",
           "DROP TABLE shelf",
           "CREATE TABLE more(id)",
           "CREATE INDEX i ON chunks(hash)",
           "CREATE VIEW v AS SELECT * FROM chunks",
           "CREATE TRIGGER t AFTER INSERT ON chunks BEGIN DELETE FROM parts; END",
           "PRAGMA user_version = 2",
           "PRAGMA application_id = 7",
           "PRAGMA writable_schema=ON; UPDATE sqlite_schema SET sql = 'CREATE TABLE shelf(x)' "
           "WHERE name = 'shelf'",
       }) {
    EXPECT_TRUE(faultAfter(sql).has_value()) << sql;
  }
}

TEST(Hostile, rowsWithRightHashes) {
  const auto fault = [](Table table, std::int64_t id, const Bytes& content) {
    return faultAfter([&](Database& database) { putRow(database, table, id, content); });
  };
  const Bytes good = chunkOf(rawUniform({{0, 3, 1.0f}}));
  EXPECT_TRUE(fault(Table::chunks, 999, good).has_value()) << "tile comes twice";
  EXPECT_TRUE(fault(Table::chunks, 1, {}).has_value()) << "empty";
  EXPECT_TRUE(fault(Table::chunks, 1, chunkOf(rawUniform({{63, 100, 1.0f}}))).has_value())
      << "overlap with another tile";
  for (std::int64_t id = 1; id <= 4; ++id) {
    EXPECT_TRUE(fault(Table::parts, id, Bytes(7)).has_value()) << id;
    EXPECT_TRUE(fault(Table::parts, id, Bytes(100000, std::byte{0xff})).has_value()) << id;
  }
  EXPECT_TRUE(fault(Table::shelf, 1, Bytes(100, std::byte{0xff})).has_value());
}

TEST(Hostile, errorsAreOneLineWithFileAndRow) {
  const auto fault = faultAfter("UPDATE chunks SET content = zeroblob(100) WHERE id = 2");
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->find('\n'), std::string::npos);
  EXPECT_NE(fault->find("a.bzt: chunks row 2: "), std::string::npos) << *fault;
}

}  // namespace
}  // namespace bozzetto
