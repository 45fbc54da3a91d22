// Runs the program as a user would and keeps what it says.
#pragma once
#include <filesystem>
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

}  // namespace bozzetto::testing
