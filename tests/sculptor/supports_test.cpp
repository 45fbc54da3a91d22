// Supports by number, and settings of clay that cannot be.
#include <gtest/gtest.h>

#include "bozzetto/sculptor/sculptor.hpp"

namespace bozzetto {
namespace {

TEST(Supports, supportsAreMovedAndTakenByNumber) {
  Sculptor sculptor;
  SupportOperation table;
  sculptor.apply(table);
  table.support.centre = {0, 20, 0};
  sculptor.apply(table);
  table.support.centre = {5, 0, 0};
  sculptor.apply(SupportMoveOperation{0, table});
  ASSERT_EQ(sculptor.clay().supports.size(), 2u);
  EXPECT_EQ(sculptor.clay().supports[0].centre.x, 5);
  sculptor.apply(SupportDropOperation{0});
  ASSERT_EQ(sculptor.clay().supports.size(), 1u);
  EXPECT_EQ(sculptor.clay().supports[0].centre.y, 20);
  EXPECT_THROW(sculptor.apply(SupportDropOperation{1}), Error);
  EXPECT_THROW(sculptor.apply(SupportMoveOperation{-1, table}), Error);
  EXPECT_EQ(sculptor.history().undoDepth(), 4u);
  sculptor.apply(UndoOperation{3});
  ASSERT_EQ(sculptor.clay().supports.size(), 1u);
  EXPECT_EQ(sculptor.clay().supports[0].centre.x, 0);
}

std::string refusalOf(Sculptor& sculptor, const Operation& operation) {
  try {
    sculptor.apply(operation);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Supports, supportsThatCannotBeSayWhy) {
  Sculptor sculptor;
  EXPECT_EQ(refusalOf(sculptor, SupportDropOperation{0}),
            "support_drop: support 0 found, but there are no supports");
  SupportOperation table;
  sculptor.apply(table);
  EXPECT_EQ(refusalOf(sculptor, SupportDropOperation{3}),
            "support_drop: support 3 found, 0 to 0 expected");
  table.support.radii = {1e30, 8, 8};
  EXPECT_EQ(refusalOf(sculptor, table),
            "support: a tool at cell -1.000004e+30 to 1.000004e+30 on axis x "
            "leaves the workspace of ±2^30 cells");
  EXPECT_NE(refusalOf(sculptor, SupportMoveOperation{0, table}), "");
  EXPECT_EQ(sculptor.clay().supports.size(), 1u);
  EXPECT_EQ(sculptor.clay().supports[0].radii.x, 8);
  EXPECT_EQ(sculptor.history().undoDepth(), 1u) << "what was refused is no step";
}

TEST(Supports, boxesInsideOutAreRefused) {
  EXPECT_THROW(
      parseOperation("{\"op\":\"hold\",\"box\":{\"min\":[0,0,0],\"max\":[-9,9,9]}}", "test"),
      Error);
}

TEST(Supports, clayWithoutLayersThatMoveItIsNoted) {
  struct Notes final : Progress {
    void note(std::string_view) override { ++count; }
    int count = 0;
  } notes;
  Sculptor sculptor;
  for (const char* layers : {"[]", "[\"tension\"]", "[\"conservation\"]"})
    sculptor.apply(
        parseOperation(std::string("{\"op\":\"clay\",\"layers\":") + layers + "}", "test"), notes);
  EXPECT_EQ(notes.count, 2);
}

}  // namespace
}  // namespace bozzetto
