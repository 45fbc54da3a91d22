// GL switches that are on during a scope.
#pragma once
#include "render/gl.hpp"

namespace bozzetto::gl {

class Enabled {
 public:
  explicit Enabled(GLenum what) : what_(what) { glEnable(what_); }
  Enabled(const Enabled&) = delete;
  Enabled& operator=(const Enabled&) = delete;
  ~Enabled() { glDisable(what_); }

 private:
  GLenum what_;
};

}  // namespace bozzetto::gl
