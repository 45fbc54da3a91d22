// The real window: GLFW tells what happens, the interface and the canvas do the rest.
#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <algorithm>
#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/render/png.hpp"
#include "bozzetto/ui/window.hpp"
#include "ui/canvas.hpp"
#include "ui/pen.hpp"
#include "ui/puck.hpp"

namespace bozzetto {
namespace ui {
namespace {

static_assert(int(KeyCode::escape) == GLFW_KEY_ESCAPE && int(KeyCode::home) == GLFW_KEY_HOME &&
              int(KeyCode::f1) == GLFW_KEY_F1 && int(KeyCode::numpad0) == GLFW_KEY_KP_0 &&
              int(KeyCode::numpadEnter) == GLFW_KEY_KP_ENTER &&
              int(KeyCode::leftShift) == GLFW_KEY_LEFT_SHIFT &&
              int(KeyCode::rightAlt) == GLFW_KEY_RIGHT_ALT);

constexpr int kWidth = 1280, kHeight = 800;
constexpr double kRefining = 1 / 30.0;  // seconds between looks when a still view gets better

[[noreturn]] void fail(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error("window: " + what + (reason ? std::string(": ") + reason : ""));
}

// Starts GLFW and ends it.
struct Library {
  Library() {
    if (!glfwInit()) fail("no display");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

struct CloseWindow {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, CloseWindow>;

WindowHandle openWindow(const std::string& title) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 24);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "bozzetto");
  glfwWindowHint(GLFW_STEREO, GLFW_TRUE);  // few drivers have it
  WindowHandle window(glfwCreateWindow(kWidth, kHeight, title.c_str(), nullptr, nullptr));
  if (!window) {
    glfwGetError(nullptr);
    glfwWindowHint(GLFW_STEREO, GLFW_FALSE);
    window.reset(glfwCreateWindow(kWidth, kHeight, title.c_str(), nullptr, nullptr));
  }
  if (!window) fail("OpenGL 3.3 is needed");
  glfwSetWindowPos(window.get(), 0, 0);
  glfwShowWindow(window.get());
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  return window;
}

Button buttonOf(int number) {
  return number == GLFW_MOUSE_BUTTON_LEFT    ? Button::left
         : number == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                             : Button::middle;
}

// Mouse, pens and pucks. A pen moves the mouse too, without its pressure: those moves are left out.
class Devices {
 public:
  Devices(GLFWwindow* window, Interface& interface)
      : window_(window), interface_(&interface), pen_(glfwGetX11Window(window)) {}

  Interface& interface() { return *interface_; }
  void mouseMoved(glm::dvec2 to) {
    if (!penLeads()) interface_->post(PointerMoved{to, 1});
  }
  void pressed(Button button, bool down) {
    const bool pens = penLeads();
    penHolds_ = pens && down;
    if (!pens) {
      // Under another program's grab the pointer may have moved unseen.
      double x = 0, y = 0;
      glfwGetCursorPos(window_, &x, &y);
      interface_->post(PointerMoved{{x, y}, 1});
    }
    interface_->post(ButtonChanged{button, down});
  }

  void poll() {
    takePen(Pen::Reach::delivered);
    for (InputEvent& event : puck_.poll()) interface_->post(std::move(event));
  }
  /// How long the loop may sleep without missing them.
  double patience() const { return puck_.isThere() || pen_.devices() > 0 ? 0.015 : 0.5; }

 private:
  void takePen(Pen::Reach reach) {
    for (const PointerMoved& moved : pen_.poll(reach)) {
      interface_->post(moved);
      penMoved_ = glfwGetTime();
    }
  }
  bool penLeads() {
    if (pen_.devices() == 0) return false;
    takePen(Pen::Reach::sent);
    return penHolds_ || glfwGetTime() - penMoved_ < kPenStays;
  }

  static constexpr double kPenStays = 0.25;  // seconds after its last move
  GLFWwindow* window_;
  Interface* interface_;
  Pen pen_;
  Puck puck_;
  double penMoved_ = -1;
  bool penHolds_ = false;  // the button that is down went down under it
};

Devices& devicesOf(GLFWwindow* window) {
  return *static_cast<Devices*>(glfwGetWindowUserPointer(window));
}
Interface& interfaceOf(GLFWwindow* window) { return devicesOf(window).interface(); }

void listen(GLFWwindow* window) {
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    devicesOf(w).mouseMoved({x, y});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int number, int action, int) {
    if (number <= GLFW_MOUSE_BUTTON_MIDDLE)
      devicesOf(w).pressed(buttonOf(number), action == GLFW_PRESS);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    interfaceOf(w).post(WheelTurned{{x, y}});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
    interfaceOf(w).post(
        KeyChanged{static_cast<KeyCode>(key), action != GLFW_RELEASE, action == GLFW_REPEAT});
  });
  glfwSetCharCallback(
      window, [](GLFWwindow* w, unsigned codepoint) { interfaceOf(w).post(TextTyped{codepoint}); });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    interfaceOf(w).post(FilesDropped{{paths, paths + count}});
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    interfaceOf(w).post(FocusChanged{focused == GLFW_TRUE});
  });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { interfaceOf(w).post(RedrawAsked{}); });
  glfwSetFramebufferSizeCallback(
      window, [](GLFWwindow* w, int, int) { interfaceOf(w).post(RedrawAsked{}); });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    interfaceOf(w).post(CloseAsked{});
  });
}

// Keeps the window as the atelier wants it: title, whole screen.
class WindowState {
 public:
  explicit WindowState(GLFWwindow* window) : window_(window) {}

