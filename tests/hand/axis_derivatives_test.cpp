// Derivatives by the axes of a chain: closed forms, differences and Jets agree.

#include "tests/hand/axis_derivatives.h"

#include <type_traits>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Jet = ceres::Jet<double, 5>;

constexpr double kRounding = 1e-14;  // of derivatives up to 2, through a chain of five products

// A question that outlived its tree would read freed memory.
template <typename Links, typename State>
constexpr bool kAsks = std::is_constructible_v<AxisQuestion, Links, State, Eigen::VectorXd, int>;
static_assert(kAsks<const Tree<double>&, const TreeState<double>&>);
static_assert(!kAsks<Tree<double>, const TreeState<double>&>);
static_assert(!kAsks<const Tree<double>&, TreeState<double>>);
static_assert(!kAsks<Tree<double>, TreeState<double>>);

struct PosedAxes {
  Skeleton skeleton;
  Eigen::VectorXd q;
  TreeState<double> state;
  int link;
  Eigen::Vector3d p;  // reference posture
  Eigen::Vector3d x;  // now
};

PosedAxes posed_digit(const Subject& subject, unsigned seed) {
  sample::Draw draw(seed);
  PosedAxes s{build_skeleton(subject), {}, {}, 0, {}, {}};
  s.q = draw.posture(s.skeleton);
  s.state = pose_tree(s.skeleton.tree, s.q);
  s.link = s.skeleton.tips[0].link;
  s.p = s.skeleton.tips[0].p;
  s.x = moved(s.state, s.link, s.p);
  return s;
}

/// The tree on jets, differentiated by the axis of one hinge.
Tree<Jet> jet_tree(const Tree<double>& tree, int variable) {
  Tree<Jet> jets;
  for (int i = 0; i < static_cast<int>(tree.size()); ++i) {
    const Hinge<double>& h = tree[i];
    jets.push_back(
        {h.parent, h.coordinate, h.ratio, h.offset, h.direction.cast<Jet>(), h.point.cast<Jet>()});
    if (i != variable) continue;
    const Tangents t = tangents(h.direction);
    for (int k = 0; k < 3; ++k) {
      jets[i].direction[k].v[0] = t.e1[k];
      jets[i].direction[k].v[1] = t.e2[k];
      jets[i].point[k].v[2 + k] = 1;
    }
  }
  return jets;
}

ByAxis derivative(const Vec3<Jet>& x) {
  ByAxis D;
  for (int k = 0; k < 3; ++k) D.row(k) = x[k].v;
  return D;
}

void expect_equal_to_jets(const PosedAxes& s) {
  for (int i = 0; i < static_cast<int>(s.skeleton.tree.size()); ++i) {
    const AxisQuestion question{s.skeleton.tree, s.state, s.q, i};
    const Tree<Jet> tree = jet_tree(s.skeleton.tree, i);
    const TreeState<Jet> state = pose_tree(tree, s.q);
    const Vec3<Jet> x = moved(state, s.link, Vec3<Jet>(s.p.cast<Jet>()));
    EXPECT_TRUE(matrix_near(position_by_axis(question, s.link, s.x), derivative(x), kRounding));

    const auto J = position_jacobian(tree, state, s.link, x, s.skeleton.coordinates());
    const std::vector<ByAxis> dJ = position_jacobian_by_axis(question, s.link, s.x);
    ASSERT_EQ(static_cast<int>(dJ.size()), s.skeleton.coordinates());
    for (int c = 0; c < s.skeleton.coordinates(); ++c)
      EXPECT_TRUE(matrix_near(dJ[c], derivative(J.col(c)), kRounding));

    const auto W = rotation_jacobian(tree, state, s.link, s.skeleton.coordinates());
    const std::vector<ByAxis> dW = rotation_jacobian_by_axis(question, s.link);
    ASSERT_EQ(static_cast<int>(dW.size()), s.skeleton.coordinates());
    for (int c = 0; c < s.skeleton.coordinates(); ++c)
      EXPECT_TRUE(matrix_near(dW[c], derivative(W.col(c)), kRounding));
  }
}

