// Tests for grasp/contact/soft_pads.cpp: the torsion of pads in whole grasps.

#include "grasp/contact/soft_pads.h"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "grasp/closing/grasp.h"
#include "grasp/quality/grasp_stiffness.h"
#include "grasp/robot/robot_hand.h"
#include "pad_laws/point_laws.h"
#include "pad_laws/soft_patch.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

Grasp squeeze(const ShapeSpec& pad, const std::string& material, const ShapeSpec& object,
              const PadOptions& options) {
  const RobotHand hand(sample::sliding_jaws(pad, pad, material));
  GraspOptions asked;
  asked.approach_distance = 0;
  asked.pads = options;
  return grasp(collision_hand(hand), {}, open_posture(hand.layout()),
               sample::setup({sample::placed("object", object, {0, 0, 0})}), asked);
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
  const double faceted = patch_torsion(patch, a, b, soft());
  patch.contacts.resize(1);
  patch.contacts[0].contact.p.setZero();
  const double smooth = patch_torsion(patch, a, b, soft());
  EXPECT_NEAR(faceted + 0.6e-3, smooth, 1e-5);  // 3 points at 1 mm from their middle hold 0.6 mm
}

/// Stiffness of what jaws squeeze, turns counted as they are: K in N/m, N and N m/rad.
GraspStiffness stiffness(const ShapeSpec& pad, const ShapeSpec& object) {
  const Materials& materials = built_in_materials();
  const Solid jaw = build_solid({pad}), body = build_solid({object});
  const PadBody held{body, materials.at("wood"), {}};
  const double half = jaw.shape->bounds().max().x();
  PadOptions options;
  options.step = 3e-4;  // so that curvatures of balls are off by 0.02 %
  std::vector<Contact> contacts;
  std::vector<PadStiffness> pads;
  for (const ContactPatch& patch : group_into_patches(squeeze(pad, "skin", object, {}).contacts)) {
    const Contact& first = patch.contacts[0].contact;
    PadBody at{jaw, materials.at("skin"), {}};
    at.X_OB.p.x() = first.p.x() - (first.n.x() > 0 ? half : -half);
    for (const HandContact& each : patch.contacts) contacts.push_back(each.contact);
    pads.insert(pads.end(), patch.contacts.size(), *pad_stiffness(patch, at, held, options));
  }
  return grasp_stiffness(contacts, {0, 0, 0}, 1, pads);
}

/// One patch on a gap of radius R, skin of E = 25 kPa and h = 3 mm at N = 1 N:
///   N = E / h pi R depth^2,  k_n = dN / ddepth = 2 sqrt(N E pi R / h) = 2 N / depth.
struct Spring {
  explicit Spring(double R) : normal(2 * std::sqrt(25e3 * kPi * R / 3e-3)), radius(R) {}
  [[nodiscard]] double shear() const { return normal / 3; }  // G = E / 3
  /// k_t int r^2 dA / A = k_t a^2 / 2, of a circle with a^2 = 2 R depth.
  [[nodiscard]] double twist() const { return shear() * radius * 2 / normal; }
  double normal;  // [N/m]
  double radius;  // [m]
};

using Diagonal = Eigen::Matrix<double, 6, 1>;

/// Of two of them at +-r on the x axis: along x both press, across both shear, about x they twist,
/// about y and z they rock the object by shearing at r.
Diagonal pinch_diagonal(const Spring& k, double r) {
  const double rock = 2 * k.shear() * r * r;
  return (Diagonal() << 2 * k.normal, 2 * k.shear(), 2 * k.shear(), 2 * k.twist(), rock, rock)
      .finished();
}

/// @param error  of an entry, by the root of the two on its row's and column's diagonal [1]
void expect_diagonal(const GraspStiffness& found, const Diagonal& diagonal, double error) {
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(found.K(i, j), i == j ? diagonal(i) : 0,
                  error * std::sqrt(diagonal(i) * diagonal(j)))
          << i << " " << j;
}

