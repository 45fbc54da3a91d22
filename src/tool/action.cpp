#include "bozzetto/tool/action.hpp"

#include <array>
#include <cmath>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"
#include "tool/actions.hpp"
#include "tool/corner_loop.hpp"

namespace bozzetto {
namespace {

constexpr std::array<std::string_view, 14> kNames{
    "add",  "remove", "erase",   "paint",  "paint_soft", "smooth", "stamp",
    "hold", "free",   "stiffen", "soften", "push",       "grip",   "swell"};

BOZZETTO_KERNEL bool otherColourKernel(const BlockView& block, Attributes tool) {
  Attributes differs = 0;
  for (int n = 0; n < block.count; ++n) {
    const Attributes other = block.attributes[n] ^ tool;
    const auto met = positiveMask(block.potential[n]) & positiveMask(block.value[n]);
    differs |= other & static_cast<Attributes>(met);
  }
  return (differs & kColourBits) != 0;
}

BOZZETTO_SIMD_DISPATCH(bool, meets, otherColourKernel, (const BlockView& block, Attributes tool),
                       (block, tool))

}  // namespace

bool meetsOtherColour(const BlockView& block, Attributes tool) { return meets(block, tool); }

std::string_view toText(ActionKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<ActionKind> actionNamed(std::string_view name) {
  for (std::size_t n = 0; n < kNames.size(); ++n)
    if (kNames[n] == name) return static_cast<ActionKind>(n);
  return std::nullopt;
}

void requireValid(const ActionOptions& options) {
  clamped(options.stamp, 0.5);
  if (options.strength >= 0 && options.strength <= 1) return;
  throw Error("action strength: " + numberText(options.strength) +
              " found, a number in 0…1 expected");
}

std::unique_ptr<Action> makeAction(const ActionOptions& options, double iso, ToolBody body) {
  requireValid(options);
  const bool gives = options.kind == ActionKind::add || options.kind == ActionKind::paint ||
                     options.kind == ActionKind::paintSoft;
  if (options.ownColours && gives) return makeOwnColours(options.kind);
  switch (options.kind) {
    case ActionKind::add:
      return makeAdd(options.colour);
    case ActionKind::remove:
      return makeRemove();
    case ActionKind::erase:
      return makeErase(body);
    case ActionKind::paint:
      return makePaint(options.colour);
    case ActionKind::paintSoft:
      return makePaintSoft(options.colour);
    case ActionKind::smooth:
      return makeSmooth();
    case ActionKind::stamp:
      return makeStamp(options.stamp.profile, iso, body);
    case ActionKind::hold:
      return makeHold();
    case ActionKind::free:
      return makeFree();
    case ActionKind::stiffen:
      return makeStiffen();
    case ActionKind::soften:
      return makeSoften();
    default:
      throw Error("action: " + std::string(toText(options.kind)) +
                  " found, one that works corner by corner expected");
  }
}

}  // namespace bozzetto
