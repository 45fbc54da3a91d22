// A file is old or new, never half; what cannot be read says so by name.
#include "bozzetto/base/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "support/folder.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

class File : public ::testing::Test {
 protected:
  fs::path at(const char* name) const { return folder_ / name; }
  std::size_t filesInFolder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{}));
  }

  const testing::Folder folder_;
};

Bytes bytesOf(std::string_view text) {
  ByteWriter writer;
  writer.put(text);
  return writer.take();
}

std::string messageOf(const auto& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(File, ComesBackAsWritten) {
  Bytes bytes(300000);
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::byte>(n % 253);
  writeFile(at("a"), bytes);
  EXPECT_EQ(readFile(at("a")), bytes);
  writeFile(at("a"), bytesOf("short"));
  EXPECT_EQ(readFile(at("a")), bytesOf("short")) << "replaced whole";
  writeFile(at("a"), {});
  EXPECT_TRUE(readFile(at("a")).empty());
  EXPECT_EQ(filesInFolder(), 1u) << "nothing temporary stays";
}

TEST_F(File, MissingFileIsNamed) {
  const std::string message = messageOf([&] { readFile(at("none")); });
  EXPECT_NE(message.find(at("none").string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
}

TEST_F(File, FoldersAndPipesAreRefusedAtOnce) {
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  EXPECT_NE(messageOf([&] { readFile(at("pipe")); }).find("not a regular file"), std::string::npos);
  EXPECT_NE(messageOf([&] { readFile(folder_.path()); }).find("not a regular file"),
            std::string::npos);
  EXPECT_THROW(readFile("/dev/zero"), Error);
}

TEST_F(File, TooLongIsRefusedBeforeReading) {
  writeFile(at("a"), bytesOf("0123456789"));
  EXPECT_EQ(readFile(at("a"), 10).size(), 10u);
  EXPECT_THROW(readFile(at("a"), 9), Error);
  // A sparse file of a terabyte costs nothing to refuse.
  writeFile(at("huge"), {});
  ASSERT_EQ(::truncate(at("huge").c_str(), off_t{1} << 40), 0);
  EXPECT_THROW(readFile(at("huge"), 1 << 20), Error);
}

TEST_F(File, WritingWhereNoFolderIsFails) {
  const fs::path path = folder_ / "nowhere" / "a";
  EXPECT_NE(messageOf([&] { writeFile(path, bytesOf("x")); }).find(path.string()),
            std::string::npos);
}

TEST_F(File, AFolderOfThatNameStays) {
  fs::create_directory(at("a"));
  writeFile(at("a") / "inside", bytesOf("x"));
  EXPECT_THROW(writeFile(at("a"), bytesOf("y")), Error);
  EXPECT_TRUE(fs::exists(at("a") / "inside"));
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, AReadOnlyFolderKeepsTheOldFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  writeFile(at("a"), bytesOf("old"));
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(writeFile(at("a"), bytesOf("new")), Error);
  EXPECT_EQ(readFile(at("a")), bytesOf("old"));
}

// A full disk, played by the limit on file sizes.
TEST_F(File, AFullDiskKeepsTheOldFile) {
  writeFile(at("a"), bytesOf("old"));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t limit : {0u, 1u, 4096u, 99999u}) {
    const rlimit small{limit, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = messageOf([&] { writeFile(at("a"), Bytes(100000)); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_NE(message.find(at("a").string()), std::string::npos) << message;
    EXPECT_EQ(readFile(at("a")), bytesOf("old")) << "limit " << limit;
    EXPECT_EQ(filesInFolder(), 1u) << "limit " << limit;
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(File, ALinkAtTheNameIsReplacedNotFollowed) {
  writeFile(at("target"), bytesOf("kept"));
  fs::create_symlink(at("target"), at("link"));
  writeFile(at("link"), bytesOf("new"));
  EXPECT_EQ(readFile(at("target")), bytesOf("kept"));
  EXPECT_EQ(readFile(at("link")), bytesOf("new"));
}

TEST_F(File, NamesMayHoldAnything) {
  for (const char* name : {"name with blanks", "Tonfigur-ä-粘土", "-", "a\nb"}) {
    writeFile(at(name), bytesOf(name));
    EXPECT_EQ(readFile(at(name)), bytesOf(name));
  }
}

TEST(StandardOutput, HasTwoNames) {
  EXPECT_TRUE(isStandardOutput("-"));
  EXPECT_TRUE(isStandardOutput("/dev/stdout"));
  EXPECT_FALSE(isStandardOutput("./-"));
  EXPECT_FALSE(isStandardOutput(""));
}

}  // namespace
}  // namespace bozzetto
