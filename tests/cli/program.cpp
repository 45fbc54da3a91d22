#include "cli/program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

namespace bozzetto::testing {
namespace fs = std::filesystem;

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

namespace {

Outcome runShell(const std::string& command) {
  const CommandFolder folder;
  const std::string out = folder / "out", err = folder / "err";
  const int status =
      std::system(("{ " + command + "; } > " + out + " 2> " + err + " < /dev/null").c_str());
  const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return {code, textOf(out), textOf(err)};
}

}  // namespace

Outcome runProgram(const std::string& arguments) {
  return runShell(std::string(BOZZETTO_PROGRAM) + " " + arguments);
}

Outcome runLimited(const std::string& arguments, int kibibytes) {
  // The shell counts blocks of 512 bytes.
  return runShell("ulimit -f " + std::to_string(2 * kibibytes) + "; " BOZZETTO_PROGRAM " " +
                  arguments);
}

Outcome runCramped(const std::string& arguments, int kibibytes) {
  return runShell("ulimit -v " + std::to_string(kibibytes) + "; " BOZZETTO_PROGRAM " " + arguments);
}

Outcome runKilled(const std::string& arguments, double seconds) {
  return runShell("timeout -s KILL " + std::to_string(seconds) + " " BOZZETTO_PROGRAM " " +
                  arguments);
}

std::string CommandFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(*this / name, std::ios::binary) << text;
  return *this / name;
}

std::string CommandFolder::listing() const {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    names.insert(entry.path().filename());
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
  return list;
}

std::string sceneOf(const CommandFolder& folder, const std::string& recording,
                    const std::string& options) {
  const std::string file = folder.write("r.jsonl", recording), scene = folder / "s.bzt";
  const Outcome outcome = runProgram("replay " + file + " -o " + scene + " " + options);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return scene;
}

nlohmann::json jsonOf(const std::string& arguments) {
  const Outcome outcome = runProgram(arguments + " --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

nlohmann::json infoOf(const std::string& scene) { return jsonOf("info " + scene); }

}  // namespace bozzetto::testing
