// Tests for pad_laws/foundation_bed.cpp.

#include "pad_laws/foundation_bed.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "geometry/primitives.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kBedThickness = 4e-3;

/// A flat square of columns about the origin, its skin towards +z.
FoundationColumns flat(double side, int across) {
  FoundationColumns out;
  const Eigen::Index count = Eigen::Index{across} * across;
  out.skin.resize(3, count);
  out.normal = Vector3d::UnitZ().replicate(1, count);
  out.thickness = Eigen::VectorXd::Constant(count, kBedThickness);
  out.area = Eigen::VectorXd::Constant(count, side * side / static_cast<double>(count));
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j)
      out.skin.col(Eigen::Index{i} * across + j) << side * ((i + 0.5) / across - 0.5),
          side * ((j + 0.5) / across - 0.5), 0;
  return out;
}

/// A dome of columns: part of a ball of 10 mm, its skin towards +z.
FoundationColumns dome() {
  FoundationColumns out = flat(12e-3, 60);
  constexpr double kRadius = 10e-3;
  for (Eigen::Index i = 0; i < out.skin.cols(); ++i) {
    const double z = std::sqrt(kRadius * kRadius - out.skin.col(i).head<2>().squaredNorm());
    out.skin(2, i) = z;
    out.normal.col(i) = out.skin.col(i) / kRadius;
    out.area[i] *= kRadius / z;
    out.thickness[i] = 3e-3 + 0.2 * z;
  }
  return out;
}

FoundationConstants linear(double spread = 1) {
  return {20e3, 1, 0, 0, spread, kBedThickness, 6e3};
}

Pose<double> at(const Vector3d& p) {
  Pose<double> X;
  X.p = p;
  return X;
}

TEST(FoundationBed, ABallOnAFlatBedIsTheIntegralOverItsCap) {
  // Exact for overlaps along the ball's normals:  F = pi E (R - d) d^2 / h.
  constexpr double kRadius = 10e-3, kDepth = 0.8e-3;
  const FoundationBed bed(flat(10e-3, 200), linear());
  const auto ball = build_sphere(kRadius);
  const BedContact contact = bed.press(*ball, at({0, 0, kRadius - kDepth}), 0.5);
  const double exact = kPi * 20e3 * (kRadius - kDepth) * kDepth * kDepth / kBedThickness;
  EXPECT_NEAR(contact.push.force[2] / -exact, 1, 2e-4);
  EXPECT_NEAR(contact.push.force.head<2>().norm(), 0, 1e-12);
  EXPECT_NEAR(contact.depth, kDepth, 1e-6);  // a column is 35 um from the middle
  // The rim of the patch is where the ball leaves the plane of the skin.
  const double rim = 2 * kRadius * kDepth - kDepth * kDepth;
  EXPECT_NEAR(contact.area / (kPi * rim), 1, 2e-3);
  // A paraboloid has 8/15 of its radius; a cap does to the order of d / R.
  EXPECT_NEAR(contact.torsion / (8.0 / 15 * 0.5 * std::sqrt(rim)), 1, kDepth / kRadius);
  EXPECT_NEAR(contact.aspect, 1, 1e-9);
}

TEST(FoundationBed, ACurvedGapIsTheClosedFormOfItsLaw) {
  // An ellipsoid, of which the law knows the curvatures alone: equal to the order of d / R.
  const Vector3d axes(16e-3, 10e-3, 8e-3);
  FoundationConstants c = linear(1.5);
  c.exponent = 0.7;
  c.stiffening = 4;
  c.surround = 0.5;
  const FoundationBed bed(flat(10e-3, 160), c);
  const RelativeCurvatures gap{axes[2] / (axes[1] * axes[1]), axes[2] / (axes[0] * axes[0])};
  const auto egg = build_ellipsoid(axes);
  double before = 0;
  for (const double depth : {2e-4, 1e-4}) {
    const BedContact ours = bed.press(*egg, at({0, 0, axes[2] - depth}), 1);
    const LawContact law = ElasticFoundation(c).at_depth(gap, depth, 1);
    EXPECT_NEAR(ours.force / law.force, 1, 1.5 * depth * gap.k1);
    EXPECT_NEAR(ours.area / law.area, 1, 0.02);
    EXPECT_NEAR(ours.torsion / law.patch.torsion, 1, 0.01);
    EXPECT_NEAR(ours.aspect / (law.patch.a / law.patch.b), 1, 0.02);
    before = ours.force;
  }
  EXPECT_GT(before, 0);
}

