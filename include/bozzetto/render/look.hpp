// What the clay is made of in a picture.
#pragma once
#include <string_view>

namespace bozzetto {

enum class Mode {
  clay,    ///< matt wet clay in its own colours
  glaze,   ///< the same under a clear coat
  metal,   ///< the environment only
  glass,   ///< see-through, nearest front and back faces
  matcap,  ///< a painted ball's shading in one colour
  wire,    ///< plaster with the edges of the triangles
};
enum class Metal { chrome, bronze };
enum class Matcap { wax, jade, plaster, pewter };

/// `full` computes light, shadow and floor shadow at every pixel; `baked` reads the studio from one
/// small picture of a ball (2–3 times as fast, no cast shadows): for moving frames.
enum class Detail { full, baked };

struct Look {
  Mode mode = Mode::clay;
  Metal metal = Metal::chrome;
  Matcap matcap = Matcap::wax;
  Detail detail = Detail::full;
  double dither = 0;  ///< 1 hides the background's bands on screen; 0 keeps files small
};

/// The name on the command line → mode. Throws Error naming the choices.
Mode parseMode(std::string_view name);

}  // namespace bozzetto
