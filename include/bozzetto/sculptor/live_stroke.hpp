// A stroke while it is drawn: points arrive one by one, dabs are made as soon as their place is
// sure, and what comes out is, bit for bit, what the finished stroke gives in one piece.
#pragma once
#include <memory>
#include <span>

#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/sculptor/workbench.hpp"

namespace bozzetto {

template <int Side>
class DabMaker;

template <int Side>
class LiveStroke {
 public:
  /// Begins with the points that `stroke` has, at least one. Nothing else may change the clay until
  /// the stroke is finished or gone. Throws Error like the stroke's operation.
  LiveStroke(Workbench<Side>& bench, Stroke stroke);
  LiveStroke(const LiveStroke&) = delete;
  LiveStroke& operator=(const LiveStroke&) = delete;
  /// Takes everything back unless finished.
  ~LiveStroke();

  /// Goes on through these points. Throws Error for bad points and leaves the stroke as it was.
  void extend(std::span<const StrokePoint> points);
  /// Makes the next dab whose place is sure. False: more points are needed first.
  bool dab();
  /// Makes the last dabs; the stroke becomes one step of history.
  OperationReport finish();

  /// Dabs of the stroke so far, made or not; symmetric images not counted.
  std::int64_t plannedDabs() const;
  /// What of it is made otherwise than asked for; may be empty.
  std::string notice() const;
  /// The stroke so far, as it will be recorded.
  const Stroke& stroke() const { return stroke_; }

 private:
  void makeDab();
  void takeStiffness();

  Workbench<Side>* bench_;
  Stroke stroke_;
  Edit<CornerBlock<Side>> edit_;
  clay::Stiffness stiffness_;  // painted before the stroke
  std::unique_ptr<DabMaker<Side>> maker_;
  OperationReport report_;
  bool finished_ = false;
};

extern template class LiveStroke<1>;
extern template class LiveStroke<8>;

}  // namespace bozzetto
