// What the clay is made of in a picture.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "bozzetto/render/image.hpp"
#include "bozzetto/render/studio.hpp"

namespace bozzetto {

enum class Mode {
  clay,     ///< matt wet clay in its own colours: no environment
  glaze,    ///< the same under a clear coat: environment by angle
  metal,    ///< the environment only, opaque
  plastic,  ///< a layer of paint: the environment, half transparent
  glass,    ///< see-through, nearest front and back faces
  matcap,   ///< a painted ball's shading in one colour
  wire,     ///< plaster with the edges of the triangles
};
/// Ferley's modes of environment mapping (§2, §5), in the order a key cycles through them.
inline constexpr std::array kEnvironmentModes{Mode::clay, Mode::metal, Mode::plastic, Mode::glaze};

enum class Metal { chrome, bronze };
enum class Matcap { wax, jade, plaster, pewter };
enum class Shading { smooth, flat };

/// `full` computes light, shadow and floor shadow at every pixel; `baked` reads the studio from one
/// small picture of a ball (2–3 times as fast, no cast shadows): for moving frames.
enum class Detail { full, baked };

/// Highlights of clay, glaze and plastic.
struct Specular {
  float roughness = .36f;  ///< 0 mirror … 1 chalk
  float strength = 1.5f;   ///< 0 none
  friend bool operator==(const Specular&, const Specular&) = default;
};

struct Look {
  Mode mode = Mode::clay;
  Metal metal = Metal::chrome;
  Matcap matcap = Matcap::wax;
  /// Instead of `matcap` where set: a picture of a lit ball that fills a square, row 0 on top.
  std::shared_ptr<const Image> matcapImage;
  Shading shading = Shading::smooth;
  Specular specular;
  float paint = .5f;       ///< plastic: 0 no layer … 1 the environment alone
  bool edges = false;      ///< triangles' edges over any mode
  bool cellLines = false;  ///< lines where cells meet, for pictures of the data structure
  bool floor = true;       ///< pool of light, contact and shadow under the clay
  float holdTint = 1;      ///< how much held clay, and painted stiffness, are tinted
  Detail detail = Detail::full;
  double dither = 0;  ///< 1 hides the background's bands on screen; 0 keeps files small
  Studio studio;

  friend bool operator==(const Look&, const Look&) = default;
};

/// The name on the command line → mode. Throws Error naming the choices.
Mode parseMode(std::string_view name);
/// The painted matcap of that name, if it is one.
std::optional<Matcap> matcapNamed(std::string_view name);

}  // namespace bozzetto
