#include "ui/pen.hpp"

#include <X11/Xatom.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <array>
#include <map>

namespace bozzetto::ui {
namespace {

struct Valuator {
  int number = 0;
  double low = 0, high = 1;
};

// The valuator named "Abs Pressure" of a device, if it has one.
bool findPressure(Display* display, const XIDeviceInfo& device, Valuator& found) {
  const Atom wanted = XInternAtom(display, "Abs Pressure", False);
  for (int n = 0; n < device.num_classes; ++n) {
    if (device.classes[n]->type != XIValuatorClass) continue;
    const auto& valuator = *reinterpret_cast<const XIValuatorClassInfo*>(device.classes[n]);
    if (valuator.label != wanted || valuator.max <= valuator.min) continue;
    found = {valuator.number, valuator.min, valuator.max};
    return true;
  }
  return false;
}

void listenTo(Display* display, Window window, int device, int event) {
  std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> bits{};
  XISetMask(bits.data(), event);
  XIEventMask mask{device, int(bits.size()), bits.data()};
  XISelectEvents(display, window, &mask, 1);
}

// A pen may be unplugged while it is asked about: no reason to end, as Xlib would.
class Lenient {
 public:
  explicit Lenient(Display* display)
      : display_(display), before_(XSetErrorHandler([](Display*, XErrorEvent*) { return 0; })) {}
  ~Lenient() {
    XSync(display_, False);
    XSetErrorHandler(before_);
  }
  Lenient(const Lenient&) = delete;
  Lenient& operator=(const Lenient&) = delete;

 private:
  Display* display_;
  XErrorHandler before_;
};

}  // namespace

struct Pen::Impl {
  Display* display = nullptr;
  Window window = 0;
  int opcode = 0;
  std::map<int, Valuator> pressure;  // by device
  std::map<int, double> last;        // valuators are told only when they change

  ~Impl() {
    if (display) XCloseDisplay(display);
  }

  void findPens() {
    const Lenient lenient(display);
    pressure.clear();
    int count = 0;
    XIDeviceInfo* devices = XIQueryDevice(display, XIAllDevices, &count);
    if (devices == nullptr) return;
    for (int n = 0; n < count; ++n) {
      Valuator valuator;
      if (devices[n].use != XISlavePointer) continue;
      if (!findPressure(display, devices[n], valuator)) continue;
      pressure[devices[n].deviceid] = valuator;
      listenTo(display, window, devices[n].deviceid, XI_Motion);
    }
    XIFreeDeviceInfo(devices);
  }

  void take(const XGenericEventCookie& cookie, std::vector<PointerMoved>& moves) {
    if (cookie.evtype == XI_HierarchyChanged) return findPens();
    if (cookie.evtype != XI_Motion) return;
    const auto& event = *static_cast<const XIDeviceEvent*>(cookie.data);
    if (pressure.contains(event.deviceid)) moves.push_back(moved(event));
  }

  PointerMoved moved(const XIDeviceEvent& event) {
    const Valuator& valuator = pressure.at(event.deviceid);
    const double* value = event.valuators.values;
    for (int n = 0; n < event.valuators.mask_len * 8; ++n) {
      if (!XIMaskIsSet(event.valuators.mask, n)) continue;
      if (n == valuator.number) {
        last[event.deviceid] = (*value - valuator.low) / (valuator.high - valuator.low);
      }
      ++value;
    }
    return {{event.event_x, event.event_y}, std::clamp(last[event.deviceid], 0.0, 1.0)};
  }
};

Pen::Pen(unsigned long window) : impl_(std::make_unique<Impl>()) {
  impl_->display = XOpenDisplay(nullptr);
  impl_->window = window;
  if (!impl_->display) return;
  int event = 0, error = 0, major = 2, minor = 2;
  const bool has =
      XQueryExtension(impl_->display, "XInputExtension", &impl_->opcode, &event, &error) &&
      XIQueryVersion(impl_->display, &major, &minor) == 0;
  if (!has) {
    impl_->opcode = 0;
    return;
  }
  listenTo(impl_->display, DefaultRootWindow(impl_->display), XIAllDevices, XI_HierarchyChanged);
  impl_->findPens();
}

Pen::~Pen() = default;

int Pen::devices() const { return int(impl_->pressure.size()); }

std::vector<PointerMoved> Pen::poll(Reach reach) {
  std::vector<PointerMoved> moves;
  if (impl_->opcode == 0) return moves;
  if (reach == Reach::sent) XSync(impl_->display, False);
  while (XPending(impl_->display) > 0) {
    XEvent event;
    XNextEvent(impl_->display, &event);
    XGenericEventCookie& cookie = event.xcookie;
    if (cookie.type != GenericEvent || cookie.extension != impl_->opcode) continue;
    if (!XGetEventData(impl_->display, &cookie)) continue;
    impl_->take(cookie, moves);
    XFreeEventData(impl_->display, &cookie);
  }
  return moves;
}

}  // namespace bozzetto::ui
