// Runs the program as a user would and keeps what it says.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "support/folder.hpp"

namespace bozzetto::testing {

struct Outcome {
  int code = -1;  ///< exit code; 128 + n when signal n ended it
  std::string out, err;
};

/// `arguments` as typed into a shell.
Outcome runProgram(const std::string& arguments);

/// The same where no file may grow beyond so many KiB.
Outcome runLimited(const std::string& arguments, int kibibytes);

/// The same with so many KiB of address space.
Outcome runCramped(const std::string& arguments, int kibibytes);

/// The same, killed (SIGKILL) after so many seconds.
Outcome runKilled(const std::string& arguments, double seconds);

/// A folder whose paths can stand on a command line.
class CommandFolder {
 public:
  std::string operator/(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a text file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Names of all files in it.
  std::string listing() const;

 private:
  Folder folder_;
};

std::string textOf(const std::string& path);

/// The program's path.
const std::string kProgram = BOZZETTO_PROGRAM;
/// The first line of a recording.
const std::string kHeader = "{\"bozzetto\":\"recording\",\"version\":1}\n";
/// A ball with a stroke on it.
const std::string kBall = kHeader +
                          "{\"op\":\"fill\",\"radii\":[16,16,16]}\n"
                          "{\"op\":\"tool\",\"radii\":[6,6,6]}\n"
                          "{\"op\":\"stroke\",\"points\":[[16,0,0],[0,16,0]]}\n";

/// What a recording makes, as s.bzt in the folder.
std::string sceneOf(const CommandFolder& folder, const std::string& recording,
                    const std::string& options = "");
/// What the program prints, with --json.
nlohmann::json jsonOf(const std::string& arguments);
nlohmann::json infoOf(const std::string& scene);

}  // namespace bozzetto::testing
