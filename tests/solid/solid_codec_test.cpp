// Solids as bytes: there and back, cut short anywhere, wrong anywhere.
#include "bozzetto/solid/solid_codec.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/tools.hpp"

namespace bozzetto {
namespace {

SolidRef rich() {
  Solid solid;
  NamedLattice made = makeBlock({{2, 2, 1}, glm::dvec3(3), glm::dvec3(1), {{1, 1, 0}}});
  solid.control = std::move(made.lattice);
  solid.names = std::move(made.names);
  solid = sharpened(solid, Element::face, 0, Sharp::yes);
  solid = sharpened(solid, Element::point, 3, Sharp::yes);
  solid = painted(solid, Matter::mass, {0, 0, 0}, 4, 3);
  solid = inflated(solid, {0, 0, 0}, 4, 0.2);
  solid.settings.creep = 0.25;
  const Pull pull{{4, 4, 2}, {5, 5, 2}};
  return std::make_shared<Solid>(pulled(solid, std::span(&pull, 1), 5, 3));
}

TEST(SolidCodec, ThereAndBack) {
  const SolidRef solid = rich();
  EXPECT_EQ(*decodeSolid(encodeSolid(solid), "test"), *solid);
  EXPECT_TRUE(encodeSolid(nullptr).empty());
  EXPECT_EQ(decodeSolid({}, "test"), nullptr);
}

TEST(SolidCodec, CutShortAnywhereIsAnError) {
  const Bytes bytes = encodeSolid(rich());
  for (std::size_t size = 1; size < bytes.size(); size += 7)
    EXPECT_THROW(decodeSolid(std::span(bytes).first(size), "test"), Error) << size;
  Bytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_THROW(decodeSolid(longer, "test"), Error);
}

TEST(SolidCodec, WrongBytesAreAnErrorOrASolid) {
  const Bytes good = encodeSolid(rich());
  for (std::size_t n = 0; n < good.size(); n += 3) {
    Bytes bytes = good;
    bytes[n] ^= std::byte{0xff};
    try {
      const SolidRef solid = decodeSolid(bytes, "test");
      EXPECT_EQ(validate(solid->control), std::nullopt);
    } catch (const Error&) {
    }
  }
}

TEST(SolidCodec, DeltasGiveTheLaterSolid) {
  const SolidRef before = rich();
  Solid changed = *before;
  changed.control.points[2] += glm::dvec3(1, 2, 3);
  const auto moved = std::make_shared<const Solid>(changed);
  changed.settings.damping = 7;
  const auto set = std::make_shared<const Solid>(changed);
  const std::vector<SolidRef> all{nullptr, before, moved, set};
  for (const SolidRef& from : all) {
    for (const SolidRef& to : all) {
      const SolidRef found = applySolidDelta(from, encodeSolidDelta(from, to), "test");
      ASSERT_EQ(found == nullptr, to == nullptr);
      if (to != nullptr) {
        EXPECT_EQ(*found, *to);
      }
    }
  }
  EXPECT_LT(encodeSolidDelta(before, moved).size(), 64u);
  EXPECT_EQ(encodeSolidDelta(moved, moved).size(), 1u);
  EXPECT_THROW(applySolidDelta(nullptr, encodeSolidDelta(before, moved), "test"), Error);
}

}  // namespace
}  // namespace bozzetto
