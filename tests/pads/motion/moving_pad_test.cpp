/// Pads in motion: all rungs by what holds for each of them, and against each other.

#include "pads/motion/moving_pad.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/primitives.h"
#include "geometry/shape_union.h"
#include "pad_laws/point_laws.h"
#include "pads/motion/bed_pad.h"
#include "pads/motion/element_pad.h"
#include "pads/motion/law_pad.h"
#include "tests/pads/sample_laws.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

using sample::kTerms;

enum class Rung { kLaw, kBed, kElements };

/// A plane above the pad's middle, its face a gap from the skin.
Pose<double> plane_at(double gap) { return {Eigen::Matrix3d::Identity(), {0, 0, 20e-3 + gap}}; }

std::unique_ptr<MovingPad> pad_of(Rung rung, double friction, bool relaxes, double gap = 1e-4,
                                  const RigidObject& plate = {}) {
  const PadShape shape;
  const std::vector<ExponentialTerm> terms = relaxes ? kTerms : std::vector<ExponentialTerm>();
  const RigidObject object =
      plate.shape ? plate : RigidObject{build_box({0.1, 0.1, 0.02}), friction};
  if (rung == Rung::kLaw) {
    return std::make_unique<LawPad>(
        "soft-finger", shape, std::make_shared<SoftFinger>(sample::soft_finger_constants(), terms),
        object, plane_at(gap));
  }
  if (rung == Rung::kBed) {
    auto bed = std::make_shared<FoundationBed>(pad_columns(shape, 20),
                                               sample::foundation_constants(), terms);
    return std::make_unique<BedPad>(bed, object, plane_at(gap));
  }
  Tissue pulp;
  pulp.shear_modulus = 12e3;
  pulp.poisson_ratio = 0.49;
  pulp.relaxation = terms;
  return std::make_unique<ElementPad>(PadModel{shape, {4, 2, 3}, {pulp}}, object, plane_at(gap));
}

PadContact go(MovingPad& pad, const Pose<double>& X_PO, double seconds) {
  const PadContact touch = pad.try_step(X_PO, seconds);
  EXPECT_EQ(touch.status, Status::kSolved) << touch.message;
  pad.accept_step();
  return touch;
}

Pose<double> beside(Pose<double> X, const Vector3d& way) {
  X.p += way;
  return X;
}

class MovingPadOf : public testing::TestWithParam<Rung> {};

TEST_P(MovingPadOf, FeelsNothingUntilItTouches) {
  const auto pad = pad_of(GetParam(), 0.5, false, 1e-3);
  const PadContact touch = go(*pad, plane_at(5e-4), 0.01);
  EXPECT_EQ(touch.force, 0);
  EXPECT_TRUE(touch.push.force.isZero(0));
  EXPECT_TRUE(pad->stiffness(Vector6::Ones()).isZero(0));
}

TEST_P(MovingPadOf, PushesAlongTheNormalAndForgetsAMoveThatIsNotKept) {
  const auto pad = pad_of(GetParam(), 0.5, false);
  const PadContact deep = pad->try_step(plane_at(-1e-3), 0.01);
  ASSERT_EQ(deep.status, Status::kSolved);
  const PadContact touch = go(*pad, plane_at(-5e-4), 0.01);
  const auto other = pad_of(GetParam(), 0.5, false);
  const PadContact same = go(*other, plane_at(-5e-4), 0.01);
  EXPECT_NEAR(touch.force, same.force, 1e-6 * same.force);
  EXPECT_GT(deep.force, 1.5 * touch.force);
  // The plane is above: it pushes down, onto the middle.
  EXPECT_NEAR(touch.normal.z(), -1, 1e-6);
  EXPECT_NEAR(touch.push.force.z(), -touch.force, 1e-3 * touch.force);
  EXPECT_LT(touch.centre.head<2>().norm(), 2e-4);
  EXPECT_NEAR(touch.centre.z(), 9.5e-3, 5e-4);
  // At half a millimetre one node of the coarse mesh touches.
  EXPECT_GT(touch.area, 0);
  EXPECT_GT(deep.area, std::max(1e-5, touch.area));
  EXPECT_NEAR(touch.stick, 1, 1e-12);
}

TEST_P(MovingPadOf, SticksThenSlidesWithCoulombsForce) {
  const auto pad = pad_of(GetParam(), 0.4, false);
  const double force = go(*pad, plane_at(-8e-4), 0).force;
  const Pose<double> pressed = plane_at(-8e-4);
  const PadContact first = go(*pad, beside(pressed, {1e-5, 0, 0}), 0);
  EXPECT_GT(first.push.force.x(), 0) << "the pad is dragged along";
  EXPECT_LT(first.push.force.x(), 0.4 * force);
  EXPECT_EQ(pad->rung() == "soft-finger" ? first.stick : 1, 1);
  PadContact last;
  for (int i = 1; i <= 20; ++i) last = go(*pad, beside(pressed, {2e-4 * i, 0, 0}), 0);
  EXPECT_NEAR(last.push.force.x(), 0.4 * last.force, 0.01 * last.force);
  EXPECT_LT(last.stick, 0.05);
}

