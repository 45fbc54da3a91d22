// A document that somebody works on: its file, its history and the Sculptor that changes it. What
// happens is on the disk within a second (undo-files, which are the journal too); the file itself
// changes when it is saved. Window and command line work through this.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/history/recovery.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto {

class KeptParts;

struct SessionOptions {
  HistoryLimits limits;
  SurfaceUpkeep upkeep = SurfaceUpkeep::none;
  FileSystem* files = &FileSystem::real();
};

/// What opening a document found.
struct SessionFindings {
  /// The document is not what its file holds: work that was not saved came back.
  bool recovered = false;
  std::size_t unsavedSteps = 0;
  std::int64_t time = 0;  ///< of the last step; milliseconds since 1970, 0 without
  /// Another program works on it: nothing is written here, not even by save.
  bool readOnly = false;
  std::vector<std::string> notices;  ///< damage, histories that do not belong to it
};

class Session {
 public:
  /// Opens a scene as of the last thing that happened to it, saved or not. Also where only its
  /// history is left, or its file is damaged and the history can do without. Throws Error where
  /// there is nothing to open.
  static Session open(const std::filesystem::path& scene, const SessionOptions& options = {},
                      Progress& progress = Progress::none());

  /// The same, changing nothing on the disk: to look, to copy.
  static Session look(const std::filesystem::path& scene, const SessionOptions& options = {},
                      Progress& progress = Progress::none());

  /// A new document that will be saved as `scene`. Throws Error where there is a file already; a
  /// history left there by a document that never became one is put aside. Without a name: it lives
  /// in the user's state folder ($XDG_STATE_HOME/bozzetto) until it gets one.
  static Session create(const std::filesystem::path& scene, const SessionOptions& options = {});

  /// A new document of which nothing is on the disk before it is saved: where there is no place
  /// for it.
  static Session inMemory(const SessionOptions& options = {});

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Documents without a name that were not saved when their program ended: for `open`.
  static std::vector<std::filesystem::path> leftBehind(FileSystem& files = FileSystem::real());
  /// One of these goes for good, unless somebody has it open.
  static void discardLeftBehind(const std::filesystem::path& scene,
                                FileSystem& files = FileSystem::real());

  const SessionFindings& findings() const { return findings_; }
  /// Empty: no name yet.
  std::filesystem::path path() const { return named_ ? path_ : std::filesystem::path(); }

  Sculptor& sculptor() { return sculptor_; }
  const Sculptor& sculptor() const { return sculptor_; }
  /// All but clay and solid; whoever has them changes them. But for shelf and supports, which are
  /// the sculptor's: here they stay as they were opened.
  SceneParts parts;

  /// Puts what is no step of history (shelf, settings) on the disk where it changed
  /// since the last call, so that a crash does not take it. Costs a comparison where nothing did.
  void keepParts();
  /// What keeps the disk from being up to date, for people; empty when all is well.
  std::string trouble() const;

  /// Everything to save, as it is now. Costs pointers.
  Document document() const;
  /// Whether the file holds what we have, clay and parts.
  bool saved() const;
  /// Throws Error, for people, where `save` would refuse: no name, or open elsewhere.
  void requireSavable() const;
  /// Waits until the undo-files of all that was done are on the disk, if it takes them. A file
  /// that is saved after this never runs ahead of its history.
  void settleHistory();
  /// Into the document's own file. Throws Error; the old file stays whole then.
  SaveReport save(Progress& progress = Progress::none());
  /// Under another name, where we go on; the history comes along, and stays with the old name too.
  SaveReport saveAs(const std::filesystem::path& scene, Progress& progress = Progress::none());
  /// For saves that somebody else makes of `document()`, in the background: they have succeeded.
  void markSaved(const Document& document);
  /// The same for a save under another name, where we go on then.
  void goOnAs(const std::filesystem::path& scene, const Document& document);
  /// The user wants none of what was not saved. Where there is a file the clay goes back to it, as
  /// a step of history like any other; otherwise the session ends, and nothing is left of it.
  static void discard(Session session);

  SceneFile& file() { return file_; }

 private:
  struct Opened;
  Session(std::filesystem::path path, Opened opened, const SessionOptions& options);
  static Session begin(const std::filesystem::path& scene, HistoryAccess access,
                       const SessionOptions& options, Progress& progress);

  bool untouched() const;
  SceneParts partsNow() const;
  void give(const SceneParts& parts);
  void bringHistoryTo(const std::filesystem::path& folder, const Document& document);

  std::filesystem::path path_;  // of a document without a name: where it would be
  bool named_ = true;
  SessionOptions options_;
  SessionFindings findings_;
  SceneFile file_;
  SceneParts savedParts_;
  int saves_ = 0;  // of the file, as far as it knows
  std::unique_ptr<KeptParts> kept_;
  Sculptor sculptor_;
};

/// Where a scene's undo-files are: SCENE.history, beside it.
std::filesystem::path historyFolderOf(const std::filesystem::path& scene);

/// A document for another file: with an identity of its own and no place in a history.
Document asCopy(Document document);

}  // namespace bozzetto
