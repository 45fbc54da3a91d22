// The stamp's deformation (Ferley §4.3, figures 10–12; algorithms.md §1): clay goes where the tool
// is and rises round it, as a function of how deep in the tool, or how far from it, a corner lies.
#pragma once

namespace bozzetto {

/// paper: outside, too, the potential says how far; the rim must fit in its fall.
/// radius: outside, distance ÷ the tool's reference radius: any tool gets the rim asked for.
enum class StampProfile { paper, radius };

struct StampOptions {
  double height = 0.3;  ///< n: density that the bulge adds at its crest, ≥ 0
  double rise = 0.2;    ///< m: from the tool's surface to the crest, in reference radii, > 0
  double fall = 0.3;    ///< r: from the crest to where the clay is as before, > 0
  double slope = 0;     ///< g: steepness at the surface; 0 … min(3n/m, 3/s₀)
  StampProfile profile = StampProfile::radius;
  bool conserving = false;  ///< the height is found so that what rises weighs what goes

  friend bool operator==(const StampOptions&, const StampOptions&) = default;
};

/// The nearest options with a curve: m and r at least 0.01, slope within its bounds and, where the
/// profile is the paper's, a rim that fits. Throws Error for numbers that are not finite.
StampOptions clamped(const StampOptions& options, double iso);

/// def(d): −1 at the tool's core (d = 0), 0 on its surface (d = 1 − iso), the height at its crest,
/// 0 from end() on; C¹. What a panel draws.
class StampCurve {
 public:
  /// Clamps the options.
  StampCurve(const StampOptions& options, double iso);

  double operator()(double d) const;
  /// Beyond the surface, of a rim so many times as wide, in 0…1; inside and past its end 0.
  void bulge(const float* depth, int count, double widening, float* def) const;
  double surface() const { return surface_; }  ///< s₀
  double end() const { return surface_ + rise_ + fall_; }

 private:
  // a·x³ + b·x² + c·x + e, x from the beginning of its piece.
  struct Cubic {
    double a, b, c, e;
    [[gnu::always_inline]] double operator()(double x) const {
      return ((a * x + b) * x + c) * x + e;
    }
  };
  double surface_, rise_, fall_;
  Cubic inside_, rising_, falling_;
};

}  // namespace bozzetto
