// How much a moving frame may cost: steps up and down by the times measured.
#pragma once
#include <array>
#include <string_view>

namespace bozzetto {

/// From what a processor alone can draw to what a graphics card can.
enum class Quality {
  least,   ///< baked, half resolution, coarse clay above 100,000 triangles, no floor
  light,   ///< baked, coarse clay above 250,000 triangles
  middle,  ///< baked, multisampled on a graphics card
  good,    ///< full light, shadows with 8 taps, multisampled
  best,    ///< full light, shadows with 16 taps, multisampled
};

/// Median of the last 8 frames: one step up after 2 s below 60 % of the budget, one step down after
/// 3 frames above 110 %. Never within a stroke.
class QualityLadder {
 public:
  /// What draws, as the driver calls itself: a processor starts at light with 33 ms and stays
  /// below good, a card at good with 16 ms.
  explicit QualityLadder(std::string_view rendererName);

  /// A moving frame took `milliseconds` at `now` (seconds).
  void measured(double milliseconds, double now);
  void setStroke(bool inStroke) { inStroke_ = inStroke; }

  Quality quality() const { return quality_; }
  bool onProcessor() const { return onProcessor_; }
  double budgetMilliseconds() const { return onProcessor_ ? 33 : 16; }
  double medianMilliseconds() const;

 private:
  void change(int steps, double now);

  bool onProcessor_, inStroke_ = false;
  Quality quality_;
  std::array<double, 8> last_{};
  int count_ = 0, slow_ = 0;
  double fastSince_ = -1;
};

}  // namespace bozzetto
