// .vdb files of the level-set ball: write without and with fsync, and a full read, warm.
#include <fcntl.h>
#include <openvdb/io/File.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "cases.hpp"

namespace bozzetto::peer {
namespace {

namespace fs = std::filesystem;

// A file of this process in the temporary folder, gone at the end.
class ScratchFile {
 public:
  ScratchFile()
      : path_(fs::temp_directory_path() / ("bozzetto_peer_" + std::to_string(getpid()) + ".vdb")) {}
  ~ScratchFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void writeBall(const fs::path& path, std::uint32_t compression) {
  static const FloatGrid::Ptr ball = [] {
    FloatGrid::Ptr grid = levelSetBall().deepCopy();
    grid->setName("clay");
    return grid;
  }();
  openvdb::io::File file(path.string());
  file.setCompression(compression);
  file.write({ball});
  file.close();
}

void synchronise(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDWR);
  if (descriptor < 0 || fsync(descriptor) != 0) {
    throw std::system_error(errno, std::generic_category(), path.string());
  }
  close(descriptor);
}

FloatGrid::Ptr readBall(const fs::path& path) {
  constexpr bool kDelayed = false;
  openvdb::io::File file(path.string());
  file.open(kDelayed);
  return openvdb::gridPtrCast<FloatGrid>(file.readGrid("clay"));
}

enum class Sync { none, file };

Result measureWrite(const Job& job, std::uint32_t compression, Sync sync) {
  Result result = job.result();
  const ScratchFile file;
  result.ms = timeRepeats(
      job.repeats, [&] { fs::remove(file.path()); },
      [&] {
        writeBall(file.path(), compression);
        if (sync == Sync::file) synchronise(file.path());
      });
  result.detail = {{"bytes", static_cast<double>(fs::file_size(file.path()))}};
  return result;
}

Result measureRead(const Job& job, std::uint32_t compression) {
  Result result = job.result();
  const ScratchFile file;
  writeBall(file.path(), compression);
  FloatGrid::Ptr grid;
  result.ms = timeRepeats(
      job.repeats, [&] { grid.reset(); }, [&] { grid = readBall(file.path()); });
  result.fingerprint = fingerprintOf(*grid);
  addCounts(result, *grid);
  return result;
}

void append(std::vector<Case>& cases, const std::string& how, std::uint32_t compression) {
  cases.push_back({"write_" + how, false,
                   [=](const Job& job) { return measureWrite(job, compression, Sync::none); }});
  cases.push_back({"write_fsync_" + how, false,
                   [=](const Job& job) { return measureWrite(job, compression, Sync::file); }});
  cases.push_back(
      {"read_" + how, false, [=](const Job& job) { return measureRead(job, compression); }});
}

}  // namespace

std::vector<Case> fileCases() {
  using namespace openvdb::io;
  std::vector<Case> cases;
  append(cases, "blosc", COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK);
  append(cases, "zip", COMPRESS_ZIP | COMPRESS_ACTIVE_MASK);
  return cases;
}

}  // namespace bozzetto::peer
