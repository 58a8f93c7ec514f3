// Tests for grasp/contact/contact_patch.cpp.

#include "grasp/contact/contact_patch.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/geometry/collision/analytic_shapes.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kFriction = 0.5;

Pose<double> at(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
}

ContactPatches patches(const Solid& a, const Pose<double>& X_WA, const Solid& b) {
  return contact_patches(collision_tree(a), X_WA, b, {}, kFriction);
}

/// The only patch there is.
ContactPatch the_patch(const Solid& a, const Pose<double>& X_WA, const Solid& b) {
  const ContactPatches found = patches(a, X_WA, b);
  EXPECT_EQ(found.patches.size(), 1U);
  EXPECT_TRUE(found.complete);
  return found.patches.empty() ? ContactPatch{} : found.patches.front();
}

/// Whether some contact lies within `tolerance` of p.
testing::AssertionResult touches_at(const ContactPatch& patch, const Eigen::Vector3d& p,
                                    double tolerance) {
  double nearest = 1e9;
  for (const HandContact& c : patch.contacts) nearest = std::min(nearest, (c.contact.p - p).norm());
  if (nearest <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the nearest contact is " << nearest << " m away";
}

TEST(ContactPatch, OfBallOnGroundIsItsLowestPoint) {
  const ContactPatch patch =
      the_patch(touching({rounded_point({0, 0, 0}, 0.01)}), at(0.3, 0.2, 0.01005), ground_solid());
  ASSERT_EQ(patch.contacts.size(), 1U);
  const Contact& contact = patch.contacts[0].contact;
  EXPECT_TRUE(matrix_near(contact.p, Eigen::Vector3d(0.3, 0.2, 0), 1e-9));
  EXPECT_TRUE(matrix_near(contact.n, Eigen::Vector3d(0, 0, -1), 1e-9));
  EXPECT_EQ(contact.friction, kFriction);
  EXPECT_NEAR(patch.distance, 5e-5, 1e-12);
}

// Seen from the flat: a face touches a ball in one point, too.
TEST(ContactPatch, OfFaceOnBallIsOnePoint) {
  for (const double radius : {0.005, 0.01, 0.03}) {
    const ContactPatch patch = the_patch(touching({{block_mesh({0.05, 0.07, 0.02}), 0}}),
                                         at(0.003, 0.004, radius + 0.01), ball_solid(radius));
    ASSERT_EQ(patch.contacts.size(), 1U) << radius;
    // The lowest point is found to the distance's tolerance, across it to the root of that.
    EXPECT_TRUE(matrix_near(patch.contacts[0].contact.p, Eigen::Vector3d(0, 0, radius),
                            std::sqrt(2 * radius * 1e-6)));
    EXPECT_NEAR(patch.distance, 0, 1e-6);
  }
}

// Wherever the ball lies on a face, which stands anyhow: the place where it is nearest, not one
// within the tolerance of the distance. Two jaws hold a ball by the line through two such places.
TEST(ContactPatch, OfFaceOnBallIsUnderItsCentre) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 50; ++k) {
    const double radius = 0.02 + 0.015 * uniform(random);
    const Eigen::Vector3d up =
        Eigen::Vector3d(uniform(random), uniform(random), uniform(random)).normalized();
    Pose<double> X_WA;
    X_WA.R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
    X_WA.p = (radius + 0.01 + 5e-5) * up + 0.015 * uniform(random) * X_WA.R.col(0) +
             0.02 * uniform(random) * X_WA.R.col(1);
    const ContactPatch patch =
        the_patch(touching({{block_mesh({0.05, 0.07, 0.02}), 0}}), X_WA, ball_solid(radius));
    ASSERT_EQ(patch.contacts.size(), 1U) << k;
    EXPECT_TRUE(matrix_near(patch.contacts[0].contact.p, radius * up, 1e-7)) << k;
    EXPECT_NEAR(patch.distance, 5e-5, 1e-12) << k;
  }
}

