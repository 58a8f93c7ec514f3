// Tests for report/answers/recorded_run.cpp.

#include "report/answers/recorded_run.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(RecordedRunText, IsACommandLineWithItsCircumstances) {
  RecordedRun recorded;
  recorded.run = {{"pose", "my hand.toml"}, "/home/ada", "", "2026-01-31T12:00:00Z"};
  recorded.warnings = {"input 'my hand.toml' is gone"};
  EXPECT_EQ(text_of(recorded),
            "thenar pose 'my hand.toml'\n  in /home/ada\n  on 2026-01-31T12:00:00Z, by commit -\n"
            "  inputs: none recorded\n  warning: input 'my hand.toml' is gone\n");
  EXPECT_EQ(json_of(recorded)["arguments"][1], "my hand.toml");
}

}  // namespace
}  // namespace thenar
