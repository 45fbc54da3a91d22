// The project's own files, read once, for rules that are checked on their text.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace bozzetto::arch {

using Names = std::set<std::string>;

struct TextFile {
  std::string path;  // from the root, with '/'
  std::vector<std::string> lines;

  /// The n-th folder of the path, "" if there is none: part(0) of "src/base/file.cpp" is "src".
  std::string part(int n) const;
  bool isCode() const;    // C++ and shaders
  bool isScript() const;  // CMake and shell
};

/// Every text file of the project, in path order; not what is built or written by the program.
const std::vector<TextFile>& allFiles();

std::filesystem::path rootFolder();

struct Include {
  std::string header;
  bool quoted;
  std::string where;  // file:line
};

std::vector<Include> includesOf(const TextFile& file);

/// What `function(NAME KEYWORD a b c …)` lists, for every NAME, in the given CMake file.
std::map<std::string, Names> cmakeLists(const TextFile& file, std::string_view function,
                                        std::string_view keyword);

const TextFile& fileAt(std::string_view path);

}  // namespace bozzetto::arch
