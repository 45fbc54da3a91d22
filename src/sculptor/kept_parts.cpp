#include "sculptor/kept_parts.hpp"

#include <charconv>

#include "bozzetto/scene/scene_file.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "parts.bzt";
constexpr const char* kSavesSetting = "saves";

}  // namespace

int takeSaves(SceneParts& parts) {
  int saves = 0;
  const auto setting = parts.settings.find(kSavesSetting);
  if (setting == parts.settings.end()) return saves;
  const std::string& text = setting->second;
  std::from_chars(text.data(), text.data() + text.size(), saves);
  parts.settings.erase(setting);
  return saves;
}

void putSaves(SceneParts& parts, int saves) {
  parts.settings[kSavesSetting] = std::to_string(saves);
}

std::optional<SceneParts> KeptParts::find(const fs::path& folder, const SceneIdentity& scene,
                                          std::optional<int> saves, FileSystem& files,
                                          std::vector<std::string>& notices) {
  const fs::path path = folder / kFile;
  if (!files.info(path)) return std::nullopt;
  try {
    SceneParts parts = loadScene(path, Progress::none(), files).parts;
    const int base = takeSaves(parts);
    if (parts.identity == scene && base == saves.value_or(base)) return parts;
  } catch (const Error& error) {
    notices.push_back(error.what());
  }
  return std::nullopt;
}

void KeptParts::keep(const fs::path& folder, const SceneParts& parts, int saves) {
  if (parts == parts_ || folder.empty()) return;
  Document document{{}, parts};
  putSaves(document.parts, saves);
  try {
    saveScene(folder / kFile, document, Progress::none(), *files_);
    parts_ = parts;
    trouble_.clear();
  } catch (const Error& error) {
    trouble_ = error.what();
  }
}

void KeptParts::drop(const fs::path& folder, SceneParts parts) {
  parts_ = std::move(parts);
  trouble_.clear();
  if (folder.empty()) return;
  try {
    files_->remove(folder / kFile);
  } catch (const Error&) {  // an old one is not taken for a new one
  }
}

}  // namespace bozzetto
