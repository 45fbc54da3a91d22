// Shelf and settings between saves. Steps of history have undo-files; these have one
// scene without clay, beside them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/base/file_system.hpp"
#include "bozzetto/scene/document.hpp"

namespace bozzetto {

class KeptParts {
 public:
  /// Nothing is kept without a folder.
  explicit KeptParts(FileSystem& files) : files_(&files) {}

  /// What was kept of this scene since its file was saved for the `saves`-th time; whatever there
  /// is when the file is lost. Damage is told in `notices`.
  static std::optional<SceneParts> find(const std::filesystem::path& folder,
                                        const SceneIdentity& scene, std::optional<int> saves,
                                        FileSystem& files, std::vector<std::string>& notices);

  /// These are on the disk already, here or in the scene's file.
  void begin(SceneParts parts) { parts_ = std::move(parts); }
  /// Returns when they are on the disk; at once where nothing changed. Never throws: what went
  /// wrong is told by `trouble`, and tried again by the next call.
  void keep(const std::filesystem::path& folder, const SceneParts& parts, int saves);
  /// The scene's file holds these.
  void drop(const std::filesystem::path& folder, SceneParts parts);

  const std::string& trouble() const { return trouble_; }

 private:
  FileSystem* files_;
  SceneParts parts_;
  std::string trouble_;
};

/// How often a document's file was saved: taken out of its settings; 0 when it does not say.
int takeSaves(SceneParts& parts);
void putSaves(SceneParts& parts, int saves);

}  // namespace bozzetto
