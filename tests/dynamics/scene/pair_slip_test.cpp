// Tests for dynamics/scene/pair_slip.cpp: ways that are known by hand.

#include "dynamics/scene/pair_slip.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.01, kStep = 0.01;  // of what is round [m], of time [s]

/// A body's motion in one step: a turn about an axis through its origin, and a way.
struct Step {
  Vector3d axis{0, 1, 0};
  double turn = 0;        // [rad]
  Vector3d way{0, 0, 0};  // [m] (3)
};

/// Slip of body 1 on body 0, which both begin at the origin, over a step in which their contact
/// goes from `first` to `last` and its normal turns from `normal_first` to `normal_last`.
double slip(const Step& a, const Step& b, const Vector3d& first, const Vector3d& last,
            const Vector3d& normal_first, const Vector3d& normal_last) {
  const auto instant = [&](double share, const Vector3d& point, const Vector3d& normal) {
    SlipInstant out;
    out.t = share * kStep;
    ContactSample contact;
    contact.a = 0, contact.b = 1, contact.id = 7;
    contact.point = point, contact.normal = normal;
    out.contacts = {contact};
    for (const Step& body : {a, b}) {
      Pose<double> X;
      X.R = rotation_about<double>(body.axis, share * body.turn);
      X.p = share * body.way;
      out.X_WB.push_back(X);
      out.centre.push_back(X.p);
      out.velocity.push_back({body.way / kStep, body.turn / kStep * body.axis});
    }
    return out;
  };
  const auto ways = slips_between(instant(0, first, normal_first), instant(1, last, normal_last));
  return ways.at({0, 1});
}

const Vector3d kDown(0, 0, -1);

/// A cylinder about y, or a ball, on the plane z = -kRadius.
double on_plane(const Step& round) {
  const Vector3d foot = kRadius * kDown;
  return slip({}, round, foot, foot + round.way, kDown, kDown);
}

// Rolling is r turn along x, sliding along the axis or beside it what is left of the way.
TEST(PairSlip, OfARollingCylinderIsWhatItSlides) {
  for (const double turn : {0.1, 0.3, 1.0, 1.9, 2.1, -30.0})
    for (const Vector3d& slides :
         {Vector3d(0, 0, 0), Vector3d(0, 0.003, 0), Vector3d(0.002, 0.003, 0)})
      EXPECT_NEAR(on_plane({{0, 1, 0}, turn, slides + Vector3d(kRadius * turn, 0, 0)}),
                  slides.norm(), 1e-15)
          << turn;
}

TEST(PairSlip, OfATurnAboutTheNormalIsNone) {
  EXPECT_NEAR(on_plane({{0, 0, 1}, 1.5, {0, 0, 0}}), 0, 1e-15);
}

// A bone that turns about its centre above a point that stays slides by r turn, however far it is
// pressed in meanwhile.
TEST(PairSlip, AWayAlongTheNormalAddsNothing) {
  const Vector3d in(0, 0, -1e-3);
  for (const double turn : {0.0, 1e-5, 1e-4, 1e-3}) {
    const Vector3d normal = rotation_about<double>({0, 1, 0}, turn) * kDown;
    const double told =
        slip({}, {{0, 1, 0}, turn, in}, kRadius * kDown, kRadius * kDown + in, kDown, normal);
    EXPECT_NEAR(told, kRadius * turn, in.norm() * turn) << turn;
  }
}

// A ring of radius 3 r that goes round a peg of r without turning: the contact runs over the peg by
// r theta and over the ring by 3 r theta.
TEST(PairSlip, OfARingRoundAPegIsTheDifferenceOfArcs) {
  const auto on = [](double angle) { return Vector3d(std::sin(angle), 0, -std::cos(angle)); };
  for (const double theta : {0.2, 1.0, 1.8}) {
    const Step ring{{0, 1, 0}, 0, 2 * kRadius * (on(0) - on(theta))};
    EXPECT_NEAR(slip({}, ring, kRadius * on(0), kRadius * on(theta), -on(0), -on(theta)),
                2 * kRadius * theta, 1e-15)
        << theta;
  }
}

// Two balls that roll on each other, each about its centre.
TEST(PairSlip, OfTwoRollingBallsIsNone) {
  const Vector3d contact(0, 0, kRadius), upper_centre = 2 * contact;
  for (const double theta : {0.1, 1.0}) {
    const Vector3d way = upper_centre - rotation_about<double>({0, 1, 0}, -theta) * upper_centre;
    EXPECT_NEAR(slip({{0, 1, 0}, theta, {0, 0, 0}}, {{0, 1, 0}, -theta, way}, contact, contact,
                     kDown, kDown),
                0, 1e-15)
        << theta;
  }
}

}  // namespace
}  // namespace thenar
