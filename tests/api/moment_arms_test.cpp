// Tests for api/moment_arms.cpp.

#include "api/moment_arms.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

DigitRequest request_of(const std::string& subject, const std::string& digit) {
  DigitRequest request;
  request.subject = subject;
  request.data = kData;
  request.digit = digit;
  request.posture.unit = PostureUnit::kTyped;
  return request;
}

struct Rung {
  std::string subject, digit, joint;
  Path path;
};

class ArmsOf : public testing::TestWithParam<Rung> {};

// The law r = -dl/dq, by central differences of lengths along the grid itself.
TEST_P(ArmsOf, AreSlopesOfLengths) {
  const Rung& rung = GetParam();
  DigitRequest request = request_of(rung.subject, rung.digit);
  request.path = rung.path;
  constexpr double kStep = 0.01;  // [deg]
  request.vary = {{rung.joint, 30 - kStep, 30 + kStep, kStep}};
  const MomentArmResult answer = compute_moment_arms(request);
  ASSERT_EQ(answer.points.size(), 3u);
  const int joint = answer.grid.varied.front();
  const Eigen::VectorXd slope =
      (answer.points[2].length_change - answer.points[0].length_change) / (2 * kStep * kDegree);
  // The error of a central difference is the step's square times a third derivative of mm.
  EXPECT_TRUE(matrix_near(answer.points[1].arms.col(joint), -slope, 1e-8));
}

INSTANTIATE_TEST_SUITE_P(
    Rungs, ArmsOf,
    testing::Values(Rung{"synek2019_middle", "middle", "PIP3", Path::kViaPoint},
                    Rung{"synek2019_middle", "middle", "MCP3_AA", Path::kViaPoint},
                    Rung{"an_chao_index", "index", "MCP2_FE", Path::kViaPoint},
                    Rung{"mirakhorlo2016", "index", "PIP2", Path::kWrapped},
                    Rung{"mirakhorlo2016", "index", "MCP2_FE", Path::kWrapped}));

// A tendon between two points at distances a and b from a joint, seen at an angle phi from each
// other across it, is a side of a triangle: l^2 = a^2 + b^2 - 2 a b cos(phi), and r = -dl/dq = a b
// sin(phi) / l as flexion closes phi. Here the insertion of FDP of a subject and its next point lie
// so about the DIP axis.
TEST(MomentArms, AreThoseOfABowstring) {
  DigitRequest request = request_of("synek2019_middle", "middle");
  request.posture.named = {{"MCP3_FE", 20}, {"PIP3", 35}, {"DIP3", 25}};
  const MomentArmResult answer = compute_moment_arms(request);
  const TendonDigit& digit = answer.tendons->digit();
  const MomentArmPoint& point = answer.points.front();
  const TreeState<double> state = pose_tree(digit.model.tree, point.q);
  const std::size_t last = state.size() - 1;  // DIP3
  for (std::size_t m = 0; m < digit.names.muscles.size(); ++m) {
    if (digit.names.muscles[m] != "FDP") continue;
    const auto& path = digit.model.paths[static_cast<std::size_t>(digit.model.pulls[m])];
    const auto across = [&](std::size_t k) -> Eigen::Vector3d {
      const Eigen::Vector3d from_axis = moved(state, path[k].link, path[k].p) - state[last].point;
      return from_axis;
    };
    // The first run that goes from beyond the axis to before it.
    std::size_t k = 0;
    while (path[k + 1].link == static_cast<int>(last)) ++k;
    const Eigen::Vector3d beyond = across(k), before = across(k + 1), axis = state[last].axis;
    const Eigen::Vector3d a = beyond - axis * axis.dot(beyond),
                          b = before - axis * axis.dot(before);
    const double cosine = a.dot(b) / (a.norm() * b.norm());
    const double length = (beyond - before).norm();
    const double arm = a.norm() * b.norm() * std::sqrt(1 - cosine * cosine) / length;
    EXPECT_NEAR(point.arms(static_cast<Eigen::Index>(m), 3), arm, 1e-12);
    return;
  }
  FAIL() << "no FDP";
}

// A joint has no arm for muscles that end before it.
TEST(MomentArms, AreOfJointsThatAreCrossed) {
  const MomentArmResult answer = compute_moment_arms(request_of("synek2019_middle", "middle"));
  const std::vector<std::string>& muscles = answer.muscles;
  const auto row = [&](const std::string& name) {
    return std::find(muscles.begin(), muscles.end(), name) - muscles.begin();
  };
  EXPECT_FALSE(answer.crosses(row("FDS"), 3));
  EXPECT_TRUE(answer.crosses(row("FDP"), 3));
  EXPECT_TRUE(answer.points.front().length_change.isZero(1e-15));  // at the reference itself
}

// Straight runs cut through a joint that bends far: a flexor extends it there, as no sheath lets
// it.
TEST(MomentArms, TellWhereARunHasPassedItsJoint) {
  for (const double angle : {0.0, 60.0, 86.0}) {
    DigitRequest request;
    request.subject = kData + "/subjects/an_chao_middle.toml";
    request.digit = "middle";
    request.posture.named = {{"MCP3_FE", angle * kDegree}};
    const MomentArmResult answer = compute_moment_arms(request);
    const auto flexor = static_cast<Eigen::Index>(
        std::find(answer.muscles.begin(), answer.muscles.end(), "FDS") - answer.muscles.begin());
    const bool passed = angle > 80;
    EXPECT_EQ(answer.points.front().arms(flexor, 0) < 0, passed);
    const std::string all = fmt::format("{}", fmt::join(answer.outcome.warnings, "\n"));
    EXPECT_EQ(all.find("arms of FDS at MCP3_FE") != std::string::npos, passed) << all;
  }
}

TEST(MomentArms, AreNotThoseOfANetOrAMap) {
  DigitRequest net = request_of("synek2019_middle", "middle");
  net.net = "winslow";
  EXPECT_EQ(message_of([&] { (void)compute_moment_arms(net); }),
            "moment arms of a net depend on tensions: ask tendon solve or tendon sweep");
  EXPECT_NE(message_of([] {
              (void)compute_moment_arms(request_of("valero_cuevas_index", "index"));
            }).find("no moment arms"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
