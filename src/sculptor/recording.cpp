#include "bozzetto/sculptor/recording.hpp"

#include <fmt/format.h>

#include <charconv>

#include "bozzetto/base/file.hpp"
#include "sculptor/operation_json.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

constexpr int kDeepest = 8;

std::uint64_t hashFrom(JsonObject& object) {
  const std::string text = object.text("field_hash");
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (error != std::errc() || end != text.data() + text.size() || text.size() != 16)
    object.fail("field_hash", "16 hex digits");
  return hash;
}

// The first line; what it says of where the recording goes on from.
std::optional<RecordingStart> readHeader(std::string_view line, const std::string& where) {
  const Json json = parseJson(line, where);
  JsonObject object(json, where);
  if (!object.has("bozzetto") || object.text("bozzetto") != "recording") {
    object.fail("not a recording: the first line is {\"bozzetto\":\"recording\",\"version\":1}");
  }
  const int version = object.integer("version", 0);
  if (version != 1) object.fail("version " + std::to_string(version) + " found, 1 expected");
  std::optional<RecordingStart> start;
  if (object.has("from")) start = RecordingStart{object.text("from"), hashFrom(object)};
  object.done();
  return start;
}

}  // namespace

// Deep nesting is refused while it is read, before anything could recurse on it.
Json parseJson(std::string_view text, const std::string& where) {
  try {
    return Json::parse(text, [&](int depth, Json::parse_event_t, Json&) {
      if (depth > kDeepest) throw Error(where + ": nested too deeply");
      return true;
    });
  } catch (const Json::exception&) {
    throw Error(where + ": not JSON");
  }
}

Operation parseOperation(std::string_view line, const std::string& where) {
  const Json json = parseJson(line, where);
  JsonObject object(json, where);
  return operationFrom(object);
}

Recording parseRecording(std::string_view text, const std::string& name) {
  Recording recording;
  bool headerSeen = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    const std::string where = name + ":" + std::to_string(number);
    if (headerSeen) {
      recording.operations.push_back(parseOperation(line, where));
      recording.places.push_back(where + ": ");
    }
    if (!headerSeen) recording.start = readHeader(line, where);
    headerSeen = true;
  }
  if (!headerSeen) throw Error(name + ": empty, a recording expected");
  return recording;
}

Recording readRecording(const std::filesystem::path& path) {
  const Bytes bytes = readFile(path, std::size_t{1} << 30);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  Recording recording = parseRecording({text, bytes.size()}, path.string());
  recording.folder = path.parent_path();
  return recording;
}

std::string toText(const Recording& recording) {
  Json header{{"bozzetto", "recording"}, {"version", 1}};
  if (recording.start) {
    header["from"] = recording.start->scene;
    header["field_hash"] = fmt::format("{:016x}", recording.start->clay);
  }
  std::string text = header.dump() + "\n";
  for (const Operation& operation : recording.operations) text += toText(operation) + "\n";
  return text;
}

}  // namespace bozzetto
