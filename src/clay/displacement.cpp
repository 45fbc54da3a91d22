// Large-scale displacement (Dewaele §3.1; clay.md §3.1): how far each cell wants to move.
#include "clay/displacement.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/clay/stiffness.hpp"
#include "clay/influence.hpp"
#include "clay/thinc.hpp"

namespace bozzetto::clay {
namespace {

constexpr int kSmoothings = 3;

// Painted stiffness: a cell of clay costs this where nothing is painted, 1 where all is (no less:
// Dial's buckets), its square where it is softest; kDearest keeps within the buckets.
constexpr float kSpread = 4, kLogSpread = 1.3862944f, kDearest = 250;

// Lets box means of 9 cells a side into the cost: thin places are weak (clay.md §3.1).
constexpr int kMeanReach = 4;

// out[n] = mean of in over n·step ± kMeanReach cells.
void meanAlong(const Region& region, const Cells<float>& in, Cells<float>& out,
               std::ptrdiff_t step) {
  forRows(region.rows(), [&](const Row& row) {
    for (std::int32_t k = 0; k < row.count; ++k) {
      const float* at = &in[row.base + k];
      float sum = 0;
      for (int n = -kMeanReach; n <= kMeanReach; ++n) sum += at[n * step];
      out[row.base + k] = sum * (1.0f / (2 * kMeanReach + 1));
    }
  });
}

}  // namespace

// Entering a cell costs 1/max(v, 0.01), or with parting 1/max(0.01, v·bⁿ), b the mean of v round
// about: then what is thin stretches first, and parts. Painted stiffness makes it up to four times
// as cheap, or as dear: what is stiff keeps its form, what is soft between gives way.
void Displacement::findCosts(Work& work) {
  Region& region = work.region;
  const auto power = static_cast<float>(work.settings.parting);
  if (power > 0) {
    forRows(region.rows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n)
        region.inverse[n] = std::min(region.value[n], 1.0f);
    });
    meanAlong(region, region.inverse, region.flux, region.strides()[0]);
    meanAlong(region, region.flux, region.inverse, region.strides()[1]);
    meanAlong(region, region.inverse, region.flux, region.strides()[2]);
  }
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      float ease = std::min(region.value[n], 1.0f);
      if (power > 0 && ease > 0)
        ease *= exponential(power * logarithm(std::max(region.flux[n], kThin)));
      region.rhs[n] = 1 / std::clamp(ease, 1 / kMostCost, 1.0f);
      if (region.stiffened)
        region.rhs[n] = std::clamp(
            region.rhs[n] * kSpread * exponential(kLogSpread * -region.offset(n)), 1.0f, kDearest);
    }
  });
}

void Displacement::findDistances(Work& work) {
  Region& region = work.region;
  const std::size_t moving = work.moving.size();
  const auto cells = static_cast<std::size_t>(region.box().count());
  if (cells != size_) distance_.clear();
  size_ = cells;
  while (distance_.size() < moving + 1) distance_.emplace_back(cells);
  path_.resize(moving + 1);
  // The pieces and the distances from each tool, side by side.
  parallelFor(moving + 2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) {
      if (task == 0) {
        pieces_.find(region, kThin);
      } else {
        const std::size_t n = task - 1;
        const auto owner = static_cast<std::uint8_t>(n < moving ? kMoving + n : +kStatic);
        path_[n].run(region, owner, region.rhs, distance_[n]);
      }
    }
  });
  contacts_.assign((moving + 1) * (moving + 1), {});
  for (std::size_t n = 0; n <= moving; ++n) {
    for (const Contact& contact : path_[n].contacts(pieces_)) {
      const std::size_t other =
          contact.owner == kStatic ? moving : static_cast<std::size_t>(contact.owner - kMoving);
      contacts_[n * (moving + 1) + other].push_back(contact);
      contacts_[other * (moving + 1) + n].push_back(contact);
    }
  }
}

// The least distance between two tools in a piece, from either side.
float Displacement::between(std::size_t pair, std::uint32_t piece) const {
  float least = kFar;
  for (const Contact& contact : contacts_[pair])
    if (contact.piece == piece) least = std::min(least, contact.distance);
  return least;
}

// Weight of moving tool `tool` at every cell, into `weight`; cells of tools marked in `fixed` as 0.
void Displacement::findLead(Work& work, std::size_t tool, Cells<float>& weight) {
  const Region& region = work.region;
  const std::size_t count = work.moving.size() + 1;
  forRows(region.rows(), [&](const Row& row) { std::fill_n(&weight[row.base], row.count, 0.0f); });
  const auto& runs = pieces_.runs();
  const auto offset =
      static_cast<float>(work.settings.distanceOffset) * (region.stiffened ? kSpread : 1.0f);
  parallelFor(runs.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<float> apart(count * count), distance(count), share(count);
    std::uint32_t piece = ~0u;
    for (std::size_t r = begin; r < end; ++r) {
      if (runs[r].root != piece) {
        piece = runs[r].root;
        for (std::size_t n = 0; n < apart.size(); ++n) apart[n] = between(n, piece);
      }
      for (std::size_t c = runs[r].base; c < runs[r].base + runs[r].count; ++c) {
        for (std::size_t t = 0; t < count; ++t)
          distance[t] = distance_[t][c] + (t + 1 < count ? offset : 0.0f);
        shareLead(distance, apart, share);
        weight[c] = ownerOf(region, c) == kStatic ? 0.0f : share[tool];
      }
    }
  });
}