TEST(AxisDerivatives, EqualAutomaticOnes) {
  for (unsigned seed = 1; seed <= 3; ++seed)
    expect_equal_to_jets(posed_digit(sample::random_hand(seed), seed));
}

TEST(AxisDerivatives, EqualAutomaticOnesOfACoupledDigit) {
  expect_equal_to_jets(posed_digit(sample::coupled_digit(), 4));
}

/// The tree with one axis moved by the five parameters, its direction kept on the sphere.
Tree<double> moved_axis(Tree<double> tree, int i, const Eigen::Matrix<double, 5, 1>& by) {
  const Tangents t = tangents(tree[i].direction);
  tree[i].direction = (tree[i].direction + by[0] * t.e1 + by[1] * t.e2).normalized();
  tree[i].point += by.tail<3>();
  return tree;
}

TEST(AxisDerivatives, EqualFiniteDifferences) {
  const PosedAxes s = posed_digit(sample::random_hand(5), 6);
  const double h = 1e-6;  // [rad] or [m]
  for (const int i : {0, 1, 3, 5}) {
    const ByAxis D = position_by_axis({s.skeleton.tree, s.state, s.q, i}, s.link, s.x);
    for (int k = 0; k < 5; ++k) {
      const Eigen::Matrix<double, 5, 1> step = h * Eigen::Matrix<double, 5, 1>::Unit(k);
      const auto at = [&](const Eigen::Matrix<double, 5, 1>& by) {
        return moved(pose_tree(moved_axis(s.skeleton.tree, i, by), s.q), s.link, s.p);
      };
      EXPECT_TRUE(matrix_near(D.col(k), (at(step) - at(-step)) / (2 * h), 1e-9));
    }
  }
}

TEST(AxisDerivatives, OfRotationEqualFiniteDifferences) {
  const PosedAxes s = posed_digit(sample::random_hand(5), 6);
  const double h = 1e-6;  // [rad] or [m]
  const int n = s.skeleton.coordinates();
  for (const int i : {0, 1, 3, 5}) {
    const auto D = rotation_jacobian_by_axis({s.skeleton.tree, s.state, s.q, i}, s.link);
    for (int k = 0; k < 5; ++k) {
      const Eigen::Matrix<double, 5, 1> step = h * Eigen::Matrix<double, 5, 1>::Unit(k);
      const auto at = [&](const Eigen::Matrix<double, 5, 1>& by) {
        const Tree<double> tree = moved_axis(s.skeleton.tree, i, by);
        return rotation_jacobian(tree, pose_tree(tree, s.q), s.link, n);
      };
      const Eigen::Matrix3Xd difference = (at(step) - at(-step)) / (2 * h);
      for (int c = 0; c < n; ++c) EXPECT_TRUE(matrix_near(D[c].col(k), difference.col(c), 1e-9));
    }
  }
}

TEST(AxisDerivatives, VanishAlongTheAxis) {
  const PosedAxes s = posed_digit(sample::random_hand(7), 8);
  for (const int i : {0, 2, 4}) {
    const ByAxis D = position_by_axis({s.skeleton.tree, s.state, s.q, i}, s.link, s.x);
    EXPECT_TRUE(matrix_near(D.rightCols<3>() * s.skeleton.tree[i].direction,
                            Eigen::Vector3d::Zero(), 1e-15));
  }
}

TEST(AxisDerivatives, AreZeroForOtherDigits) {
  const PosedAxes s = posed_digit(sample::random_hand(9), 10);
  const int other = s.skeleton.tips[1].link;
  EXPECT_TRUE(position_by_axis({s.skeleton.tree, s.state, s.q, other}, s.link, s.x).isZero(0));
  for (const ByAxis& D :
       position_jacobian_by_axis({s.skeleton.tree, s.state, s.q, other}, s.link, s.x))
    EXPECT_TRUE(D.isZero(0));
}

}  // namespace
}  // namespace thenar
