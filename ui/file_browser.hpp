// A folder as a list to choose from: what the file dialog shows, without the showing.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bozzetto::ui {

struct FileEntry {
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

class FileBrowser {
 public:
  /// Shows folders and files with one of these endings (".bzt"; none: all).
  void open(const std::filesystem::path& folder, std::vector<std::string> endings);
  /// Another folder; stays where it is when that cannot be read.
  void enter(const std::filesystem::path& folder);
  void up() { enter(folder_.parent_path()); }
  void setHidden(bool shown);
  bool showsHidden() const { return hidden_; }

  const std::filesystem::path& folder() const { return folder_; }
  /// Folders first, then files, each by name.
  const std::vector<FileEntry>& entries() const { return entries_; }
  /// The first entry that starts with `typed`, any case; -1 when there is none.
  int find(const std::string& typed) const;
  /// What a typed name means: absolute, from home with ~, or in this folder.
  std::filesystem::path resolve(const std::string& typed) const;
  const std::string& trouble() const { return trouble_; }

 private:
  void read();

  std::filesystem::path folder_;
  std::vector<std::string> endings_;
  std::vector<FileEntry> entries_;
  std::string trouble_;
  bool hidden_ = false;
};

}  // namespace bozzetto::ui
