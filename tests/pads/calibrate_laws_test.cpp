// Tests for pads/calibrate_laws.cpp, pads/press_trials.cpp and pads/pad_shape.cpp.

#include "pads/calibrate_laws.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/primitives.h"
#include "pads/pad_shape.h"
#include "pads/skin_gap.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

PadModel default_pad() {
  PadModel model;
  model.tissues.resize(1);
  model.tissues[0].shear_modulus = 12e3;
  model.tissues[0].relaxation = {{0.4, 0.1}};
  return model;
}

TEST(PadColumns, CoverTheSkin) {
  PadShape shape;
  shape.length = shape.width = 24e-3;
  shape.height = 12e-3;
  for (const int rings : {9, 18}) {
    const FoundationColumns columns = pad_columns(shape, rings);
    // Chords of arcs telescope on a half ball.
    EXPECT_NEAR(columns.area.sum() / (2 * kPi * 12e-3 * 12e-3), 1, 1e-12);
    for (Eigen::Index i = 0; i < columns.skin.cols(); ++i) {
      EXPECT_NEAR(columns.skin.col(i).norm(), 12e-3, 1e-12);
      EXPECT_NEAR(columns.normal.col(i).dot(columns.skin.col(i)), 12e-3, 1e-12);
      EXPECT_GT(columns.thickness[i], 0);
    }
  }
  EXPECT_THROW((void)pad_columns(shape, 0), InputError);
}

/// Presses by a bed in place of the elements.
MeasuredPresses by_a_bed(const PadModel& model, const FoundationConstants& constants,
                         const std::vector<PressTrial>& trials, int rings) {
  const FoundationBed bed(pad_columns(model.shape, rings), constants);
  MeasuredPresses out;
  for (const PressTrial& trial : trials)
    for (const double depth : trial.depths) {
      MeasuredPress press;
      press.trial = trial.name;
      press.object = trial.object.shape;
      press.X_PO = trial.X_PO;
      // As far as the bed says that it is in.
      const auto overlap = [&] {
        return deepest_skin(PadChart(model.shape), *press.object, press.X_PO).overlap;
      };
      for (int k = 0; k < 100; ++k) press.X_PO.p += (depth - overlap()) * trial.along;
      const BedContact contact = bed.press(*press.object, press.X_PO, 1);
      press.gap = {120, 70};
      press.depth = depth;
      press.force = contact.force;
      press.area = contact.area;
      press.aspect = contact.aspect;
      press.arm = contact.torsion;
      // What sticking adds as it is pulled across.
      Pose<double> pulled = press.X_PO;
      const Vector3d across = contact.normal.cross(Vector3d(1, 0, 0)).normalized();
      pulled.p += 1e-6 * across;
      const auto pull = [&](double friction) {
        BedState held;
        (void)bed.step(*press.object, press.X_PO, friction, 0, held);
        return across.dot(bed.step(*press.object, pulled, friction, 0, held).push.force);
      };
      press.shear = (pull(10) - pull(0)) / 1e-6;
      out.presses.push_back(press);
    }
  return out;
}

TEST(FitLaws, FindsTheBedThatThereIs) {
  const PadModel model = default_pad();
  const LawTrials trials = standard_trials(model.shape, {5e-4, 1e-3, 2e-3});
  FoundationConstants truth{3e4, 0.8, 9, 0.5, 1.4, 5e-3, 9e3};
  LawFitOptions options;
  options.rings = 12;
  MeasuredPresses fit = by_a_bed(model, truth, trials.fit, options.rings);
  const MeasuredPresses check = by_a_bed(model, truth, trials.check, options.rings);
  // Powers need gaps that differ.
  for (std::size_t i = 0; i < fit.presses.size(); ++i)
    fit.presses[i].gap.k1 += 10.0 * static_cast<double>(i);
  const LawCalibration found = fit_laws(model, fit, check, options);
  EXPECT_EQ(found.status, Status::kSolved) << found.message;
  const FoundationConstants& ours = found.laws.foundation;
  EXPECT_NEAR(ours.modulus / truth.modulus, 1, 1e-4);
  EXPECT_NEAR(ours.exponent, truth.exponent, 1e-4);
  EXPECT_NEAR(ours.stiffening, truth.stiffening, 1e-3);
  EXPECT_NEAR(ours.spread, truth.spread, 1e-4);
  EXPECT_NEAR(ours.surround, truth.surround, 1e-3);
  // One way across stands for the mean of both.
  EXPECT_NEAR(ours.shear / truth.shear, 1, 0.02);
  EXPECT_LT(found.laws.bed_error.force.worst, 1e-4);
  EXPECT_LT(found.laws.bed_error.torsion.worst, 1e-4);
  EXPECT_EQ(found.laws.evidence.fitted, 15);
  EXPECT_EQ(found.laws.evidence.checked, 9);
  EXPECT_NO_THROW(check_laws(found.laws));
}