TEST_P(MovingPadOf, RelaxesToWhatItsTermsLeave) {
  const auto pad = pad_of(GetParam(), 0.5, true);
  const double at_once = go(*pad, plane_at(-8e-4), 0).force;
  const double left = go(*pad, plane_at(-8e-4), 1e3).force;
  // 1 - 0.3 - 0.25 - 0.2; elements keep their volume by a pressure that does not relax.
  EXPECT_NEAR(left / at_once, 0.25, pad->rung() == "elements" ? 0.02 : 1e-6);
}

TEST_P(MovingPadOf, StiffnessIsTheSlopeOfThePush) {
  const auto pad = pad_of(GetParam(), 0.9, false);
  const Pose<double> pressed =
      moved_by(plane_at(-8e-4), (Vector6() << 0.05, 0.03, 0, 0, 0, 0).finished());
  (void)go(*pad, pressed, 0);
  const Matrix6 K = pad->stiffness(Vector6::Ones());
  // Smaller for elements, whose forces are balanced to a millionth of a newton.
  Vector6 motion;
  motion << 1e-3, -2e-3, 3e-3, 4e-6, -5e-6, -6e-6;
  const Vector6 before = wrench_vector(pad->try_step(pressed, 0).push);
  const Vector6 up = wrench_vector(pad->try_step(moved_by(pressed, motion), 0).push) - before,
                down = wrench_vector(pad->try_step(moved_by(pressed, -motion), 0).push) - before;
  const Vector6 slope = 0.5 * (up - down), seen = K * motion;
  EXPECT_LT((slope - seen).tail<3>().norm(), 0.005 * slope.tail<3>().norm())
      << "forces " << slope.tail<3>().transpose() << " by K " << seen.tail<3>().transpose();
  EXPECT_LT((slope - seen).head<3>().norm(), 0.005 * slope.head<3>().norm())
      << "moments " << slope.head<3>().transpose() << " by K " << seen.head<3>().transpose();
}

TEST_P(MovingPadOf, ResistsATwistUpToAMoment) {
  const auto pad = pad_of(GetParam(), 0.5, false);
  const Pose<double> pressed = plane_at(-8e-4);
  (void)go(*pad, pressed, 0);
  PadContact touch;
  double last = 0;
  for (int i = 1; i <= 30; ++i) {
    Vector6 turn = Vector6::Zero();
    turn[2] = 2 * kDegree * i;
    touch = go(*pad, moved_by(pressed, turn), 0);
    EXPECT_GE(touch.push.moment.z(), last - 1e-3 * last);
    last = touch.push.moment.z();
  }
  // No more than friction at the rim, no less than half of what even pressure has.
  const double radius = std::sqrt(touch.area / kPi);
  EXPECT_LT(last, 0.5 * touch.force * radius * 1.3);
  EXPECT_GT(last, 0.5 * 0.5 * touch.force * radius * 2 / 3);
}

TEST_P(MovingPadOf, CloneIsUntouched) {
  const auto pad = pad_of(GetParam(), 0.5, true);
  (void)go(*pad, plane_at(-8e-4), 0);
  const auto fresh = pad->clone();
  EXPECT_EQ(fresh->rung(), pad->rung());
  EXPECT_EQ(fresh->try_step(plane_at(1e-3), 0.1).force, 0);
}

INSTANTIATE_TEST_SUITE_P(Rungs, MovingPadOf,
                         testing::Values(Rung::kLaw, Rung::kBed, Rung::kElements),
                         [](const auto& tested) {
                           return tested.param == Rung::kLaw   ? "SoftFinger"
                                  : tested.param == Rung::kBed ? "Foundation"
                                                               : "Elements";
                         });

TEST_P(MovingPadOf, NeverPullsThroughAThinObject) {
  // Pressed 1.2 mm by a plate of 2 mm: undeformed skin is nearer to its far side.
  const RigidObject plate{build_box({0.04, 0.04, 2e-3}), 0.5};
  const auto at = [](double depth) {
    return Pose<double>{Eigen::Matrix3d::Identity(), {0, 0, PadShape().height + 1e-3 - depth}};
  };
  const auto pad = pad_of(GetParam(), 0.5, false, 1e-4, plate);
  for (const double depth : {4e-4, 8e-4, 1.2e-3, 1.6e-3, 2.4e-3}) {
    const PadContact contact = pad->try_step(at(depth), 0);
    if (contact.status != Status::kSolved) {
      EXPECT_NE(pad->rung(), "elements") << contact.message;
      EXPECT_GT(depth, 1e-3);
      continue;
    }
    EXPECT_TRUE(pad->rung() == "elements" || depth < 1e-3) << depth;
    EXPECT_LT(contact.push.force.z(), 0) << depth;
    pad->accept_step();
  }
}

