// What lies in a history's folder, as far as heads tell.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/base/file_system.hpp"
#include "history/place_file.hpp"
#include "history/undo_file.hpp"

namespace bozzetto::undo {

struct FolderListing {
  std::map<StepNumber, FileHead> steps;
  std::map<StepNumber, FileHead> checkpoints;  ///< by state
  std::optional<PlaceRecord> place;
  StepNumber lastNumber = 0;         ///< of any file, sound or not
  std::vector<std::string> names;    ///< of all undo-files and checkpoints but strangers'
  std::vector<std::string> notices;  ///< one line for each file that is damaged
  std::map<HistoryIdentity, std::size_t> strangers;  ///< files of other scenes
};

/// An empty listing where there is no folder. Throws FileError when it cannot be read.
FolderListing listFolder(const std::filesystem::path& folder, const HistoryIdentity& identity,
                         FileSystem& files);

/// The first bytes of a file, decoded. Throws Error.
FileHead readHead(const std::filesystem::path& path, FileSystem& files);

}  // namespace bozzetto::undo
