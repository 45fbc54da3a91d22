#include "bozzetto/history/copy.hpp"

#include <algorithm>

#include "bozzetto/base/file.hpp"
#include "bozzetto/history/recovery.hpp"
#include "history/folder_listing.hpp"
#include "history/journal.hpp"

namespace bozzetto {

void putHistoryAside(const std::filesystem::path& folder, FileSystem& files) {
  if (!files.info(folder)) return;
  if (historyIsLocked(folder, files)) {
    throw Error(folder.string() + ": another program has it open");
  }
  const std::filesystem::path old = folder.string() + "~";
  if (files.info(old)) removeHistory(old, files);
  files.rename(folder, old, Existing::refuse);
}

std::optional<std::int64_t> lastChangeOf(const std::filesystem::path& folder, FileSystem& files) {
  std::optional<std::int64_t> last;
  try {
    for (const std::string& name : files.list(folder)) {
      const auto info = files.info(folder / name);
      if (info && name != undo::kLockFile) last = std::max(last.value_or(0), info->seconds);
    }
  } catch (const Error&) {
  }
  return last;
}

template <int Side>
void copyHistory(const History<Side>& history, const std::filesystem::path& folder,
                 FileSystem& files) {
  const std::filesystem::path from = history.folder();
  if (from.empty()) return;
  putHistoryAside(folder, files);
  files.makePrivateFolder(folder);
  for (const std::string& name : files.list(from)) {
    if (name == undo::kLockFile || name.starts_with(".")) continue;
    writeFile(folder / name, readFile(from / name, std::size_t{1} << 40, files), files);
  }
  files.syncFolder(folderOf(folder));
}

template void copyHistory(const History<1>&, const std::filesystem::path&, FileSystem&);
template void copyHistory(const History<8>&, const std::filesystem::path&, FileSystem&);

void removeHistory(const std::filesystem::path& folder, FileSystem& files) {
  try {
    for (const std::string& name : files.list(folder)) files.remove(folder / name);
    files.remove(folder);
  } catch (const Error&) {
  }
}

std::optional<HistoryGlance> glanceAt(const std::filesystem::path& folder, FileSystem& files) {
  const auto identity = identityOf(folder, files);
  if (!identity) return std::nullopt;
  const undo::FolderListing listing = undo::listFolder(folder, *identity, files);
  HistoryGlance glance;
  glance.steps = listing.steps.size();
  if (glance.steps > 0) {
    const Step& last = listing.steps.rbegin()->second.step;
    glance.time = last.time;
    glance.label = last.note.label;
  }
  for (auto step = listing.steps.rbegin(); step != listing.steps.rend() && glance.thumbnail.empty();
       ++step) {
    try {
      const auto picture = folder / undo::pictureFileName(step->first);
      if (!files.info(picture)) continue;
      glance.thumbnail = readFile(picture, undo::kMostThumbnailBytes, files);
    } catch (const Error&) {
    }
  }
  return glance;
}

bool historyIsLocked(const std::filesystem::path& folder, FileSystem& files) {
  const auto lock = folder / undo::kLockFile;
  return files.info(lock) && !FileLock::tryTake(lock, files);
}

}  // namespace bozzetto
