#include "bozzetto/scene/scene_file.hpp"

#include "bozzetto/base/file.hpp"
#include "scene/database.hpp"
#include "scene/scene_read.hpp"
#include "scene/scene_write.hpp"
#include "scene/tiles.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

bool samePlace(const fs::path& a, const fs::path& b) {
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

// Names may have 255 bytes, the journal's too.
bool hasRoomForJournal(const fs::path& path) {
  return journalOf(path).filename().string().size() <= 255;
}

// More than half of the pages hold nothing any more: time for a new file.
bool mostlyFree(Database& database) {
  Statement free(database, "PRAGMA freelist_count"), all(database, "PRAGMA page_count");
  return free.step() && all.step() && 2 * free.number(0) > all.number(0);
}

// A journal left by a save that was cut off belongs to the file that goes now; SQLite would play it
// into the new one. The old file gets its content back first, in case we stop in between.
void removeOldJournal(const fs::path& path, FileSystem& files) {
  if (!files.info(journalOf(path))) return;
  try {
    finishInterruptedSave(path, files);
  } catch (const Error&) {
  }
  if (files.remove(journalOf(path))) files.syncFolder(folderOf(path));
}

void copyInto(NewFile& copy, File& original) {
  Bytes piece(std::size_t{1} << 20);
  for (std::uint64_t at = 0;;) {
    const std::size_t got = original.read(at, piece);
    if (got == 0) return;
    copy.file().write(at, std::span(piece).first(got));
    at += got;
  }
}

// The whole document into a file that is nobody's yet: it is synced before it gets its name.
SaveReport writeWhole(NewFile& file, FileSystem& files, const Document& document,
                      std::map<Key, std::int64_t>& rows, Progress& progress) {
  Database database = Database::forWriting(file.temporaryName(), file.file().path().string(), files,
                                           Sharing::nobodyElse);
  database.run("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA locking_mode=EXCLUSIVE");
  makeTables(database);
  return writeScene(database, document, {tilesOf(document.field.tree), true}, rows, progress);
}

// "faun.bzt", 7 → "faun.007.bzt"
fs::path numbered(const fs::path& path, unsigned number) {
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
  return path.parent_path() / (path.stem().string() + "." + digits + path.extension().string());
}

// The number of a copy of `path`, 0 for other names.
unsigned numberOf(const fs::path& path, const std::string& name) {
  const std::string start = path.stem().string() + ".", end = path.extension().string();
  if (!name.starts_with(start) || !name.ends_with(end)) return 0;
  if (name.size() <= start.size() + end.size()) return 0;
  const std::string digits = name.substr(start.size(), name.size() - start.size() - end.size());
  const bool good = digits.find_first_not_of("0123456789") == std::string::npos;
  return good && digits.size() < 9 ? static_cast<unsigned>(std::stoul(digits)) : 0;
}

}  // namespace

fs::path previousVersionOf(const fs::path& path) { return path.string() + "~"; }

std::optional<FileInfo> SceneFile::stampOf(const fs::path& path) const {
  const auto info = files_->info(path);
  return info && info->kind == FileInfo::Kind::file ? info : std::nullopt;
}

void SceneFile::remember(const fs::path& path, const Document& document) {
  path_ = path;
  stamp_ = stampOf(path);
  saved_ = document;
}

Document SceneFile::load(const fs::path& path, Progress& progress) {
  LoadedScene loaded = readScene(path, progress, *files_);
  rowOfTile_ = std::move(loaded.rowOfTile);
  remember(path, loaded.document);
  return std::move(loaded.document);
}

// Once for each file. A disk that has no room for it may still have room for the save.
void SceneFile::keepPrevious(const fs::path& path, Progress& progress) {
  if (keptPreviousOf_ == path) return;
  try {
    if (stampOf(path)) {
      NewFile copy(previousVersionOf(path), *files_);
      copyInto(copy, *files_->open(path, OpenMode::read));
      copy.putInPlace();
    }
    keptPreviousOf_ = path;
  } catch (const FileError& error) {
    progress.note("the previous version is not kept: " + std::string(error.what()));
  }
}

SaveReport SceneFile::saveWhole(const fs::path& path, const Document& document,
                                Progress& progress) {
  std::map<Key, std::int64_t> rows;
  NewFile file(path, *files_);
  const SaveReport report = writeWhole(file, *files_, document, rows, progress);
  removeOldJournal(path, *files_);
  keepPrevious(path, progress);
  file.putInPlace();
  rowOfTile_ = std::move(rows);
  return report;
}

std::optional<SaveReport> SceneFile::saveChanges(const Document& document, Progress& progress) {
  keepPrevious(path_, progress);
  Database database = Database::forWriting(path_, path_.string(), *files_);
  if (mostlyFree(database)) return std::nullopt;
  // EXTRA: the journal's removal, which is the commit, is synced too.
  database.run("PRAGMA journal_mode=DELETE; PRAGMA synchronous=EXTRA");
  const bool sameHead = saved_.field.scale == document.field.scale;
  const TileChanges changes{changedTiles(saved_.field.tree, document.field.tree),
                            !sameHead || !(saved_.parts == document.parts)};
  SaveReport report;
  if (!changes.written.empty() || changes.parts) {
    report = writeScene(database, document, changes, rowOfTile_, progress);
  }
  report.chunks = rowOfTile_.size();
  report.kind = SaveKind::changes;
  return report;
}

SaveReport SceneFile::save(const fs::path& path, const Document& document, Progress& progress) {
  if (isStandardOutput(path)) throw Error("a scene cannot be written to standard output");
  // Until this save is known to be good, nothing is known of the file.
  const auto stamp = std::exchange(stamp_, std::nullopt);
  const bool ours = stamp && samePlace(path, path_) && stamp == stampOf(path);
  std::optional<SaveReport> report;
  if (ours && hasRoomForJournal(path)) report = saveChanges(document, progress);
  if (!report) report = saveWhole(path, document, progress);
  remember(path, document);
  if (stamp_) report->fileBytes = stamp_->bytes;
  return *report;
}

Document loadScene(const fs::path& path, Progress& progress, FileSystem& files) {
  return readScene(path, progress, files).document;
}

SaveReport saveScene(const fs::path& path, const Document& document, Progress& progress,
                     FileSystem& files) {
  if (isStandardOutput(path)) throw Error("a scene cannot be written to standard output");
  std::map<Key, std::int64_t> rows;
  NewFile file(path, files);
  SaveReport report = writeWhole(file, files, document, rows, progress);
  removeOldJournal(path, files);
  report.fileBytes = file.file().info().bytes;
  file.putInPlace();
  return report;
}

fs::path saveNumberedCopy(const fs::path& path, const Document& document, Progress& progress,
                          FileSystem& files) {
  std::map<Key, std::int64_t> rows;
  NewFile file(path, files);
  writeWhole(file, files, document, rows, progress);
  unsigned last = 0;
  for (const std::string& name : files.list(folderOf(path))) {
    last = std::max(last, numberOf(path, name));
  }
  const fs::path name = numbered(path, last + 1);
  file.putInPlaceAs(name, Existing::refuse);
  return name;
}

std::optional<std::string> checkScene(const fs::path& path, Progress& progress, FileSystem& files) {
  try {
    readScene(path, progress, files);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace bozzetto
