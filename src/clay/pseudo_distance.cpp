#include "clay/pseudo_distance.hpp"

#include <algorithm>

namespace bozzetto::clay {

void PseudoDistance::sow(const Region& region, std::uint8_t owner, Cells<float>& distance) {
  forRows(region.rows(),
          [&](const Row& row) { std::fill_n(&distance[row.base], row.count, kFar); });
  for (const Row& row : region.rows())
    for (std::size_t cell = row.base; cell < row.base + row.count; ++cell) {
      if (region.value[cell] < kThin || ownerOf(region, cell) != owner) continue;
      distance[cell] = 0;
      bucket_[0].push_back(static_cast<std::uint32_t>(cell));
    }
}

std::vector<Contact> PseudoDistance::contacts(const Pieces& pieces) const {
  std::vector<Contact> contacts;
  for (const Touch& touch : touches_) {
    const std::uint32_t piece = pieces.pieceAt(touch.cell);
    const auto same = std::find_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
      return contact.piece == piece && contact.owner == touch.owner;
    });
    if (same == contacts.end())
      contacts.push_back({piece, touch.owner, touch.distance});
    else
      same->distance = std::min(same->distance, touch.distance);
  }
  return contacts;
}

// Dial's buckets of width 1: no cost is less than 1, so a bucket never feeds itself.
void PseudoDistance::run(const Region& region, std::uint8_t owner, const Cells<float>& cost,
                         Cells<float>& distance) {
  touches_.clear();
  sow(region, owner, distance);
  std::size_t idle = 0;
  for (std::size_t now = 0; idle < kBuckets; ++now) {
    std::vector<std::uint32_t>& bucket = bucket_[now % kBuckets];
    idle = bucket.empty() ? idle + 1 : 0;
    for (const std::size_t cell : bucket) {
      const float here = distance[cell];
      if (static_cast<std::size_t>(here) != now) continue;  // reached on a shorter way since
      for (const std::ptrdiff_t step : region.neighbours()) {
        const std::size_t next = cell + step;
        const float there = here + cost[next];
        if (region.value[next] < kThin || !(there < distance[next])) continue;
        if (region.owner[next] == kRim) continue;
        distance[next] = there;
        const std::uint8_t other = ownerOf(region, next);
        if (other == kNobody || other == owner) {
          bucket_[static_cast<std::size_t>(there) % kBuckets].push_back(
              static_cast<std::uint32_t>(next));
        } else {
          touches_.push_back({static_cast<std::uint32_t>(next), other, there});
        }
      }
    }
    bucket.clear();
  }
}

}  // namespace bozzetto::clay
