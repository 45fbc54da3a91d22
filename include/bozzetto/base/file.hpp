// Whole files in, whole files out. Writing never leaves half a file under the real name.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/file_system.hpp"

namespace bozzetto {

/// The whole file. Throws Error naming the path when it is missing, unreadable, not a regular file
/// or longer than `limit` bytes.
Bytes readFile(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 40,
               FileSystem& files = FileSystem::real());

/// Writes to a temporary name in the same folder, syncs, renames, syncs the folder. On any failure
/// throws Error and leaves whatever stood at `path` untouched; only where the last step failed the
/// new content may stand there, whole, and a power cut may bring back the old. "-" and /dev/stdout
/// write to standard output.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes,
               FileSystem& files = FileSystem::real());

/// A file that gets its name only when it is whole. Until then it has a temporary name in the same
/// folder, and goes with this object; a name left by a program that died is free for
/// removeLeftovers. Throws FileError.
class NewFile {
 public:
  explicit NewFile(std::filesystem::path path, FileSystem& files = FileSystem::real());
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  File& file() { return *file_; }
  const std::filesystem::path& temporaryName() const { return temporary_; }
  /// Syncs, closes, renames, syncs the folder.
  void putInPlace(Existing existing = Existing::replace);
  /// The same under another name in the folder.
  void putInPlaceAs(const std::filesystem::path& path, Existing existing);

 private:
  struct Nameless {};
  NewFile(std::filesystem::path path, FileSystem& files, Nameless);

  FileSystem* files_;
  std::filesystem::path path_, temporary_;
  std::unique_ptr<File> file_;
};

/// Removes temporary files that programs left in a folder when they died. Those in use stay. What
/// cannot be removed stays too.
void removeLeftovers(const std::filesystem::path& folder, FileSystem& files = FileSystem::real());

/// True for "-" and /dev/stdout.
bool isStandardOutput(const std::filesystem::path& path);

}  // namespace bozzetto
