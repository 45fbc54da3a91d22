// Every #include obeys the arrows, and CMake's link lists say the same.
#include "arch/arrows.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace bozzetto::arch {
namespace {

std::string moduleOf(const TextFile& file) {
  if (file.part(0) == "src") return file.part(1);
  if (file.path.starts_with("include/bozzetto/")) return file.part(2);
  return file.part(0) == "ui" ? "ui" : "";
}

/// "bozzetto/base/axis.hpp" → "base"; "" for what is not ours.
std::string moduleNamed(const std::string& header) {
  if (!header.starts_with("bozzetto/")) return "";
  return header.substr(9, header.find('/', 9) - 9);
}

bool isStandard(const std::string& header) {
  return header.find_first_of("./") == std::string::npos;
}

bool isSystem(const std::string& header) {
  static const Names posix{
      "dirent.h",      "dlfcn.h",     "fcntl.h",     "poll.h",     "sched.h",        "signal.h",
      "spawn.h",       "sys/file.h",  "sys/ioctl.h", "sys/mman.h", "sys/resource.h", "sys/stat.h",
      "sys/statvfs.h", "sys/types.h", "sys/wait.h",  "unistd.h",   "immintrin.h"};
  return posix.contains(header);
}

Names mayInclude(const std::string& header) {
  for (const auto& [prefix, modules] : kThirdParty)
    if (header.starts_with(prefix)) return modules;
  return {};
}

template <class Check>
void forEachInclude(const Check& check) {
  for (const TextFile& file : allFiles())
    if (file.isCode())
      for (const Include& include : includesOf(file)) check(file, include);
}

/// What CMakeLists.txt links, by module.
Arrows linkedModules() {
  const TextFile& lists = fileAt("CMakeLists.txt");
  Arrows linked = cmakeLists(lists, "bozzetto_module", "USES");
  linked["cli"] = cmakeLists(lists, "bozzetto_program", "USES")["bozzetto"];
  return linked;
}

TEST(Arrows, HaveNoCycle) {
  for (const auto& [module, uses] : kArrows)
    EXPECT_FALSE(reach(kArrows, uses).contains(module)) << module;
}

TEST(Arrows, HistoryAndSurfaceNeverSeeATool) {
  EXPECT_FALSE(reach(kArrows, {"history"}).contains("tool"));
  EXPECT_FALSE(reach(kArrows, {"surface"}).contains("tool"));
  EXPECT_FALSE(reach(kArrows, {"sculptor"}).contains("render"));
}

TEST(Arrows, EveryModuleHasAPlace) {
  for (const TextFile& file : allFiles())
    if (const std::string module = moduleOf(file); !module.empty() && file.isCode()) {
      EXPECT_TRUE(kArrows.contains(module)) << file.path << ": no arrows for '" << module << "'";
    }
}

TEST(Arrows, IncludesFollowThem) {
  const Arrows law = withoutFuture(linkedModules());
  forEachInclude([&](const TextFile& file, const Include& include) {
    const std::string module = moduleOf(file), named = moduleNamed(include.header);
    if (module.empty() || named.empty()) return;
    EXPECT_TRUE(reach(law, {module}).contains(named))
        << include.where << ": " << module << " may not include " << include.header;
  });
}

TEST(Arrows, PrivateHeadersStayInTheirModule) {
  forEachInclude([](const TextFile& file, const Include& include) {
    const std::string folder = include.header.substr(0, include.header.find('/'));
    if (!include.quoted || !kArrows.contains(folder) || file.part(0) == "tests") return;
    EXPECT_EQ(folder, moduleOf(file)) << include.where << ": " << include.header << " is private";
  });
}

TEST(Arrows, PublicHeadersIncludeNoPrivateOnes) {
  forEachInclude([](const TextFile& file, const Include& include) {
    if (file.part(0) != "include") return;
    EXPECT_EQ(include.quoted, include.header.starts_with("bozzetto/"))
        << include.where << ": " << include.header;
  });
}

TEST(Arrows, TestsUseWhatTheyLink) {
  const auto lists = cmakeLists(fileAt("tests/CMakeLists.txt"), "bozzetto_tests", "USES");
  forEachInclude([&](const TextFile& file, const Include& include) {
    const std::string named = moduleNamed(include.header);
    const auto uses = lists.find(file.part(1));
    if (file.part(0) != "tests" || named.empty() || uses == lists.end()) return;
    EXPECT_TRUE(reach(kArrows, uses->second).contains(named))
        << include.where << ": " << include.header << " is not in what test_" << uses->first
        << " USES";
  });
}

TEST(Arrows, LinkListsEqualThem) {
  const Arrows linked = linkedModules(), law = withoutFuture(linked);
  for (const auto& [module, uses] : linked) {
    const Names expected = reach(law, {module}), found = reach(linked, {module});
    for (const std::string& used : found) {
      EXPECT_TRUE(expected.contains(used)) << "CMakeLists.txt: " << module << " links " << used;
    }
    for (const std::string& used : expected) {
      EXPECT_TRUE(found.contains(used)) << "CMakeLists.txt: " << module << " lacks " << used;
    }
  }
}

TEST(ThirdParty, PublicHeadersShowOnlyGlmAndBoostContainer) {
  forEachInclude([](const TextFile& file, const Include& include) {
    if (file.part(0) != "include" || include.quoted) return;
    const bool boost = file.part(2) == "grid" && mayInclude(include.header) == Names{"grid"};
    EXPECT_TRUE(isStandard(include.header) || include.header.starts_with("glm/") || boost)
        << include.where << ": <" << include.header << "> in a public header";
  });
}

TEST(ThirdParty, StaysWhereItBelongs) {
  forEachInclude([](const TextFile& file, const Include& include) {
    const std::string module = moduleOf(file);
    if (module.empty() || include.quoted) return;
    if (isStandard(include.header) || isSystem(include.header)) return;
    EXPECT_TRUE(mayInclude(include.header).contains(module))
        << include.where << ": <" << include.header << "> in " << module;
  });
}

TEST(ThirdParty, NoOtherWayToOpenGl) {
  forEachInclude([](const TextFile& file, const Include& include) {
    for (const char* prefix : {"GL/", "GLES", "EGL/", "OpenGL/"})
      EXPECT_FALSE(include.header.starts_with(prefix))
          << include.where << ": only epoxy's headers, in render and ui";
    EXPECT_TRUE(!include.header.starts_with("epoxy/") || moduleOf(file) == "render" ||
                moduleOf(file) == "ui" || file.path.starts_with("tests/render/") ||
                file.path.starts_with("tests/ui/"))
        << include.where;
  });
}

TEST(Threads, LiveInBaseAndTheJournalOnly) {
  static const Names owners{"src/base/parallel.cpp", "src/base/background.cpp", "ui/worker.hpp",
                            "src/history/journal.hpp", "include/bozzetto/haptic/loop.hpp"};
  static const Names forbidden{"thread", "future",    "execution", "barrier",
                               "latch",  "semaphore", "pthread.h"};
  forEachInclude([](const TextFile& file, const Include& include) {
    if (moduleOf(file).empty() || owners.contains(file.path)) return;
    const bool threads = forbidden.contains(include.header) || include.header.starts_with("tbb/") ||
                         include.header.starts_with("oneapi/tbb/");
    EXPECT_FALSE(threads) << include.where << ": <" << include.header << ">";
  });
}

}  // namespace
}  // namespace bozzetto::arch
