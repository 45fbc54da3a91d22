// Sizes, names and places of files.
#include <gtest/gtest.h>

#include <algorithm>

#include "arch/source_tree.hpp"

namespace bozzetto::arch {
namespace {

constexpr std::size_t kLongestFile = 500, kLongestLine = 100, kLongestFunction = 60;

// Longer than a file may be, and why.
const std::map<std::string, std::string> kLongFiles{};

std::size_t columns(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

template <class Check>
void forEachLine(const Check& check) {
  for (const TextFile& file : allFiles())
    for (std::size_t n = 0; n < file.lines.size(); ++n)
      check(file, file.lines[n], file.path + ":" + std::to_string(n + 1));
}

TEST(Layout, TopLevelHoldsOnlyWhatItShould) {
  const Names allowed{
      "CMakeLists.txt", "CMakePresets.json", "src",     "include", "ui",   "tests", "data",
      "cmake",          "README.md",         "LICENSE", "run",     "test", "build", "out"};
  for (const auto& entry : std::filesystem::directory_iterator(rootFolder())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(allowed.contains(name) || name.starts_with(".")) << name << " at the top level";
  }
}

TEST(Layout, EveryModuleHasNotesAndTests) {
  Names modules;
  for (const TextFile& file : allFiles())
    if (file.part(0) == "src" && file.path.ends_with(".cpp")) modules.insert(file.part(1));
  for (const std::string& module : modules) {
    for (const std::string& path : {"src/" + module + "/NOTES.md", "tests/" + module}) {
      EXPECT_TRUE(std::filesystem::exists(rootFolder() / path)) << "no " << path;
    }
  }
}

TEST(Layout, NamesAreSnakeCase) {
  static const std::string allowed = "abcdefghijklmnopqrstuvwxyz0123456789_/.";
  for (const TextFile& file : allFiles())
    if (file.isCode()) {
      EXPECT_EQ(file.path.find_first_not_of(allowed), std::string::npos) << file.path;
    }
}

TEST(Layout, FilesAreShort) {
  for (const TextFile& file : allFiles())
    if ((file.isCode() || file.isScript()) && !kLongFiles.contains(file.path)) {
      EXPECT_LE(file.lines.size(), kLongestFile) << file.path;
    }
}

TEST(Layout, LinesAreShort) {
  forEachLine([](const TextFile& file, const std::string& line, const std::string& where) {
    if (file.isCode() || file.isScript()) {
      EXPECT_LE(columns(line), kLongestLine) << where;
    }
  });
}

// clang-format puts the first and last line of every function outside a class at the margin.
TEST(Layout, FunctionsAreShort) {
  for (const TextFile& file : allFiles()) {
    if (!file.path.ends_with(".cpp") && !file.path.ends_with(".hpp")) continue;
    std::size_t begin = 0;
    for (std::size_t n = 0; n < file.lines.size(); ++n) {
      const std::string& line = file.lines[n];
      if (line.empty() || line[0] == '#') continue;
      const bool margin = line[0] != ' ' && line[0] != '}';
      const bool opensOther = line.starts_with("namespace") || line.starts_with("class") ||
                              line.starts_with("struct") || line.starts_with("enum");
      if (margin) begin = opensOther || line.find('(') == std::string::npos ? 0 : n + 1;
      if (line == "}" && begin != 0) {
        EXPECT_LE(n + 2 - begin, kLongestFunction) << file.path << ":" << begin;
      }
    }
  }
}

TEST(Layout, HeadersAreIncludedOnce) {
  for (const TextFile& file : allFiles())
    if (file.path.ends_with(".hpp")) {
      EXPECT_TRUE(std::count(file.lines.begin(), file.lines.end(), "#pragma once") == 1)
          << file.path;
    }
}

TEST(Layout, PublicHeadersOpenWithWhyTheyExist) {
  for (const TextFile& file : allFiles())
    if (file.part(0) == "include" && !file.lines.empty()) {
      EXPECT_TRUE(file.lines[0].starts_with("// ")) << file.path << ":1";
    }
}

TEST(Layout, NoTabsNoTrailingBlanks) {
  forEachLine([](const TextFile& file, const std::string& line, const std::string& where) {
    if (!file.isCode() && !file.isScript()) return;
    EXPECT_EQ(line.find('\t'), std::string::npos) << where;
    EXPECT_FALSE(line.ends_with(' ') || line.ends_with('\r')) << where;
  });
}

// Tests of one program run side by side, so that a name they share is a race.
TEST(Layout, TestsWriteIntoFoldersOfTheirOwn) {
  const std::string forbidden[] = {std::string("Temp") + "Dir()",
                                   std::string("temp_directory") + "_path"};
  forEachLine([&](const TextFile& file, const std::string& line, const std::string& where) {
    if (file.part(0) != "tests" || file.part(1) == "support" || file.part(1) == "bench") return;
    for (const std::string& text : forbidden)
      EXPECT_EQ(line.find(text), std::string::npos) << where << ": testing::Folder";
  });
}

// ImGui ends the program over an area without size.
TEST(Layout, PanelsAskForAreasThatHaveSomeSize) {
  forEachLine([](const TextFile& file, const std::string& line, const std::string& where) {
    if (file.part(0) != "ui" || file.path == "ui/widgets.cpp") return;
    EXPECT_EQ(line.find("InvisibleButton"), std::string::npos) << where << ": hotArea()";
  });
}

// Split so that this file does not break its own rule.
TEST(Layout, NothingNamesOneMachine) {
  const std::string forbidden[] = {std::string("/wo") + "rk/", std::string("/ho") + "me/",
                                   std::string("/ro") + "ot/", std::string("debian.") + "org"};
  forEachLine([&](const TextFile&, const std::string& line, const std::string& where) {
    for (const std::string& text : forbidden)
      EXPECT_EQ(line.find(text), std::string::npos) << where << ": names " << text;
  });
}

}  // namespace
}  // namespace bozzetto::arch
