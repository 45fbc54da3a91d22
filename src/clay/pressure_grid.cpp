#include "clay/pressure_grid.hpp"

#include <algorithm>
#include <cstring>

namespace bozzetto::clay {
namespace {

constexpr auto kClay = static_cast<std::uint8_t>(CellType::clay);
constexpr int kSmoothings = 2, kBottomSweeps = 12;
constexpr float kRelaxation = 1.15f, kBottomRelaxation = 1.6f;
constexpr float kLinkWeight = 0.5f;  // four times the area, twice the way: 2 for 4 faces

struct LevelRow {
  const float *link[3], *source, *inverse;
  float* pressure;
  std::ptrdiff_t step[3];
};

float pulled(const LevelRow& row, std::ptrdiff_t n) {
  float sum = 0;
  for (int a = 0; a < 3; ++a)
    sum += row.link[a][n] * row.pressure[n + row.step[a]] +
           row.link[a][n - row.step[a]] * row.pressure[n - row.step[a]];
  return sum;
}

// Σ over neighbours − rhs, less what the cell itself takes: nothing when the equation holds.
struct ResidualRow {
  const float *pressure, *rhs, *inverse;
  std::ptrdiff_t di, dj;
  int count;
};

BOZZETTO_KERNEL void residualKernel(const ResidualRow& row, float* __restrict sums) {
  const float *p = row.pressure, *inverse = row.inverse;
  for (int n = 0; n < row.count; n += 2) {
    float pair = 0;
    for (int m = n; m < n + 2; ++m) {
      const float sum = ((p[m + row.di] + p[m - row.di]) + (p[m + row.dj] + p[m - row.dj])) +
                        (p[m + 1] + p[m - 1]);
      const float own = inverse[m] > 0 ? (sum - row.rhs[m]) - p[m] / inverse[m] : 0.0f;
      pair += own;
    }
    sums[n / 2] += pair;
  }
}

BOZZETTO_SIMD_DISPATCH(void, residualRow, residualKernel, (const ResidualRow& row, float* sums),
                       (row, sums))

// Coarse grids have P itself, what is left of its equation is m times as much as of that for Q.
void fadedResidualRow(const ResidualRow& row, const float* m, float* sums) {
  const float *p = row.pressure, *inverse = row.inverse;
  for (int n = 0; n < row.count; ++n) {
    if (inverse[n] <= 0) continue;
    const float sum =
        ((p[n + row.di] + p[n - row.di]) + (p[n + row.dj] + p[n - row.dj])) + (p[n + 1] + p[n - 1]);
    sums[n / 2] += m[n] * ((sum - row.rhs[n]) - p[n] / inverse[n]);
  }
}

// Four coarse cells in a row, and those behind their far faces, are clay without air round it: what
// most of a body is.
bool openAllRound(const std::uint8_t* type, const std::uint8_t* air,
                  const std::array<std::ptrdiff_t, 3>& step) {
  constexpr std::uint64_t eightOfClay = 0x0101010101010101u * kClay;
  const auto eight = [](const std::uint8_t* bytes) {
    std::uint64_t word;
    std::memcpy(&word, bytes, sizeof word);
    return word;
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i + j == 4) continue;
      const std::ptrdiff_t row = i * step[0] + j * step[1];
      if (eight(type + row) != eightOfClay) return false;
      const bool own = i < 2 && j < 2;
      if (own && (eight(air + row) != 0 || type[row + 8] != kClay)) return false;
    }
  return true;
}

// Of eight cells in a row and those beside them; freedom is concave: its least is at a corner.
bool freeAllRound(const Region& region, std::size_t n) {
  if (!region.fade) return true;
  const auto& step = region.strides();
  for (std::size_t c = 0; c < 8; ++c)
    if (region.fade[n + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + 7 * (c & 1)] < 1)
      return false;
  return true;
}

}  // namespace

void PressureGrid::resize(const Region& region) {
  box_ = region.box();
  const Key size = box_.high - box_.low + Key{1, 1, 1};
  for (int n = 0; n < kLevels; ++n) {
    Level& level = levels_[n];
    const Key cells{size.i >> (n + 1), size.j >> (n + 1), size.k >> (n + 1)};
    level.low = {box_.low.i >> (n + 1), box_.low.j >> (n + 1), box_.low.k >> (n + 1)};
    level.strides = {std::ptrdiff_t{cells.j} * cells.k, cells.k, 1};
    const auto count = static_cast<std::size_t>(cells.i) * cells.j * cells.k;
    for (auto* field : {&level.pressure, &level.source, &level.inverse, &level.air, &level.link[0],
                        &level.link[1], &level.link[2]})
      *field = Cells<float>(count);
    level.rows.clear();
  }
}

