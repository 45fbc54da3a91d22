// Reconstruction of turned tools for AVX2 by hand. The same arithmetic, bit for bit, as
// turnedBody. A corner of the clay reads two squares of the tool's, by pairs: gathers, of single
// numbers, are forty steps each on some processors.
#pragma once
#if defined(__x86_64__)
#include "tool/squares_avx2.hpp"
#include "tool/trilinear_avx2.hpp"

namespace bozzetto {

// From corners of the tool to the next, for each of a row.
struct Ways {
  __m256 t, rest;
};

// Of corners n and n + 4 of a row: their squares, between the tool's planes.
template <int n>
BOZZETTO_TARGET_AVX2 inline __m256 squaresOn(const Squares& squares, const std::int32_t* at,
                                             const Ways& i) {
  constexpr int all = n * 0x55;
  return mixed(both(squares.near(at[n]), squares.near(at[n + 4])),
               both(squares.far(at[n]), squares.far(at[n + 4])), _mm256_permute_ps(i.t, all),
               _mm256_permute_ps(i.rest, all));
}

// Rows of eight, one after the other along j, where they lie in the box: in 2⁻¹⁶ of its cells from
// its low end.
class TurnedRows {
 public:
  BOZZETTO_TARGET_AVX2 explicit TurnedRows(const TilePatch& patch) : patch_(patch) {
    strideJ_ = _mm256_set1_epi32(patch.wide[2]);
    strideI_ = _mm256_set1_epi32(patch.wide[1] * patch.wide[2]);
    std::int32_t widest = 0;
    for (std::size_t a = 0; a < 3; ++a) widest = std::max(widest, std::abs(step(2, a)));
    bricks_ = ToolBricks::bricksFor(((7 * widest) >> (kFractionBits + 1)) + 2);
    for (const Axis axis : kAxes) along_[index(axis)] = alongRow(patch.frame, index(axis));
  }

  BOZZETTO_TARGET_AVX2 void begin(int i) {
    for (const Axis axis : kAxes) {
      const int a = index(axis);
      const std::int32_t from = positionOn(patch_.frame, a, patch_.first + Key{i, 0, 0});
      const std::int32_t low = patch_.low[axis] - patch_.base[axis];
      const std::int32_t start = from - low * (1 << kFractionBits);
      middle_[a] = start + ((7 * step(2, std::size_t(a))) >> 1);
      position_[a] = _mm256_add_epi32(_mm256_set1_epi32(start), along_[a]);
    }
  }
  BOZZETTO_TARGET_AVX2 void next() {
    for (std::size_t a = 0; a < 3; ++a) {
      middle_[a] += step(1, a);
      position_[a] = _mm256_add_epi32(position_[a], _mm256_set1_epi32(step(1, a)));
    }
  }

  // What all corners are that it reads; may miss that they are alike.
  ToolKind kind() const {
    if (patch_.box == nullptr) return ToolKind::varied;
    const auto at = [&](int a) { return middle_[a] >> kFractionBits; };
    return patch_.box->bricks.around({at(0), at(1), at(2)}, bricks_);
  }
  // Where its cells begin in the box, or at its rim.
  BOZZETTO_TARGET_AVX2 __m256i cells() const {
    __m256i corner[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const __m256i at = _mm256_srai_epi32(position_[a], kFractionBits);
      corner[a] = _mm256_min_epi32(_mm256_max_epi32(at, _mm256_setzero_si256()),
                                   _mm256_set1_epi32(patch_.wide[a] - 2));
    }
    return _mm256_add_epi32(_mm256_add_epi32(_mm256_mullo_epi32(corner[0], strideI_),
                                             _mm256_mullo_epi32(corner[1], strideJ_)),
                            corner[2]);
  }
  // How far from there to the next, on one axis.
  BOZZETTO_TARGET_AVX2 Ways waysOn(int a) const {
    const __m256i fraction =
        _mm256_and_si256(position_[a], _mm256_set1_epi32((1 << kFractionBits) - 1));
    const __m256 t =
        _mm256_mul_ps(_mm256_cvtepi32_ps(fraction), _mm256_set1_ps(1.0f / (1 << kFractionBits)));
    return {t, _mm256_sub_ps(_mm256_set1_ps(1.0f), t)};
  }

 private:
  std::int32_t step(std::size_t grid, std::size_t a) const { return patch_.frame.step[grid][a]; }

  const TilePatch& patch_;
  __m256i strideI_, strideJ_, along_[3], position_[3];
  std::int32_t middle_[3] = {};
  int bricks_;
};

BOZZETTO_TARGET_AVX2 inline __m256 turnedRow(const Squares& squares, const std::int32_t* at,
                                             const TurnedRows& rows) {
  const Ways i = rows.waysOn(0), j = rows.waysOn(1), k = rows.waysOn(2);
  const __m256 a = squaresOn<0>(squares, at, i), b = squaresOn<1>(squares, at, i),
               c = squaresOn<2>(squares, at, i), d = squaresOn<3>(squares, at, i);
  const Sorted all = sorted(a, b, c, d);
  const __m256 low = mixed(all.corner, all.beside, j.t, j.rest);
  const __m256 high = mixed(all.next, all.besideNext, j.t, j.rest);
  return mixed(low, high, k.t, k.rest);
}

// Whether the cells of a row are all of one kind.
inline ToolKind kindOf(const ToolBox* box, const std::int32_t* at) {
  if (box == nullptr) return ToolKind::varied;
  auto all = static_cast<unsigned>(box->kinds[std::size_t(at[0])]);
  for (int n = 1; n < 8; ++n) all &= static_cast<unsigned>(box->kinds[std::size_t(at[n])]);
  return static_cast<ToolKind>(all);
}

BOZZETTO_TARGET_AVX2 inline void turnedAvx2(const TilePatch& patch, float* result) {
  const std::ptrdiff_t strideJ = patch.wide[2];
  const Squares squares{patch.value, patch.wide[1] * strideJ, strideJ};
  TurnedRows rows(patch);
  alignas(32) std::int32_t at[8];
  for (int i = 0; i < 8; ++i) {
    rows.begin(i);
    for (int j = 0; j < 8; ++j, rows.next(), result += 8) {
      ToolKind kind = rows.kind();
      if (kind == ToolKind::varied) {
        _mm256_store_si256(reinterpret_cast<__m256i*>(at), rows.cells());
        kind = kindOf(patch.box, at);
      }
      const __m256 alike = _mm256_set1_ps(kind == ToolKind::full ? 1.0f : 0.0f);
      const bool varied = kind == ToolKind::varied;
      _mm256_storeu_ps(result, varied ? turnedRow(squares, at, rows) : alike);
    }
  }
}

}  // namespace bozzetto
#endif
