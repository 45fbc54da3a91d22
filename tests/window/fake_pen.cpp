// A pen for the X server's driver inputtest(4): fake_pen SOCKET WIDTH HEIGHT does what it is told:
// "near", "away", "move X Y PRESSURE" (pixels, 0 ... 1), "down", "up", "wait MILLISECONDS". Every
// event has gone through the server before the next line is read.
#include <array>
#include <cstdint>

#include "window/fake_device.hpp"

namespace {

using namespace bozzetto::testing;

// As xf86-input-inputtest-protocol.h has them.
enum class Kind : std::uint32_t { version, sync, motion, proximity, button };
constexpr std::size_t kValuators = 64;
constexpr double kLargest = 0xffff, kHardest = 1000;  // of the axes, as the driver makes them
constexpr int kPressureAxis = 4;

struct Header {
  std::uint32_t length;
  Kind kind;
};

struct Valuators {
  std::uint32_t hasRaw = 0;
  std::array<std::uint8_t, kValuators / 8> set{};
  std::array<double, kValuators> value{}, raw{};
};

struct Version {
  Header header{sizeof(Version), Kind::version};
  std::uint16_t major = 1, minor = 0;
};

struct Sync {
  Header header{sizeof(Sync), Kind::sync};
};

struct Motion {
  Header header{sizeof(Motion), Kind::motion};
  std::uint32_t absolute = 1;
  Valuators axes;
};

struct Proximity {
  Header header{sizeof(Proximity), Kind::proximity};
  std::uint32_t near = 0;
  Valuators axes;
};

struct Press {
  Header header{sizeof(Press), Kind::button};
  std::int32_t absolute = 1, button = 1;
  std::uint32_t down = 0;
  Valuators axes;
};

template <class Event>
bool tell(int driver, const Event& event) {
  const Sync sync;
  std::array<std::byte, 64> answer;
  return send(driver, std::as_bytes(std::span(&event, 1))) &&
         send(driver, std::as_bytes(std::span(&sync, 1))) &&
         ::read(driver, answer.data(), answer.size()) > 0;
}

bool begin(int driver) {
  const Version version;
  std::array<std::byte, 64> answer;
  return send(driver, std::as_bytes(std::span(&version, 1))) &&
         ::read(driver, answer.data(), answer.size()) > 0;
}

Motion moved(std::istream& words, double width, double height) {
  double x = 0, y = 0, pressure = 0;
  words >> x >> y >> pressure;
  Motion motion;
  motion.axes.value[0] = x / width * kLargest;
  motion.axes.value[1] = y / height * kLargest;
  motion.axes.value[kPressureAxis] = pressure * kHardest;
  motion.axes.set[0] = 1 | 2 | 1 << kPressureAxis;
  return motion;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const int driver = ::socket(AF_UNIX, SOCK_STREAM, 0);
  const sockaddr_un address = addressOf(arguments[1]);
  if (::connect(driver, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return 1;
  if (!begin(driver)) return 1;
  const double width = std::stod(arguments[2]), height = std::stod(arguments[3]);
  return play([&](const std::string& verb, std::istream& words) {
    if (verb == "wait") {
      unsigned milliseconds = 0;
      words >> milliseconds;
      return ::usleep(milliseconds * 1000) == 0;
    }
    if (verb == "move") return tell(driver, moved(words, width, height));
    if (verb == "near" || verb == "away") {
      Proximity change;
      change.near = verb == "near";
      return tell(driver, change);
    }
    Press press;
    press.down = verb == "down";
    return tell(driver, press);
  });
}