TEST(FoundationBed, ForcesOfAPlainBedAreMinusTheGradientOfItsEnergy) {
  FoundationConstants c = linear();
  c.exponent = 1.3;
  c.stiffening = 5;
  const FoundationBed bed(dome(), c);
  const auto egg = build_ellipsoid({9e-3, 6e-3, 5e-3});
  Pose<double> X;
  X.R = rotation_about<double>(Vector3d(1, 2, -1).normalized(), 0.6);
  X.p = {1e-3, -0.7e-3, 14e-3};
  const BedContact here = bed.press(*egg, X);
  ASSERT_GT(here.depth, 5e-4);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const auto energy = [&](double way) {
      Pose<double> moved = X;
      if (k < 3) {
        // Turns about the pad's origin.
        const Eigen::Matrix3d turn = rotation_about<double>(Vector3d::Unit(k), way);
        moved = {turn * X.R, turn * X.p};
      } else {
        moved.p[k - 3] += way;
      }
      return bed.press(*egg, moved).energy;
    };
    // What the object does to the pad is stored.
    const double work = k < 3 ? here.push.moment[k] : here.push.force[k - 3];
    EXPECT_NEAR((energy(kStep) - energy(-kStep)) / (2 * kStep), work,
                1e-6 * (k < 3 ? here.force * 1e-2 : here.force))
        << k;
  }
}

/// Returns the slope of press()'s wrench, moment first, by motion k of the object: rotations about
/// the pad's axes, then displacements along them. By central differences (6).
Eigen::Matrix<double, 6, 1> slope_of_push(const FoundationBed& bed, const Shape& object,
                                          const Pose<double>& X, int k, double step) {
  const auto push = [&](double way) {
    Pose<double> moved = X;
    if (k < 3) {
      const Eigen::Matrix3d turn = rotation_about<double>(Vector3d::Unit(k), way);
      moved = {turn * X.R, turn * X.p};
    } else {
      moved.p[k - 3] += way;
    }
    const Wrench found = bed.press(object, moved).push;
    Eigen::Matrix<double, 6, 1> out;
    out << found.moment, found.force;
    return out;
  };
  return (push(step) - push(-step)) / (2 * step);
}

TEST(FoundationBed, StiffnessOfAFlatBedIsThatOfItsSprings) {
  constexpr double kSide = 6e-3;
  const FoundationBed bed(flat(kSide, 20), linear());
  const auto plane = build_box({0.1, 0.1, 0.1});
  const Pose<double> X = at({0, 0, 0.05 - 5e-4});
  // The push along z falls as the plane goes up.
  const double k = 20e3 / kBedThickness * kSide * kSide;
  EXPECT_NEAR(slope_of_push(bed, *plane, X, 5, 1e-6)[5] / k, 1, 1e-8);
  // A plane that turns presses with a moment of  k <x^2>  against it.
  const double spread = bed.columns().skin.row(0).squaredNorm() / 400;
  EXPECT_NEAR(slope_of_push(bed, *plane, X, 1, 1e-4)[1] / (k * spread), 1, 1e-3);
  EXPECT_NEAR(slope_of_push(bed, *plane, X, 3, 1e-6)[3], 0, 1e-6 * k);
}

TEST(FoundationBed, StickingColumnsAreSpringsUntilTheConeHoldsThem) {
  constexpr double kDepth = 5e-4, kFriction = 0.4, kSide = 6e-3;
  const FoundationBed bed(flat(kSide, 20), linear());
  const auto plane = build_box({0.1, 0.1, 0.1});
  BedState state;
  Pose<double> X = at({0, 0, 0.05 - kDepth});
  BedContact contact = bed.step(*plane, X, kFriction, 0, state);
  const double normal = 20e3 * kDepth / kBedThickness * kSide * kSide;
  EXPECT_NEAR(contact.force, normal, 1e-12);
  EXPECT_NEAR(contact.stick, 1, 1e-12);
  const double spring = 6e3 * kSide * kSide / kBedThickness;
  X.p[0] += 1e-4;
  contact = bed.step(*plane, X, kFriction, 0, state);
  EXPECT_NEAR(contact.push.force[0], spring * 1e-4, 1e-12);
  X.p[0] += 9e-3;
  contact = bed.step(*plane, X, kFriction, 0, state);
  EXPECT_NEAR(contact.push.force[0], kFriction * normal, 1e-12);
  EXPECT_EQ(contact.stick, 0);
  // Back by a little it sticks again, from the cone.
  X.p[0] -= 1e-4;
  contact = bed.step(*plane, X, kFriction, 0, state);
  EXPECT_NEAR(contact.push.force[0], kFriction * normal - spring * 1e-4, 1e-12);
  // Lifted, it forgets.
  X.p[2] += 1e-3;
  EXPECT_EQ(bed.step(*plane, X, kFriction, 0, state).push.force.norm(), 0);
  X.p[2] -= 1e-3;
  EXPECT_NEAR(bed.step(*plane, X, kFriction, 0, state).push.force[0], 0, 1e-12);
}

