// The tree of runs against a plain map of single keys.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "bozzetto/grid/edit.hpp"

namespace bozzetto {
namespace {

// A block that is a number; equal numbers above 100 are interned, 0 is empty.
struct Number : RefCounted {
  static constexpr int kCount = 1;
  int number = 0;
  Number() = default;
  explicit Number(int n) : number(n) {}

  static Ref<Number> shared(int n) {
    static std::map<int, Ref<Number>> table;
    Ref<Number>& block = table[n];
    if (!block) block = Ref<Number>(new Number(n));
    return block;
  }
  static Ref<Number> canonical(Ref<Number> block) {
    if (block->number == 0) return nullptr;
    return block->number > 100 ? shared(block->number) : block;
  }
  bool sameAs(const Number& other) const { return number == other.number; }
};

using Tree = KeyTree<Number>;
using Model = std::map<Key, int>;

Model contentOf(const Tree& tree) {
  Model model;
  for (const auto& [key, run] : tree) {
    for (int n = 0; n < run.length; ++n) model[key + Key{0, 0, n}] = run.block->number;
  }
  return model;
}

TEST(KeyTree, randomPutsAndErasesMatchAPlainMap) {
  std::mt19937 random(7);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Tree tree;
  Model model;
  for (int step = 0; step < 4000; ++step) {
    const Key key{pick(2), pick(2), pick(40) - 20};
    const int length = 1 + pick(9);
    const int number = pick(3) == 0 ? 0 : 101 + pick(3);
    for (int n = 0; n < length; ++n) {
      if (number == 0) model.erase(key + Key{0, 0, n});
      if (number != 0) model[key + Key{0, 0, n}] = number;
    }
    if (number == 0) tree.erase(key, length);
    if (number != 0) tree.put(key, length, Number::shared(number));
    if (pick(2) == 0) tree.join(key);
    ASSERT_EQ(tree.validate(), std::nullopt);
    ASSERT_EQ(contentOf(tree), model) << "step " << step;
  }
}

TEST(KeyTree, joinMakesOneNodeOfTouchingRuns) {
  Tree tree;
  for (int k : {0, 2, 1}) {
    tree.put({0, 0, k}, Number::shared(200));
    tree.join({0, 0, k});
  }
  tree.put({0, 1, 0}, Number::shared(200));
  tree.join({0, 1, 0});
  EXPECT_EQ(tree.nodeCount(), 2u);
  EXPECT_EQ(tree.begin()->second.length, 3);
}

TEST(KeyTree, findSeesInsideRunsAndNotBeyond) {
  Tree tree;
  tree.put({0, 0, -5}, 10, Number::shared(300));
  EXPECT_EQ(tree.find({0, 0, -6}), nullptr);
  EXPECT_EQ(tree.find({0, 0, -5})->number, 300);
  EXPECT_EQ(tree.find({0, 0, 4})->number, 300);
  EXPECT_EQ(tree.find({0, 0, 5}), nullptr);
  EXPECT_EQ(tree.find({0, 1, 0}), nullptr);
}

TEST(KeyTree, aNearNodeLeadsToWhereASearchLeads) {
  std::mt19937 random(3);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Tree tree;
  for (int n = 0; n < 300; ++n)
    tree.put({pick(2), pick(3), pick(90)}, 1 + pick(4), Number::shared(101 + pick(3)));
  auto near = tree.end();
  for (Key key{0, 0, -2}; key.i<2; key = key.k> 99 ? Key{key.i + (key.j > 2), (key.j + 1) % 4, -2}
                                                   : key + Key{0, 0, 1 + pick(5)}) {
    const auto expected = tree.from(key);
    EXPECT_EQ(tree.from(key, near), expected) << toText(key);
    near = expected;
  }
}

TEST(KeyTree, runsReachTheRimOfTheKeys) {
  Tree tree;
  const std::int32_t rim = kWorkspaceRim / 8;
  tree.put({rim, -rim, -rim}, 2 * rim, Number::shared(300));
  EXPECT_NE(tree.find({rim, -rim, rim - 1}), nullptr);
  EXPECT_EQ(tree.find({rim, -rim, rim}), nullptr);
}

TEST(Edit, randomEditsUndoAndRedoToTheSameContent) {
  std::mt19937 random(11);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Tree tree;
  std::vector<Model> states{contentOf(tree)};
  std::vector<Delta<Number>> deltas;
  for (int step = 0; step < 200; ++step) {
    Edit<Number> edit(tree);
    for (int write = pick(8); write >= 0; --write) {
      const Key key{0, pick(2), pick(16)};
      if (pick(3) == 0) edit.replace({key, 1 + pick(6)}, pick(2) ? Number::shared(200) : nullptr);
      if (pick(3) != 0) edit.write(key).number = pick(4) * 67;
    }
    deltas.push_back(edit.commit());
    ASSERT_EQ(tree.validate(), std::nullopt);
    states.push_back(contentOf(tree));
  }
  for (std::size_t n = deltas.size(); n-- > 0;) {
    deltas[n].apply(tree, Direction::backward);
    ASSERT_EQ(contentOf(tree), states[n]) << "undo of step " << n;
    ASSERT_EQ(tree.validate(), std::nullopt);
  }
  for (std::size_t n = 0; n < deltas.size(); ++n) {
    deltas[n].apply(tree, Direction::forward);
    ASSERT_EQ(contentOf(tree), states[n + 1]) << "redo of step " << n;
  }
}

TEST(Edit, replacingInOrderEqualsReplacingOneByOne) {
  std::mt19937 random(13);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Tree tree, twin;
  for (int step = 0; step < 100; ++step) {
    Edit<Number> edit(tree), other(twin);
    if (pick(2) == 0) {
      const KeyRun run{{0, pick(3), pick(30)}, 1 + pick(9)};
      edit.replace(run, Number::shared(150));
      other.replace(run, Number::shared(150));
    }
    Edit<Number>::Place place(edit);
    for (Key key{0, 0, pick(8)};
         key.j<3; key = key.k> 30 ? Key{0, key.j + 1, pick(8)} : key + Key{0, 0, 1 + pick(4)}) {
      const Ref<Number> block = pick(3) == 0 ? nullptr : Number::shared(101 + pick(60));
      edit.replace(key, block, place);
      other.replace({key, 1}, block);
    }
    const auto delta = edit.commit(), expected = other.commit();
    ASSERT_EQ(contentOf(tree), contentOf(twin));
    ASSERT_EQ(tree.nodeCount(), twin.nodeCount());
    ASSERT_EQ(delta.keys().size(), expected.keys().size());
    ASSERT_EQ(tree.validate(), std::nullopt);
    if (pick(3) != 0) continue;
    delta.apply(tree, Direction::backward);
    expected.apply(twin, Direction::backward);
    ASSERT_EQ(contentOf(tree), contentOf(twin));
  }
}

TEST(Edit, aBlockHandedOutToBeWrittenIsNotSettled) {
  Tree tree;
  Edit<Number> edit(tree);
  Number& block = edit.write({0, 0, 0});
  block.number = 7;
  block.settled = true;
  EXPECT_FALSE(edit.write({0, 0, 0}).settled);
}

TEST(Edit, writingWhatWasThereIsNoChange) {
  Tree tree;
  tree.put({0, 0, 0}, Ref<Number>(new Number(5)));
  const Number* before = tree.find({0, 0, 0});
  Edit<Number> edit(tree);
  edit.write({0, 0, 0}).number = 5;
  edit.write({0, 0, 9});
  EXPECT_TRUE(edit.commit().empty());
  EXPECT_EQ(tree.find({0, 0, 0}), before);
  EXPECT_EQ(tree.nodeCount(), 1u);
}

TEST(Edit, sharedBlocksAreNeverWritten) {
  Tree tree;
  tree.put({0, 0, 0}, Ref<Number>(new Number(5)));
  const Tree copy = tree;
  Edit<Number> edit(tree);
  edit.write({0, 0, 0}).number = 6;
  edit.commit();
  EXPECT_EQ(copy.find({0, 0, 0})->number, 5);
  EXPECT_EQ(tree.find({0, 0, 0})->number, 6);
}

TEST(Edit, aDuplicateMadeDuringAnEditStaysAsItIs) {
  Tree tree;
  Edit<Number> edit(tree);
  edit.write({0, 0, 0}).number = 5;
  const Tree copy = tree;
  edit.write({0, 0, 0}).number = 6;
  EXPECT_EQ(copy.find({0, 0, 0})->number, 5);
  edit.rollback();
  EXPECT_TRUE(tree.empty());
  EXPECT_EQ(copy.find({0, 0, 0})->number, 5);
}

TEST(Delta, differenceLeadsFromOneTreeToTheOther) {
  std::mt19937 random(5);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 200; ++round) {
    Tree a, b;
    for (int n = 0; n < 6; ++n) {
      a.put({0, 0, pick(30)}, 1 + pick(9), Number::shared(200 + pick(2)));
      b.put({0, 0, pick(30)}, 1 + pick(9), Number::shared(200 + pick(2)));
    }
    const KeyRun all{{0, 0, -1}, 50};
    difference(a, b, {&all, 1}).apply(a, Direction::forward);
    ASSERT_EQ(contentOf(a), contentOf(b));
    ASSERT_EQ(a.validate(), std::nullopt);
  }
}

TEST(Edit, withoutCommitNothingRemains) {
  Tree tree;
  tree.put({0, 0, 0}, 5, Number::shared(200));
  const Model before = contentOf(tree);
  {
    Edit<Number> edit(tree);
    edit.write({0, 0, 2}).number = 6;
    edit.replace({{0, 0, 4}, 10}, Number::shared(300));
  }
  EXPECT_EQ(contentOf(tree), before);
  EXPECT_EQ(tree.nodeCount(), 1u);
}

}  // namespace
}  // namespace bozzetto
