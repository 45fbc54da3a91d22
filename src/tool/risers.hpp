// Corners that may rise under a conserving stamp.
#pragma once
#include <cstddef>
#include <vector>

#include "tool/rise_kernels.hpp"

namespace bozzetto {

/// In the order of their blocks in a list, then of their places in them.
struct Risers {
  std::vector<std::size_t> place;         ///< block in the list · corners of a block + corner
  std::vector<float> value, climb, most;  ///< climb: density per cell of way

  std::size_t size() const { return place.size(); }
  Climbers climbers() const { return {value.data(), climb.data(), most.data(), size()}; }

  void resize(std::size_t count) {
    place.resize(count);
    for (auto* each : {&value, &climb, &most}) each->resize(count);
  }
  void append(const Risers& more) {
    const auto add = [](auto& all, const auto& some) {
      all.insert(all.end(), some.begin(), some.end());
    };
    add(place, more.place);
    add(value, more.value);
    add(climb, more.climb);
    add(most, more.most);
  }
};

}  // namespace bozzetto
