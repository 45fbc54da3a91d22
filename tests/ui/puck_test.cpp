// A SpaceMouse whose daemon is this test.
#include "ui/puck.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "support/folder.hpp"

namespace bozzetto::ui {
namespace {

/// What spacenavd tells a client: eight numbers an event.
using Wire = std::array<int, 8>;
constexpr int kMotion = 0, kPress = 1, kRelease = 2;

class FakeDaemon {
 public:
  FakeDaemon() {
    listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    ::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(listener_, 1);
    ::setenv("SPNAV_SOCKET", path_.c_str(), 1);
  }
  ~FakeDaemon() {
    if (client_ >= 0) ::close(client_);
    ::close(listener_);
    ::unsetenv("SPNAV_SOCKET");
  }
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;

  void accept() { client_ = ::accept(listener_, nullptr, nullptr); }
  void tell(const Wire& event) {
    ASSERT_EQ(::write(client_, event.data(), sizeof event), ssize_t(sizeof event));
  }

 private:
  const testing::Folder folder_;
  const std::filesystem::path path_ = folder_ / "spnav";
  int listener_ = -1, client_ = -1;
};

std::vector<InputEvent> pollFor(Puck& puck, std::size_t count) {
  std::vector<InputEvent> events;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (events.size() < count && std::chrono::steady_clock::now() < end) {
    for (InputEvent& event : puck.poll()) events.push_back(std::move(event));
    ::usleep(1000);
  }
  return events;
}

TEST(Puck, withoutADaemonThereIsNone) {
  ::setenv("SPNAV_SOCKET", "/nowhere/at/all", 1);
  Puck puck;
  EXPECT_FALSE(puck.isThere());
  EXPECT_TRUE(puck.poll().empty());
  ::unsetenv("SPNAV_SOCKET");
}

TEST(Puck, tellsPushesTurnsAndButtonsInOrder) {
  FakeDaemon daemon;
  Puck puck;
  ASSERT_TRUE(puck.isThere());
  daemon.accept();
  daemon.tell({kMotion, 350, 0, -175, 0, 70, 700, 16});
  daemon.tell({kPress, 1, 0, 0, 0, 0, 0, 0});
  daemon.tell({kRelease, 1, 0, 0, 0, 0, 0, 0});
  daemon.tell({kMotion, 0, 0, 0, 0, 0, 0, 100000});
  const auto events = pollFor(puck, 4);
  ASSERT_EQ(events.size(), 4u);
  const auto& moved = std::get<PuckMoved>(events[0]);
  EXPECT_DOUBLE_EQ(moved.push.x, 1);
  EXPECT_DOUBLE_EQ(moved.push.z, 0.5);  // towards the viewer
  EXPECT_DOUBLE_EQ(moved.turn.y, 0.2);
  EXPECT_DOUBLE_EQ(moved.turn.z, -1);  // no further than the stop
  EXPECT_DOUBLE_EQ(moved.seconds, 0.016);
  EXPECT_TRUE(std::get<PuckButton>(events[1]).down);
  EXPECT_EQ(std::get<PuckButton>(events[1]).number, 1);
  EXPECT_FALSE(std::get<PuckButton>(events[2]).down);
  EXPECT_LE(std::get<PuckMoved>(events[3]).seconds, 0.1);
}

}  // namespace
}  // namespace bozzetto::ui