// What is no longer listed has no links and no pressure.
void PressureGrid::listRows(const Region& region) {
  for (int n = 0; n < kLevels; ++n) {
    Level& level = levels_[n];
    for (const Row& row : level.rows) {
      for (auto& link : level.link) std::fill_n(&link[row.base], row.count, 0.0f);
      std::fill_n(&level.pressure[row.base], row.count, 0.0f);
    }
    level.rows.clear();
    const std::int32_t side = Region::kTile >> (n + 1);
    for (const TileRun& run : region.denseTiles())
      for (std::int32_t i = run.i * side; i < (run.i + 1) * side; ++i)
        for (std::int32_t j = run.j * side; j < (run.j + 1) * side; ++j) {
          const std::int32_t k = run.k * side;
          const auto base =
              static_cast<std::size_t>(i * level.strides[0] + j * level.strides[1] + k);
          level.rows.push_back({base, i, j, k, run.count * side});
        }
  }
}

// Faces between two cells of clay that belong to two coarse cells.
void PressureGrid::linkFine(const Region& region) {
  Level& level = levels_[0];
  const auto& step = region.strides();
  const std::uint8_t* type = region.type.data();
  const auto joined = [&](std::size_t n, std::ptrdiff_t way) {
    return type[n] == kClay && type[n + way] == kClay ? 1.0f : 0.0f;
  };
  const auto open = [&](std::size_t n) {
    return freeAllRound(region, n) && openAllRound(type + n, &region.mark2[n], step);
  };
  forRows(level.rows, [&](const Row& row) {
    const auto first = static_cast<std::size_t>(2 * (row.i * step[0] + row.j * step[1] + row.k));
    for (std::int32_t k = 0; k < row.count; ++k) {
      const std::size_t n = first + 2 * k;
      if (k % 4 == 0 && open(n)) {
        std::fill_n(&level.air[row.base + k], 4, 0.0f);
        for (auto& link : level.link) std::fill_n(&link[row.base + k], 4, 4 * kLinkWeight);
        k += 3;
        continue;
      }
      float air = 0, links[3] = {0, 0, 0};
      for (std::size_t c = 0; c < 8; ++c) {
        const std::size_t cell = n + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1);
        const float free = region.freedom(cell), area = free * free;
        air += area * region.mark2[cell];
        if ((c & 4) != 0) links[0] += area * joined(cell, step[0]);
        if ((c & 2) != 0) links[1] += area * joined(cell, step[1]);
        if ((c & 1) != 0) links[2] += area * joined(cell, step[2]);
      }
      level.air[row.base + k] = air;
      for (std::size_t a = 0; a < 3; ++a) level.link[a][row.base + k] = kLinkWeight * links[a];
    }
  });
}

void PressureGrid::linkCoarse(const Level& fine, Level& coarse) {
  const auto& step = fine.strides;
  forRows(coarse.rows, [&](const Row& row) {
    const auto first = static_cast<std::size_t>(2 * (row.i * step[0] + row.j * step[1] + row.k));
    for (std::int32_t k = 0; k < row.count; ++k) {
      float air = 0, links[3] = {0, 0, 0};
      for (std::size_t c = 0; c < 8; ++c) {
        const std::size_t cell =
            first + 2 * k + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1);
        air += fine.air[cell];
        for (std::size_t a = 0; a < 3; ++a)
          if ((c >> (2 - a) & 1) != 0) links[a] += fine.link[a][cell];
      }
      coarse.air[row.base + k] = air;
      for (std::size_t a = 0; a < 3; ++a) coarse.link[a][row.base + k] = kLinkWeight * links[a];
    }
  });
}

void PressureGrid::finishLinks(Level& level, float airWeight) {
  forRows(level.rows, [&](const Row& row) {
    for (std::size_t n = row.base; n < row.base + row.count; ++n) {
      float diagonal = airWeight * level.air[n];
      for (std::size_t a = 0; a < 3; ++a)
        diagonal += level.link[a][n] + level.link[a][n - level.strides[a]];
      level.inverse[n] = diagonal > 0 ? 1 / diagonal : 0.0f;
    }
  });
}

void PressureGrid::prepare(const Region& region, float skin) {
  if (!levels_[0].pressure || region.box() != box_) resize(region);
  listRows(region);
  linkFine(region);
  for (int n = 1; n < kLevels; ++n) linkCoarse(levels_[n - 1], levels_[n]);
  for (int n = 0; n < kLevels; ++n) finishLinks(levels_[n], skin);
}

