#include "bozzetto/base/function_ref.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "bozzetto/base/axis.hpp"

namespace bozzetto {
namespace {

int twice(FunctionRef<int(int)> function) { return function(function(1)); }

TEST(FunctionRef, CallsWhatItViews) {
  int calls = 0;
  auto addThree = [&](int n) { return ++calls, n + 3; };
  EXPECT_EQ(twice(addThree), 7);
  EXPECT_EQ(calls, 2);
}

TEST(FunctionRef, KeepsTheStateOfTheCallable) {
  auto counter = [n = 0](int) mutable { return ++n; };
  EXPECT_EQ(twice(counter), 2);
  EXPECT_EQ(counter(0), 3) << "no copy was made";
}

TEST(FunctionRef, MovesArgumentsThrough) {
  auto take = [](std::unique_ptr<int> value) { return *value; };
  const FunctionRef<int(std::unique_ptr<int>)> view(take);
  EXPECT_EQ(view(std::make_unique<int>(9)), 9);
}

TEST(Axis, NextGoesRound) {
  for (const Axis axis : kAxes) {
    EXPECT_NE(next(axis), axis);
    EXPECT_EQ(next(next(next(axis))), axis);
  }
  EXPECT_EQ(next(Axis::x), Axis::y);
}

}  // namespace
}  // namespace bozzetto