TEST(FitLaws, FindsThePowersThatThereAre) {
  const PadModel model = default_pad();
  const SoftFingerConstants truth{0.3, 1.8, 0.6, 4e-3, 0.22, 0.3, 0.55, 0.58, 7e3};
  const LawTrials trials = standard_trials(model.shape, {5e-4, 1e-3, 2e-3});
  const auto by_a_finger = [&](const std::vector<PressTrial>& of) {
    MeasuredPresses out = by_a_bed(model, {3e4, 1, 0, 0, 1, 5e-3, 9e3}, of, 6);
    double k1 = 100;
    for (MeasuredPress& press : out.presses) {
      press.gap = {k1 *= 1.1, 60};
      const LawContact contact = SoftFinger(truth).at_depth(press.gap, press.depth, 1);
      press.force = contact.force;
      press.area = contact.area;
      press.aspect = contact.patch.a / contact.patch.b;
      press.arm = contact.patch.torsion;
      press.shear = contact.shear;
    }
    return out;
  };
  LawFitOptions options;
  options.rings = 6;
  const LawCalibration found =
      fit_laws(model, by_a_finger(trials.fit), by_a_finger(trials.check), options);
  const SoftFingerConstants& ours = found.laws.soft_finger;
  EXPECT_NEAR(ours.force, truth.force, 1e-6);
  EXPECT_NEAR(ours.depth_exponent, truth.depth_exponent, 1e-6);
  EXPECT_NEAR(ours.radius_exponent, truth.radius_exponent, 1e-6);
  EXPECT_NEAR(ours.patch, truth.patch, 1e-8);
  EXPECT_NEAR(ours.patch_exponent, truth.patch_exponent, 1e-6);
  EXPECT_NEAR(ours.patch_radius, truth.patch_radius, 1e-6);
  EXPECT_NEAR(ours.aspect, truth.aspect, 1e-6);
  EXPECT_NEAR(ours.torsion, truth.torsion, 1e-6);
  EXPECT_NEAR(ours.shear, truth.shear, 1e-2);
  EXPECT_LT(found.laws.soft_finger_error.force.worst, 1e-5);
  EXPECT_LT(found.laws.soft_finger_error.radius.worst, 1e-5);
  EXPECT_GT(found.laws.power_error.force.worst, 1e-2);  // it knows no gap
  ASSERT_EQ(found.laws.relaxation.size(), 1U);
  EXPECT_EQ(found.laws.relaxation[0].share, 0.4);
}

TEST(FitLaws, RefusesTooFewPresses) {
  const PadModel model = default_pad();
  EXPECT_THROW((void)fit_laws(model, {}, {}, {}), InputError);
  EXPECT_THROW((void)standard_trials(model.shape, {}), InputError);
  EXPECT_THROW((void)standard_trials(model.shape, {2e-3, 1e-3}), InputError);
}

TEST(TrialDepths, FollowTheTissueOverTheBone) {
  PadShape shape;
  EXPECT_EQ(trial_depths(shape), (std::vector{0.5e-3, 1e-3, 1.5e-3, 2e-3}));
  shape.height = 6.7e-3;  // 2.2 mm over the bone
  EXPECT_EQ(trial_depths(shape), (std::vector{0.2e-3, 0.4e-3, 0.6e-3, 0.8e-3}));
}

TEST(MeasurePresses, KnowsGapAndDepthOfABall) {
  const PadModel model = default_pad();
  PressTrial trial;
  trial.name = "ball";
  trial.object = {build_sphere(8e-3), 0};
  trial.X_PO.p = {0, 0, 19e-3};
  trial.depths = {8e-4};
  PadPressOptions options;
  options.force_error = 0.3;
  options.max_penetration = 1;
  const MeasuredPresses out = measure_presses(model, {trial}, options);
  ASSERT_EQ(out.presses.size(), 1U);
  const MeasuredPress& press = out.presses[0];
  EXPECT_NEAR(press.depth, 8e-4, 1e-10);  // its first touch is at a node
  // Radii of the ellipsoid at its pole: 12^2 / 10 and 8^2 / 10 mm. Second differences over 1 mm
  // are off by (k h)^2 / 4.
  EXPECT_NEAR(press.gap.k1, 1 / 6.4e-3 + 1 / 8e-3, 2);
  EXPECT_NEAR(press.gap.k2, 1 / 14.4e-3 + 1 / 8e-3, 2);
  EXPECT_GT(press.force, 0);
  EXPECT_GT(press.area, 0);
  EXPECT_GT(press.aspect, 1);
  EXPECT_LT(press.arm, std::sqrt(press.area));
}

TEST(MeasurePresses, SomeNodesAreNoPatch) {
  // Nodes of quadratic elements stand for so much skin that balls touch one of them, whose pressure
  // has an arm of rounding alone.
  PadModel model = default_pad();
  model.element = HexElement::kQuadratic;
  model.cells = {2, 2, 2};
  const LawTrials trials = standard_trials(model.shape, {0.5e-3});
  const MeasuredPresses out = measure_presses(model, trials.fit, {});
  EXPECT_FALSE(out.failures.empty());
  for (const std::string& failure : out.failures)
    EXPECT_NE(failure.find("too few nodes touch"), std::string::npos) << failure;
  for (const MeasuredPress& press : out.presses)
    EXPECT_GT(press.arm, 0.1 * std::sqrt(press.area)) << press.trial;
}

TEST(StandardTrials, BeginClearOfASkinWithCorners) {
  PadShape shape;
  shape.skin = build_box({24e-3, 16e-3, 20e-3});
  const LawTrials trials = standard_trials(shape, {0.5e-3});
  for (const std::vector<PressTrial>* part : {&trials.fit, &trials.check})
    for (const PressTrial& trial : *part)
      for (const double x : {-12e-3, 12e-3})
        for (const double y : {-8e-3, 8e-3})
          EXPECT_GT(trial.object.shape->distance(trial.X_PO.inverse() * Vector3d(x, y, 10e-3)), 0)
              << trial.name;
}

}  // namespace
}  // namespace thenar