TEST_P(MovingPadOf, IsDraggedByNothingThatMovedBeforeItTouched) {
  // From far aside and turned, at once into the pad.
  const auto pad = pad_of(GetParam(), 0.9, false, 50e-3);
  Vector6 aside;
  aside << 0, 0, 0.7, 0.01, -0.02, 0;
  (void)go(*pad, moved_by(plane_at(50e-3), aside), 0.1);
  const PadContact touch = go(*pad, plane_at(-8e-4), 0.01);
  EXPECT_GT(touch.force, 0.1);
  EXPECT_LT(touch.push.force.head<2>().norm(), 0.01 * touch.force);
  EXPECT_LT(std::abs(touch.push.moment.z()), 1e-5 * touch.force);
}

TEST(LawPad, FeelsWhicheverOfTwoBallsIsDeeper) {
  // Two balls side by side, turned about the pad's middle: first the one is deeper, then the other.
  const double radius = 4e-3, aside = 6e-3;
  std::vector<std::shared_ptr<const Shape>> balls;
  for (const double x : {-aside, aside})
    balls.push_back(place(build_sphere(radius), {Eigen::Matrix3d::Identity(), {x, 0, 0}}));
  const auto pad = pad_of(Rung::kLaw, 0, false, 1e-3, {join(balls), 0});
  double least = 1;
  for (int i = -30; i <= 30; ++i) {
    const Pose<double> X{rotation_about<double>({0, 1, 0}, 0.2 * kDegree * i),
                         {0, 0, PadShape().height + 1.6e-3}};
    const double force = go(*pad, X, 0).force, fresh = pad->clone()->try_step(X, 0).force;
    EXPECT_NEAR(force, fresh, 1e-4 * fresh) << i;
    least = std::min(least, fresh);
  }
  EXPECT_GT(least, 1e-3);
}

TEST(ReducedPads, GiveNoWorkInACycle) {
  // Pressed deep, dragged aside or twisted, lifted, and back by other ways; several times.
  for (const Rung rung : {Rung::kLaw, Rung::kBed})
    for (const bool twists : {false, true}) {
      for (const bool other_way_round : {false, true}) {
        SCOPED_TRACE(testing::Message() << (rung == Rung::kLaw ? "law" : "bed") << ", twists "
                                        << twists << ", other way " << other_way_round);
        const auto pad = pad_of(rung, 0.9, false);
        const double deep = 8e-4, flat = 3e-4, way = twists ? 0.01 : 3e-5;
        std::vector<std::pair<double, double>> corners{
            {deep, 0}, {deep, way}, {flat, way}, {flat, 0}};
        if (other_way_round) std::reverse(corners.begin() + 1, corners.end());
        const auto pose = [&](double depth, double aside) {
          Vector6 motion = Vector6::Zero();
          motion[twists ? 2 : 3] = aside;
          return moved_by(plane_at(-depth), motion);
        };
        Pose<double> last = pose(deep, 0);
        Vector6 push = wrench_vector(go(*pad, last, 0).push);
        double given = 0, moved = 0;
        for (int cycle = 0; cycle < 3; ++cycle)
          for (std::size_t k = 0; k < 4; ++k) {
            const auto [d0, w0] = corners[k];
            const auto [d1, w1] = corners[(k + 1) % 4];
            const int steps = 20;
            for (int i = 1; i <= steps; ++i) {
              const double s = i / double{steps};
              const Pose<double> X = pose(d0 + s * (d1 - d0), w0 + s * (w1 - w0));
              const Vector6 next = wrench_vector(go(*pad, X, 0).push),
                            motion = motion_from(last, X);
              // Along the normal the law gives back what it took.
              const double work = 0.5 * (push + next).dot(motion),
                           normal = 0.5 * (push + next)[5] * motion[5];
              given -= work - normal;
              moved += std::abs(work - normal);
              push = next;
              last = X;
            }
          }
        EXPECT_LT(given, 0.01 * moved);
      }
    }
}

TEST(LawPad, DoesNotSlipWhereItRolls) {
  // A ball that rolls on the pad's flat top by a turn about its lowest point.
  const PadShape shape;
  const double radius = 20e-3, depth = 5e-4;
  const Pose<double> on{Eigen::Matrix3d::Identity(), {0, 0, shape.height + radius - depth}};
  LawPad pad("soft-finger", shape, std::make_shared<SoftFinger>(sample::soft_finger_constants()),
             {build_sphere(radius), 0.8}, on);
  (void)go(pad, on, 0);
  Pose<double> X = on;
  PadContact touch;
  for (int i = 0; i < 50; ++i) {
    // About the instant's point of contact.
    touch = pad.try_step(X, 0);
    const Pose<double> turn{rotation_about<double>({0, 1, 0}, 0.1 * kDegree), {0, 0, 0}};
    const Pose<double> there{Eigen::Matrix3d::Identity(), touch.centre};
    X = there * turn * there.inverse() * X;
    touch = go(pad, X, 0);
  }
  EXPECT_GT(touch.force, 0.01);
  EXPECT_LT(touch.push.force.cross(touch.normal).norm(), 0.02 * touch.force);
}

}  // namespace
}  // namespace thenar
