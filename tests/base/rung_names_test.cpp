// Tests for base/rung_names.cpp.

#include "base/rung_names.h"

#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(RungNames, FindsEveryRungByItsName) {
  EXPECT_EQ(path_named("wrapped"), Path::kWrapped);
  EXPECT_EQ(hood_named("net"), Hood::kFloatingNet);
  EXPECT_EQ(muscle_named("elastic-tendon"), Muscle::kElasticTendon);
  for (const std::string& name : hood_names()) EXPECT_NO_THROW((void)hood_named(name));
}

TEST(RungNames, GuessesWhatWasMeant) {
  EXPECT_EQ(message_of([] { (void)path_named("wraped"); }),
            "no path 'wraped', did you mean 'wrapped'? there are via, fitted, wrapped");
}

}  // namespace
}  // namespace thenar
