#include "process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>

namespace bozzetto::compare {
namespace {

std::vector<char*> argumentList(const std::filesystem::path& program,
                                const std::vector<std::string>& arguments) {
  std::vector<char*> list{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
  list.push_back(nullptr);
  return list;
}

// Starts the program with `output` as its standard output; 0 when it could not be.
pid_t start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            int output, int unused) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, output);
  posix_spawn_file_actions_addclose(&actions, unused);
  pid_t child = 0;
  const std::vector<char*> list = argumentList(program, arguments);
  const int failure = posix_spawn(&child, program.c_str(), &actions, nullptr, list.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failure == 0 ? child : 0;
}

std::string readAll(int descriptor) {
  std::string text;
  std::array<char, 65536> buffer;
  for (ssize_t n = 0; (n = read(descriptor, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  return text;
}

}  // namespace

std::optional<std::string> outputOf(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments) {
  int pipeEnds[2];
  if (pipe(pipeEnds) != 0) return std::nullopt;
  const pid_t child = start(program, arguments, pipeEnds[1], pipeEnds[0]);
  close(pipeEnds[1]);
  const std::string text = readAll(pipeEnds[0]);
  close(pipeEnds[0]);
  int status = -1;
  if (child != 0) waitpid(child, &status, 0);
  if (child != 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return text;
  std::fprintf(stderr, "%s failed (status %d)\n", program.c_str(), status);
  return std::nullopt;
}

}  // namespace bozzetto::compare
