// Tests for api/named/things.cpp.

#include "api/named/things.h"

#include <gtest/gtest.h>

#include "api/named/data_folders.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(NamedThing, FindsNamesOfAllKinds) {
  EXPECT_EQ(named_thing("barrett", kData), kData + "/robots/barrett.toml");
  EXPECT_EQ(named_thing("synek2019_H01", kData), kData + "/experiments/synek2019_H01.toml");
  EXPECT_EQ(named_thing("two_soft_fingers", kData), kData + "/contacts/two_soft_fingers.json");
  EXPECT_EQ(named_thing(kData + "/nets/winslow.toml", ""), kData + "/nets/winslow.toml");
}

TEST(NamedThing, NamesTheNearest) {
  EXPECT_NE(message_of([] { (void)named_thing("baret", kData); }).find("did you mean 'barrett'?"),
            std::string::npos);
  EXPECT_EQ(message_of([] { (void)named_thing(kData + "/robots/baret.toml", kData); }),
            "there is no file '" + kData + "/robots/baret.toml', did you mean 'barrett.toml'?");
}

TEST(ReadThing, HoldsWhatTheFileIs) {
  const Thing net = read_thing(named_thing("winslow", kData));
  ASSERT_TRUE(std::holds_alternative<NetDescription>(net));
  EXPECT_EQ(std::get<NetDescription>(net).name, "winslow");
  EXPECT_TRUE(std::holds_alternative<BodySpec>(read_thing(named_thing("mug", kData))));
}

// The command names what reads a file of this kind.
TEST(ReadThing, NamesTheKindOfOthers) {
  const std::string path = named_thing("two_soft_fingers", kData);
  try {
    (void)read_thing(path);
    FAIL() << "expected WrongKindError";
  } catch (const WrongKindError& error) {
    EXPECT_EQ(error.kind, "contacts");
    EXPECT_EQ(error.name, path);
  }
}

}  // namespace
}  // namespace thenar