TEST(ContactPatch, OfCapsuleOnGroundIsItsTwoEnds) {
  const ContactPatch patch =
      the_patch(touching({rounded_segment({-0.02, 0, 0}, {0.02, 0, 0}, 0.01)}), at(0, 0, 0.01),
                ground_solid());
  ASSERT_EQ(patch.contacts.size(), 2U);
  EXPECT_TRUE(touches_at(patch, {-0.02, 0, 0}, 1e-9));
  EXPECT_TRUE(touches_at(patch, {0.02, 0, 0}, 1e-9));
  EXPECT_LT(patch.loss, 1.01e-3);  // the rim's resolution
}

// Two blocks crossed: the overlap of 30 x 20 mm has corners no block has.
TEST(ContactPatch, OfCrossedFacesIsTheCornersOfTheOverlap) {
  const ContactPatch patch = the_patch(touching({{block_mesh({0.1, 0.02, 0.02}), 0}}),
                                       at(0.01, 0.005, 0.02), box_shape({0.03, 0.1, 0.02}));
  ASSERT_EQ(patch.contacts.size(), 4U);
  for (const double x : {-0.015, 0.015})
    for (const double y : {-0.005, 0.015}) EXPECT_TRUE(touches_at(patch, {x, y, 0.01}, 2e-4));
  for (const HandContact& c : patch.contacts)
    EXPECT_TRUE(matrix_near(c.contact.n, Eigen::Vector3d(0, 0, -1), 1e-6));
}

// The same seen by the other body, whose normals are opposite.
TEST(ContactPatch, IsTheSameForEitherBody) {
  const ContactPatch patch = the_patch(touching({{block_mesh({0.03, 0.1, 0.02}), 0}}),
                                       at(-0.01, -0.005, -0.02), box_shape({0.1, 0.02, 0.02}));
  ASSERT_EQ(patch.contacts.size(), 4U);
  for (const double x : {-0.025, 0.005})
    for (const double y : {-0.01, 0.01}) EXPECT_TRUE(touches_at(patch, {x, y, -0.01}, 2e-4));
}

TEST(ContactPatch, OfSmallFaceOnLargeIsTheSmallOne) {
  const ContactPatch patch =
      the_patch(touching({{block_mesh({0.01, 0.012, 0.02}), 0}}), at(0, 0, 0.0101), ground_solid());
  ASSERT_EQ(patch.contacts.size(), 4U);
  for (const double x : {-0.005, 0.005})
    for (const double y : {-0.006, 0.006}) EXPECT_TRUE(touches_at(patch, {x, y, 0}, 1e-9));
}

// An edge of B on a face of A: the normal is that of the face, not of either side of the edge.
TEST(ContactPatch, TakesTheNormalOfTheFaceOnAnEdge) {
  const Eigen::Matrix3d R = rotation_about<double>({1, 0, 0}, 0.5);
  const Solid wedge = solid_of([R](const Eigen::Vector3d& p) {
    return box_distance({0.04, 0.02, 0.02}, R * p);
  });
  // The topmost edge is at (y, z) = (-0.01, 0.01) in the wedge's frame.
  const double top = (R.transpose() * Eigen::Vector3d(0, -0.01, 0.01)).z();
  const ContactPatch patch =
      the_patch(touching({{block_mesh({0.1, 0.1, 0.02}), 0}}), at(0, 0, top + 0.01), wedge);
  ASSERT_EQ(patch.contacts.size(), 2U);
  for (const HandContact& c : patch.contacts) {
    EXPECT_NEAR(std::abs(c.contact.p.x()), 0.02, 1e-3);  // the rim's resolution
    EXPECT_TRUE(matrix_near(c.contact.n, Eigen::Vector3d(0, 0, -1), 1e-6));
  }
}

// Two blocks side by side, all edges flush: their sides look the same way, too, but only the faces
// between them press on each other.
TEST(ContactPatch, OfFlushBlocksPressesNowhereAlongTheirSides) {
  for (const double gap : {-5e-5, 0.0, 5e-5}) {
    const ContactPatch patch = the_patch(touching({{block_mesh({0.01, 0.02, 0.06}), 0}}),
                                         at(-0.025 - gap, 0, 0), box_shape({0.04, 0.02, 0.06}));
    ASSERT_EQ(patch.contacts.size(), 4U) << gap;
    for (const HandContact& c : patch.contacts)
      EXPECT_TRUE(matrix_near(c.contact.n, Eigen::Vector3d(1, 0, 0), 1e-6)) << gap;
  }
}

