// Tests for kinematics_fit/axis_pivots.cpp: which point of an axis a subject states is no matter.

#include "kinematics_fit/axis_pivots.h"

#include <gtest/gtest.h>

#include "tendons/linear_tendons.h"
#include "tests/data_folder.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Subject read(const std::string& name) {
  return read_subject(std::string(kData) + "/subjects/" + name + ".toml");
}

/// The subject with points of its axes moved along them [m].
Subject slid(Subject subject, double way) {
  for (JointAxis& joint : subject.joints) joint.point += way * joint.direction;
  return subject;
}

// From 30, 60 or -45 mm away, all points come to the middle of the tendons, where arms are the
// same.
TEST(AxisPivots, AreTheSameWhicheverPointIsStated) {
  const Subject hand = read("mirakhorlo2016");
  const Subject near = with_points_at_tendons(slid(hand, 0.03), "middle");
  for (const double way : {0.06, -0.045}) {
    const Subject other = with_points_at_tendons(slid(hand, way), "middle");
    for (std::size_t i = 0; i < hand.joints.size(); ++i)
      EXPECT_TRUE(matrix_near(other.joints[i].point, near.joints[i].point, 1e-12))
          << hand.joints[i].name;
  }
  const VectorXd q = VectorXd::Constant(4, 0.3), t = VectorXd::Zero(0);
  const auto arms = [&](const Subject& subject) {
    const auto tendons = build_linear_tendons(subject, "middle");
    const auto muscles = static_cast<Eigen::Index>(tendons->digit().names.muscles.size());
    return tendons->evaluate(q, VectorXd::Zero(muscles), {}).R;
  };
  EXPECT_TRUE(matrix_near(arms(near), arms(hand), 1e-12));
}

// A straight tendon from (0, 3, 8) to (0, 3, -8) mm of an axis along x crosses it at x = 0; one
// from (4, 3, 8) to (8, 3, -8) at 6: their middle is 3.
TEST(AxisPivots, LieInTheMiddleOfTheTendons) {
  Subject subject;
  JointAxis joint;
  joint.name = "J", joint.parent = "A", joint.child = "B";
  joint.direction = {1, 0, 0};
  joint.point = {0.05, 0, 0};
  subject.joints = {joint};
  const auto point = [](const std::string& segment, double x, double z) {
    PathPoint out;
    out.segment = segment, out.p = {x, 0.003, z};
    return out;
  };
  subject.strands = {{"S", {point("B", 0, 0.008), point("A", 0, -0.008)}, {}},
                     {"T", {point("B", 0.004, 0.008), point("A", 0.008, -0.008)}, {}}};
  EXPECT_TRUE(matrix_near(with_points_at_tendons(subject, "").joints[0].point,
                          Vector3d(0.003, 0, 0), 1e-15));
  // Within a finger's radius the stated point holds, and so it does of a joint of no digit that no
  // path crosses.
  subject.joints[0].point.x() = 0.012;
  EXPECT_EQ(with_points_at_tendons(subject, "").joints[0].point.x(), 0.012);
  subject.strands.clear();
  subject.joints[0].point.x() = 0.05;
  EXPECT_EQ(with_points_at_tendons(subject, "").joints[0].point.x(), 0.05);
}

// Moment arms of constants leave no tendons: axes that are not parallel have the place where they
// pass each other, here the origin and (0, 40, 0) mm; one that is parallel to its neighbour lies
// opposite the tip.
TEST(AxisPivots, LieAtTheNextAxesWithoutPaths) {
  Subject subject;
  const auto joint = [](const std::string& name, const std::string& parent,
                        const std::string& child, const Vector3d& direction,
                        const Vector3d& point) {
    JointAxis out;
    out.name = name, out.parent = parent, out.child = child;
    out.direction = direction, out.point = point;
    return out;
  };
  subject.joints = {joint("FE", "A", "B", {1, 0, 0}, {-0.06, 0, 0}),
                    joint("AA", "B", "C", {0, 0, 1}, {0, 0, 0.05}),
                    joint("PIP", "C", "D", {1, 0, 0}, {0.03, 0.04, 0}),
                    joint("DIP", "D", "E", {1, 0, 0}, {0.03, 0.06, 0})};
  Digit digit;
  digit.name = "index", digit.tip_segment = "E", digit.tip = {0.002, 0.08, 0};
  subject.digits = {digit};
  subject.strands = {{"S", {}, {{"FE", 0.01}, {"PIP", 0.008}}}};
  const Subject moved = with_points_at_tendons(subject, "index");
  EXPECT_TRUE(matrix_near(moved.joints[0].point, Vector3d(0, 0, 0), 1e-15));
  EXPECT_TRUE(matrix_near(moved.joints[1].point, Vector3d(0, 0, 0), 1e-15));
  EXPECT_TRUE(matrix_near(moved.joints[2].point, Vector3d(0, 0.04, 0), 1e-15));
  EXPECT_TRUE(matrix_near(moved.joints[3].point, Vector3d(0.002, 0.06, 0), 1e-15));
}

// Thumbs that state constant arms, with points 30, 60 and -60 mm along their axes.
TEST(AxisPivots, AreTheSameWithoutPaths) {
  for (const std::string name : {"arms_thumb", "arms_five_axis_thumb"}) {
    const Subject near = with_points_at_tendons(slid(read(name), 0.03), "thumb");
    for (const double way : {0.06, -0.06}) {
      const Subject other = with_points_at_tendons(slid(read(name), way), "thumb");
      for (std::size_t i = 0; i < near.joints.size(); ++i)
        EXPECT_TRUE(matrix_near(other.joints[i].point, near.joints[i].point, 1e-12))
            << name << " " << near.joints[i].name;
    }
    // The shipped points are those of joints already.
    const Subject kept = with_points_at_tendons(read(name), "thumb");
    for (std::size_t i = 0; i < near.joints.size(); ++i)
      EXPECT_EQ(kept.joints[i].point, read(name).joints[i].point);
  }
}

// Of points 30 and 60 mm along z, the direction of the flexion axes, the whole fit is one.
TEST(AxisPivots, MakeFitsOfAnyPointsTheSame) {
  const auto fitted = [](const std::string& z) {
    FitInputs inputs = sample::finger_inputs("an_chao_middle", {"H01"});
    std::string& text = inputs.subject.text;
    for (const std::string point : {"94.8694, 0, ", "47.8457, 0, ", "19.0171, 0, "}) {
      const std::size_t at = text.find("point_mm = [" + point);
      text.replace(at, text.find(']', at) - at, "point_mm = [" + point + z);
    }
    return run_fit(inputs).solution.z;
  };
  const VectorXd near = fitted("30"), far = fitted("60");
  EXPECT_LT((near - far).norm(), 1e-6 * near.norm());
}

}  // namespace
}  // namespace thenar
