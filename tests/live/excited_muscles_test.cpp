// Tests for live/excited_muscles.cpp: tensions of muscles in steady state.

#include "live/excited_muscles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "api/named/digits.h"
#include "base/error.h"
#include "tendons/muscle/hill_curves.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

constexpr double kNoExcitation = std::numeric_limits<double>::quiet_NaN();

/// A digit of a subject and its muscles.
struct ExcitedDigit {
  DigitCase digit;
  ExcitedMuscles muscles;
  Eigen::Index count;

  explicit ExcitedDigit(const std::string& subject)
      : digit(case_of(subject)),
        muscles(digit.subject, digit.tendons),
        count(static_cast<Eigen::Index>(digit.bones().names.muscles.size())) {}

  static DigitCase case_of(const std::string& subject) {
    DigitRequest request;
    request.subject = kData + "/subjects/" + subject + ".toml";
    return build_digit(request, Hood::kFractions);
  }
  [[nodiscard]] VectorXd all(double value) const { return VectorXd::Constant(count, value); }
  [[nodiscard]] VectorXd posture(double angle) const {
    return VectorXd::Constant(digit.bones().model.coordinates, angle);
  }
};

// Without fibre lengths a muscle pulls excitation times its largest force, at any length; that is
// told. Those without excitation keep their tensions.
TEST(ExcitedMuscles, PullAShareOfTheirForceWithoutFibres) {
  const ExcitedDigit middle("synek2019_middle");
  const VectorXd t = middle.all(3);
  VectorXd excitation = middle.all(kNoExcitation);
  EXPECT_EQ(middle.muscles.tensions(excitation, t, middle.posture(0.2)), t);
  EXPECT_TRUE(middle.muscles.warnings(excitation).empty());
  Eigen::Index known = 0;
  while (!std::isfinite(middle.digit.bones().max_tension[known])) ASSERT_LT(++known, middle.count);
  excitation[known] = 0.25;
  for (const double angle : {0.0, 0.4}) {
    VectorXd wanted = t;
    wanted[known] = 0.25 * middle.digit.bones().max_tension[known];
    EXPECT_TRUE(
        matrix_near(middle.muscles.tensions(excitation, t, middle.posture(angle)), wanted, 1e-12));
  }
  ASSERT_EQ(middle.muscles.warnings(excitation).size(), 1U);
}

// With all joints at 0 every fibre has its optimal length: what excitation adds is F0
// cos(pennation) times the force that its fibres have there.
TEST(ExcitedMuscles, AreAtTheirOptimumWithJointsAtZero) {
  const ExcitedDigit index("an_chao_index");
  const VectorXd q = index.posture(0), none = index.all(0);
  EXPECT_EQ(index.muscles.lengthening(q), none);
  const VectorXd rest = index.muscles.tensions(none, none, q),
                 half = index.muscles.tensions(index.all(0.5), none, q);
  for (Eigen::Index m = 0; m < index.count; ++m) {
    const std::string& name = index.digit.bones().names.muscles[static_cast<std::size_t>(m)];
    const auto unit =
        std::find_if(index.digit.subject.muscles.begin(), index.digit.subject.muscles.end(),
                     [&](const MuscleUnit& each) { return each.name == name; });
    ASSERT_NE(unit, index.digit.subject.muscles.end());
    const double F0 = index.digit.bones().max_tension[m];
    EXPECT_NEAR(half[m] - rest[m], 0.5 * F0 * active_force(1) * std::cos(unit->pennation),
                1e-9 * F0)
        << name;
  }
}

// Lengthening is the integral of arms: dL = -R dq at a bent posture.
TEST(ExcitedMuscles, LengthensAsArmsSay) {
  const ExcitedDigit middle("synek2019_middle");
  const VectorXd q = middle.posture(0.3);
  const TendonTorque pull = middle.digit.tendons->evaluate(q, middle.all(0));
  const double step = 1e-6;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const VectorXd way = step * VectorXd::Unit(q.size(), j);
    const VectorXd slope =
        (middle.muscles.lengthening(q + way) - middle.muscles.lengthening(q - way)) / (2 * step);
    EXPECT_TRUE(matrix_near(slope, -pull.R.col(j), 1e-9)) << j;
  }
}

TEST(ExcitedMuscles, RefuseExcitationsOutOfRange) {
  const ExcitedDigit middle("synek2019_middle");
  VectorXd excitation = middle.all(kNoExcitation);
  excitation[0] = 1.5;
  EXPECT_EQ(message_of([&] {
              (void)middle.muscles.tensions(excitation, middle.all(0), middle.posture(0));
            }),
            "wanted an excitation of '" + middle.digit.bones().names.muscles[0] +
                "' from 0 to 1, got 1.5");
}

}  // namespace
}  // namespace thenar
