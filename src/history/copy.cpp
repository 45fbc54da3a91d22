#include "bozzetto/history/copy.hpp"

#include "bozzetto/base/file.hpp"
#include "history/journal.hpp"

namespace bozzetto {
namespace {

void putAside(const std::filesystem::path& folder, FileSystem& files) {
  if (!files.info(folder)) return;
  if (historyIsLocked(folder, files)) {
    throw Error(folder.string() + ": another program has it open");
  }
  const std::filesystem::path old = folder.string() + "~";
  if (files.info(old)) removeHistory(old, files);
  files.rename(folder, old, Existing::refuse);
}

}  // namespace

template <int Side>
void copyHistory(const History<Side>& history, const std::filesystem::path& folder,
                 FileSystem& files) {
  const std::filesystem::path from = history.folder();
  if (from.empty()) return;
  putAside(folder, files);
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

bool historyIsLocked(const std::filesystem::path& folder, FileSystem& files) {
  const auto lock = folder / undo::kLockFile;
  return files.info(lock) && !FileLock::tryTake(lock, files);
}

}  // namespace bozzetto
