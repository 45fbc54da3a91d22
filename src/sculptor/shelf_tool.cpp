#include "bozzetto/sculptor/shelf_tool.hpp"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>

#include "bozzetto/base/text.hpp"
#include "bozzetto/scene/clay_bytes.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/tool/fill.hpp"
#include "sculptor/operation_format.hpp"
#include "sculptor/operation_json.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

constexpr const char* kSetting = "tool";
constexpr std::uint32_t kLongestNotes = 1 << 20;

}  // namespace

// Everything but name, tags of shelf items, clay and thumbnail.
Json notesOf(const ShelfTool& tool) {
  Json notes = Json::object();
  notes["name"] = tool.name;
  notes["tags"] = tool.tags;
  if (tool.pivot) notes["pivot"] = listOf(*tool.pivot);
  if (tool.contact) notes["contact"] = listOf(*tool.contact);
  for (const Operation& operation : tool.preset) notes["preset"].push_back(toJson(operation));
  return notes;
}

void readNotes(const Json& json, const std::string& where, ShelfTool& tool) {
  JsonObject notes(json, where);
  tool.name = notes.text("name", tool.name);
  if (notes.has("tags")) {
    tool.tags.clear();
    for (const Json& tag : notes.required("tags")) {
      if (!tag.is_string()) notes.fail("tags", "a list of texts");
      tool.tags.push_back(tag.get<std::string>());
    }
  }
  if (notes.has("pivot")) tool.pivot = readVector(notes, "pivot", {});
  if (notes.has("contact")) tool.contact = readVector(notes, "contact", {});
  if (notes.has("preset")) {
    for (const Json& line : notes.required("preset")) {
      JsonObject operation(line, where + ": preset");
      tool.preset.push_back(operationFrom(operation));
    }
  }
  notes.done();
}

namespace {

void readNotesText(std::string_view text, const std::string& where, ShelfTool& tool) {
  readNotes(parseJson(text, where), where, tool);
}

}  // namespace

const ToolShape* plainShapeOf(const std::vector<Operation>& preset) {
  const ToolShape* shape = nullptr;
  for (const Operation& operation : preset)
    if (const auto* tool = std::get_if<ToolOperation>(&operation)) shape = &tool->shape;
  return shape != nullptr && shape->shape != Shape::freeform ? shape : nullptr;
}

Clay likenessOf(const ShelfTool& tool) {
  if (!tool.clay.tree.empty()) return tool.clay;
  constexpr double kCells = 24;
  Primitive body;
  if (const ToolShape* shape = plainShapeOf(tool.preset)) {
    body.shape = shape->shape;
    body.radii = shape->radii;
    body.rotation = shape->rotation;
  }
  body.radii *= kCells / std::max({body.radii.x, body.radii.y, body.radii.z});
  body.radii = glm::max(body.radii, 1.0);
  for (const Operation& operation : tool.preset)
    if (const auto* doing = std::get_if<ActionOperation>(&operation))
      body.colour = doing->action.colour;
  Clay clay;
  Edit<CornerBlock<8>> edit(clay.tree);
  fill<8>(edit, clay.scale, body);
  edit.commit();
  return clay;
}

ShelfItem toItem(const ShelfTool& tool) {
  const std::string notes = notesOf(tool).dump();
  ByteWriter out;
  out.put(static_cast<std::uint32_t>(notes.size()));
  out.put(std::string_view(notes));
  if (!tool.clay.tree.empty()) out.put(encodeClay(tool.clay));
  return {tool.name, tool.tags, out.take(), tool.thumbnail};
}

ShelfTool fromItem(const ShelfItem& item) {
  ShelfTool tool;
  const std::string where = "tool " + item.name;
  ByteReader in(item.payload, where);
  const auto size = in.get<std::uint32_t>();
  if (size > kLongestNotes) throw Error(where + ": notes of " + std::to_string(size) + " bytes");
  const auto notes = in.take(size);
  readNotesText({reinterpret_cast<const char*>(notes.data()), notes.size()}, where, tool);
  if (in.remaining() > 0) tool.clay = decodeClay(in.take(in.remaining()), where);
  tool.name = item.name;
  tool.tags = item.tags;
  tool.thumbnail = item.thumbnail;
  return tool;
}

void saveTool(const std::filesystem::path& path, const ShelfTool& tool) {
  Document document;
  document.field = tool.clay;
  document.parts.settings[kSetting] = notesOf(tool).dump();
  document.parts.thumbnail = tool.thumbnail;
  saveScene(path, document);
}

ShelfTool loadTool(const std::filesystem::path& path, Progress& progress) {
  const Document document = loadScene(path, progress);
  ShelfTool tool;
  tool.name = path.stem().string();
  tool.clay = document.field;
  tool.thumbnail = document.parts.thumbnail;
  const auto notes = document.parts.settings.find(kSetting);
  if (notes != document.parts.settings.end()) readNotesText(notes->second, path.string(), tool);
  return tool;
}

std::filesystem::path userToolFolder() {
  const auto setting = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  const std::filesystem::path data = setting("XDG_DATA_HOME");
  return (data.is_absolute() ? data : setting("HOME") / ".local/share") / "bozzetto/tools";
}

std::filesystem::path userToolFile(const std::string& name) {
  const auto unfit = [](char c) { return c == '/' || c == 127 || (c >= 0 && c < ' '); };
  if (name.empty() || name.front() == '.' || std::any_of(name.begin(), name.end(), unfit))
    throw Error("'" + name + "': a name that files can have expected");
  return userToolFolder() / (name + ".bzt");
}

bool matches(const ToolEntry& entry, std::string_view query) {
  std::string all = entry.name;
  for (const std::string& tag : entry.tags) all += "\n" + tag;
  all = lower(all);
  const std::string words = lower(query);
  for (std::size_t at = words.find_first_not_of(' '); at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (all.find(words.substr(at, end - at)) == all.npos) return false;
    at = words.find_first_not_of(' ', end);
  }
  return true;
}

}  // namespace bozzetto
