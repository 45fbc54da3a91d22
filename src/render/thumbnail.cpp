#include "bozzetto/render/thumbnail.hpp"

#include "bozzetto/field/pyramid.hpp"
#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"

namespace bozzetto {
namespace {

// A surface block has some 64 cubes in sight: more blocks than these show no more in so few pixels.
constexpr std::size_t kEnoughNodes = 4000;

// The colours of clay where one corner stands for many; between clay, the colour found last.
class Colours {
 public:
  Colours(const Clay& clay, int level) : blocks_(clay.tree), level_(level) {}
  Attributes at(Key corner) {
    using Geometry = Clay::Geometry;
    const Key fine = corner * (1 << level_);
    const CornerBlock<8>* block = blocks_.find(Geometry::blockOf(fine));
    const int index = Geometry::indexOf(fine);
    if (block != nullptr && block->value[index] > 0) last_ = block->attributes[index];
    return last_;
  }

 private:
  BlockCache<CornerBlock<8>> blocks_;
  int level_;
  Attributes last_ = packAttributes({});
};

Ref<CornerBlock<8>> coloured(const DensityBlock& density, Key key, Colours& colours) {
  const Key first = Clay::Geometry::firstCornerOf(key);
  if (density.uniform) {
    return CornerBlock<8>::uniform(density.value[0], colours.at(first));
  }
  Ref<CornerBlock<8>> block(new CornerBlock<8>);
  for (int n = 0; n < CornerBlock<8>::kCount; ++n) {
    block->value[n] = density.value[n];
    if (density.value[n] > 0) {
      block->attributes[n] = colours.at(first + Key{n / 64, n / 8 % 8, n % 8});
    }
  }
  return CornerBlock<8>::canonical(std::move(block));
}

// The clay itself, or the first coarser copy that is small enough.
Clay smallEnough(const Clay& clay) {
  std::size_t nodes = clay.tree.nodeCount();
  int level = 0;
  for (; nodes > kEnoughNodes; nodes /= 4) ++level;
  if (level == 0) return clay;
  Pyramid pyramid(level);
  pyramid.rebuild(clay);
  Colours colours(clay, level);
  Clay coarse;
  coarse.scale = clay.scale;
  for (const auto& [key, run] : pyramid.level(level)) {
    Ref<CornerBlock<8>> block = coloured(*run.block, key, colours);
    if (block) coarse.tree.put(key, run.length, std::move(block));
  }
  return coarse;
}

}  // namespace

Bytes thumbnailOf(const Clay& clay, int width, int height) {
  if (clay.tree.empty()) return {};
  try {
    const Clay small = smallEnough(clay);
    Surface<8> surface;
    surface.rebuild(small);
    PictureOptions options;
    options.width = width;
    options.height = height;
    options.slices = 1;
    options.look.detail = Detail::baked;
    return encodePng(renderPicture(surface, small, options), PngEffort::quick);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace bozzetto
