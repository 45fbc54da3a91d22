// One scene in one file, an SQLite database. Its bytes are written down in src/scene/NOTES.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

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
/// saving again writes only what changed. Holds pointers to the saved clay's blocks.
class SceneFile {
 public:
  /// Loads, and remembers what it loaded. In parallel; the whole file passes through memory once.
  /// Throws Error, one line with file, row, found and expected, for anything that is not a sound
  /// scene: nothing is allocated from sizes that the file's own length does not bear out.
  /// Cancelled leaves this object as it was.
  Document load(const std::filesystem::path& path, Progress& progress = Progress::none());

  /// Makes the file at `path` hold the document. Where that is the file this object loaded or saved
  /// last, and nobody else has touched it, only changed parts are written, by one atomic commit;
  /// otherwise a new file is written beside it, synced and renamed into place. On any failure
  /// (a full disk, a read-only folder) throws Error and the old file stays whole.
  SaveReport save(const std::filesystem::path& path, const Document& document,
                  Progress& progress = Progress::none());

 private:
  struct FileStamp {
    std::uint64_t device = 0, node = 0;
    std::int64_t bytes = 0, seconds = 0, nanoseconds = 0;
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
  };
  static std::optional<FileStamp> stampOf(const std::filesystem::path& path);
  SaveReport saveWhole(const std::filesystem::path& path, const Document& document,
                       Progress& progress);
  SaveReport saveChanges(const Document& document, Progress& progress);
  void remember(const std::filesystem::path& path, const Document& document);

  std::filesystem::path path_;
  std::optional<FileStamp> stamp_;
  Document saved_;
  std::map<Key, std::int64_t> rowOfTile_;
};

/// SceneFile::load and ::save for those who do it once.
Document loadScene(const std::filesystem::path& path, Progress& progress = Progress::none());
SaveReport saveScene(const std::filesystem::path& path, const Document& document,
                     Progress& progress = Progress::none());

/// Reads the whole file as load does; the first fault, or nothing. Every byte of every page is
/// covered.
std::optional<std::string> checkScene(const std::filesystem::path& path,
                                      Progress& progress = Progress::none());

}  // namespace bozzetto
