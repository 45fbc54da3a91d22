// Opening a document's history, and with it the document as of the last thing that happened to it:
// what was not saved when the program ended, whyever it did, comes back.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/history/history.hpp"

namespace bozzetto {

/// Where undo-files live.
struct HistoryFolder {
  std::filesystem::path path;
  HistoryIdentity identity{};
  FileSystem* files = &FileSystem::real();
};

enum class HistoryAccess {
  write,  ///< makes the folder and locks it; nobody else writes meanwhile
  read    ///< looks, and changes nothing on the disk
};

/// The scene's file as it was read.
template <int Side>
struct SavedScene {
  Field<Side> field;
  HistoryPlace place;  ///< what it remembers
  Beside beside{};     ///< the clay
};

/// The place of a scene's file that remembers none.
inline constexpr HistoryPlace kUnknownPlace{0, 0, 1, 0};

template <int Side>
struct OpenedHistory {
  History<Side> history;
  Field<Side> field;  ///< as of the last durable step or move; the history knows what is beside it
  /// Somebody else has the document: nothing that happens now is written.
  bool readOnly = false;
  /// Whether `field` is not what the scene's file holds, and how many steps lie between.
  bool recovered = false;
  std::size_t unsavedSteps = 0;
  std::int64_t time = 0;  ///< of the step that led here; milliseconds since 1970, 0 without
  std::vector<std::string> notices;  ///< damage that was found, histories that were ignored
};

/// Reads the folder and goes from the nearest sound state (the saved scene, a checkpoint, an empty
/// document) over the undo-files to the last state that can be reached. Damaged and missing files
/// cut the history there and are told in `notices`; nothing on the disk is changed by that, so
/// opening again finds the same. Throws FileError when the folder cannot be read or, for writing,
/// made. O(undo-files) and the blocks on the way.
template <int Side>
OpenedHistory<Side> openHistory(const HistoryFolder& where,
                                const std::optional<SavedScene<Side>>& saved, HistoryAccess access,
                                const HistoryLimits& limits = {});

extern template OpenedHistory<1> openHistory(const HistoryFolder&,
                                             const std::optional<SavedScene<1>>&, HistoryAccess,
                                             const HistoryLimits&);
extern template OpenedHistory<8> openHistory(const HistoryFolder&,
                                             const std::optional<SavedScene<8>>&, HistoryAccess,
                                             const HistoryLimits&);

/// The scene that a folder is the history of: that of its latest file. Nothing when there is none.
std::optional<HistoryIdentity> identityOf(const std::filesystem::path& folder,
                                          FileSystem& files = FileSystem::real());

}  // namespace bozzetto
