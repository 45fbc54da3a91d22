// Where names of tools lead: the document's shelf, the user's folder, the starters, files.
#pragma once
#include <map>
#include <memory>

#include "bozzetto/sculptor/shelf_tool.hpp"

namespace bozzetto {

class ToolLibrary {
 public:
  std::filesystem::path folder;  ///< relative paths start here
  std::vector<ShelfItem> shelf;  ///< the document's

  /// Everything at hand that matches, the document's first, by name within a place.
  std::vector<ToolEntry> list(std::string_view query = {}) const;

  /// By name: the document's shelf, then the user's folder, then the starters. Throws Error that
  /// says where it looked.
  ShelfTool find(const std::string& name, Progress& progress = Progress::none()) const;

  /// The sculpture that a source means. Kept, so that the same source costs nothing the second
  /// time. Throws Error for what cannot be read or holds no clay.
  std::shared_ptr<const Sculpture> sculpture(const ToolSource& source,
                                             Progress& progress = Progress::none());

  /// What a source means, whole, with what is written down about it; not kept.
  ShelfTool load(const ToolSource& source, Progress& progress = Progress::none()) const;

  /// Reads every source again: names mean other tools than before.
  void forget();

  /// Recordings that make tools from recordings that make tools …
  int depth = 0;

 private:
  const ShelfTool& shelfTool(const ToolSource& source, Progress& progress);

  std::map<std::string, ShelfTool> read_;  // from shelves, by name
  std::map<std::string, std::shared_ptr<const Sculpture>> kept_;
};

/// The corners in a region's box.
KeyBox cornersIn(const WorldRegion& region, double spacing);

/// Of clay, what the source says of region, patch, pivot and contact.
std::shared_ptr<const Sculpture> sculptureOf(const ShelfTool& tool, const ToolSource& source);
/// The same as a tool to be kept.
ShelfTool shapedBy(const ToolSource& source, ShelfTool tool);

}  // namespace bozzetto
