// The tables of a scene file. NOTES.md describes them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/hash.hpp"

namespace bozzetto {

inline constexpr std::uint32_t kApplicationId = 0x425a5a31;  // "BZZ1"
inline constexpr std::uint32_t kFormatVersion = 1;

enum class Table : std::uint8_t { parts = 0, shelf = 1, chunks = 2 };
inline constexpr std::array<Table, 3> kTables{Table::parts, Table::shelf, Table::chunks};

/// Table name and the statement that made it, as SQLite keeps it.
struct TableText {
  std::string_view name;
  const char* create;
};
inline constexpr std::array<TableText, 4> kTableTexts{{
    {"parts",
     "CREATE TABLE parts(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL, content BLOB NOT NULL)"},
    {"shelf",
     "CREATE TABLE shelf(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL, content BLOB NOT NULL)"},
    {"chunks",
     "CREATE TABLE chunks(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL, content BLOB NOT NULL)"},
    {"digest", "CREATE TABLE digest(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL)"},
}};
constexpr std::string_view nameOf(Table table) {
  return kTableTexts[static_cast<std::size_t>(table)].name;
}

/// Rows of table parts.
enum class Part : std::int64_t {
  head = 1,
  view = 2,
  thumbnail = 3,
  solid = 4,
  supports = 5,
  stiffness = 6
};
inline constexpr std::int64_t kLastPart = 6;

/// What stands in column hash: over table, id and content, so that exchanged rows show.
inline std::int64_t rowHash(Table table, std::int64_t id, std::span<const std::byte> content) {
  ByteWriter place;
  place.put(static_cast<std::uint8_t>(table));
  place.put(id);
  Hasher hasher;
  hasher.add(content);
  hasher.add(place.bytes());
  return static_cast<std::int64_t>(hasher.result());
}

}  // namespace bozzetto