// Where edges cross the normal is across both, wherever the middle of the faces' normals points.
TEST(ContactPatch, TakesTheNormalAcrossTwoEdges) {
  // The top edge of a roof along x, whose faces slope by 30 and 60 degrees.
  constexpr double kSlope = 0.5235987755982988;  // [rad]
  const Eigen::Matrix3d about_x = rotation_about<double>({1, 0, 0}, kSlope);
  const Solid roof = solid_of([about_x](const Eigen::Vector3d& p) {
    return box_distance({0.1, 0.02, 0.02}, about_x * p);
  });
  const Eigen::Vector3d top = about_x.transpose() * Eigen::Vector3d(0, -0.01, 0.01);
  ASSERT_GT(top.z(), (about_x.transpose() * Eigen::Vector3d(0, 0.01, 0.01)).z());
  // The lowest edge of a block, which crosses it aslant.
  const Eigen::Matrix3d about_y = rotation_about<double>({0, 1, 0}, kSlope);
  const Eigen::Vector3d lowest = about_y * Eigen::Vector3d(0.01, 0, -0.01);
  ASSERT_LT(lowest.z(), (about_y * Eigen::Vector3d(-0.01, 0, -0.01)).z());
  for (const double yaw : {-0.4, 0.0, 0.4})
    for (const double rise : {-0.2, 0.0, 0.3})
      for (const double gap : {-2e-5, 0.0, 1e-6, 8e-5}) {
        const Eigen::Matrix3d turned =
            rotation_about<double>({0, 0, 1}, yaw) * rotation_about<double>({1, 0, 0}, rise);
        const Eigen::Vector3d edge = turned * Eigen::Vector3d(0, 1, 0);
        const Eigen::Vector3d n = edge.cross(Eigen::Vector3d(1, 0, 0)).normalized();
        ASSERT_LT(n.z(), 0);
        const ContactPatch patch =
            the_patch(touching({{block_mesh({0.02, 0.1, 0.02}), 0}}),
                      {turned * about_y, top - gap * n - turned * lowest}, roof);
        ASSERT_EQ(patch.contacts.size(), 1U);
        EXPECT_TRUE(matrix_near(patch.contacts[0].contact.p, top, 2e-4));
        EXPECT_TRUE(matrix_near(patch.contacts[0].contact.n, n, 1e-6))
            << yaw << ' ' << rise << ' ' << gap;
      }
}

// Edge across edge: both sharp. The middle of B's normals points straight in.
TEST(ContactPatch, TakesTheMiddleOfNormalsWhereEdgesCross) {
  const double up = 0.01 * std::sqrt(2.0);
  const Eigen::Matrix3d about_x = rotation_about<double>({1, 0, 0}, std::atan(1.0));
  const Eigen::Matrix3d about_y = rotation_about<double>({0, 1, 0}, std::atan(1.0));
  const Solid roof = solid_of([about_x](const Eigen::Vector3d& p) {
    return box_distance({0.1, 0.02, 0.02}, about_x * p);
  });
  const ContactPatch patch =
      the_patch(touching({{block_mesh({0.02, 0.1, 0.02}), 0}}), {about_y, {0, 0, 2 * up}}, roof);
  ASSERT_EQ(patch.contacts.size(), 1U);
  EXPECT_TRUE(matrix_near(patch.contacts[0].contact.p, Eigen::Vector3d(0, 0, up), 1e-4));
  EXPECT_TRUE(matrix_near(patch.contacts[0].contact.n, Eigen::Vector3d(0, 0, -1), 1e-3));
}

// Flipped triangles still push the right way.
TEST(ContactPatch, MindsNoFlippedNormals) {
  TriangleMesh flipped = block_mesh({0.1, 0.1, 0.02});
  flipped.triangles.row(0).swap(flipped.triangles.row(1));
  const Solid corner = box_shape({0.02, 0.02, 0.02});
  const ContactPatch patch = the_patch(touching({{flipped, 0}}), at(0.05, 0, 0.02), corner);
  ASSERT_EQ(patch.contacts.size(), 4U);
  for (const HandContact& c : patch.contacts) EXPECT_NEAR(c.contact.n.z(), -1, 1e-6);
}

