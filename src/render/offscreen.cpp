#include "bozzetto/render/offscreen.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

[[noreturn]] void fail(const char* what) {
  throw Error(std::string("OpenGL off-screen: ") + what + " (EGL code " +
              std::to_string(eglGetError()) + "); Mesa's EGL (libegl1, libgl1-mesa-dri) is needed");
}

EGLDisplay openDisplay() {
  // libepoxy ends the program when it finds no libEGL: ask first.
  if (!epoxy_has_egl()) {
    throw Error("OpenGL off-screen: libEGL.so.1 not found; Mesa's EGL (libegl1) is needed");
  }
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    fail("no surfaceless platform");
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("no display");
  if (!eglInitialize(display, nullptr, nullptr)) fail("EGL does not start");
  return display;
}

}  // namespace

struct OffscreenContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

OffscreenContext::OffscreenContext() : impl_(std::make_unique<Impl>()) {
  impl_->display = openDisplay();
  if (!eglBindAPI(EGL_OPENGL_API)) fail("no desktop OpenGL");
  constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                    3,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    3,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_NONE};
  impl_->context = eglCreateContext(impl_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
  if (impl_->context == EGL_NO_CONTEXT) fail("no OpenGL 3.3 core context");
  try {
    makeCurrent();
  } catch (...) {
    eglDestroyContext(impl_->display, impl_->context);
    throw;
  }
}

// The display is the process's: other contexts may use it, so it is not terminated.
OffscreenContext::~OffscreenContext() {
  if (eglGetCurrentContext() == impl_->context) {
    eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(impl_->display, impl_->context);
}

void OffscreenContext::makeCurrent() {
  if (!eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, impl_->context)) {
    fail("the context cannot be made current");
  }
}

std::string OffscreenContext::rendererName() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
}

}  // namespace bozzetto
