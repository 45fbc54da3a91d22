// Solids through the one door: operations, undo, both block sides.
#include <gtest/gtest.h>

#include <cmath>

#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/sculptor.hpp"
#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"

namespace bozzetto {
namespace {

template <int Side>
void submit(BasicSculptor<Side>& sculptor, const std::string& line) {
  const Operation operation = parseOperation(line, "test");
  EXPECT_EQ(toText(parseOperation(toText(operation), "again")), toText(operation));
  sculptor.apply(operation);
}

TEST(SolidOperations, BlockMoveBake) {
  Sculptor sculptor;
  submit(sculptor,
         R"({"op":"solid","cells":[2,2,2],"edge":20,"center":[0,0,0],"removed":[[0,0,1]]})");
  ASSERT_NE(sculptor.solid(), nullptr);
  EXPECT_EQ(sculptor.solid()->control.cells.size(), 7u);
  submit(sculptor, R"({"op":"solid_move","point":[2,2,2],"by":[5,6,7]})");
  const Id moved = sculptor.solid()->pointNamed({2, 2, 2});
  EXPECT_EQ(sculptor.solid()->control.points[moved], glm::dvec3(25, 26, 27));
  const double volume = enclosedVolume(refine(surfaceOf(sculptor.solid()->control), 2).lattice);
  submit(sculptor, R"({"op":"bake","levels":2,"colour":"#b08060"})");
  EXPECT_EQ(validate(sculptor.field()), std::nullopt);
  EXPECT_NEAR(statistics(sculptor.field()).mass / volume, 1, 5e-3);
  EXPECT_EQ(colourOf(sculptor.field().attributes({5, 5, 5})), (Colour{0xb0, 0x80, 0x60}));
  EXPECT_EQ(sculptor.history().steps().size(), 3u);
}

TEST(SolidOperations, EachIsOneStepOfUndo) {
  Sculptor sculptor;
  submit(sculptor, R"({"op":"fill","radii":[9,20,9]})");
  const std::uint64_t filled = fieldHash(sculptor.field());
  submit(sculptor, R"({"op":"wrap","cells":[4,4,4]})");
  EXPECT_EQ(sculptor.solid()->names.size(), 343u);
  const SolidRef wrapped = sculptor.solid();
  for (int j = 0; j <= 6; ++j)
    for (int k = 0; k <= 6; ++k)
      submit(sculptor, R"({"op":"solid_move","point":[6,)" + std::to_string(j) + "," +
                           std::to_string(k) + R"(],"by":[6,0,0]})");
  submit(sculptor, R"({"op":"wrap_apply","keep_mass":true})");
  const std::uint64_t posed = fieldHash(sculptor.field());
  EXPECT_NE(posed, filled);
  submit(sculptor, R"({"op":"undo"})");
  EXPECT_EQ(fieldHash(sculptor.field()), filled);
  submit(sculptor, R"({"op":"undo","count":49})");
  EXPECT_EQ(*sculptor.solid(), *wrapped);
  submit(sculptor, R"({"op":"undo"})");
  EXPECT_EQ(sculptor.solid(), nullptr);
  EXPECT_EQ(fieldHash(sculptor.field()), filled);
  submit(sculptor, R"({"op":"redo","count":51})");
  EXPECT_EQ(fieldHash(sculptor.field()), posed);
}

TEST(SolidOperations, WrapKeepsMassAndSidesAgree) {
  std::vector<std::uint64_t> hashes;
  const auto work = [&](auto& sculptor) {
    submit(sculptor, R"({"op":"fill","shape":"capsule","radii":[7,22,7],"colour":"#aa5533"})");
    submit(sculptor, R"({"op":"fill","center":[0,20,0],"radii":[9,9,9],"colour":"#3355aa"})");
    submit(sculptor, R"({"op":"wrap","cells":[2,3,2]})");
    for (int i = 0; i <= 4; ++i)
      for (int k = 0; k <= 4; ++k)
        submit(sculptor, R"({"op":"solid_move","point":[)" + std::to_string(i) + ",5," +
                             std::to_string(k) + R"(],"by":[12,-4,3]})");
    const double before = statistics(sculptor.field()).mass;
    submit(sculptor, R"({"op":"wrap_apply"})");
    EXPECT_NEAR(statistics(sculptor.field()).mass / before, 1, 1e-6);
    hashes.push_back(fieldHash(sculptor.field()));
  };
  BasicSculptor<8> blocks;
  BasicSculptor<1> corners;
  work(blocks);
  work(corners);
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(SolidOperations, WhatCannotBeDoneChangesNothing) {
  Sculptor sculptor;
  for (const char* line :
       {R"({"op":"bake"})", R"({"op":"wrap"})", R"({"op":"wrap_apply"})", R"({"op":"solid_drop"})",
        R"({"op":"solid_move","point":[0,0,0],"by":[1,1,1]})", R"({"op":"solid","cells":[0,1,1]})",
        R"({"op":"solid","edge":-1})"}) {
    EXPECT_THROW(submit(sculptor, line), Error) << line;
  }
  submit(sculptor, R"({"op":"solid"})");
  EXPECT_THROW(submit(sculptor, R"({"op":"wrap_apply"})"), Error);
  EXPECT_THROW(submit(sculptor, R"({"op":"solid_move","point":[3,0,0],"by":[1,1,1]})"), Error);
  EXPECT_THROW(submit(sculptor, R"({"op":"solid_move","point":27,"by":[1,1,1]})"), Error);
  EXPECT_EQ(sculptor.history().steps().size(), 1u);
  for (const char* line :
       {R"({"op":"solid","cells":[1.5,1,1]})", R"({"op":"solid_move","point":[0,0],"by":[1,1,1]})",
        R"({"op":"solid_move","point":[0,0,0]})", R"({"op":"bake","levels":9})",
        R"({"op":"wrap","min":[0,0,0]})", R"({"op":"solid","removed":3})"}) {
    EXPECT_THROW(parseOperation(line, "test"), Error) << line;
  }
}

}  // namespace
}  // namespace bozzetto
