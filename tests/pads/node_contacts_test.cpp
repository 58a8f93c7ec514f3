// Tests for pads/node_contacts.cpp: laws of nodes under a plane, by hand, and their slopes.

#include "pads/node_contacts.h"

#include <random>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFriction = 0.4;
constexpr double kNodeStiffness = 2;  // of contacts [N/m]

/// A block of tissue under a wide plate, whose lower face is at z = 0 as the block's upper one.
class PlateOnBlock {
 public:
  PlateOnBlock()
      : block_(graded_box(even_axis(-1, 1, 2), even_axis(-1, 1, 2), even_axis(-1, 0, 2)),
               {neo_hookean(1, 0.4)}),
        object_{build_box({20, 20, 2}), kFriction} {
    goal_.X_PO.p = {0, 0, 1};
    state_ = block_.at_rest(goal_.X_PO);
    factors_.emplace(*block_.body);
    at_.emplace(PressProblem{*block_.body, block_.surface, object_, goal_, options_, state_},
                *factors_);
    at_->node_stiffness.assign(at_->contacts.size(), kNodeStiffness);
  }
  PressIterate& at() { return *at_; }

 private:
  TissueBlock block_;
  RigidObject object_;
  PressGoal goal_;
  PressOptions options_;
  PressState state_;
  std::optional<PressFactors> factors_;
  std::optional<PressIterate> at_;
};

/// Forces on all nodes.
Matrix3Xd forces_of(PressIterate& at) {
  update_contacts(at);
  Matrix3Xd out = normal_forces(at);
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    out.col(static_cast<Eigen::Index>(k)) += at.contacts[k].friction_force;
  return out;
}

TEST(NodeContacts, AreOpenOrStickOrSlip) {
  PlateOnBlock sample;
  PressIterate& at = sample.at();
  const auto move = [&](std::size_t k, const Vector3d& by) {
    at.state.x.segment<3>(3 * at.surface.nodes[k]) = by;
  };
  move(0, {0, 0, -0.1});    // away from the plate
  move(1, {0, 0.02, 0.1});  // in by 0.1, aside by less than friction bears
  move(2, {0.05, 0, 0.1});  // and by more
  update_contacts(at);
  const std::vector<ContactState> states = contact_states(at);
  EXPECT_EQ(states[0], ContactState::kOpen);
  EXPECT_EQ(states[1], ContactState::kSticks);
  EXPECT_EQ(states[2], ContactState::kSlips);
  EXPECT_TRUE(has_sliding_nodes(at));
  EXPECT_NEAR(at.contacts[1].normal_force, 0.1 * kNodeStiffness, 1e-12);
  EXPECT_NEAR((at.contacts[1].friction_force - Vector3d(0, -0.02 * kNodeStiffness, 0)).norm(), 0,
              1e-12);
  EXPECT_NEAR(
      (at.contacts[2].friction_force - Vector3d(-0.1 * kNodeStiffness * kFriction, 0, 0)).norm(), 0,
      1e-12);
}

// The last forces and no gap or slip: an answer.
TEST(NodeContacts, KeepTheForcesOfAnAnswer) {
  PlateOnBlock sample;
  PressIterate& at = sample.at();
  at.state.normal_force.setConstant(0.3);
  at.state.friction_force.row(0).setConstant(0.1);
  update_contacts(at);
  for (const SkinNodeContact& c : at.contacts) {
    EXPECT_NEAR(c.normal_force, 0.3, 1e-14);
    EXPECT_NEAR((c.friction_force - Vector3d(0.1, 0, 0)).norm(), 0, 1e-14);
    EXPECT_FALSE(c.slips);
  }
}

// Where last friction has the way of this one, as at an answer, the loss is the slope.
TEST(NodeContacts, LoseForcesByTheirSlope) {
  PlateOnBlock sample;
  PressIterate& at = sample.at();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    at.state.x.segment<3>(3 * at.surface.nodes[k]) =
        Vector3d(0.1 * unit(random), 0.1 * unit(random), 0.1 * (1.5 + unit(random)));
  update_contacts(at);
  // Last friction along this one's way, as large as its bound.
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    at.contacts[k].last_friction_ratio = at.contacts[k].slip_direction;
  Matrix3Xd moved(3, static_cast<Eigen::Index>(at.contacts.size()));
  for (Eigen::Index k = 0; k < moved.cols(); ++k)
    moved.col(k) = Vector3d(unit(random), unit(random), unit(random));
  const Matrix3Xd loss = contact_force_loss(at, moved);
  constexpr double kDifference = 1e-6;
  const VectorXd x = at.state.x, dx = kDifference * at.body_forces(moved);
  at.state.x = x + dx;
  const Matrix3Xd more = forces_of(at);
  at.state.x = x - dx;
  const Matrix3Xd less = forces_of(at);
  EXPECT_LT((loss + (more - less) / (2 * kDifference)).norm(), 1e-8 * loss.norm());
}

TEST(NodeContacts, HaveAnOwnSlopeThatIsSymmetricAndPositive) {
  PlateOnBlock sample;
  PressIterate& at = sample.at();
  at.state.x.setConstant(0.05);
  update_contacts(at);
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const Eigen::Matrix3d slope = own_stiffness(at, k);
    EXPECT_EQ((slope - slope.transpose()).norm(), 0);
    EXPECT_NEAR(slope(2, 2), kNodeStiffness, 1e-12);
    EXPECT_GE(slope.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), -1e-12);
  }
}

}  // namespace
}  // namespace thenar
