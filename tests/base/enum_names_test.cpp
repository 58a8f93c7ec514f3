#include "base/enum_names.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

enum class Fruit { kPlum, kPear };
constexpr std::array kFruitNames{EnumName{Fruit::kPear, "pear"}, EnumName{Fruit::kPlum, "plum"}};

TEST(EnumNames, GoBothWaysWhateverTheOrder) {
  EXPECT_EQ(name_in(kFruitNames, Fruit::kPlum), "plum");
  EXPECT_EQ(name_in(kFruitNames, Fruit::kPear), "pear");
  EXPECT_EQ(value_in(kFruitNames, "plum", "fruit"), Fruit::kPlum);
  EXPECT_EQ(names_in(kFruitNames), (std::vector<std::string>{"pear", "plum"}));
}

TEST(EnumNames, NameTheNearest) {
  EXPECT_EQ(message_of([] { (void)value_in(kFruitNames, "peer", "fruit"); }),
            "no fruit 'peer', did you mean 'pear'? there are pear, plum");
}

TEST(EnumNames, HaveNoNameForWhatTheTableLacks) {
  EXPECT_EQ(name_in(kFruitNames, static_cast<Fruit>(7)), "");
}

}  // namespace
}  // namespace thenar
