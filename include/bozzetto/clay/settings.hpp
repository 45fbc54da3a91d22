// What clay does when it is pushed: which layers run, in which order, and how.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace bozzetto::clay {

/// displacement   large scale: clay moves with tools, fades to what holds it (Dewaele §3.1)
/// conservation   no room where tools are, no cell fuller than full (§3.2)
/// tension        no dust, no crumbs, parting at weak points (§3.3)
/// diffusion      pushed matter walks out along tool normals and spreads (Raffin)
/// automaton      Margolus blocks share what is too much (Takai)
enum class LayerKind { displacement, conservation, tension, diffusion, automaton };

/// projected     the same roles made to hold at today's sizes: see src/clay/NOTES.md
/// paper         Dewaele & Cani to the letter
/// paper_sweeps  the same, but all cells that hold too much give at once, sweep after sweep: what
///               comes of mirrored clay is mirrored to the bit
enum class Scheme { projected, paper, paperSweeps };

/// How Takai's blocks share: `literal` gives α·m, `capped` no more than the excess over full.
enum class SharingRule { capped, literal };

/// push leaves no room where it is and leads clay along; grip leads what it holds; support leaves
/// no room and stands still.
/// swell lets clay come out where it is, by the automaton.
enum class Role { push, grip, support, swell };

std::string_view toText(LayerKind layer);
std::string_view toText(Scheme scheme);
std::string_view toText(SharingRule rule);
std::optional<LayerKind> layerNamed(std::string_view name);
std::optional<Scheme> schemeNamed(std::string_view name);
std::optional<SharingRule> sharingRuleNamed(std::string_view name);

/// Control points of the spreading curve, a quadratic Bézier from (0, 1) to (1, 0) (Raffin §3).
inline constexpr std::array<double, 2> kUniform{1, 1}, kLinear{0.5, 0.5}, kGaussian{0.35, 0.05};

struct Settings {
  std::vector<LayerKind> layers{LayerKind::displacement, LayerKind::conservation,
                                LayerKind::tension};
  Scheme scheme = Scheme::projected;

  double stiffness = 0.7;     ///< 0 fluid … 1 dry: how far clay follows a tool (Dewaele's α)
  double distanceOffset = 0;  ///< cells added to pseudo-distances; more = tools lead less far
  double parting = 0;  ///< 0 … 4: how much weaker clay is where it is thin (clay.md §3.1: 4)
  int crumb = 8;       ///< pieces of fewer cells are eaten; 0 = let them lie
  int iterations = 200'000;  ///< paper: cells taken from the queue per step, at most

  double viscosity = 0;                     ///< diffusion: radius of spreading in cells; 0 = none
  std::array<double, 2> profile = kLinear;  ///< control point of the spreading curve, in 0…1
  double walk = 2;  ///< diffusion: longest walk, × the tool's largest radius

  double rate = 0.3;        ///< automaton: Takai's α, share that is given
  double threshold = 1.05;  ///< automaton: what is more is given
  SharingRule sharing = SharingRule::capped;
  int sweeps = 60;  ///< automaton: at most, per step
};

/// What happened in a step, for who watches.
struct StepReport {
  std::int64_t cells = 0;      ///< visited
  std::int64_t clayCells = 0;  ///< of these, with clay
  int crumbs = 0;              ///< pieces eaten
};

/// Throws Error unless every number is in its range.
void requireValid(const Settings& settings);

}  // namespace bozzetto::clay