  void follow(const Atelier& atelier) {
    const std::string title = atelier.title() + (atelier.isModified() ? " *" : "") + " – bozzetto";
    if (title != title_) glfwSetWindowTitle(window_, title.c_str());
    title_ = title;
    if (atelier.fullScreen == full_) return;
    full_ = atelier.fullScreen;
    if (full_) {
      glfwGetWindowPos(window_, &x_, &y_);
      glfwGetWindowSize(window_, &width_, &height_);
      GLFWmonitor* monitor = glfwGetPrimaryMonitor();
      const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
      if (mode) glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, 0);
    } else {
      glfwSetWindowMonitor(window_, nullptr, x_, y_, width_, height_, 0);
    }
  }

 private:
  GLFWwindow* window_;
  std::string title_;
  bool full_ = false;
  int x_ = 0, y_ = 0, width_ = kWidth, height_ = kHeight;
};

float scaleFor(GLFWwindow* window, const Atelier& atelier) {
  if (atelier.settings.scale > 0) return float(atelier.settings.scale);
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::max(x, 1.f);
}

void shareClipboard(GLFWwindow* window) {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = window;
  io.SetClipboardTextFn = [](void* w, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
  };
  io.GetClipboardTextFn = [](void* w) {
    return glfwGetClipboardString(static_cast<GLFWwindow*>(w));
  };
}

void savePicture(Atelier& atelier, glm::dvec2 size) {
  if (!atelier.windowPicture) return;
  const std::filesystem::path path = *std::exchange(atelier.windowPicture, std::nullopt);
  try {
    writePng(path, Canvas::readBack(size));
    atelier.say(Message::Kind::note, "Saved " + path.filename().string());
  } catch (const Error& error) {
    atelier.say(Message::Kind::error, error.what());
  }
}

// Draws while something happens, sleeps otherwise.
class Loop {
 public:
  Loop(GLFWwindow* window, Atelier& atelier, Devices& devices, Canvas& canvas)
      : window_(window),
        atelier_(atelier),
        interface_(devices.interface()),
        canvas_(canvas),
        state_(window),
        devices_(devices) {}

  void run() {
    while (!atelier_.wantsToClose()) {
      wait();
      int width = 0, height = 0;
      glfwGetFramebufferSize(window_, &width, &height);
      if (width >= 64 && height >= 64 && isWorthAFrame()) drawFrame({width, height});
    }
  }

 private:
  void wait() {
    const double start = glfwGetTime();
    if (lively_ > 0) {
      glfwPollEvents();
    } else if (!settled_) {
      glfwWaitEventsTimeout(kRefining);
      refine_ = true;
    } else {
      glfwWaitEventsTimeout(atelier_.job() || speaking_ ? 0.1 : devices_.patience());
    }
    // Without a monitor's rhythm a frame that draws nothing must not spin.
    if (lively_ > 0 && start - lastStart_ < kShortestFrame) {
      glfwWaitEventsTimeout(kShortestFrame - (start - lastStart_));
    }
    devices_.poll();
  }

  bool isWorthAFrame() {
    const bool speaks = !atelier_.messages().empty();
    const bool talked = std::exchange(speaking_, speaks) || speaks;
    return lively_ > 0 || std::exchange(refine_, false) || interface_.hasEvents() ||
           atelier_.hasNews() || atelier_.job() || atelier_.feltHand() || talked;
  }

  void drawFrame(glm::dvec2 size) {
    const double start = lastStart_ = glfwGetTime();
    interface_.setScale(scaleFor(window_, atelier_));
    const bool busy =
        interface_.hasEvents() || atelier_.hasNews() || atelier_.job() || atelier_.feltHand();
    Publication fresh = interface_.frame(size, start);
    state_.follow(atelier_);
    settled_ = canvas_.draw(std::move(fresh), size);
    savePicture(atelier_, size);
    glfwSwapBuffers(window_);
    interface_.figures.milliseconds = 1000 * (glfwGetTime() - start);
    // ImGui needs a frame or two to settle.
    lively_ = busy || interface_.hasEvents() ? 3 : std::max(lively_ - 1, 0);
  }

  static constexpr double kShortestFrame = 1 / 125.0;
  GLFWwindow* window_;
  Atelier& atelier_;
  Interface& interface_;
  Canvas& canvas_;
  WindowState state_;
  Devices& devices_;
  int lively_ = 3;
  bool settled_ = false, refine_ = false, speaking_ = false;
  double lastStart_ = -1;
};

}  // namespace
}  // namespace ui

void runWindow(const WindowOptions& given) {
  // A name for a scene that is to be; anything else is a slip of the fingers.
  if (!given.scene.empty() && given.scene.extension() != ".bzt" &&
      !std::filesystem::exists(given.scene)) {
    throw Error(given.scene.string() + ": no such scene, and no command of bozzetto");
  }
  const ui::Library library;
  const ui::WindowHandle window = ui::openWindow("bozzetto");
  ui::Atelier::Options options;
  options.scene = given.scene;
  options.configFolder = ui::configFolder();
  options.wake = [] { glfwPostEmptyEvent(); };
  ui::Atelier atelier(options);
  ui::Interface interface(atelier);
  ui::Canvas canvas(interface, atelier);
  atelier.thumbnail = [&canvas] { return canvas.thumbnail(); };
  ui::Devices devices(window.get(), interface);
  glfwSetWindowUserPointer(window.get(), &devices);
  ui::listen(window.get());
  ui::shareClipboard(window.get());
  ui::Loop(window.get(), atelier, devices, canvas).run();
}

}  // namespace bozzetto
