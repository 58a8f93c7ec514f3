// Tests for grasp/quality/minkowski_volume.cpp.

#include "grasp/quality/minkowski_volume.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/volume.h"

namespace thenar {
namespace {

constexpr double kExactVolumeError = 1e-12;  // relative, in general position
constexpr double kTurnedError = 1e-7;        // relative, where contacts are turned
constexpr double kMax = 1e7;

double sum_of(const WrenchSet& set) {
  const std::optional<double> volume = internal::minkowski_volume(set, kMax);
  return volume ? *volume : std::nan("");
}

/// The half axes of the wrench space, so many to a contact.
WrenchSet axes(int together) {
  WrenchSet set;
  for (int i = 0; i < 6; ++i) set.caps.push_back({ScaledWrench::unit(i), {}, i / together});
  return set;
}

/// Hard points on the axes of a ball, m edges each; +x, -x, +y, ..
WrenchSet on_axes(int contacts, int edges) {
  std::vector<Contact> list(static_cast<std::size_t>(contacts));
  for (int i = 0; i < contacts; ++i) {
    Contact& contact = list[static_cast<std::size_t>(i)];
    contact.p = (i % 2 == 0 ? 1 : -1) * Eigen::Vector3d::Unit(i / 2);
    contact.n = -contact.p;
    contact.friction = 0.5;
  }
  return friction_pyramids(wrench_set(list, {0, 0, 0}, 1), edges);
}

// A cube; three triangles at right angles, 1/2 each; two tetrahedra, 1/6 each.
TEST(SumVolume, OfDirectSumsIsTheProduct) {
  EXPECT_NEAR(sum_of(axes(1)), 1, kExactVolumeError);
  EXPECT_NEAR(sum_of(axes(2)), 1. / 8, kExactVolumeError);
  EXPECT_NEAR(sum_of(axes(3)), 1. / 36, kExactVolumeError);
}

// Two cones at right angles, of m corners each: the product of (m / 2 sin(2 pi / m)) / 3.
TEST(SumVolume, OfManyEdgesIsTheProductOfTwoCones) {
  constexpr int kEdges = 64;
  WrenchSet set;
  for (int contact = 0; contact < 2; ++contact)
    for (int i = 0; i < kEdges; ++i) {
      const double turn = 2 * M_PI * i / kEdges;
      WrenchCoordinates point = WrenchCoordinates::Zero();
      point.segment<3>(3 * contact) << 1, std::cos(turn), std::sin(turn);
      set.caps.push_back({ScaledWrench::from_coordinates(point), {}, contact});
    }
  EXPECT_NEAR(sum_of(set), std::pow(0.5 * kEdges * std::sin(2 * M_PI / kEdges) / 3, 2), 1e-9);
}

// A sum of segments is tiled by one parallelotope for each six of them.
TEST(SumVolume, OfSegmentsIsTheSumOfDeterminants) {
  std::mt19937 rng(4);
  WrenchSet set;
  Eigen::Matrix<double, 6, 8> segments;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 6; ++j)
      segments(j, i) = 2.0 * static_cast<double>(rng()) / 4294967296.0 - 1;
    set.caps.push_back({ScaledWrench::from_coordinates(segments.col(i)), {}, -1});
  }
  double volume = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = i + 1; j < 8; ++j) {
      Eigen::Matrix<double, 6, 6> six;
      for (int k = 0, column = 0; k < 8; ++k)
        if (k != i && k != j) six.col(column++) = segments.col(k);
      volume += std::abs(six.determinant());
    }
  EXPECT_NEAR(sum_of(set) / volume, 1, kExactVolumeError);
}

// Contacts that stand twice make twice the set: 2^6 times its volume. All their edges are parallel.
TEST(SumVolume, OfDuplicatesIsThatOfTheSetTwiceAsLarge) {
  const WrenchSet set = on_axes(3, 4);
  WrenchSet twice = set;
  for (WrenchCap cap : set.caps) {
    cap.contact += 3;
    twice.caps.push_back(cap);
  }
  EXPECT_NEAR(sum_of(twice) / sum_of(set), 64, 64 * kTurnedError);
}

TEST(SumVolume, IsThatOfTheHull) {
  VolumeOptions options;
  options.limit = ForceNorm::kLinf;
  for (const WrenchSet& set : {on_axes(4, 4), on_axes(3, 6)})
    EXPECT_NEAR(sum_of(set) / volume(set, options).estimate, 1, kTurnedError);
}

TEST(SumVolume, IsNotToBeHadOfSoftFingersOrTooManyFaces) {
  WrenchSet soft = axes(1);
  for (WrenchCap& cap : soft.caps) cap.contact = 0;  // one contact of six dimensions
  EXPECT_FALSE(internal::minkowski_volume(soft, kMax));
  EXPECT_FALSE(internal::minkowski_volume(on_axes(6, 8), 1000));
}

}  // namespace
}  // namespace thenar
