// Tests for data/io/doubled_trials.cpp.

#include "data/io/doubled_trials.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

Experiment measured(const std::string& name) {
  return read_experiment(kData + "/experiments/synek2019_" + name + ".toml");
}

TEST(DoubledTrials, AreNoneInPublishedForces) {
  EXPECT_TRUE(doubled_trial_warnings({measured("H01"), measured("H02"), measured("B01")}).empty());
}

TEST(DoubledTrials, ACopiedRowIsNamedBesideItsOriginal) {
  Experiment copied = measured("H01");
  copied.trials.push_back(copied.trials[1]);
  EXPECT_EQ(
      doubled_trial_warnings({copied}),
      std::vector<std::string>{
          "trial 25 of 'synek2019_H01' (MinorFlex, FDP) is the same as trial 2 of "
          "'synek2019_H01' (MinorFlex, FDP) to the last digit: a copied row counts twice, and "
          "intervals come out too narrow"});
  copied.trials.push_back(copied.trials[1]);
  EXPECT_NE(doubled_trial_warnings({copied})[0].find(", and so is 1 more"), std::string::npos);
}

// The same file under another name, as a second specimen.
TEST(DoubledTrials, AreSeenAcrossExperiments) {
  Experiment renamed = measured("H01");
  renamed.name = renamed.specimen = "other";
  const std::vector<std::string> warnings = doubled_trial_warnings({measured("H01"), renamed});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("and so are 23 more"), std::string::npos) << warnings[0];
}

// A measurement made again differs in its last digits; a load that moves nothing reads zero again.
TEST(DoubledTrials, RepeatedMeasurementsAreNone) {
  Experiment repeated = measured("H01");
  repeated.trials.push_back(repeated.trials[1]);
  repeated.trials.back().force.x() += 1e-12;
  repeated.trials.push_back(repeated.trials[2]);
  repeated.trials.push_back(repeated.trials[2]);
  for (std::size_t i = 25; i < 27; ++i) repeated.trials[i].force.setZero();
  EXPECT_TRUE(doubled_trial_warnings({repeated}).empty());
}

}  // namespace
}  // namespace thenar
