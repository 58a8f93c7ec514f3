// Tests for api/experiment_check.cpp.

#include "api/experiment_check.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "api/named/files.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

const std::string kH01 = kData + "/experiments/synek2019_H01.toml";

/// The experiment with one text in place of another, everywhere.
SourceText with(const std::string& from, const std::string& to) {
  SourceText source = read_source(kH01);
  source.path = "H01.toml";
  for (std::size_t at = source.text.find(from); at != std::string::npos;
       at = source.text.find(from, at + to.size()))
    source.text.replace(at, from.size(), to);
  return source;
}

SubjectMatch checked(const SourceText& source) {
  return check_experiment(source, read_subject(kData + "/subjects/an_chao_middle.toml"));
}

bool any_starts(const std::vector<std::string>& sentences, const std::string& start) {
  return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
    return sentence.compare(0, start.size(), start) == 0;
  });
}

TEST(CheckExperiment, FindsNothingWrongWithAPublishedOne) {
  EXPECT_TRUE(checked(read_source(kH01)).misfits.empty());
  EXPECT_TRUE(checked(read_source(kH01)).doubts.empty());
}

TEST(CheckExperiment, NamesWhatTheDigitHasNotByItsLine) {
  // The joint stands in the first posture, which begins on line 30; the muscle in row 1, line 48.
  EXPECT_EQ(checked(with("PIP3", "PIP")).misfits.front(),
            "H01.toml:30: the digit has no free joint 'PIP', did you mean 'PIP3'? it has MCP3_FE, "
            "MCP3_AA, PIP3, DIP3");
  EXPECT_TRUE(
      any_starts(checked(with("FDS", "FSD")).misfits, "H01.toml:48: the digit has no musc"));
  EXPECT_TRUE(any_starts(checked(with("\"middle\"", "\"index\"")).misfits, "H01.toml:15: subject"));
}

TEST(CheckExperiment, DoubtsForcesOfAnotherUnitOrSign) {
  // 45 g at an efficiency of 0.835 are 0.37 N; a force of 1.73 N cannot come from these.
  EXPECT_TRUE(any_starts(checked(with("FDS = 950", "FDS = 45")).doubts,
                         "H01.toml:48: the tip's force, 2.14 N, is larger than all tensions"));
  EXPECT_TRUE(any_starts(
      checked(with("\"proximal\", \"dorsal\", \"radial\"", "\"distal\", \"palmar\", \"ulnar\""))
          .doubts,
      "H01.toml:23: measured forces point"));
}

TEST(CheckExperiment, DoubtsPosturesBeyondTheLimits) {
  EXPECT_TRUE(any_starts(checked(with("PIP3 = 55", "PIP3 = 150")).doubts, "H01.toml:30: "));
}

}  // namespace
}  // namespace thenar
