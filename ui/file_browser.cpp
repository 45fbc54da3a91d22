#include "ui/file_browser.hpp"

#include <algorithm>
#include <cstdlib>

#include "bozzetto/base/text.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

bool isWanted(const std::string& name, const std::vector<std::string>& endings) {
  return endings.empty() || std::any_of(endings.begin(), endings.end(), [&](const auto& ending) {
           return lower(name).ends_with(ending);
         });
}

}  // namespace

void FileBrowser::open(const fs::path& folder, std::vector<std::string> endings) {
  endings_ = std::move(endings);
  std::error_code error;
  folder_ = fs::is_directory(folder, error) ? fs::absolute(folder, error).lexically_normal()
                                            : fs::current_path(error);
  read();
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  folder_ = fs::absolute(folder, error).lexically_normal();
  if (folder_.has_relative_path() && folder_.filename().empty()) folder_ = folder_.parent_path();
  read();
}

void FileBrowser::setHidden(bool shown) {
  hidden_ = shown;
  read();
}

void FileBrowser::read() {
  entries_.clear();
  trouble_.clear();
  std::error_code error;
  fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, error);
  if (error) trouble_ = error.message();
  for (; !error && at != fs::directory_iterator{}; at.increment(error)) {
    std::error_code ignored;
    FileEntry entry{at->path().filename().string(), at->is_directory(ignored), 0};
    if (!hidden_ && entry.name.starts_with(".")) continue;
    const bool history =
        entry.name.ends_with(".bzt.history") || entry.name.ends_with(".bzt.history~");
    if (entry.folder && history) continue;  // its scene stands there
    if (!entry.folder && !isWanted(entry.name, endings_)) continue;
    if (!entry.folder) entry.bytes = at->file_size(ignored);
    entries_.push_back(std::move(entry));
  }
  std::sort(entries_.begin(), entries_.end(), [](const FileEntry& a, const FileEntry& b) {
    if (a.folder != b.folder) return a.folder;
    const std::string low = lower(a.name), other = lower(b.name);
    return low != other ? low < other : a.name < b.name;
  });
}

int FileBrowser::find(const std::string& typed) const {
  for (std::size_t n = 0; n < entries_.size(); ++n)
    if (lower(entries_[n].name).starts_with(lower(typed))) return int(n);
  return -1;
}

fs::path FileBrowser::resolve(const std::string& typed) const {
  if (typed.starts_with("~/")) {
    if (const char* home = std::getenv("HOME")) return fs::path(home) / typed.substr(2);
  }
  const fs::path path(typed);
  return path.is_absolute() ? path : folder_ / path;
}

}  // namespace bozzetto::ui