constexpr double kPlaces = 1e-3;  // jaws stop within 0.01 mm, at arms of 10 to 20 mm

TEST(SoftPads, HoldABallWithTheirSprings) {
  const Spring spring(1 / (1 / kPad + 1 / kBall));
  expect_diagonal(stiffness(kPadBall, kObjectBall), pinch_diagonal(spring, kBall), kPlaces);
}

TEST(SoftPads, HoldACubeWithTheirSprings) {
  const ShapeSpec cube = sample::shape(ShapeKind::kBox, {0.03, 0.03, 0.03});
  expect_diagonal(stiffness(kPadBall, cube), pinch_diagonal(Spring(kPad), 0.015), kPlaces);
}

// Faces of 20 x 20 mm touch a cube at four corners each, which share the spring of a radius of
// 0.1 m, by convention: at (+-15, +-10, +-10) mm they press along x and shear across, shear at
// sqrt(2) 10 mm about x, press at 10 mm and shear at 15 mm about y and z.
TEST(SoftPads, RockACubeBetweenFlatFacesOnTheirCorners) {
  const ShapeSpec plate = sample::shape(ShapeKind::kBox, {0.01, 0.02, 0.02});
  const ShapeSpec cube = sample::shape(ShapeKind::kBox, {0.03, 0.03, 0.03});
  const Spring k(0.1);
  const double along = 2 * k.normal, across = 2 * k.shear();
  const double rock = along * 0.01 * 0.01 + across * 0.015 * 0.015;
  const Diagonal diagonal =
      (Diagonal() << along, across, across, across * 2 * 0.01 * 0.01, rock, rock).finished();
  expect_diagonal(stiffness(plate, cube), diagonal, kPlaces);
}

TEST(SoftPads, OfRigidMaterialsAreNoSprings) {
  const Solid ball = build_solid({kPadBall});
  const PadBody metal{ball, built_in_materials().at("metal"), {}};
  ContactPatch patch;
  patch.contacts.resize(1);
  EXPECT_FALSE(pad_stiffness(patch, metal, metal).has_value());
  EXPECT_THROW((void)pad_stiffness({}, metal, metal), InputError);
}

/// A ball of 10 mm on one of 20 mm, the pad of skin with a law of its own.
struct PadWithLaw {
  explicit PadWithLaw(std::shared_ptr<const ContactLaw> law) {
    skin.law = std::move(law);
    patch.contacts.resize(1);
    patch.contacts[0].contact.friction = 0.6;
    options.step = 3e-4;  // so that curvatures of balls are off by 0.02 %
  }
  [[nodiscard]] double torsion() const {
    return patch_torsion(patch, {ball, skin, {}}, held, options);
  }
  [[nodiscard]] PadStiffness stiffness() const {
    return *pad_stiffness(patch, {ball, skin, {}}, held, options);
  }

  Material skin = built_in_materials().at("skin");
  Solid ball = build_solid({sample::shape(ShapeKind::kSphere, {kPad, 0, 0}, {-kPad, 0, 0})});
  Solid object = build_solid({sample::shape(ShapeKind::kSphere, {kBall, 0, 0}, {kBall, 0, 0})});
  PadBody held{object, built_in_materials().at("wood"), {}};
  ContactPatch patch;
  PadOptions options = soft();
};

/// Hertz's contact [Johnson1985] of modulus E* as powers: F = 4/3 E* R^(1/2) depth^(3/2),
/// a = (3 F R / (4 E*))^(1/3), torsion 3 pi / 16 mu a.
std::shared_ptr<const ContactLaw> hertz_law(double modulus) {
  SoftFingerConstants c;
  c.force = 4.0 / 3 * modulus * std::sqrt(kLawRadius) * std::pow(kLawDepth, 1.5);
  c.depth_exponent = 1.5;
  c.radius_exponent = 0.5;
  c.patch = std::cbrt(3 * kLawRadius / (4 * modulus));
  c.patch_exponent = c.patch_radius = 1.0 / 3;
  c.torsion = 3 * kPi / 16;
  return std::make_shared<const SoftFinger>(c);
}

