// What makes the dabs of a stroke, brush or clay; a live stroke leads it.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "bozzetto/sculptor/workbench.hpp"
#include "bozzetto/tool/stroke.hpp"

namespace bozzetto {

template <int Side>
class DabMaker {
 public:
  virtual ~DabMaker() = default;
  virtual void extend(std::span<const StrokePoint> points) = 0;
  virtual std::int64_t dabCount() const = 0;
  virtual std::int64_t sureDabs() const = 0;
  virtual DabReport dab(std::int64_t n) = 0;
  /// After the last dab: whatever is not in the edit yet goes there; returns where.
  virtual std::vector<ChangedRun> finish() = 0;
  /// What is made otherwise than asked for, by the points so far; may be empty.
  virtual std::string notice() const { return {}; }
  /// Painted stiffness as it is after the last dab, where the maker changes it. Not while dabs go
  /// on unless somebody shows it: O(blocks painted).
  virtual std::optional<clay::Stiffness> stiffness() { return std::nullopt; }
};

/// Of actions that move clay.
clay::Role clayRoleOf(ActionKind kind);

/// The one for the action in the hand.
template <int Side>
std::unique_ptr<DabMaker<Side>> makeDabMaker(Workbench<Side>& bench, Edit<CornerBlock<Side>>& edit,
                                             const Stroke& stroke);

extern template std::unique_ptr<DabMaker<1>> makeDabMaker(Workbench<1>&, Edit<CornerBlock<1>>&,
                                                          const Stroke&);
extern template std::unique_ptr<DabMaker<8>> makeDabMaker(Workbench<8>&, Edit<CornerBlock<8>>&,
                                                          const Stroke&);

}  // namespace bozzetto
