#include "clay/carrying.hpp"

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "clay/pseudo_distance.hpp"

namespace bozzetto::clay {
namespace {

constexpr double kTurned = 1e-9;  // rotations that are none come out as this, or less
constexpr double kFurther = 0.25;
constexpr int kMostFurther = 6;
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

bool turns(const Motion& motion) {
  for (int axis = 0; axis < 3; ++axis)
    if (glm::length(motion.turn[axis]) > kTurned) return true;
  return false;
}

glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& way) { return v - way * glm::dot(v, way); }

// Where the piece should be: a push goes so far ahead that, however that is rounded to cells, the
// piece goes as far as the tool.
glm::dvec3 aim(const PlacedTool& tool, const glm::dvec3& owed) {
  const glm::dvec3 shift = tool.motion.shift;
  if (tool.role == Role::grip) return owed + shift;
  const glm::dvec3 way = glm::normalize(shift);
  const double lead = 0.5 * (std::abs(way.x) + std::abs(way.y) + std::abs(way.z));
  return across(owed, way) + shift + way * lead;
}

Key nearest(const glm::dvec3& place) {
  return {static_cast<std::int32_t>(std::lround(place.x)),
          static_cast<std::int32_t>(std::lround(place.y)),
          static_cast<std::int32_t>(std::lround(place.z))};
}

void aimAt(auto& leg, const glm::dvec3& place, const Region& region) {
  const auto& step = region.strides();
  leg.place = place;
  leg.cells = nearest(place);
  leg.step = leg.cells.i * step[0] + leg.cells.j * step[1] + leg.cells.k;
}

bool besidePiece(const Region& region, std::size_t cell, const auto& isOfPiece) {
  for (const std::ptrdiff_t i : {-1, 0, 1})
    for (const std::ptrdiff_t j : {-1, 0, 1})
      for (const std::ptrdiff_t k : {-1, 0, 1})
        if (isOfPiece(cell + i * region.strides()[0] + j * region.strides()[1] + k)) return true;
  return false;
}

}  // namespace

// Which pieces a moving tool touches, and whether they are free.
void Carrying::look(const Region& region, const Pieces& pieces) {
  pieces_.assign(pieces.runs().size(), {});
  for (const Pieces::Run& run : pieces.runs()) {
    Piece& piece = pieces_[run.root];
    for (std::size_t cell = run.base; cell < run.base + run.count; ++cell) {
      const std::uint8_t owner = region.owner[cell];
      piece.fixed = piece.fixed || region.hold[cell] != 0 || owner == kStatic;
      if (owner < kMoving || owner == piece.owner) continue;
      piece.fixed = piece.fixed || piece.owner != kNobody;
      piece.owner = owner;
    }
  }
}

// One for each tool that touches anything; false where what is touched cannot be carried.
bool Carrying::findLegs(const Work& work) {
  legs_.clear();
  owed_.resize(work.moving.size(), glm::dvec3(0));
  for (std::size_t n = 0; n < work.moving.size(); ++n) {
    const auto owner = static_cast<std::uint8_t>(kMoving + n);
    bool touches = false;
    for (const Piece& piece : pieces_) {
      if (piece.owner == owner && piece.fixed) return false;
      touches = touches || piece.owner == owner;
    }
    if (!touches) continue;
    const PlacedTool& tool = work.moving[n];
    if (turns(tool.motion) || glm::length(tool.motion.shift) < kTurned) return false;
    legs_.push_back({owner, {}});
    aimAt(legs_.back(), aim(tool, owed_[n]), work.region);
  }
  return !legs_.empty();
}

// Cells to be carried, by their tool; with them what is thin beside them.
void Carrying::mark(Region& region, const Pieces& pieces) const {
  const auto ownerAt = [&](std::size_t cell) {
    if (region.value[cell] < kThin || region.owner[cell] == kRim) return kNobody;
    return static_cast<Owner>(pieces_[pieces.pieceAt(cell)].owner);
  };
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      if (region.value[n] <= 0) continue;
      std::uint8_t owner = ownerAt(n);
      if (region.value[n] < kThin)
        besidePiece(region, n, [&](std::size_t next) {
          owner = ownerAt(next);
          return owner != kNobody;
        });
      region.mark[n] = owner;
    }
  });
}

// Where the surface faces sideways, cells beside the way lead back into the tool: a little further,
// then. Clay that is all round the tool stays about it.
void Carrying::leadClear(const Work& work) {
  const Region& region = work.region;
  const auto meets = [&](const Leg& leg) {
    std::atomic<bool> met = false;
    forRows(region.bandRows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n) {
        const bool carried = region.mark[n] == leg.owner && region.value[n] >= kThin;
        if (carried && region.owner[n + leg.step] == leg.owner) met = true;
      }
    });
    return met.load();
  };
  for (Leg& leg : legs_) {
    const PlacedTool& tool = work.moving[leg.owner - kMoving];
    if (tool.role == Role::grip) continue;
    Leg further = leg;
    for (int n = 0; n < kMostFurther && meets(further); ++n)
      aimAt(further, further.place + kFurther * glm::normalize(tool.motion.shift), region);
    if (!meets(further)) leg = further;
  }
}

bool Carrying::hasRoom(const Region& region) const {
  std::atomic<bool> room = true;
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      if (region.mark[n] == 0) continue;
      for (const Leg& leg : legs_) {
        if (region.mark[n] != leg.owner) continue;
        const std::size_t next = n + leg.step;
        const bool other = region.mark[next] != leg.owner && region.value[next] >= kThin;
        if (other || region.owner[next] == kStatic || region.owner[next] == kRim) room = false;
      }
    }
  });
  return room;
}

void Carrying::shift(Region& region) const {
  const auto source = [&](std::size_t n) {
    for (const Leg& leg : legs_)
      if (region.mark[n - leg.step] == leg.owner) return n - leg.step;
    return kNowhere;
  };
  for (auto& channel : region.carried) {
    forRows(region.rows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n) {
        const std::size_t from = source(n);
        region.scratch[n] = channel[from != kNowhere ? from : n];
      }
    });
    forRows(region.rows(), [&](const Row& row) {
      std::copy_n(&region.scratch[row.base], row.count, &channel[row.base]);
    });
  }
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      const std::size_t from = source(n);
      const float stays = region.mark[n] == 0 ? region.value[n] : 0.0f;
      region.scratch[n] = stays + (from != kNowhere ? region.value[from] : 0.0f);
    }
  });
  forRows(region.rows(), [&](const Row& row) {
    std::copy_n(&region.scratch[row.base], row.count, &region.value[row.base]);
    std::fill_n(&region.pressure[row.base], row.count, 0.0f);
  });
  region.touchRows();
}

bool Carrying::run(Work& work, const Pieces& pieces) {
  Region& region = work.region;
  look(region, pieces);
  if (!findLegs(work)) return false;
  mark(region, pieces);
  leadClear(work);
  const bool room = hasRoom(region);
  if (room) {
    shift(region);
    for (const Leg& leg : legs_)
      owed_[leg.owner - kMoving] = leg.place - glm::dvec3(leg.cells.i, leg.cells.j, leg.cells.k);
  }
  forRows(region.rows(),
          [&](const Row& row) { std::fill_n(&region.mark[row.base], row.count, std::uint8_t{0}); });
  return room;
}

}  // namespace bozzetto::clay
