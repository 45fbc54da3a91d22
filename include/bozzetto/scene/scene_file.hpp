// One scene in one file, an SQLite database. Its bytes are written down in src/scene/NOTES.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "bozzetto/base/file_system.hpp"
#include "bozzetto/base/progress.hpp"
#include "bozzetto/scene/document.hpp"

namespace bozzetto {

enum class SaveKind {
  whole,    ///< a new file, renamed into place
  changes,  ///< what changed, by one atomic commit into the file that is there
};

struct SaveReport {
  SaveKind kind = SaveKind::whole;
  std::size_t chunks = 0;         ///< of clay, in the file
  std::size_t chunksWritten = 0;  ///< this time
  std::size_t bytesWritten = 0;   ///< of rows, this time
  std::uintmax_t fileBytes = 0;
};

/// A document's file while somebody works on the document: remembers what the file holds, so that
/// saving again writes only what changed. Holds pointers to the saved clay's blocks. For one thread
/// at a time, which need not be the one that sculpts: documents are values, so whoever saves gets a
/// copy, which costs pointers only.
class SceneFile {
 public:
  explicit SceneFile(FileSystem& files = FileSystem::real()) : files_(&files) {}

  /// Loads, and remembers what it loaded. In parallel; the whole file passes through memory once.
  /// Throws Error, one line with file, row, found and expected, for anything that is not a sound
  /// scene: nothing is allocated from sizes that the file's own length does not bear out.
  /// Cancelled leaves this object as it was.
  Document load(const std::filesystem::path& path, Progress& progress = Progress::none());

  /// Makes the file at `path` hold the document. Where that is the file this object loaded or saved
  /// last, and nobody else has touched it, only changed parts are written, by one atomic commit;
  /// otherwise a new file is written beside it, synced and renamed into place. The first save over
  /// a file keeps that as previousVersionOf(path). Returns when the document is on the disk, safe
  /// from power cuts. On any failure (a full disk, a read-only folder) throws Error, the old file
  /// stays whole, and the next save writes a new one: a disk that failed once is not asked whether
  /// it kept the rest.
  SaveReport save(const std::filesystem::path& path, const Document& document,
                  Progress& progress = Progress::none());

 private:
  std::optional<FileInfo> stampOf(const std::filesystem::path& path) const;
  void keepPrevious(const std::filesystem::path& path, Progress& progress);
  SaveReport saveWhole(const std::filesystem::path& path, const Document& document,
                       Progress& progress);
  std::optional<SaveReport> saveChanges(const Document& document, Progress& progress);
  void remember(const std::filesystem::path& path, const Document& document);

  FileSystem* files_;
  std::filesystem::path path_, keptPreviousOf_;
  std::optional<FileInfo> stamp_;
  Document saved_;
  std::map<Key, std::int64_t> rowOfTile_;
};

/// SceneFile::load and ::save for those who do it once; no previous version is kept.
Document loadScene(const std::filesystem::path& path, Progress& progress = Progress::none(),
                   FileSystem& files = FileSystem::real());
SaveReport saveScene(const std::filesystem::path& path, const Document& document,
                     Progress& progress = Progress::none(), FileSystem& files = FileSystem::real());

/// Saves a copy under the next free number, scene.001.bzt after scene.bzt, and returns its name.
/// Never replaces a file.
std::filesystem::path saveNumberedCopy(const std::filesystem::path& path, const Document& document,
                                       Progress& progress = Progress::none(),
                                       FileSystem& files = FileSystem::real());

/// Where a document's file as it was before the first save of a session is kept: SCENE~.
std::filesystem::path previousVersionOf(const std::filesystem::path& path);

/// Reads the whole file as load does; the first fault, or nothing. Every byte of every page is
/// covered.
std::optional<std::string> checkScene(const std::filesystem::path& path,
                                      Progress& progress = Progress::none(),
                                      FileSystem& files = FileSystem::real());

}  // namespace bozzetto
