#include "bozzetto/sculptor/user_tools.hpp"

#include <algorithm>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/shelf_tool.hpp"
#include "sculptor/tool_notes.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

// Scenes are tools too: what they have beside their clay stays.
void writeNamed(const fs::path& from, const fs::path& to, const ShelfTool& tool) {
  Document document = loadScene(from);
  document.parts.settings[kToolSetting] = notesOf(tool).dump();
  saveScene(to, document);
}

}  // namespace

std::vector<DamagedTool> damagedTools() {
  std::vector<DamagedTool> damaged;
  std::error_code ignored;
  for (const auto& file : fs::directory_iterator(userToolFolder(), ignored)) {
    if (file.path().extension() != ".bzt") continue;
    try {
      loadTool(file.path());
    } catch (const Error& error) {
      damaged.push_back({file.path().stem().string(), error.what()});
    }
  }
  std::ranges::sort(damaged, {}, &DamagedTool::name);
  return damaged;
}

void renameUserTool(const std::string& name, const std::string& to,
                    const std::vector<std::string>& tags) {
  const fs::path from = userToolFile(name), file = userToolFile(to);
  if (to != name && isStarter(to))
    throw Error(to + ": a starter is called so, another name expected");
  if (to != name && fs::exists(file)) throw Error(file.string() + ": exists already");
  ShelfTool tool = loadTool(from);
  tool.name = to;
  tool.tags = tags;
  writeNamed(from, file, tool);
  if (to != name) dropUserTool(name);
}

void dropUserTool(const std::string& name) {
  const fs::path file = userToolFolder() / (name + ".bzt");
  std::error_code failed;
  if (name.find('/') != name.npos || !fs::remove(file, failed))
    throw Error(file.string() + ": could not be deleted");
}

}  // namespace bozzetto
