// Tests for dynamics/stepping/impulse_losses.cpp: losses  -P . (u + u+) / 2  by hand.

#include "dynamics/stepping/impulse_losses.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// A contact of two bodies, or of a joint, with its mode before the impulses.
ActiveContact contact_of(int a, int b, ContactMode mode,
                         ActiveContact::Kind kind = ActiveContact::Kind::kContact) {
  ActiveContact out;
  out.kind = kind;
  out.a = a;
  out.b = b;
  out.mode = mode;
  return out;
}

struct Booked {
  double impacts, friction;  // [J]
};
Booked booked(const std::vector<ActiveContact>& list, const std::vector<ContactBlock>& blocks,
              const Eigen::VectorXd& f, const Eigen::VectorXd& mean_u, ImpulseBooking booking) {
  EnergyFlows w = EnergyFlows::Zero();
  add_impulse_losses(list, blocks, f, mean_u, booking, w);
  return {w[kImpactLoss], w[kFrictionLoss]};
}

// 2 N s against 0.5 m/s take 1 J; 3 N s along 0.25 m/s of a new point give 0.75 J, which only kNet
// books.
TEST(ImpulseLosses, OfAPairThatGainsAreNotBooked) {
  const std::vector<ActiveContact> list{contact_of(0, 1, ContactMode::kStick),
                                        contact_of(0, 1, ContactMode::kOpen)};
  const std::vector<ContactBlock> blocks(2, unilateral_block());
  const Eigen::Vector2d f(2, 3), u(-0.5, 0.25);
  EXPECT_EQ(booked(list, blocks, f, u, ImpulseBooking::kLosses).impacts, 1);
  EXPECT_EQ(booked(list, blocks, f, u, ImpulseBooking::kNet).impacts, 0.25);
}

// A new contact gives 0.75 J along its normal, and takes 1 J by friction: 0.25 J are lost together.
TEST(ImpulseLosses, OfANewContactAreThoseOfItsThreeRowsTogether) {
  const std::vector<ActiveContact> list{contact_of(0, 1, ContactMode::kOpen)};
  const std::vector<ContactBlock> blocks{coulomb_block(0.8)};
  const Eigen::Vector3d f(3, 2, 0), u(0.25, -0.5, 7), slower(0.25, -0.25, 7);
  const Booked lost = booked(list, blocks, f, u, ImpulseBooking::kLosses);
  EXPECT_EQ(lost.impacts, -0.75);
  EXPECT_EQ(lost.friction, 1);
  // With half the slip they gain.
  const Booked gained = booked(list, blocks, f, slower, ImpulseBooking::kLosses);
  EXPECT_EQ(gained.impacts, 0);
  EXPECT_EQ(gained.friction, 0);
}

// What one pair gains does not offset the loss of another; dry friction of a joint is friction.
TEST(ImpulseLosses, OfPairsAndJointsAreBookedEach) {
  const std::vector<ActiveContact> list{
      contact_of(0, 1, ContactMode::kOpen), contact_of(0, 2, ContactMode::kOpen),
      contact_of(3, 0, ContactMode::kSlide, ActiveContact::Kind::kJointFriction)};
  const std::vector<ContactBlock> blocks{unilateral_block(), unilateral_block(), box_block(-1, 1)};
  const Eigen::Vector3d f(2, 2, -1), u(0.5, -0.25, 0.125);
  const Booked lost = booked(list, blocks, f, u, ImpulseBooking::kLosses);
  EXPECT_EQ(lost.impacts, 0.5);
  EXPECT_EQ(lost.friction, 0.125);
  EXPECT_EQ(booked(list, blocks, f, u, ImpulseBooking::kNet).impacts, -0.5);
}

}  // namespace
}  // namespace thenar
