// Tests for api/tendon_solve.cpp.

#include "api/tendon_solve.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TendonRequest bent_finger(Hood hood) {
  TendonRequest request;
  request.digit.subject = kData + "/subjects/synek2019_middle.toml";
  request.digit.hood = hood;
  request.digit.posture.named = {{"MCP3_FE", 0.3}, {"PIP3", 0.5}, {"DIP3", 0.2}};
  request.tension = {{"EDC", 2.9}, {"LU", 0.4}};
  return request;
}

// Virtual work: the torque of the tendons is that of the tip's force and what is left of it.
TEST(SolveTendons, BalancesTorques) {
  const TendonSolveResult solution = solve_tendons(bent_finger(Hood::kSeparate));
  const TipStatics statics = tip_statics(solution.loaded.bones(), solution.point.q);
  EXPECT_TRUE(
      matrix_near(statics.J.transpose() * solution.point.tip.f_W + solution.point.tip.tau_residual,
                  solution.point.pull.tau, 1e-12));
}

TEST(SolveTendons, TurnsTheForceIntoTheTipsAxes) {
  const TendonSolveResult solution = solve_tendons(bent_finger(Hood::kFractions));
  EXPECT_NEAR(force_in_tip_axes(solution.loaded, solution.point).norm(),
              solution.point.tip.f_W.norm(), 1e-12);
}

TEST(SolveTendons, RefusesSeveralPostures) {
  TendonRequest request = bent_finger(Hood::kSeparate);
  request.digit.vary = {{"PIP3", 0, 0.5, 0.1}};
  EXPECT_EQ(message_of([&] { (void)solve_tendons(request); }),
            "wanted one posture, got 1 joints that vary");
}

TEST(SolveTendons, RefusesATipMap) {
  TendonRequest request;
  request.digit.subject = kData + "/subjects/valero_cuevas_index.toml";
  EXPECT_NE(message_of([&] { (void)solve_tendons(request); }).find("has no bones, only tip map"),
            std::string::npos);
}

// At one posture there is one answer, however it is asked for.
TEST(SweepTendons, AgreesWithSolve) {
  for (const Hood hood : {Hood::kSeparate, Hood::kFractions, Hood::kFloatingNet}) {
    TendonRequest request = bent_finger(hood);
    const TendonSolveResult solution = solve_tendons(request);
    request.digit.vary = {{"PIP3", 0.5, 0.5, 1}};
    const TendonSweepResult sweep = sweep_tendons(request);
    ASSERT_EQ(sweep.points.size(), 1U);
    EXPECT_FALSE(sweep.outcome.stopped());
    EXPECT_TRUE(matrix_near(sweep.points[0].pull.tau, solution.point.pull.tau, 1e-12));
  }
}

TEST(SweepTendons, GoesRowByRowAndReportsTheWhole) {
  TendonRequest request = bent_finger(Hood::kSeparate);
  request.digit.vary = {{"MCP3_FE", 0, 0.2, 0.2}, {"PIP3", 0, 0.3, 0.1}};
  double last = 0;
  Progress progress;
  progress.report = [&](double fraction, const std::string&) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
  };
  const TendonSweepResult sweep = sweep_tendons(request, progress);
  EXPECT_EQ(sweep.loaded.grid.row, 4U);
  ASSERT_EQ(sweep.points.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(sweep.points[i].q, sweep.loaded.grid.postures[i]);
}

TEST(SweepTendons, StopsWithThePosturesThatAreDone) {
  TendonRequest request = bent_finger(Hood::kSeparate);
  request.digit.vary = {{"MCP3_FE", 0, 0.2, 0.2}, {"PIP3", 0, 0.3, 0.1}};
  Progress progress;
  progress.stop_requested = [] { return true; };
  const TendonSweepResult sweep = sweep_tendons(request, progress);
  EXPECT_TRUE(sweep.outcome.stopped());
  EXPECT_LT(sweep.points.size(), 8U);
}

}  // namespace
}  // namespace thenar
