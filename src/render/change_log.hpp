// Where the clay's picture is out of date: boxes of patches that came, changed or went, numbered,
// so that every view can ask what happened since it last looked.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bozzetto/render/camera.hpp"

namespace bozzetto {

class ChangeLog {
 public:
  void note(const CellBounds& box);
  /// Everything is out of date.
  void noteAll();
  std::uint64_t now() const { return first_ + boxes_.size(); }
  /// What changed since then; nothing when that is forgotten: everything may have.
  std::optional<std::span<const CellBounds>> since(std::uint64_t then) const;

 private:
  static constexpr std::size_t kMost = 1 << 14;
  std::uint64_t first_ = 1;  // number of boxes_[0]
  std::vector<CellBounds> boxes_;
};

}  // namespace bozzetto