// Jacobi means over neighbours with clay; cells of tools keep theirs.
void Displacement::smooth(Work& work, Cells<float>& weight, Cells<float>& spare) {
  Region& region = work.region;
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      int around = 2;
      for (const std::ptrdiff_t step : region.neighbours())
        around += region.value[n + step] >= kThin && region.owner[n + step] != kRim ? 1 : 0;
      const bool free = region.value[n] >= kThin && ownerOf(region, n) == kNobody;
      region.inverse[n] = free ? 1.0f / static_cast<float>(around) : 0.0f;
      if (region.value[n] < kThin) weight[n] = 0;
    }
  });
  const auto [di, dj, dk] = region.strides();
  for (int pass = 0; pass < kSmoothings; ++pass) {
    forRows(region.rows(), [&, di = di, dj = dj](const Row& row) {
      const float *w = &weight[row.base], *inverse = &region.inverse[row.base];
      float* out = &spare[row.base];
      for (std::ptrdiff_t n = 0; n < row.count; ++n) {
        const float sum =
            2 * w[n] + ((w[n + di] + w[n - di]) + (w[n + dj] + w[n - dj])) + (w[n + 1] + w[n - 1]);
        out[n] = inverse[n] > 0 ? sum * inverse[n] : w[n];
      }
    });
    swap(weight, spare);
  }
}

// How far cells follow, into `rhs`, whose costs are spent.
void Displacement::findFollowing(Work& work) {
  Region& region = work.region;
  if (!region.stiffened) return;
  const auto stiffness = static_cast<float>(work.settings.stiffness);
  forRows(region.rows(), [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n)
      region.rhs[n] = followingAt(stiffness, region.offset(n));
  });
}

// δ = α·w·(rigid motion of the tool); a piece that nothing holds moves as a whole, and what a grip
// holds moves with it. What is pulled stretches less and less towards both ends: no notch there.
void Displacement::addWish(Work& work, std::size_t tool, const Cells<float>& weight) {
  Region& region = work.region;
  const Motion& motion = work.moving[tool].motion;
  const bool grips = work.moving[tool].role == Role::grip;
  const auto reach =
      static_cast<float>(work.moving[tool].radius) * (region.stiffened ? kSpread : 1.0f);
  const auto stiffness = static_cast<float>(work.settings.stiffness);
  const Cells<float>&held = distance_.back(), &away = distance_[tool];
  const auto following = [&](std::size_t n) {
    if (held[n] == kFar) return 1.0f;
    const float follows = region.stiffened ? region.rhs[n] : stiffness;
    return grips ? follows + (1 - follows) * dragAt(away[n], reach) : follows;
  };
  forRows(region.rows(), [&](const Row& row) {
    const Key first = region.box().low + Key{row.i, row.j, row.k} - work.origin;
    const glm::dvec3 start = motion.at(glm::dvec3(first.i, first.j, first.k));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<float>(start[static_cast<int>(axis)]);
      const auto slope = static_cast<float>(motion.turn[2][static_cast<int>(axis)]);
      for (std::int32_t k = 0; k < row.count; ++k) {
        const std::size_t n = row.base + k;
        const float lead = grips ? eased(weight[n]) : weight[n];
        region.wish[axis][n] += following(n) * lead * (at + slope * static_cast<float>(k));
      }
    }
  });
}

void Displacement::run(Work& work) {
  Region& region = work.region;
  const bool leads = work.settings.stiffness > 0 || region.stiffened || work.grips();
  if (!leads || work.moving.empty()) return;
  findCosts(work);
  findDistances(work);
  if (carrying_.run(work, pieces_)) {
    pushedWhole_ = pushedWhole_ || !work.grips();
    return;
  }
  findFollowing(work);
  for (auto& axis : region.wish)
    forRows(region.rows(), [&](const Row& row) { std::fill_n(&axis[row.base], row.count, 0.0f); });
  for (std::size_t tool = 0; tool < work.moving.size(); ++tool) {
    findLead(work, tool, region.scratch);
    smooth(work, region.scratch, region.scratch2);
    addWish(work, tool, region.scratch);
  }
  for (auto& axis : region.wish)
    forRows(region.rows(), [&](const Row& row) {
      for (std::size_t n = row.base; n < row.base + row.count; ++n)
        axis[n] *= static_cast<float>(kFixed - region.hold[n]) * (1.0f / kFixed);
    });
  region.wished = true;
}

std::string Displacement::remark() const {
  if (!pushedWhole_) return {};
  return "nothing holds this clay: it was pushed along, whole (hold it, or put a support behind "
         "it)";
}

}  // namespace bozzetto::clay
