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

constexpr std::uint32_t kLongestNotes = 1 << 20;
constexpr std::size_t kLongestName = 255;  // bytes: of shelf items, and of files

}  // namespace

bool isOfPreset(const Operation& operation) {
  return std::holds_alternative<ToolOperation>(operation) ||
         std::holds_alternative<ActionOperation>(operation) ||
         std::holds_alternative<StrokeOperation>(operation) ||
         std::holds_alternative<ClayOperation>(operation);
}

void requireOfPreset(const Operation& operation) {
  if (!isOfPreset(operation))
    throw Error(std::string(nameOf(operation)) + " found, tool, action, stroke or clay expected");
  const auto* doing = std::get_if<ActionOperation>(&operation);
  if (doing != nullptr && doing->recall)
    throw Error("action recall found, one that every document can do expected");
}

Operation presetOperation(const Json& json, const std::string& where, std::size_t n) {
  JsonObject object(json, where + ": operation " + std::to_string(n + 1) + " of the preset");
  Operation operation = operationFrom(object);
  object.checked([&] { requireOfPreset(operation); });
  return operation;
}

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
    const Json& lines = notes.required("preset");
    if (!lines.is_array() || lines.empty()) notes.fail("preset", "a list of operations");
    for (const Json& line : lines)
      tool.preset.push_back(presetOperation(line, where, tool.preset.size()));
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
  document.parts.settings[kToolSetting] = notesOf(tool).dump();
  document.parts.thumbnail = tool.thumbnail;
  saveScene(path, document);
}

ShelfTool loadTool(const std::filesystem::path& path, Progress& progress) {
  const Document document = loadScene(path, progress);
  ShelfTool tool;
  tool.name = path.stem().string();
  tool.clay = document.field;
  tool.thumbnail = document.parts.thumbnail;
  const auto notes = document.parts.settings.find(kToolSetting);
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

void requireToolName(const std::string& name) {
  const std::string expected = " found, 1 to 255 bytes expected";
  if (name.empty() || name.size() > kLongestName)
    throw Error("tool name: " + std::to_string(name.size()) + " bytes" + expected);
  if (!isOneLine(name)) throw Error("tool name: found other than one line of UTF-8, that expected");
  if (name.front() == ' ' || name.back() == ' ')
    throw Error("tool name: '" + name + "' found, one without blanks at its ends expected");
}

std::filesystem::path userToolFile(const std::string& name) {
  constexpr std::string_view kEnd = ".bzt";
  requireToolName(name);
  if (name.front() == '.' || name.find('/') != name.npos)
    throw Error("tool name: '" + name + "' found, a name that files can have expected");
  if (name.size() + kEnd.size() > kLongestName)
    throw Error("tool name: " + std::to_string(name.size()) +
                " bytes found, at most 251 expected: files' names hold no more");
  return userToolFolder() / (name + ".bzt");
}

bool matches(const ToolEntry& entry, std::string_view query) {
  const auto begins = [](const std::string& text, std::string_view word) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
      if (at == 0 || text[at - 1] == ' ' || text[at - 1] == '_' || text[at - 1] == '-') return true;
    return false;
  };
  std::vector<std::string> all{lower(entry.name)};
  for (const std::string& tag : entry.tags) all.push_back(lower(tag));
  const std::string words = lower(query);
  for (std::size_t at = words.find_first_not_of(' '); at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string_view word = std::string_view(words).substr(at, end - at);
    if (std::ranges::none_of(all, [&](const std::string& text) { return begins(text, word); }))
      return false;
    at = words.find_first_not_of(' ', end);
  }
  return true;
}

}  // namespace bozzetto
