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

/// Whether a preset may hold it: tool, action, stroke, clay.
bool isOfPreset(const Operation& operation);
/// Throws Error for others, and for actions that need a history.
void requireOfPreset(const Operation& operation);

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
/// Throws Error for names that no shelf takes: empty ones, of more than 255 bytes, with blanks at
/// their ends, control characters, or other than UTF-8.
void requireToolName(const std::string& name);
/// Where the user's tool of that name is, or would be. Throws Error for those and for names that no
/// file can have there: hidden ones, with '/', of more than 251 bytes.
std::filesystem::path userToolFile(const std::string& name);

/// What the list of a shelf shows.
struct ToolEntry {
  enum class Place { document, user, starter };
  std::string name;
  std::vector<std::string> tags;
  Place place;
};

/// True when every word of the query begins a word of the name or of a tag, whatever the case.
bool matches(const ToolEntry& entry, std::string_view query);

/// Names and tags of the starter library.
std::vector<ToolEntry> starterTools();
/// Whether one is called so: a tool of the user's would take its place in recordings that say
/// `shelf:NAME`. Whoever makes one asks first.
bool isStarter(const std::string& name);
/// Replays a starter's recording. Throws Error when there is none of that name.
ShelfTool makeStarter(const std::string& name, Progress& progress = Progress::none());

}  // namespace bozzetto
