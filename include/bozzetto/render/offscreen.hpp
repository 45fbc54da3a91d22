// An OpenGL 3.3 context without a window or a display.
#pragma once
#include <memory>
#include <string>

namespace bozzetto {

/// Current on the thread that made it, until it dies or another becomes current. Throws Error when
/// the machine has no EGL that draws without a surface.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void makeCurrent();
  /// What draws, as the driver calls itself.
  std::string rendererName() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bozzetto
