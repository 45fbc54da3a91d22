// What tests of tools share: strokes on fresh clay, and a slow reference written from the formulas.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "bozzetto/base/simd.hpp"
#include "bozzetto/tool/fill.hpp"
#include "bozzetto/tool/stroke.hpp"

namespace bozzetto::testing {

inline constexpr Colour kBallColour{200, 40, 90}, kToolColour{20, 180, 250};

inline Primitive ballOf(double radius, glm::dvec3 centre = glm::dvec3(0),
                        Colour colour = kBallColour) {
  Primitive primitive;
  primitive.centre = centre;
  primitive.radii = glm::dvec3(radius);
  primitive.colour = colour;
  return primitive;
}

template <int Side>
Delta<CornerBlock<Side>> fillInto(Field<Side>& field, const Primitive& primitive) {
  Edit<CornerBlock<Side>> edit(field.tree);
  fill<Side>(edit, field.scale, primitive);
  return edit.commit();
}

template <int Side>
Field<Side> clayBall(double radius, glm::dvec3 centre = glm::dvec3(0),
                     Colour colour = kBallColour) {
  Field<Side> field;
  fillInto(field, ballOf(radius, centre, colour));
  return field;
}

template <int Side>
struct Made {
  StrokeReport report;
  Delta<CornerBlock<Side>> delta;
};

template <int Side>
Made<Side> stroke(Field<Side>& field, const ToolShape& tool, const ActionOptions& action,
                  const Stroke& path) {
  Edit<CornerBlock<Side>> edit(field.tree);
  StrokeRunner<Side> runner(edit, field.scale, tool, action, path);
  Made<Side> made;
  made.report = applyStroke(runner);
  made.delta = edit.commit();
  return made;
}

inline Stroke dabAt(glm::dvec3 position) {
  Stroke path;
  path.points = {{position, 1}};
  return path;
}

inline Stroke lineOf(glm::dvec3 from, glm::dvec3 to) {
  Stroke path;
  path.points = {{from, 1}, {to, 1}};
  return path;
}

inline ToolShape ball(double radius) {
  ToolShape tool;
  tool.radii = glm::dvec3(radius);
  return tool;
}

inline ToolShape oblique(Shape shape, Profile profile = Profile::wyvill) {
  ToolShape tool;
  tool.shape = shape;
  tool.profile = profile;
  tool.radii = {9, 6.5, 4.25};
  tool.rotation = glm::dquat(0.8, 0.3, -0.4, 0.2);
  return tool;
}

/// Every corner of a field with clay.
struct Sample {
  float value = 0;
  Attributes attributes = 0;
};
using Samples = std::map<Key, Sample>;

template <int Side>
Samples samplesOf(const Field<Side>& field) {
  Samples samples;
  for (const auto& [key, run] : field.tree) {
    for (std::int32_t n = 0; n < run.length; ++n) {
      const KeyBox box = BlockGeometry<Side>::cornersOf(key + Key{0, 0, n});
      for (auto i = box.low.i; i <= box.high.i; ++i)
        for (auto j = box.low.j; j <= box.high.j; ++j)
          for (auto k = box.low.k; k <= box.high.k; ++k) {
            const int at = BlockGeometry<Side>::indexOf({i, j, k});
            if (run.block->value[at] > 0)
              samples[{i, j, k}] = {run.block->value[at], run.block->attributes[at]};
          }
    }
  }
  return samples;
}

inline double wyvill(double u) {
  if (u >= 1) return 0;
  return 1 - 4.0 / 9 * std::pow(u, 6) + 17.0 / 9 * std::pow(u, 4) - 22.0 / 9 * u * u;
}

/// A session, a template over the block side that returns its field's hash, gives the same with
/// blocks of one corner and of 8³, with and without vectors.
template <class Session>
void expectSameBits(const Session& session) {
  const auto eight = session.template operator()<8>();
  EXPECT_EQ(session.template operator()<1>(), eight);
  forbidSimd(true);
  EXPECT_EQ(session.template operator()<8>(), eight);
  forbidSimd(false);
}

}  // namespace bozzetto::testing
