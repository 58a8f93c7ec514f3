// Tests for base/run_record.cpp.

#include "base/run_record.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

/// SOURCE_DATE_EPOCH for as long as it lives.
class Epoch {
 public:
  explicit Epoch(const char* seconds) { setenv("SOURCE_DATE_EPOCH", seconds, 1); }
  ~Epoch() { unsetenv("SOURCE_DATE_EPOCH"); }
  Epoch(const Epoch&) = delete;
  Epoch& operator=(const Epoch&) = delete;
};

// 10^9 seconds after 1970 are 11574 days, 1 h 46 min 40 s: 9 September 2001.
TEST(RunRecord, ObeysSourceDateEpoch) {
  const Epoch epoch("1000000000");
  const RunRecord record = record_of_run({"pose", "barrett"});
  EXPECT_EQ(record.date, "2001-09-09T01:46:40Z");
  EXPECT_EQ(record.folder, std::filesystem::current_path().string());
  EXPECT_EQ(record.arguments.back(), "barrett");
}

TEST(RunRecord, RefusesADateThatIsNone) {
  const Epoch epoch("yesterday");
  EXPECT_EQ(message_of([] { (void)record_of_run({}); }),
            "SOURCE_DATE_EPOCH: wanted whole seconds since 1970, got 'yesterday'");
}

TEST(RunRecord, NamesACommitOrNone) {
  const std::string commit = source_commit();
  EXPECT_TRUE(commit.empty() || commit.size() == 40) << commit;
  EXPECT_EQ(commit.find_first_not_of("0123456789abcdef"), std::string::npos) << commit;
}

TEST(RunRecord, ReadsBackInAShell) {
  EXPECT_EQ(command_line({{"fit", "my hand.toml", "it's", ""}, "", "", ""}),
            "thenar fit 'my hand.toml' 'it'\\''s' ''");
}

TEST(RunRecord, TakesALineApartAsItWasPutTogether) {
  const std::vector<std::string> typed{"fit",  "my hand.toml", "it's", "",
                                       "a\\b", "--tension",    "A=1"};
  EXPECT_EQ(arguments_of(command_line({typed, "", "", ""})), typed);
  EXPECT_TRUE(arguments_of("").empty());
  EXPECT_EQ(message_of([] { (void)arguments_of("thenar fit 'x"); }),
            "wanted a command line of thenar, got 'thenar fit 'x'");
}

}  // namespace
}  // namespace thenar
