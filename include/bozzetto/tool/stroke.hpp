// Strokes: points joined by lines, resampled to dabs, repeated by symmetry. One edit a stroke.
#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/tool/dab.hpp"
#include "bozzetto/tool/placement.hpp"
#include "bozzetto/tool/symmetry.hpp"

namespace bozzetto {

struct StrokePoint {
  glm::dvec3 position{0};  ///< world units
  double pressure = 1;     ///< 0…1
};

/// What pressure multiplies.
struct PressureTargets {
  bool strength = false;
  bool size = false;
};

struct Stroke {
  std::vector<StrokePoint> points;
  /// Of the tool at each point, on top of its own rotation; w, x, y, z. Empty: none.
  std::vector<glm::dquat> rotations;
  double spacing = 0.25;  ///< between dabs, × the tool's smallest radius; > 0
  PressureTargets pressure;
  Symmetry symmetry;
  Placement placement{};
};

/// What can be said without tool and grid. Throws Error for no points, a spacing that is not above
/// 0, other than as many rotations as points, and what its symmetry and placement refuse.
void requireValid(const Stroke& stroke);

inline constexpr std::int64_t kMostDabs = 10'000'000;

/// The points of a polyline at equal distances along it, the first one included. Distances carry
/// on round corners; pressure is linear between points.
class StrokePath {
 public:
  struct Sample {
    glm::dvec3 position;
    double pressure;
  };

  /// `points` in cells; `step` > 0 in cells.
  StrokePath(const std::vector<Sample>& points, double step);
  void append(const Sample& point);
  std::size_t pointCount() const { return points_.size(); }
  /// Forgets the points after the first `count`, at least one.
  void shorten(std::size_t count);
  /// 1 + ⌊length / step⌋, as a double because it may be absurd.
  double count() const;
  /// How many of these stay as they are however the line goes on.
  std::int64_t sure() const;
  Sample at(std::int64_t n) const;
  const Sample& last() const { return points_.back(); }  ///< of the points
  double step() const { return step_; }

 private:
  std::vector<Sample> points_;
  std::vector<double> distance_;  // along the line, of every point
  double step_;
};

template <int Side>
class Placer;

/// A stroke that is made dab by dab, so that a window can show each one. The caller owns the edit
/// and commits it; when something throws, the edit has been rolled back.
template <int Side>
class StrokeRunner {
 public:
  /// Checks everything first. Throws Error for bad points, tools, actions, spacings, symmetries,
  /// for more than 10 million dabs and for boxes beyond the workspace.
  StrokeRunner(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const ToolShape& tool,
               const ActionOptions& action, const Stroke& stroke);
  /// The same where dabs face another clay than the one they change, `faced`.
  StrokeRunner(Edit<CornerBlock<Side>>& edit, const Field<Side>& faced, const ToolShape& tool,
               const ActionOptions& action, const Stroke& stroke);
  ~StrokeRunner();

  /// Goes on through these points, while the stroke is drawn: the dabs are those of a stroke that
  /// had them from the start. Throws Error as for those and leaves the stroke as it was.
  void extend(std::span<const StrokePoint> points);

  std::int64_t dabCount() const { return count_; }       ///< symmetric images not counted
  std::int64_t sureDabs() const;                         ///< those that `extend` cannot move
  const std::string& notice() const { return notice_; }  ///< about the tool; may be empty
  /// About the placement of the points so far; may be empty.
  std::string placementNotice() const;

  /// Makes the n-th dab and its images.
  DabReport dab(std::int64_t n);

  /// Reports that the n-th is made; rolls the edit back and throws Cancelled when asked to stop.
  void step(Progress& progress, std::int64_t n);

 private:
  std::unique_ptr<Potential> potentialOf(const ToolShape& tool) const;
  std::vector<DabPose> posesOf(const struct Standing& standing) const;
  void makeDab(const Standing& standing, double strength, DabReport& report);
  ToolShape sized(double factor) const;
  std::vector<StrokePath::Sample> relative(std::span<const StrokePoint> points) const;
  void requireRoom(const std::vector<StrokePath::Sample>& points) const;
  std::int64_t countOf(const StrokePath& path) const;

  Edit<CornerBlock<Side>>* edit_;
  FieldScale scale_;
  DabWalker<Side> walker_;
  std::map<Key, SweptBlock<Side>> swept_;  // by stamps, in images of the dab too
  ToolShape tool_;                         // radii in cells
  std::unique_ptr<Potential> potential_;
  std::unique_ptr<Action> action_;
  double factor_ = 1;  // of the size that the potential is for
  ActionOptions options_;
  PressureTargets pressure_;
  std::string notice_;
  Key origin_;
  std::vector<glm::dmat3> images_;
  glm::dvec3 centre_;
  std::unique_ptr<const Placer<Side>> placer_;
  std::optional<StrokePath> path_;
  std::int64_t count_ = 0;
};

extern template class StrokeRunner<1>;
extern template class StrokeRunner<8>;

struct StrokeReport {
  std::int64_t dabs = 0;  ///< symmetric images not counted
  DabReport total;        ///< `changed` sorted, each key once
  std::string notice;
};

/// A whole stroke. Cancelling rolls the edit back and throws Cancelled.
template <int Side>
StrokeReport applyStroke(StrokeRunner<Side>& runner, Progress& progress = Progress::none());

extern template StrokeReport applyStroke(StrokeRunner<1>&, Progress&);
extern template StrokeReport applyStroke(StrokeRunner<8>&, Progress&);

}  // namespace bozzetto
