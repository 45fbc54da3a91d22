// A file manager's part of drag and drop (XDND 5): drop_files X Y FILE... drops them on the window
// at that place of the screen. Ends with 0 when the window has taken them.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

namespace {

class Source {
 public:
  Source(int x, int y, std::string list) : x_(x), y_(y), list_(std::move(list)) {
    window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
  }
  ~Source() { XCloseDisplay(display_); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  bool drop() {
    target_ = windowUnder();
    if (target_ == None) return false;
    tell("XdndEnter", {5l << 24, long(atom("text/uri-list")), 0, 0});
    tell("XdndPosition", {0, long(x_) << 16 | y_, CurrentTime, long(atom("XdndActionCopy"))});
    if (!(waitFor("XdndStatus") & 1)) return false;
    tell("XdndDrop", {0, CurrentTime, 0, 0});
    return waitFor("XdndFinished") != 0;  // GLFW tells how many bytes it took
  }

 private:
  struct Data {
    long at[4];
  };

  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  bool isAware(Window window) {
    Atom type;
    int format;
    unsigned long count, left;
    unsigned char* value = nullptr;
    XGetWindowProperty(display_, window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type,
                       &format, &count, &left, &value);
    if (value) XFree(value);
    return type != None;
  }

  Window windowUnder() {
    Window window = DefaultRootWindow(display_);
    while (window != None && !isAware(window)) {
      Window child = None;
      int x, y;
      XTranslateCoordinates(display_, DefaultRootWindow(display_), window, x_, y_, &x, &y, &child);
      window = child;
    }
    return window;
  }

  void tell(const char* what, const Data& data) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(what);
    event.xclient.format = 32;
    event.xclient.data.l[0] = long(window_);
    std::copy(std::begin(data.at), std::end(data.at), event.xclient.data.l + 1);
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  void give(const XSelectionRequestEvent& asked) {
    XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(list_.data()), int(list_.size()));
    XEvent answer{};
    answer.xselection = {
        SelectionNotify, 0,         True, display_, asked.requestor, asked.selection, asked.target,
        asked.property,  asked.time};
    XSendEvent(display_, asked.requestor, False, NoEventMask, &answer);
    XFlush(display_);
  }

  // The flags that come with it; 0 after ten seconds.
  long waitFor(const char* what) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end) {
      if (XPending(display_) == 0) {
        const timespec pause{0, 5'000'000};
        nanosleep(&pause, nullptr);
        continue;
      }
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) give(event.xselectionrequest);
      if (event.type == ClientMessage && event.xclient.message_type == atom(what))
        return event.xclient.data.l[1];
    }
    std::fprintf(stderr, "drop_files: no %s\n", what);
    return 0;
  }

  Display* display_ = XOpenDisplay(nullptr);
  Window window_ = None, target_ = None;
  int x_, y_;
  std::string list_;
};

std::string uriOf(const std::filesystem::path& path) {
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(path).string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("/-_.~", c);
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    uri += plain ? std::string(1, c) : code;
  }
  return uri + "\r\n";
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  std::string list;
  for (int n = 3; n < count; ++n) list += uriOf(arguments[n]);
  return Source(std::atoi(arguments[1]), std::atoi(arguments[2]), list).drop() ? 0 : 1;
}