// A beam over two posts touches twice.
TEST(ContactPatch, KeepsRegionsApart) {
  const Solid posts = solid_of([](const Eigen::Vector3d& p) {
    const Eigen::Vector3d x(0.03, 0, 0);
    return std::min(box_distance({0.01, 0.01, 0.02}, p - x),
                    box_distance({0.01, 0.01, 0.02}, p + x));
  });
  const ContactPatches found =
      patches(touching({{block_mesh({0.1, 0.02, 0.02}), 0}}), at(0, 0, 0.02), posts);
  ASSERT_EQ(found.patches.size(), 2U);
  for (const ContactPatch& patch : found.patches) EXPECT_EQ(patch.contacts.size(), 4U);
  const std::vector<HandContact> all = number_patch_contacts(found.patches);
  ASSERT_EQ(all.size(), 8U);
  EXPECT_EQ(all.front().contact.patch, 0);
  EXPECT_EQ(all.back().contact.patch, 1);
}

/// A rectangle of contacts on the plane z = height, from (x, 0) to (x + 10, 10) mm.
ContactPatch rectangle(double x, double height) {
  ContactPatch patch{{}, -height, 0, {0, 0, -1}};
  for (const auto& [dx, y] : {std::pair(0.0, 0.0), {0.01, 0.0}, {0.01, 0.01}, {0.0, 0.01}})
    patch.contacts.push_back({{{x + dx, y, height}, {0, 0, -1}, 0.5, 0}, -1, 0});
  return patch;
}

double area(const ContactPatch& patch) {
  Eigen::AlignedBox3d box;
  for (const HandContact& contact : patch.contacts) box.extend(contact.contact.p);
  return box.sizes().x() * box.sizes().y();
}

// Upon each other, crossing, and side by side with 0.5 mm between them.
TEST(ContactPatch, JoinsWhatMeets) {
  for (const double x : {0.0, 0.006, 0.0105}) {
    const auto one = merge_patches(rectangle(0, 0), rectangle(x, 1e-4));
    ASSERT_TRUE(one);
    EXPECT_EQ(one->contacts.size(), 4U) << x;
    EXPECT_NEAR(area(*one), 0.01 * (0.01 + x), 1e-12);
  }
}

TEST(ContactPatch, LeavesWhatIsApart) {
  EXPECT_FALSE(merge_patches(rectangle(0, 0), rectangle(0.012, 0)));  // 2 mm beside
  EXPECT_FALSE(merge_patches(rectangle(0, 0), rectangle(0, 0.003)));  // on a step of 3 mm
  ContactPatch other_side = rectangle(0, 0);
  other_side.normal = {0, 0, 1};
  EXPECT_FALSE(merge_patches(rectangle(0, 0), other_side));
}

TEST(ContactPatch, ReportsTheDepthOfAnOverlap) {
  const ContactPatch patch =
      the_patch(touching({rounded_point({0, 0, 0}, 0.01)}), at(0, 0, 0.008), ground_solid());
  ASSERT_EQ(patch.contacts.size(), 1U);
  EXPECT_NEAR(patch.contacts[0].depth, 0.002, 1e-12);
  EXPECT_NEAR(patch.distance, -0.002, 1e-12);
}

TEST(ContactPatch, OfThingsApartIsNone) {
  EXPECT_TRUE(patches(touching({rounded_point({0, 0, 0}, 0.01)}), at(0, 0, 0.0103), ground_solid())
                  .patches.empty());
}

TEST(ContactPatch, RejectsFrictionBelowZero) {
  EXPECT_EQ(message_of([] {
              (void)contact_patches(collision_tree(touching({rounded_point({0, 0, 0}, 0.01)})), {},
                                    ground_solid(), {}, -1);
            }),
            "friction must be finite and >= 0, got -1");
}

}  // namespace
}  // namespace thenar
