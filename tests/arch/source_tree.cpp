#include "arch/source_tree.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace bozzetto::arch {
namespace fs = std::filesystem;
namespace {

// Built, written by the program, or not ours.
bool isSkipped(const fs::path& path) {
  static const Names skipped{"build", "out", ".git", ".cache", ".vscode", ".idea"};
  return skipped.contains(path.filename().string()) && path.parent_path() == rootFolder();
}

bool endsWithAny(std::string_view text, std::initializer_list<std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return text.ends_with(ending); });
}

bool isText(std::string_view path) {
  return !endsWithAny(path, {".png", ".jpg", ".hdr", ".bzt", ".ply", ".stl", ".glb", ".ttf"});
}

TextFile read(const fs::path& path) {
  TextFile file{fs::relative(path, rootFolder()).generic_string(), {}};
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
  return file;
}

// The files worth reading whole: corpora of inputs are not.
bool isRead(const fs::directory_entry& entry) {
  return entry.is_regular_file() && isText(entry.path().string()) &&
         entry.path().generic_string().find("/corpus/") == std::string::npos;
}

std::vector<TextFile> readAll() {
  std::vector<TextFile> files;
  fs::recursive_directory_iterator at(rootFolder());
  for (; at != fs::recursive_directory_iterator{}; ++at) {
    if (isSkipped(at->path())) {
      at.disable_recursion_pending();
    } else if (isRead(*at)) {
      files.push_back(read(at->path()));
    }
  }
  std::sort(files.begin(), files.end(),
            [](const TextFile& a, const TextFile& b) { return a.path < b.path; });
  return files;
}

std::string withoutComments(const TextFile& file) {
  std::string text;
  for (const std::string& line : file.lines) text += line.substr(0, line.find('#')) + " ";
  return text;
}

}  // namespace

std::string TextFile::part(int n) const {
  std::istringstream stream(path);
  std::string name;
  for (; n >= 0 && std::getline(stream, name, '/'); --n) {
  }
  return n >= 0 || stream.eof() ? "" : name;
}

bool TextFile::isCode() const {
  return endsWithAny(path, {".cpp", ".hpp", ".glsl", ".vert", ".frag"});
}

bool TextFile::isScript() const {
  return endsWithAny(path, {"CMakeLists.txt", ".cmake", ".sh"}) || path == "run" ||
         path == "test" || path == ".ci/run";
}

fs::path rootFolder() { return BOZZETTO_SOURCE_DIR; }

const std::vector<TextFile>& allFiles() {
  static const std::vector<TextFile> files = readAll();
  return files;
}

const TextFile& fileAt(std::string_view path) {
  for (const TextFile& file : allFiles())
    if (file.path == path) return file;
  throw std::runtime_error("no file " + std::string(path));
}

std::vector<Include> includesOf(const TextFile& file) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  for (std::size_t n = 0; n < file.lines.size(); ++n) {
    std::smatch match;
    if (std::regex_match(file.lines[n], match, pattern))
      includes.push_back({match[2], match[1] == "\"", file.path + ":" + std::to_string(n + 1)});
  }
  return includes;
}

std::map<std::string, Names> cmakeLists(const TextFile& file, std::string_view function,
                                        std::string_view keyword) {
  const std::string text = withoutComments(file);
  const std::regex call(std::string(function) + R"(\(\s*(\w+)([^)]*)\))");
  std::map<std::string, Names> lists;
  for (std::sregex_iterator at(text.begin(), text.end(), call), end; at != end; ++at) {
    Names& names = lists[(*at)[1]];
    std::istringstream words((*at)[2]);
    bool listed = false;
    for (std::string word; words >> word;) {
      static const Names keywords{"USES", "THIRD_PARTY", "PRIVATE"};
      if (keywords.contains(word)) {
        listed = word == keyword;
      } else if (listed) {
        names.insert(word);
      }
    }
  }
  return lists;
}

}  // namespace bozzetto::arch
