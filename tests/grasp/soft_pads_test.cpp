// Tests for grasp/soft_pads.cpp: the torsion of pads in whole grasps.

#include "grasp/soft_pads.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "base/error.h"
#include "grasp/contact/soft_finger.h"
#include "grasp/grasp.h"
#include "grasp/robot_hand.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

Grasp squeeze(const ShapeSpec& pad, const std::string& material, const ShapeSpec& object,
              const PadOptions& options) {
  const RobotHand hand(sample::sliding_jaws(pad, pad, material));
  GraspOptions asked;
  asked.way = 0;
  asked.pads = options;
  return grasp(touching_hand(hand), {}, open_posture(hand.layout()),
               sample::scene({sample::placed("object", object, {0, 0, 0})}), asked);
}

PadOptions soft(double force = 1) {
  PadOptions options;
  options.contact = ContactModel::kSoftFinger;
  options.force = force;
  return options;
}

constexpr double kPad = 0.01, kBall = 0.02;  // radii [m]
const ShapeSpec kPadBall = sample::shape(ShapeKind::kSphere, {kPad, 0, 0});
const ShapeSpec kObjectBall = sample::shape(ShapeKind::kSphere, {kBall, 0, 0});

// Skin of 25 kPa and 3 mm on wood, friction 0.6 (data/materials.toml); R = 1 / (1/10 + 1/20) mm:
// at 1 N  depth = sqrt(1 N 3 mm / (25 kPa pi R)) = 2.394 mm,  a = sqrt(2 depth R) = 5.650 mm,
// torsion = 8/15 0.6 a = 1.808 mm.
constexpr double kTorsion = 1.808e-3;
// The step of 3 mm takes 2 % of the curvatures, a quarter of that of torsion.
constexpr double kStepError = 0.006;

TEST(SoftPads, HoldTheTorsionOfTheirPatch) {
  const Grasp done = squeeze(kPadBall, "skin", kObjectBall, soft());
  ASSERT_EQ(done.contacts.size(), 2u);
  for (const HandContact& contact : done.contacts)
    EXPECT_NEAR(contact.contact.torsion, kTorsion, kStepError * kTorsion);
}

// Fingers on both sides of a ball turn it about the line between them: rank 5.
TEST(SoftPads, GiveTwoFingersForceClosure) {
  const Grasp hard = squeeze(kPadBall, "skin", kObjectBall, {});
  ASSERT_EQ(hard.outcome, GraspOutcome::kGrasped);
  EXPECT_EQ(hard.contacts[0].contact.torsion, 0);
  EXPECT_EQ(hard.quality.rank, 5);
  EXPECT_FALSE(hard.quality.force_closure);
  const Grasp done = squeeze(kPadBall, "skin", kObjectBall, soft());
  EXPECT_EQ(done.quality.rank, 6);
  EXPECT_TRUE(done.quality.force_closure);
}

TEST(SoftPads, OfRigidMaterialsAreHard) {
  for (const HandContact& contact : squeeze(kPadBall, "metal", kObjectBall, soft()).contacts)
    EXPECT_EQ(contact.contact.torsion, 0);
}

TEST(SoftPads, OnFlatFacesLeaveTorsionToTheirPoints) {
  const ShapeSpec plate = sample::shape(ShapeKind::kBox, {0.01, 0.02, 0.02});
  const ShapeSpec cube = sample::shape(ShapeKind::kBox, {0.03, 0.03, 0.03});
  const Grasp done = squeeze(plate, "skin", cube, soft());
  ASSERT_EQ(done.contacts.size(), 8u);
  for (const HandContact& contact : done.contacts) EXPECT_EQ(contact.contact.torsion, 0);
}

TEST(SoftPads, GrowWithTheFourthRootOfForceUntilTheLayerIsFlat) {
  const auto torsion = [](double force) {
    return squeeze(kPadBall, "skin", kObjectBall, soft(force)).contacts[0].contact.torsion;
  };
  EXPECT_NEAR(torsion(0.5) / torsion(0.5 / 16), 2, 1e-9);
  EXPECT_EQ(torsion(100), torsion(10));
  // Flat at 3 mm:  a = sqrt(2 3 mm R) = 6.325 mm.
  const double flat = 8.0 / 15 * 0.6 * 6.325e-3;
  EXPECT_NEAR(torsion(100), flat, 2 * kStepError * flat);
}

// A pad made of facets touches a flat face with the corners of one; with what these hold by
// themselves they hold as much as a smooth pad.
TEST(SoftPads, OfFacetsHoldAsMuchAsSmoothOnes) {
  ContactPatch patch;
  for (const double angle : {0.0, 2.1, 4.2}) {
    HandContact contact;
    contact.contact.p = Eigen::Vector3d(0, 1e-3 * std::cos(angle), 1e-3 * std::sin(angle));
    contact.contact.friction = 0.6;
    patch.contacts.push_back(contact);
  }
  const Solid ball = build_solid({sample::shape(ShapeKind::kSphere, {kPad, 0, 0}, {-kPad, 0, 0})});
  const Solid wall =
      build_solid({sample::shape(ShapeKind::kBox, {0.02, 0.06, 0.06}, {0.01, 0, 0})});
  const Materials& materials = built_in_materials();
  const PadBody a{ball, materials.at("skin"), {}}, b{wall, materials.at("wood"), {}};
  const double faceted = torsion_of(patch, a, b, soft());
  patch.contacts.resize(1);
  patch.contacts[0].contact.p.setZero();
  const double smooth = torsion_of(patch, a, b, soft());
  EXPECT_NEAR(faceted + 0.6e-3, smooth, 1e-5);  // 3 points at 1 mm from their middle hold 0.6 mm
}

TEST(SoftPads, RejectImpossibleOptions) {
  EXPECT_THROW((void)squeeze(kPadBall, "skin", kObjectBall, soft(0)), InputError);
  PadOptions wrong;
  wrong.contact = ContactModel::kFiniteElement;
  EXPECT_THROW((void)squeeze(kPadBall, "skin", kObjectBall, wrong), InputError);
}

}  // namespace
}  // namespace thenar
