// Pieces of clay that nothing holds, carried by whole cells: every density arrives as it was. Moved
// by half a cell at a time a body that only changes its place would grow rings and scales. The
// price is that a grip's piece may end half a cell (an axis) from where it was led.
#pragma once
#include "clay/layer.hpp"
#include "clay/pieces.hpp"

namespace bozzetto::clay {

class Carrying {
 public:
  /// Carries what the moving tools touch, and says so; false, and nothing done, where any of it is
  /// held, touched by two tools, turned, or in the way of other clay: then it has to give way.
  /// A push leads its piece by a cell or two, so that the tool does not stand in it.
  bool run(Work& work, const Pieces& pieces);

 private:
  struct Piece {
    std::uint8_t owner = kNobody;  ///< the moving tool that touches it, if any
    bool fixed = false;            ///< held, or touched by two tools
  };
  /// What one tool carries, and how far.
  struct Leg {
    std::uint8_t owner;
    glm::dvec3 place;  ///< that is aimed at
    Key cells{};       ///< the nearest whole ones
    std::ptrdiff_t step = 0;
  };
  void look(const Region& region, const Pieces& pieces);
  bool findLegs(const Work& work);
  void mark(Region& region, const Pieces& pieces) const;
  void leadClear(const Work& work);
  bool hasRoom(const Region& region) const;
  void shift(Region& region) const;

  std::vector<glm::dvec3> owed_;  // of each moving tool's way, in cells
  std::vector<Piece> pieces_;     // by their root
  std::vector<Leg> legs_;
};

}  // namespace bozzetto::clay
