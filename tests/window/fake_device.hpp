// A socket that stands for a device, and a script for it on the standard input.
#pragma once
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <iostream>
#include <span>
#include <sstream>
#include <string>

namespace bozzetto::testing {

inline sockaddr_un addressOf(const char* path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path, sizeof address.sun_path - 1);
  return address;
}

inline bool send(int socket, std::span<const std::byte> bytes) {
  return ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) == ssize_t(bytes.size());
}

/// Calls `act(verb, rest of the line)` for every line; 1 when one of them fails.
template <class Act>
int play(const Act& act) {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    if (!act(verb, words)) {
      std::cerr << "failed: " << line << "\n";
      return 1;
    }
  }
  return 0;
}

}  // namespace bozzetto::testing
