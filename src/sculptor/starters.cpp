// Starters are made when they are asked for: their recordings are replayed.
#include "sculptor/starters.hpp"

#include <algorithm>

#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/sculptor/shelf_tool.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

std::string_view fileNamed(const std::string& name) {
  const auto files = starterFiles();
  const auto file = std::ranges::find(files, name, &StarterFile::name);
  if (file == files.end()) throw Error("starter tools: " + name + " is missing");
  return file->text;
}

struct Starter {
  ShelfTool notes;
  std::string recording;  // file
  std::string character;  // that stands for the recording's "?"; empty: none
};

// tools.json: a list of notes. "file" names the recording where it is not NAME.jsonl; "each" makes
// a tool of every character in it, called NAME CHARACTER.
void readStarter(Json entry, std::vector<Starter>& starters) {
  const std::string each = entry.value("each", "");
  const std::string name = entry.value("name", "");
  Starter starter;
  starter.recording = entry.value("file", name + ".jsonl");
  entry.erase("each");
  entry.erase("file");
  readNotes(entry, "tools.json: " + name, starter.notes);
  if (each.empty()) starters.push_back(starter);
  for (const char character : each) {
    starter.character = character;
    starter.notes.name = name + " " + character;
    starters.push_back(starter);
  }
}

const std::vector<Starter>& starters() {
  static const std::vector<Starter> all = [] {
    std::vector<Starter> read;
    for (const Json& entry : parseJson(fileNamed("tools.json"), "tools.json"))
      readStarter(entry, read);
    return read;
  }();
  return all;
}

std::string recordingOf(const Starter& starter) {
  std::string text(fileNamed(starter.recording));
  if (starter.character.empty()) return text;
  const std::string mark = "\"text\":\"?\"";
  const std::size_t at = text.find(mark);
  if (at != text.npos) text.replace(at, mark.size(), "\"text\":\"" + starter.character + "\"");
  return text;
}

}  // namespace

std::vector<ToolEntry> starterTools() {
  std::vector<ToolEntry> entries;
  for (const Starter& starter : starters())
    entries.push_back({starter.notes.name, starter.notes.tags, ToolEntry::Place::starter});
  return entries;
}

bool isStarter(const std::string& name) {
  return std::ranges::any_of(starters(),
                             [&](const Starter& each) { return each.notes.name == name; });
}

ShelfTool makeStarter(const std::string& name, Progress& progress) {
  const auto& all = starters();
  const auto found =
      std::ranges::find(all, name, [](const Starter& each) { return each.notes.name; });
  if (found == all.end()) throw Error("no starter tool is called '" + name.substr(0, 40) + "'");
  const Recording recording = parseRecording(recordingOf(*found), found->recording);
  ShelfTool tool = found->notes;
  tool.clay = replay(recording, {}, {}, progress).field;
  return tool;
}

}  // namespace bozzetto
