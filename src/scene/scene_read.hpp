#pragma once
#include <filesystem>
#include <map>

#include "bozzetto/scene/scene_file.hpp"

namespace bozzetto {

struct LoadedScene {
  Document document;
  std::map<Key, std::int64_t> rowOfTile;
};

/// The whole file, checked. Throws Error; see SceneFile::load.
LoadedScene readScene(const std::filesystem::path& path, Progress& progress, FileSystem& files);

/// Where a save was cut off, has SQLite put the old content back.
void finishInterruptedSave(const std::filesystem::path& path, FileSystem& files);

/// SQLite's name for what a save needs to be taken back.
std::filesystem::path journalOf(const std::filesystem::path& path);

}  // namespace bozzetto
