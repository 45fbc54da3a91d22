// Histories as a whole: copied to where a document goes under another name, removed, looked at.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "bozzetto/history/history.hpp"

namespace bozzetto {

/// Puts the undo-files of all steps and the checkpoints into another folder, which is made, and
/// keeps what was there under the name FOLDER~. The history must be durable. In memory: nothing to
/// copy. Throws FileError; Error when somebody has the other folder locked.
template <int Side>
void copyHistory(const History<Side>& history, const std::filesystem::path& folder,
                 FileSystem& files = FileSystem::real());

extern template void copyHistory(const History<1>&, const std::filesystem::path&, FileSystem&);
extern template void copyHistory(const History<8>&, const std::filesystem::path&, FileSystem&);

/// Gives the folder the name FOLDER~, in the place of what had it. Throws FileError; Error when
/// somebody has it locked. Nothing when there is none.
void putHistoryAside(const std::filesystem::path& folder, FileSystem& files = FileSystem::real());

/// When anything in the folder was changed last, seconds since 1970; nothing when it holds nothing.
std::optional<std::int64_t> lastChangeOf(const std::filesystem::path& folder,
                                         FileSystem& files = FileSystem::real());

/// Removes a folder that holds a history and nothing else. What cannot be removed stays.
void removeHistory(const std::filesystem::path& folder, FileSystem& files = FileSystem::real());

/// What the heads of a folder's files tell, without the clay.
struct HistoryGlance {
  std::size_t steps = 0;
  std::int64_t time = 0;  ///< of the last step; milliseconds since 1970
  std::string label;      ///< of the last step
  Bytes thumbnail;        ///< PNG of the last step that has one beside it; empty without
};

/// O(undo-files). Damaged files are passed over; nothing where there is no history.
std::optional<HistoryGlance> glanceAt(const std::filesystem::path& folder,
                                      FileSystem& files = FileSystem::real());

/// Whether somebody writes there now.
bool historyIsLocked(const std::filesystem::path& folder, FileSystem& files = FileSystem::real());

}  // namespace bozzetto
