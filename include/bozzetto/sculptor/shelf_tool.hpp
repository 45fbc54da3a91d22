// A tool as people keep it: with a name, tags, a picture and what it is used for. On the shelf of a
// document, in a file of its own (.bzt, a scene with settings), or among the starters.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/scene/shelf.hpp"
#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {

struct ShelfTool {
  std::string name;
  std::vector<std::string> tags;
  Clay clay;                                 ///< none: a preset only
  std::optional<glm::dvec3> pivot, contact;  ///< as in SculptureOptions
  /// Operations that put it to use: tool, action, a stroke whose settings count and not its points.
  std::vector<Operation> preset;
  Bytes thumbnail;  ///< a PNG, or empty
};

/// The plain shape (ball, box …) that these operations put in the hand; null where it is none.
const ToolShape* plainShapeOf(const std::vector<Operation>& preset);
/// What pictures of it show: its clay, or of a preset its shape in its colour, a ball without one.
Clay likenessOf(const ShelfTool& tool);

/// Throws Error for clay that cannot be kept.
ShelfItem toItem(const ShelfTool& tool);
/// Throws Error for a payload that is no tool.
ShelfTool fromItem(const ShelfItem& item);

/// One .bzt file, whole or not at all.
void saveTool(const std::filesystem::path& path, const ShelfTool& tool);
/// Of a .bzt file; scenes that were never saved as tools have their file's name.
ShelfTool loadTool(const std::filesystem::path& path, Progress& progress = Progress::none());

/// $XDG_DATA_HOME/bozzetto/tools, or ~/.local/share/bozzetto/tools.
std::filesystem::path userToolFolder();
/// Where the user's tool of that name is, or would be. Throws Error for names that no file can have
/// there: empty ones, hidden ones, with '/' or control characters.
std::filesystem::path userToolFile(const std::string& name);

/// What the list of a shelf shows.
struct ToolEntry {
  enum class Place { document, user, starter };
  std::string name;
  std::vector<std::string> tags;
  Place place;
};

/// True when every word of the query is part of the name or of a tag, whatever the case.
bool matches(const ToolEntry& entry, std::string_view query);

/// Names and tags of the starter library.
std::vector<ToolEntry> starterTools();
/// Replays a starter's recording. Throws Error when there is none of that name.
ShelfTool makeStarter(const std::string& name, Progress& progress = Progress::none());

}  // namespace bozzetto
