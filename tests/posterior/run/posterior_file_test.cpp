// Tests for posterior/run/posterior_file.cpp and posterior_groups.cpp: to a file and back.

#include "posterior/run/posterior_file.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data/mutated_arrays.h"
#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

using sample::sampled;
using sample::temporary_path;
using testing::AllOf;
using testing::AnyOf;
using testing::EndsWith;
using testing::Not;
using testing::StartsWith;

TEST(PosteriorFile, ComesBackWithEveryDrawAndVerdict) {
  const std::string path = temporary_path("thenar_posterior_test.nc");
  write_posterior(sampled(), path);
  const PosteriorRun back = read_posterior(path);
  std::filesystem::remove(path);
  EXPECT_EQ(pooled(back.draws), pooled(sampled().draws));
  EXPECT_EQ(back.convergence.worst_r_hat, sampled().convergence.worst_r_hat);
  EXPECT_EQ(back.convergence.warnings, sampled().convergence.warnings);
  EXPECT_EQ(back.inputs.settings.text, sampled().inputs.settings.text);
  EXPECT_EQ(back.draws.stats[1][7].energy, sampled().draws.stats[1][7].energy);
  EXPECT_EQ(describe_run(back), describe_run(sampled()));
  EXPECT_EQ(back.settings.run.sampler.target_acceptance, 0.85);
  EXPECT_EQ(back.settings.run.sampler.max_depth, 9);
}

TEST(PosteriorFile, KeepsTheRecordOfItsRun) {
  const std::string path = temporary_path("thenar_posterior_record.nc");
  PosteriorRun run = sampled();
  EXPECT_EQ(describe_posterior(run).attributes.count("run_command"), 0U);
  run.run = {{"fit", "my H01.toml"}, "/work", "abc", "2001-09-09T01:46:40Z"};
  write_posterior(run, path);
  const PosteriorRun back = read_posterior(path);
  std::filesystem::remove(path);
  EXPECT_EQ(back.run.arguments, run.run.arguments);
  EXPECT_EQ(back.run.folder, "/work");
  EXPECT_EQ(back.run.commit, "abc");
  EXPECT_EQ(back.run.date, "2001-09-09T01:46:40Z");
  EXPECT_EQ(describe_posterior(run).attributes.at("created_at"), "2001-09-09T01:46:40Z");
}

TEST(PosteriorFile, RefusesOtherFiles) {
  const std::string path = temporary_path("thenar_not_a_posterior.nc");
  InferenceFile other;
  other.groups["posterior"].lengths["draw"] = 1;
  other.groups["posterior"].arrays["a"] = {{1}, {"draw"}, "1", ""};
  write_inference(other, path);
  EXPECT_THROW((void)read_posterior(path), DataError);
  std::filesystem::remove(path);
}

// Of what only people read, numbers need not be known; everything else is refused.
TEST(PosteriorFile, IsRefusedWithAnyArrayChanged) {
  const std::string path = temporary_path("thenar_posterior_changed.nc");
  const MutationVerdicts verdicts = verdicts_on_mutations(
      describe_posterior(sampled()), path, {"unconstrained_posterior", "sample_stats", "modes"},
      [](const std::string& file) { (void)read_posterior(file); });
  std::filesystem::remove(path);
  EXPECT_GE(verdicts.size(), kMinMutations);
  for (const std::string& verdict : read_all_the_same(verdicts))
    EXPECT_THAT(verdict,
                AnyOf(StartsWith("prior/"), AllOf(StartsWith("posterior/"), EndsWith(" missing")),
                      AllOf(Not(StartsWith("sample_stats/")), Not(StartsWith("unconst")),
                            EndsWith(" not a number"))));
}

TEST(PosteriorFile, HasNoPopulationOfOneSpecimen) {
  const InferenceFile file = describe_posterior(sampled());
  EXPECT_EQ(file.groups.at("posterior").arrays.count("hood_central"), 0U);
  EXPECT_EQ(file.groups.at("posterior").arrays.count("hood_central_specimen"), 1U);
}

}  // namespace
}  // namespace thenar
