// Tests for tendons/forces/posture_sensitivity.cpp.

#include "tendons/forces/posture_sensitivity.h"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "hand/tip_manipulability.h"
#include "tendons/forces/max_tip_load.h"
#include "tendons/forces/tip_force.h"
#include "tendons/linear_tendons.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::unique_ptr<DigitTendons> finger(const std::string& subject = "an_chao_index",
                                     Path path = Path::kViaPoint,
                                     PassiveMoments passive = PassiveMoments::kOff) {
  TendonOptions options;
  options.path = path;
  const Subject read = read_subject(std::string(THENAR_DATA_DIR "/subjects/") + subject + ".toml");
  return build_linear_tendons(with_passive(read, passive), "index", options);
}

/// MCP flexion and abduction, PIP, DIP.
VectorXd bent(const TendonDigit& digit, double pip, double dip) {
  VectorXd q = VectorXd::Zero(digit.model.coordinates);
  for (std::size_t i = 0; i < digit.names.coordinates.size(); ++i) {
    const std::string& name = digit.names.coordinates[i];
    const auto k = static_cast<Eigen::Index>(i);
    if (name == "MCP2_FE") q[k] = radians(30);
    if (name == "PIP2") q[k] = radians(pip);
    if (name == "DIP2") q[k] = radians(dip);
  }
  return q;
}

VectorXd pulls(const TendonDigit& digit) {
  return VectorXd::LinSpaced(static_cast<Eigen::Index>(digit.names.muscles.size()), 1, 9);  // [N]
}

/// Derivative of any answer by differences of the answer itself.
template <typename Answer>
MatrixXd differences(const VectorXd& q, double step, const Answer& answer) {
  MatrixXd result(answer(q).size(), q.size());
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const auto at = [&](double by) -> VectorXd {
      return answer(q + by * step * VectorXd::Unit(q.size(), k));
    };
    result.col(k) = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
  }
  return result;
}

// On every rung of paths: arms that wrap or are fitted change otherwise than via points' do.
// Passive moments change, too.
TEST(PostureSlopes, PinnedForceAgreesWithDifferences) {
  for (const Path path : {Path::kViaPoint, Path::kFitted, Path::kWrapped}) {
    const auto tendons = finger("mirakhorlo2016", path, PassiveMoments::kOn);
    const VectorXd q = bent(tendons->digit(), 40, 20), t = pulls(tendons->digit());
    const MatrixXd slopes =
        tip_force_jacobian(tip_statics(*tendons, q), statics_derivatives(*tendons, q), t);
    const MatrixXd wanted = differences(
        q, 1e-3, [&](const VectorXd& at) { return tip_force(tip_statics(*tendons, at), t).f_W; });
    EXPECT_TRUE(matrix_near(slopes, wanted, 1e-7 * wanted.norm())) << static_cast<int>(path);
  }
}

TEST(PostureSlopes, HeldWrenchAgreesWithDifferences) {
  const auto tendons = finger();
  const TendonDigit& digit = tendons->digit();
  const VectorXd q = bent(digit, 40, 20), t = pulls(digit);
  const MatrixXd slopes =
      tip_wrench_jacobian(tip_statics(*tendons, q), statics_derivatives(*tendons, q), t);
  const MatrixXd wanted = differences(q, 1e-3, [&](const VectorXd& at) {
    const TipWrench wrench = tip_wrench(tip_statics(*tendons, at), t);
    return (VectorXd(6) << wrench.m_W, wrench.f_W).finished();
  });
  EXPECT_TRUE(matrix_near(slopes, wanted, 1e-8 * wanted.norm()));
}

TEST(PostureSlopes, LargestForceAgreesWithDifferences) {
  const auto tendons = finger();
  const TendonDigit& digit = tendons->digit();
  const VectorXd q = bent(digit, 40, 20);
  const auto direction = [&](DirectionFrame frame, const VectorXd& at) -> Vector3d {
    if (frame == DirectionFrame::kWorld) return {0.2, 1, 0.1};
    const TreeState<double> state = pose_tree(digit.model.tree, at);
    const auto& X = state[static_cast<std::size_t>(digit.model.tip_link)].X;
    return -(X.R * digit.model.tip_axes).col(1);
  };
  for (const DirectionFrame frame : {DirectionFrame::kWorld, DirectionFrame::kTip})
    for (const double cone : {0.0, radians(10)}) {
      const auto largest = [&](const VectorXd& at) {
        return max_tip_force(tip_statics(*tendons, at), direction(frame, at), {cone});
      };
      const MaxTipForce now = largest(q);
      ASSERT_EQ(now.status, Status::kSolved);
      ASSERT_GT(now.component, 1);
      const VectorXd slopes =
          max_tip_load_gradient(tip_statics(*tendons, q), statics_derivatives(*tendons, q),
                                {now, Vector3d::Zero()}, TipLoad::kForce, frame);
      const MatrixXd wanted = differences(q, 2e-4, [&](const VectorXd& at) {
        return VectorXd(VectorXd::Constant(1, largest(at).component));
      });
      EXPECT_TRUE(matrix_near(slopes.transpose(), wanted, 1e-5 * wanted.norm())) << cone;
    }
}

// Near straight the force grows as 1 / angle, so a degree changes it by about force / angle.
TEST(PostureSlopes, NearlyStraightFingerHangsOnItsAngles) {
  const auto tendons = finger();
  const TendonDigit& digit = tendons->digit();
  const VectorXd q = bent(digit, 0.1, 0.1);
  const TipStatics statics = tip_statics(*tendons, q);
  VectorXd t = VectorXd::Zero(statics.R.rows());
  t[0] = 10;
  EXPECT_GT(tip_manipulability(statics.J).condition, kNearlyStraight);
  const Eigen::Matrix3Xd slopes = tip_force_jacobian(statics, statics_derivatives(*tendons, q), t);
  const double force = tip_force(statics, t).f_W.norm();
  EXPECT_GT(force, 50);                                            // [N] from 10 N
  EXPECT_GT(slopes.colwise().norm().maxCoeff() * kDegree, force);  // [N/deg]
}

TEST(PostureSlopes, AreInfiniteInAStraightFinger) {
  const auto tendons = finger();
  const TendonDigit& digit = tendons->digit();
  const VectorXd q = bent(digit, 0, 0);
  const TipStatics statics = tip_statics(*tendons, q);
  ASSERT_LT(tip_manipulability(statics.J).rank, 3);
  EXPECT_TRUE(std::isinf(
      tip_force_jacobian(statics, statics_derivatives(*tendons, q), pulls(digit)).maxCoeff()));
}

}  // namespace
}  // namespace thenar