TEST(SoftPads, HaveThePatchAndSpringsOfTheirLaw) {
  constexpr double kModulus = 40e3;  // [Pa]
  const PadWithLaw pad(hertz_law(kModulus));
  const double R = 1 / (1 / kPad + 1 / kBall);
  const SoftPatch hertz = hertz_patch(1, kModulus, R, 0.6);
  EXPECT_NEAR(pad.torsion(), hertz.torsion, 1e-3 * hertz.torsion);
  // dF / d depth = 2 E* a, and the twist of shear springs under a circle.
  const PadStiffness springs = pad.stiffness();
  const double normal = 2 * kModulus * hertz.a;
  EXPECT_NEAR(springs.normal, normal, 1e-3 * normal);
  EXPECT_NEAR(springs.tangential, normal / 3, 1e-3 * normal);
  const double twist = normal / 3 * hertz.a * hertz.a / 2;
  EXPECT_NEAR(springs.twisting, twist, 2e-3 * twist);
}

TEST(SoftPads, OfAStiffLawAreHardPoints) {
  const PadWithLaw point(std::make_shared<const HardPoint>());
  EXPECT_EQ(point.torsion(), 0);
  EXPECT_EQ(point.stiffness().normal, std::numeric_limits<double>::infinity());
  EXPECT_EQ(point.stiffness().twisting, 0);
  // A thousand times as stiff is a tenth of the patch, and so on to no torsion.
  const double once = PadWithLaw(hertz_law(40e3)).torsion();
  EXPECT_NEAR(PadWithLaw(hertz_law(40e6)).torsion(), once / 10, 1e-9 * once);
  EXPECT_NEAR(PadWithLaw(hertz_law(40e15)).torsion(), once / 10000, 1e-9 * once);
}

// Points of a patch share the law's spring and have the rest of its torsion.
TEST(SoftPads, OfSeveralPointsShareTheirLaw) {
  PadWithLaw pad(hertz_law(40e3));
  const double torsion = pad.torsion(), normal = pad.stiffness().normal;
  pad.patch.contacts.resize(2, pad.patch.contacts[0]);
  pad.patch.contacts[0].contact.p.y() = 1e-3;
  pad.patch.contacts[1].contact.p.y() = -1e-3;
  EXPECT_NEAR(pad.torsion(), torsion - 0.6e-3, 1e-9);
  EXPECT_NEAR(pad.stiffness().normal, normal / 2, 1e-9 * normal);
  EXPECT_EQ(pad.stiffness().twisting, 0);
}

// A law is of its own material: beside a softer one it is not asked.
TEST(SoftPads, AskTheLawOfTheSofterLayer) {
  PadWithLaw pad(hertz_law(40e3));
  const PadBody as_soft{pad.object, built_in_materials().at("skin"), {}};
  EXPECT_EQ(patch_torsion(pad.patch, {pad.ball, pad.skin, {}}, as_soft, pad.options),
            pad.torsion());
  Material softer = built_in_materials().at("skin");
  softer.young /= 2;
  const PadBody held{pad.object, softer, {}};
  pad.options.force = 0.5;  // [N], which leaves the softer layer thicker than it is pressed
  const double R = 1 / (1 / kPad + 1 / kBall);
  const double springs =
      winkler_patch(0.5, softer.young, softer.layer_thickness, R, R, 0.6).torsion;
  EXPECT_NEAR(patch_torsion(pad.patch, {pad.ball, pad.skin, {}}, held, pad.options), springs,
              1e-3 * springs);
}

TEST(SoftPads, RejectImpossibleOptions) {
  EXPECT_THROW((void)squeeze(kPadBall, "skin", kObjectBall, soft(0)), InputError);
  PadOptions wrong;
  wrong.contact = ContactModel::kFiniteElement;
  EXPECT_THROW((void)squeeze(kPadBall, "skin", kObjectBall, wrong), InputError);
}

}  // namespace
}  // namespace thenar
