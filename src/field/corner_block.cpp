#include "bozzetto/field/corner_block.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <mutex>
#include <new>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/grid/block_pool.hpp"

namespace bozzetto {
namespace {

struct Range {
  float low, high;
};

BOZZETTO_KERNEL Range rangeKernel(const float* value, int count) {
  // Values are never negative: they order like their bits, which compilers can reduce in vectors.
  auto low = std::bit_cast<std::int32_t>(value[0]), high = low;
  for (int n = 0; n < count; ++n) {
    low = std::min(low, std::bit_cast<std::int32_t>(value[n]));
    high = std::max(high, std::bit_cast<std::int32_t>(value[n]));
  }
  return {std::bit_cast<float>(low), std::bit_cast<float>(high)};
}

// Adding 1.5·2¹² to a double leaves multiples of 2⁻⁴⁰ in its low bits: a float in [0, 2048)
// becomes mass units by one addition and one subtraction, four at a time.
constexpr double kToUnits = 0x1.8p12;

BOZZETTO_KERNEL MassUnits massKernel(const float* value, int count) {
  MassUnits sum = 0;
  for (int n = 0; n < count; ++n) {
    sum += std::bit_cast<MassUnits>(static_cast<double>(value[n]) + kToUnits) -
           std::bit_cast<MassUnits>(kToUnits);
  }
  return sum;
}

struct Tidied {
  Range range;
  Attributes every, any;  // of corners with clay
};

// Clears attributes where there is no clay; all in one pass through the block.
BOZZETTO_KERNEL Tidied tidyKernel(const float* value, Attributes* attributes, int count) {
  auto low = std::bit_cast<std::int32_t>(value[0]), high = low;
  Attributes every = ~Attributes{0}, any = 0;
  for (int n = 0; n < count; ++n) {
    const auto bits = std::bit_cast<std::int32_t>(value[n]);
    const auto clay = static_cast<Attributes>(
        static_cast<std::int32_t>(0u - static_cast<std::uint32_t>(bits)) >> 31);
    const Attributes kept = attributes[n] & clay;
    attributes[n] = kept;
    every &= kept | ~clay;
    any |= kept;
    low = std::min(low, bits);
    high = std::max(high, bits);
  }
  return {{std::bit_cast<float>(low), std::bit_cast<float>(high)}, every, any};
}

BOZZETTO_SIMD_DISPATCH(Range, rangeOf, rangeKernel, (const float* value, int count), (value, count))
BOZZETTO_SIMD_DISPATCH(MassUnits, massOf, massKernel, (const float* value, int count),
                       (value, count))
BOZZETTO_SIMD_DISPATCH(Tidied, tidy, tidyKernel,
                       (const float* value, Attributes* attributes, int count),
                       (value, attributes, count))

// The interned blocks of one side. Contents that nobody uses any more go when there are many.
template <int Side>
class InternTable {
 public:
  Ref<CornerBlock<Side>> get(float value, Attributes attributes) {
    const std::lock_guard lock(mutex_);
    if (blocks_.size() >= limit_) dropUnused();
    Ref<CornerBlock<Side>>& block = blocks_[{std::bit_cast<std::uint32_t>(value), attributes}];
    if (!block) block = make(value, attributes);
    return block;
  }

 private:
  static Ref<CornerBlock<Side>> make(float value, Attributes attributes) {
    Ref<CornerBlock<Side>> block(new CornerBlock<Side>());
    block->value.fill(value);
    block->attributes.fill(attributes);
    block->low = block->high = value;
    block->oneColour = block->settled = true;
    block->only = attributes;
    block->mass = massOf(block->value.data(), block->kCount);
    block->interned = true;
    return block;
  }

  void dropUnused() {
    std::erase_if(blocks_, [](const auto& entry) { return entry.second->holders() == 1; });
    limit_ = std::max<std::size_t>(1024, 2 * blocks_.size());
  }

  std::mutex mutex_;
  std::map<std::pair<std::uint32_t, Attributes>, Ref<CornerBlock<Side>>> blocks_;
  std::size_t limit_ = 1024;
};

template <int Side>
InternTable<Side>& internTable() {
  static auto* const table = new InternTable<Side>();  // outlives every static field
  return *table;
}

}  // namespace

template <int Side>
CornerBlock<Side>::CornerBlock(const CornerBlock& other)
    : RefCounted(other),
      low(other.low),
      high(other.high),
      mass(other.mass),
      value(other.value),
      attributes(other.attributes) {}

template <int Side>
void CornerBlock<Side>::updateRange() {
  const Range range = rangeOf(value.data(), kCount);
  low = range.low;
  high = range.high;
}

template <int Side>
Ref<CornerBlock<Side>> CornerBlock<Side>::canonical(Ref<CornerBlock> block) {
  if (!block->settled) {
    const Tidied tidied = tidy(block->value.data(), block->attributes.data(), kCount);
    block->low = tidied.range.low;
    block->high = tidied.range.high;
    block->oneColour = tidied.every == tidied.any;
    block->only = tidied.any;
    block->settled = true;
  }
  if (block->high <= 0) return nullptr;
  const bool alike = block->low == block->high && block->oneColour;
  if (Side > 1 && alike) return uniform(block->value[0], block->attributes[0]);
  block->mass = massOf(block->value.data(), kCount);
  return block;
}

template <int Side>
Ref<CornerBlock<Side>> CornerBlock<Side>::uniform(float value, Attributes attributes) {
  return internTable<Side>().get(value, attributes);
}

template <int Side>
bool CornerBlock<Side>::sameAs(const CornerBlock& other) const {
  return std::memcmp(value.data(), other.value.data(), sizeof value) == 0 &&
         std::memcmp(attributes.data(), other.attributes.data(), sizeof attributes) == 0;
}

template <int Side>
void* CornerBlock<Side>::operator new(std::size_t size) {
  return allocateBlock(size);
}

template <int Side>
void CornerBlock<Side>::operator delete(void* block, std::size_t size) {
  releaseBlock(block, size);
}

template struct CornerBlock<1>;
template struct CornerBlock<8>;

}  // namespace bozzetto
