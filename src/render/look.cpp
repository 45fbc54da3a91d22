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

std::optional<Matcap> matcapNamed(std::string_view name) {
  using enum Matcap;
  for (const auto& [known, matcap] : {std::pair<std::string_view, Matcap>{"wax", wax},
                                      {"jade", jade},
                                      {"plaster", plaster},
                                      {"pewter", pewter}}) {
    if (name == known) return matcap;
  }
  return std::nullopt;
}

}  // namespace bozzetto
