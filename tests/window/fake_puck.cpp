// spacenavd, without a SpaceMouse: fake_puck SOCKET waits for the window there, then does what it
// is told: "move X Y Z RX RY RZ MILLISECONDS", "press N", "release N", "wait MILLISECONDS".
#include <array>

#include "window/fake_device.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  const sockaddr_un address = bozzetto::testing::addressOf(arguments[1]);
  ::unlink(arguments[1]);
  if (::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return 1;
  ::listen(listener, 1);
  const int client = ::accept(listener, nullptr, nullptr);
  return bozzetto::testing::play([&](const std::string& verb, std::istream& words) {
    std::array<int, 8> event{};  // what spacenavd sends
    if (verb == "wait") {
      words >> event[0];
      return ::usleep(useconds_t(event[0]) * 1000) == 0;
    }
    event[0] = verb == "move" ? 0 : verb == "press" ? 1 : 2;
    for (std::size_t n = 1; n < event.size() && words >> event[n]; ++n) {
    }
    return bozzetto::testing::send(client, std::as_bytes(std::span(event)));
  });
}
