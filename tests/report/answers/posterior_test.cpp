// Tests for report/answers/posterior.cpp.

#include "report/answers/posterior.h"

#include <gtest/gtest.h>

#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

PosteriorResult small_result() {
  return {{}, {}, sample::sampled(), summarise_posterior(sample::sampled()), 3};
}

TEST(PosteriorAnswer, ListsTheBestKnownFirst) {
  const PosteriorResult result = small_result();
  const Table table = table_of(result);
  ASSERT_EQ(table.rows.size(), result.summary->quantities.size());
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    EXPECT_LE(std::stod(table.rows[i - 1][4]) / std::stod(table.rows[i - 1][5]),
              std::stod(table.rows[i][4]) / std::stod(table.rows[i][5]) * (1 + 1e-6));
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  EXPECT_NE(text_of(result).find("best-determined parameters (3 of 8)"), std::string::npos)
      << text_of(result);
}

TEST(PosteriorAnswer, HasMeaningsAndTheVerdict) {
  const OrderedJson json = json_of(small_result());
  for (const OrderedJson& parameter : json["parameters"])
    EXPECT_FALSE(parameter["meaning"].get<std::string>().empty()) << parameter["name"];
  EXPECT_EQ(json["converged"], sample::sampled().convergence.warnings.empty());
  EXPECT_EQ(json["draws"], 250);
}

TEST(ConvergenceComplaint, NamesCausesAndTheCommandToGoOnWith) {
  PosteriorRun run = sample::sampled();
  run.convergence.warnings = {"R-hat of a is 1.2, above 1.01"};
  run.convergence.worst_r_hat = 1.2;
  run.run.arguments = {"fit", "H01", "--draws", "250"};
  const std::string text = convergence_complaint(run);
  EXPECT_NE(text.find("R-hat of a is 1.2"), std::string::npos);
  EXPECT_NE(text.find("thenar fit H01 --draws 1000"), std::string::npos) << text;
  run.convergence.warnings.clear();
  EXPECT_EQ(convergence_complaint(run), "");
}

TEST(PosteriorAnswer, IsRefusedWhereChainsDisagree) {
  PosteriorResult result = small_result();
  result.run.convergence.warnings = {"R-hat of a is 1.2, above 1.01"};
  EXPECT_EQ(refusal_of(result),
            "the chains have NOT converged; do not use these draws:\n"
            "  * R-hat of a is 1.2, above 1.01");
  result.outcome.status = Status::kStopped;
  EXPECT_EQ(refusal_of(result), "");
  result.outcome.status = Status::kSolved;
  result.run.convergence.warnings.clear();
  EXPECT_EQ(refusal_of(result), "");
}

TEST(ConvergenceCautions, AreOfConvergedRunsAlone) {
  PosteriorRun run = sample::sampled();
  run.convergence.warnings.clear();
  run.convergence.cautions = {"2 of 1000 draws ended a divergent trajectory"};
  EXPECT_EQ(convergence_cautions(run).size(), 1U);
  run.convergence.warnings = {"R-hat of a is 1.2"};
  EXPECT_TRUE(convergence_cautions(run).empty());
}

TEST(PosteriorAnswer, SaysFirstThatTheChainsAgree) {
  PosteriorResult result = small_result();
  result.run.draws.complete = true;
  result.run.convergence.warnings.clear();
  result.run.convergence.cautions.clear();
  EXPECT_EQ(text_of(result).rfind("converged: the chains agree\n", 0), 0U);
  result.run.convergence.cautions = {"2 draws"};
  EXPECT_EQ(text_of(result).find("the chains agree"), std::string::npos);
}

}  // namespace
}  // namespace thenar
