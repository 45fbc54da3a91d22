#include "bozzetto/render/look.hpp"

#include "render/names.hpp"

namespace bozzetto {

Mode parseMode(std::string_view name) {
  using enum Mode;
  return parseName<Mode>("mode", name,
                         {{"clay", clay},
                          {"glaze", glaze},
                          {"metal", metal},
                          {"plastic", plastic},
                          {"glass", glass},
                          {"matcap", matcap},
                          {"wire", wire}});
}

}  // namespace bozzetto
