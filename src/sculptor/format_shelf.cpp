// What is done to the document's shelf, in JSON.
#include "sculptor/operation_format.hpp"
#include "sculptor/operation_json.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kLongestTag = 255;  // bytes; as scene files have it

// Of a tool to be; others are on the shelf or not.
std::string readName(JsonObject& object, const char* key) {
  std::string name = object.text(key);
  object.checked([&] { requireToolName(name); });
  return name;
}

std::vector<std::string> readTags(JsonObject& object) {
  std::vector<std::string> tags;
  const Json& list = object.required("tags");
  if (!list.is_array() || list.size() > 255) object.fail("tags", "a list of up to 255 words");
  for (const Json& tag : list) {
    if (!tag.is_string()) object.fail("tags", "a list of words");
    tags.push_back(tag.get<std::string>());
    if (tags.back().size() > kLongestTag) object.fail("tags", "words of up to 255 bytes");
  }
  return tags;
}

ShelfKeepOperation readKeep(JsonObject& object) {
  ShelfKeepOperation keep;
  keep.name = readName(object, "name");
  if (object.has("tags")) keep.tags = readTags(object);
  keep.source = readSource(object, "from");
  if (!object.has("preset")) return keep;
  const Json& list = object.required("preset");
  if (!list.is_array() || list.empty()) object.fail("preset", "a list of operations");
  for (const Json& line : list)
    keep.preset.push_back(toText(presetOperation(line, object.where(), keep.preset.size())));
  return keep;
}

Json writeKeep(const ShelfKeepOperation& keep) {
  Json json{{"name", keep.name}};
  if (!keep.tags.empty()) json["tags"] = keep.tags;
  writeSource(keep.source, "from", json);
  for (const std::string& line : keep.preset) json["preset"].push_back(Json::parse(line));
  return json;
}

ShelfRenameOperation readRename(JsonObject& object) {
  ShelfRenameOperation rename{object.text("name"), readName(object, "to")};
  if (object.has("tags")) rename.tags = readTags(object);
  return rename;
}

Json writeRename(const ShelfRenameOperation& rename) {
  Json json{{"name", rename.name}, {"to", rename.to}};
  if (rename.tags) json["tags"] = *rename.tags;
  return json;
}

ShelfDropOperation readDrop(JsonObject& object) { return {object.text("name")}; }
Json writeDrop(const ShelfDropOperation& drop) { return {{"name", drop.name}}; }

}  // namespace

std::span<const OperationFormat> shelfFormats() {
  static constexpr OperationFormat kFormats[] = {formatOf<readKeep, writeKeep>("shelf_keep"),
                                                 formatOf<readRename, writeRename>("shelf_rename"),
                                                 formatOf<readDrop, writeDrop>("shelf_drop")};
  return kFormats;
}

}  // namespace bozzetto
