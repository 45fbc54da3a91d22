#pragma once
#include <map>

#include "bozzetto/scene/scene_file.hpp"
#include "scene/database.hpp"

namespace bozzetto {

struct TileChanges {
  std::vector<Key> written;  ///< tiles to write from the document's tree; no run left: erase
  bool parts = true;         ///< whether anything but clay is to be written
};

/// Writes the changes of a document into an open database, one transaction. `rows` is brought up to
/// date. Throws Error or Cancelled with nothing written.
SaveReport writeScene(Database& database, const Document& document, const TileChanges& changes,
                      std::map<Key, std::int64_t>& rows, Progress& progress);

/// Makes the tables in an empty database.
void makeTables(Database& database);

}  // namespace bozzetto
