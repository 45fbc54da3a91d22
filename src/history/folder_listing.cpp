#include "history/folder_listing.hpp"

#include <algorithm>
#include <charconv>

#include "bozzetto/base/file.hpp"
#include "history/journal.hpp"

namespace bozzetto::undo {
namespace {

// "0000000012.undo" → 12.
std::optional<StepNumber> numberOf(const std::string& name, std::string_view ending) {
  if (name.size() != 10 + ending.size() || !name.ends_with(ending)) return std::nullopt;
  StepNumber number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + 10, number);
  if (error != std::errc() || end != name.data() + 10) return std::nullopt;
  return number;
}

class Lister {
 public:
  Lister(const std::filesystem::path& folder, const HistoryIdentity& identity, FileSystem& files)
      : folder_(folder), identity_(identity), files_(files) {}

  FolderListing list() {
    for (const std::string& name : names()) {
      if (const auto number = numberOf(name, kStepEnding)) {
        result_.lastNumber = std::max(result_.lastNumber, *number);
        take(name, *number, FileKind::step, result_.steps);
      } else if (const auto state = numberOf(name, kCheckpointEnding)) {
        take(name, *state, FileKind::checkpoint, result_.checkpoints);
      } else if (name == kPlaceFile) {
        takePlace();
      }
    }
    return std::move(result_);
  }

 private:
  std::vector<std::string> names() {
    try {
      return files_.list(folder_);
    } catch (const FileError& error) {
      if (error.fault() == FileFault::missing) return {};
      throw;
    }
  }

  void take(const std::string& name, StepNumber number, FileKind kind,
            std::map<StepNumber, FileHead>& into) {
    try {
      FileHead head = readHead(folder_ / name, files_);
      if (head.identity != identity_) {
        ++result_.strangers[head.identity];
        return;
      }
      result_.names.push_back(name);
      if (head.kind != kind || head.step.number != number) {
        throw Error((folder_ / name).string() + ": content of step " +
                    std::to_string(head.step.number) + ", another name expected");
      }
      into[number] = std::move(head);
    } catch (const Error& error) {
      result_.notices.push_back(error.what());
      if (result_.names.empty() || result_.names.back() != name) result_.names.push_back(name);
    }
  }

  void takePlace() {
    try {
      const PlaceRecord record =
          decodePlace(readFile(folder_ / kPlaceFile, 4096, files_), kPlaceFile);
      if (record.identity == identity_) {
        result_.place = record;
      } else {
        ++result_.strangers[record.identity];
      }
    } catch (const Error& error) {
      result_.notices.push_back(error.what());
    }
  }

  const std::filesystem::path& folder_;
  const HistoryIdentity& identity_;
  FileSystem& files_;
  FolderListing result_;
};

}  // namespace

FileHead readHead(const std::filesystem::path& path, FileSystem& files) {
  const auto file = files.open(path, OpenMode::read);
  Bytes bytes(kMostHeadBytes);
  bytes.resize(file->read(0, bytes));
  FileHead head = decodeHead(bytes, path.string());
  const std::uint64_t length = file->info().bytes;
  if (head.fileBytes != 0 && head.fileBytes != length) {
    throw Error(path.string() + ": " + std::to_string(length) + " bytes, " +
                std::to_string(head.fileBytes) + " expected");
  }
  return head;
}

FolderListing listFolder(const std::filesystem::path& folder, const HistoryIdentity& identity,
                         FileSystem& files) {
  return Lister(folder, identity, files).list();
}

}  // namespace bozzetto::undo