void PressureGrid::restrictFine(const Region& region) {
  Level& level = levels_[0];
  const auto& step = region.strides();
  forRows(level.rows, [&](const Row& row) {
    float* sums = &level.source[row.base];
    std::fill_n(sums, row.count, 0.0f);
    for (std::int32_t n = 0; n < 4; ++n) {
      const auto first = static_cast<std::size_t>((2 * row.i + (n >> 1)) * step[0] +
                                                  (2 * row.j + (n & 1)) * step[1] + 2 * row.k);
      const ResidualRow fine{&region.pressure[first],
                             &region.rhs[first],
                             &region.inverse[first],
                             step[0],
                             step[1],
                             2 * row.count};
      if (region.fade)
        fadedResidualRow(fine, &region.fade[first], sums);
      else
        residualRow(fine, sums);
    }
  });
}

void PressureGrid::restrictCoarse(const Level& fine, Level& coarse) {
  const auto& step = fine.strides;
  const auto residual = [&](std::size_t n) {
    float sum = fine.source[n];
    if (fine.inverse[n] <= 0) return 0.0f;
    for (std::size_t a = 0; a < 3; ++a)
      sum += fine.link[a][n] * fine.pressure[n + step[a]] +
             fine.link[a][n - step[a]] * fine.pressure[n - step[a]];
    return sum - fine.pressure[n] / fine.inverse[n];
  };
  forRows(coarse.rows, [&](const Row& row) {
    for (std::int32_t k = 0; k < row.count; ++k) {
      const auto first =
          static_cast<std::size_t>(2 * (row.i * step[0] + row.j * step[1] + row.k + k));
      float sum = 0;
      for (std::size_t c = 0; c < 8; ++c)
        sum += residual(first + (c >> 2) * step[0] + (c >> 1 & 1) * step[1] + (c & 1));
      coarse.source[row.base + k] = sum;
    }
  });
}

// Red, then black, by global keys.
void PressureGrid::sweep(Level& level, float relaxation) {
  for (int colour = 0; colour < 2; ++colour)
    forRows(level.rows, [&](const Row& row) {
      const LevelRow here{
          {&level.link[0][row.base], &level.link[1][row.base], &level.link[2][row.base]},
          &level.source[row.base],
          &level.inverse[row.base],
          &level.pressure[row.base],
          {level.strides[0], level.strides[1], level.strides[2]}};
      const std::int32_t parity =
          level.low.i + row.i + level.low.j + row.j + level.low.k + row.k + colour;
      for (std::ptrdiff_t n = parity & 1; n < row.count; n += 2) {
        const float wanted = (pulled(here, n) + here.source[n]) * here.inverse[n];
        here.pressure[n] += relaxation * (wanted - here.pressure[n]);
      }
    });
}

void PressureGrid::solve(int number) {
  Level& level = levels_[number];
  for (const Row& row : level.rows) std::fill_n(&level.pressure[row.base], row.count, 0.0f);
  if (number + 1 == kLevels) {
    for (int n = 0; n < kBottomSweeps; ++n) sweep(level, kBottomRelaxation);
    return;
  }
  for (int n = 0; n < kSmoothings; ++n) sweep(level, kRelaxation);
  Level& coarse = levels_[number + 1];
  restrictCoarse(level, coarse);
  solve(number + 1);
  forRows(coarse.rows, [&](const Row& row) {
    const auto& step = level.strides;
    for (std::int32_t n = 0; n < 4; ++n) {
      const auto first = static_cast<std::size_t>((2 * row.i + (n >> 1)) * step[0] +
                                                  (2 * row.j + (n & 1)) * step[1] + 2 * row.k);
      for (std::int32_t k = 0; k < 2 * row.count; ++k)
        if (level.inverse[first + k] > 0)
          level.pressure[first + k] += coarse.pressure[row.base + k / 2];
    }
  });
  for (int n = 0; n < kSmoothings; ++n) sweep(level, kRelaxation);
}

void PressureGrid::correct(Region& region) {
  restrictFine(region);
  solve(0);
  const Level& coarse = levels_[0];
  const auto& step = region.strides();
  forRows(coarse.rows, [&](const Row& row) {
    for (std::int32_t n = 0; n < 4; ++n) {
      const auto first = static_cast<std::size_t>((2 * row.i + (n >> 1)) * step[0] +
                                                  (2 * row.j + (n & 1)) * step[1] + 2 * row.k);
      const float *inverse = &region.inverse[first], *error = &coarse.pressure[row.base];
      float* pressure = &region.pressure[first];
      for (std::int32_t k = 0; k < 2 * row.count; ++k)
        pressure[k] += inverse[k] > 0 ? error[k / 2] * region.freedom(first + k) : 0.0f;
    }
  });
}

}  // namespace bozzetto::clay
