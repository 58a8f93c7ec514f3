// Largest forces of all subjects against every vertex, and against each other as cones widen:
// solvers/linear_program.cpp, feasible_force.cpp, feasible_set.cpp.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/tendon_model.h"
#include "tests/tendons/vertex_oracle.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Postures a digit: few by default, all under the label long.
int postures(int few) {
  const char* asked = std::getenv("THENAR_POSTURES");
  return asked == nullptr ? few : std::atoi(asked);
}

/// Tendons alone: without passive moments no force at all is feasible, too.
TendonDigit digit_of(const std::string& subject, const std::string& digit) {
  const Subject read = read_subject(std::string(THENAR_DATA_DIR "/subjects/") + subject);
  return build_tendon_digit(with_passive(read, PassiveMoments::kOff), digit);
}

VectorXd draw_posture(const TendonDigit& digit, std::mt19937& rng) {
  VectorXd q(digit.model.coordinates);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const CoordinateLimits& limits = digit.skeleton.limits[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution<double>(limits.lower, limits.upper)(rng);
  }
  return q;
}

Vector3d axis(int k) { return (k % 2 == 0 ? 1 : -1) * Vector3d::Unit(k / 2); }

struct Named {
  const char *subject, *digit;
};

class EverySubject : public testing::TestWithParam<Named> {};

TEST_P(EverySubject, LargestForcesAreThoseOfEveryVertex) {
  const TendonDigit digit = digit_of(GetParam().subject, GetParam().digit);
  std::mt19937 rng(11);
  for (int i = 0; i < postures(4); ++i) {
    const TipStatics statics = tip_statics(digit, draw_posture(digit, rng));
    const VertexOracle oracle(statics);
    for (int k = 0; k < 6; ++k) {
      const MaxTipForce largest = max_tip_force(statics, axis(k));
      const double certain = oracle.along(axis(k));
      ASSERT_EQ(largest.status, Status::kSolved) << "posture " << i << " axis " << k;
      ASSERT_NEAR(largest.component, certain, 1e-9 * std::max(1.0, certain))
          << "posture " << i << " axis " << k;
      ASSERT_LE(largest.check.gap, 1e-9 * std::max(1.0, certain));
      ASSERT_LE(largest.check.imbalance, 1e-12);
    }
  }
}

// All subjects whose every muscle has a largest force.
INSTANTIATE_TEST_SUITE_P(
    Digits, EverySubject,
    testing::Values(Named{"an_chao_index.toml", "index"}, Named{"an_chao_middle.toml", "middle"},
                    Named{"arms_five_axis_thumb.toml", "thumb"}, Named{"arms_thumb.toml", "thumb"},
                    Named{"graspit_orthogonal_thumb.toml", "thumb"},
                    Named{"graspit_skewed_thumb.toml", "thumb"},
                    Named{"mechanical_five_axis_thumb.toml", "thumb"},
                    Named{"mirakhorlo2016.toml", "thumb"}, Named{"mirakhorlo2016.toml", "index"},
                    Named{"mirakhorlo2016.toml", "middle"}, Named{"myohand_thumb.toml", "thumb"},
                    Named{"synek2019_middle.toml", "middle"}));

class Fingers : public testing::TestWithParam<Named> {};

TEST_P(Fingers, ForcesNeverFallAsTheConeWidens) {
  const TendonDigit digit = digit_of(GetParam().subject, GetParam().digit);
  std::mt19937 rng(12);
  for (int i = 0; i < postures(4); ++i) {
    const TipStatics statics = tip_statics(digit, draw_posture(digit, rng));
    for (int k = 0; k < 6; ++k) {
      double narrower = 0;
      for (const double degrees : {0, 1, 2, 5, 8, 10, 20, 30, 40}) {
        const MaxTipForce largest = max_tip_force(statics, axis(k), {radians(degrees)});
        ASSERT_EQ(largest.status, Status::kSolved);
        ASSERT_GE(largest.component, (1 - 1e-9) * narrower - 1e-9)
            << "posture " << i << " axis " << k << " cone " << degrees;
        narrower = largest.component;
      }
    }
  }
}

TEST_P(Fingers, SetsReachAsFarAsEveryVertex) {
  const TendonDigit digit = digit_of(GetParam().subject, GetParam().digit);
  std::mt19937 rng(13);
  std::normal_distribution<double> normal;
  for (int i = 0; i < postures(6); ++i) {
    const TipStatics statics = tip_statics(digit, draw_posture(digit, rng));
    const VertexOracle oracle(statics);
    const FeasibleForceSet set = feasible_force_set(statics);
    ASSERT_EQ(set.status, Status::kSolved) << set.message;
    for (int k = 0; k < 12; ++k) {
      const Vector3d u = k < 6 ? axis(k) : Vector3d(normal(rng), normal(rng), normal(rng));
      const double certain = oracle.support(u.normalized());
      const double reached = (set.vertices * u.normalized()).maxCoeff();
      ASSERT_NEAR(reached, certain, 1e-9 * std::max(1.0, std::abs(certain))) << "posture " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Digits, Fingers,
                         testing::Values(Named{"an_chao_index.toml", "index"},
                                         Named{"an_chao_middle.toml", "middle"},
                                         Named{"synek2019_middle.toml", "middle"}));

struct Wrong {
  double degrees;  // half angle of the cone
  double certain;  // largest force, by an independent simplex method and its own cuts [N]
};

// Postures at which a vertex was taken for optimal whose reduced costs had the wrong sign.
TEST(CertainForce, PalmarForceOfABentIndexFingerInACone) {
  const TendonDigit digit = digit_of("an_chao_index.toml", "index");
  VectorXd q = VectorXd::Zero(digit.model.coordinates);
  const auto set = [&](const char* name, double degrees) {
    const auto& names = digit.names.coordinates;
    q[std::find(names.begin(), names.end(), name) - names.begin()] = radians(degrees);
  };
  set("MCP2_FE", 45);
  set("PIP2", 45);
  set("DIP2", 10);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const Eigen::Matrix3d axes =
      state[static_cast<std::size_t>(digit.model.tip_link)].X.R * digit.model.tip_axes;
  const TipStatics statics = tip_statics(digit, q);
  for (const Wrong& w : {Wrong{0, 30.396}, Wrong{1, 30.47}, Wrong{5, 30.77}, Wrong{10, 31.15},
                         Wrong{20, 31.26}, Wrong{40, 31.26}})
    EXPECT_NEAR(max_tip_force(statics, -axes.col(1), {radians(w.degrees)}).component, w.certain,
                0.006)
        << w.degrees;
}

}  // namespace
}  // namespace thenar
