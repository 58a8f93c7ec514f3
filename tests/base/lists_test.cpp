// Tests for base/lists.h.

#include "base/lists.h"

#include <map>

#include <gtest/gtest.h>

namespace thenar {
namespace {

struct Entry {
  std::string name;
  int value;
};

TEST(Lists, TellWhatTheyHold) {
  const std::vector<int> list{3, 1, 4, 1};
  EXPECT_TRUE(contains(list, 4));
  EXPECT_FALSE(contains(list, 5));
  EXPECT_EQ(place_in(list, 1), 1);
  EXPECT_EQ(place_in(list, 5), -1);
}

TEST(Lists, FindEntriesByName) {
  std::vector<Entry> list{{"a", 1}, {"b", 2}, {"b", 3}};
  find_named(list, "b")->value = 7;
  EXPECT_EQ(list[1].value, 7);
  EXPECT_EQ(place_named(list, "b"), 1);
  EXPECT_EQ(place_named(list, "c"), -1);
  EXPECT_EQ(find_named(std::as_const(list), "c"), nullptr);
}

TEST(Lists, AreTestedAsAWhole) {
  const std::vector<int> list{1, 2}, none;
  const auto is_odd = [](int each) { return each % 2 == 1; };
  EXPECT_TRUE(any_of(list, is_odd));
  EXPECT_FALSE(all_of(list, is_odd));
  EXPECT_TRUE(all_of(none, is_odd));
  EXPECT_FALSE(any_of(none, is_odd));
}

TEST(Lists, MakeOthers) {
  const std::vector<int> list{1, 2};
  EXPECT_EQ(transformed(list, [](int each) { return 10.0 * each; }), (std::vector<double>{10, 20}));
  EXPECT_EQ(map_keys(std::map<std::string, int>{{"b", 1}, {"a", 2}}),
            (std::vector<std::string>{"a", "b"}));
}

TEST(Lists, LoseAndGainEntries) {
  std::vector<int> list{1, 2, 3};
  erase_where(list, [](int each) { return each != 2; });
  EXPECT_EQ(list, (std::vector<int>{2}));
  append_all(list, std::vector<int>{5, 6});
  EXPECT_EQ(list, (std::vector<int>{2, 5, 6}));
}

}  // namespace
}  // namespace thenar