TEST(FoundationBed, ATwistToTheConeGivesItsTorsion) {
  constexpr double kDepth = 5e-4, kFriction = 0.4, kRadius = 8e-3;
  FoundationConstants c = linear();
  c.shear = 6e6;  // stiff, so that columns slip where they are
  const FoundationBed bed(flat(8e-3, 100), c);
  const auto ball = build_sphere(kRadius);
  BedState state;
  Pose<double> X = at({0, 0, kRadius - kDepth});
  (void)bed.step(*ball, X, kFriction, 0, state);
  // Far enough that all slips; the direction of friction is that of the last small turn.
  for (int k = 0; k < 100; ++k) {
    X.R = rotation_about<double>(Vector3d::UnitZ(), 0.01) * X.R;
    (void)bed.step(*ball, X, kFriction, 0, state);
  }
  const BedContact slips = bed.step(*ball, X, kFriction, 0, state);
  // Near the centre of the turn ways are short and columns still stick.
  EXPECT_NEAR(slips.push.moment[2] / (slips.torsion * slips.force), 1, 0.01);
}

TEST(FoundationBed, HeldItRelaxesExactlyInUnequalSteps) {
  const std::vector<ExponentialTerm> terms{{0.4, 0.05}, {0.2, 1}};
  const FoundationBed bed(dome(), linear(1.5), terms);
  const auto ball = build_sphere(8e-3);
  BedState state;
  Pose<double> X = at({0, 0, 18e-3 - 1e-3});
  const BedContact first = bed.step(*ball, X, 0.5, 0, state);
  X.p[0] += 2e-5;  // sheared, but stuck everywhere but at the rim
  const BedContact sheared = bed.step(*ball, X, 1e6, 0, state);
  const double g = 0.4 + 0.4 * std::exp(-0.08 / 0.05) + 0.2 * std::exp(-0.08);
  (void)bed.step(*ball, X, 1e6, 0.01, state);
  const BedContact later = bed.step(*ball, X, 1e6, 0.07, state);
  EXPECT_NEAR(later.force / sheared.force, g, 1e-12);
  EXPECT_LT((later.push.force - g * sheared.push.force).norm(), 1e-12 * first.force);
  EXPECT_EQ(later.area, sheared.area);
}

TEST(FoundationBed, WithoutFrictionAStepOfNoTimeIsAPress) {
  const FoundationBed bed(dome(), linear(1.5), {{0.5, 1}});
  const auto ball = build_sphere(8e-3);
  const Pose<double> X = at({1e-3, 0, 17.2e-3});
  BedState state;
  const BedContact step = bed.step(*ball, X, 0, 0, state), press = bed.press(*ball, X);
  EXPECT_NEAR(step.force, press.force, 1e-14);
  EXPECT_LT((step.push.force - press.push.force).norm(), 1e-14);
  EXPECT_EQ(step.area, press.area);
}

TEST(FoundationBed, ApartIsNothing) {
  const FoundationBed bed(dome(), linear());
  const auto ball = build_sphere(8e-3);
  const BedContact apart = bed.press(*ball, at({0, 0, 1}));
  EXPECT_EQ(apart.force, 0);
  EXPECT_EQ(apart.area, 0);
  EXPECT_EQ(apart.depth, 0);
  EXPECT_TRUE(apart.centre.allFinite());
}

TEST(FoundationBed, WhatMakesNoSenseIsRefused) {
  const auto refused = [](auto change) {
    FoundationColumns columns = flat(1e-2, 3);
    change(columns);
    EXPECT_THROW(FoundationBed(columns, linear()), InputError);
  };
  refused([](FoundationColumns& c) { c = {}; });
  refused([](FoundationColumns& c) { c.area.conservativeResize(4); });
  refused([](FoundationColumns& c) { c.area[2] = 0; });
  refused([](FoundationColumns& c) { c.thickness[2] = kNaN; });
  refused([](FoundationColumns& c) { c.skin(0, 1) = kInfinity; });
  refused([](FoundationColumns& c) { c.normal.col(0) *= 2; });
  const FoundationBed bed(flat(1e-2, 3), linear());
  const auto ball = build_sphere(8e-3);
  EXPECT_THROW((void)bed.press(*ball, at({0, 0, kNaN})), InputError);
  EXPECT_THROW((void)bed.press(*ball, at({0, 0, 1}), -1), InputError);
  BedState state;
  EXPECT_THROW((void)bed.step(*ball, at({0, 0, 1}), 0, -1, state), InputError);
  state = {};
  (void)FoundationBed(flat(1e-2, 4), linear()).step(*ball, at({0, 0, 1}), 0, 0, state);
  EXPECT_THROW((void)bed.step(*ball, at({0, 0, 1}), 0, 0, state), InputError);
}

}  // namespace
}  // namespace thenar
