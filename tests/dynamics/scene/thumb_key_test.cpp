// A key turned by a human thumb: data/scenes/thumb_key.toml.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

constexpr double kLock = 0.05;                       // dry friction of the lock [N m]
constexpr double kTurnsFrom = 0.9, kTurnsTo = 1.55;  // it turns evenly [s]

/// The scene and what became of it.
struct TurnedKey {
  TurnedKey() {
    const SceneSpec spec = read_scene(kData + "/scenes/thumb_key.toml");
    axis = spec.hands.front().joint.axis;
    point = spec.hands.front().joint.point;
    HumanModel model{default_human(), HumanVersion::kSkewedThumb};
    model.options.skin.triangles = spec.hands.front().skin_triangles;
    model.options.passive = PassiveMoments::kOff;  // as the scene says
    const BuiltScene built = build_scene(spec, {model});
    const Mechanism& mechanism = built.scene.mechanism;
    key = body_named(mechanism, "key");
    const MechanismLayout layout = layout_of(mechanism);
    for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c) {
      if (mechanism.coordinates[c].name == "key") key_q = layout.coordinate_q[c];
      if (mechanism.coordinates[c].name == "human:skewed/base") hand_q = layout.coordinate_q[c];
    }
    run = simulate_scene(built.scene, built.options);
  }

  /// Moment of all contacts on the key about its axis [N m].
  [[nodiscard]] double moment(const SceneSample& sample) const {
    double sum = 0;
    for (const ContactSample& contact : sample.contacts) {
      const Eigen::Vector3d about = (contact.point - point).cross(contact.force);
      sum += (contact.a == key ? 1 : -1) * about.dot(axis);
    }
    return sum;
  }

  Eigen::Vector3d axis, point;
  int key = 0, key_q = 0, hand_q = 0;
  SceneRun run;
};

const TurnedKey& turned_key() {
  static const TurnedKey made;
  return made;
}

TEST(ThumbKey, IsTurnedByThumbAndIndexFinger) {
  const SceneSample& end = turned_key().run.samples.back();
  EXPECT_EQ(turned_key().run.status, SceneStatus::kDone);
  EXPECT_GT(end.q[turned_key().key_q], 50 * kDegree);
  ASSERT_EQ(end.contacts.size(), 3u);
  for (const ContactSample& contact : end.contacts) EXPECT_EQ(contact.mode, ContactMode::kStick);
}

// Newton's law about the axis of a key that turns evenly: contacts do what the lock's friction
// takes, and no more. What its speed still changes by, less than 1 rad/s^2, asks for 2e-7 N m.
TEST(ThumbKey, ContactsDoTheFrictionOfTheLock) {
  for (const SceneSample& sample : turned_key().run.samples) {
    if (sample.t > kTurnsFrom && sample.t < kTurnsTo) {
      EXPECT_NEAR(turned_key().moment(sample), kLock, 1e-6) << sample.t;
    }
  }
}

// Before and after it stands, and the lock takes any part of its friction.
TEST(ThumbKey, StandsWhileTheLockHoldsIt) {
  const std::vector<SceneSample>& samples = turned_key().run.samples;
  for (const auto& [from, to] : {std::pair{0.2, 0.6}, {1.7, 2.0}}) {
    double first = std::nan("");
    for (const SceneSample& sample : samples) {
      if (sample.t < from || sample.t > to) continue;
      EXPECT_LE(std::abs(turned_key().moment(sample)), kLock + 1e-6);
      if (std::isnan(first)) first = sample.q[turned_key().key_q];
      EXPECT_NEAR(sample.q[turned_key().key_q], first, 1e-9);
    }
  }
}

// Under one moment joints yield by one angle and contacts stick, so that the key goes with the
// hand. What changes is the weight of its fingers against it, which turn about the axis: less than
// a hundredth of the moment, on joints that yield by 4 degrees under all that presses.
TEST(ThumbKey, GoesWithTheHand) {
  double least = 1, most = -1;
  for (const SceneSample& sample : turned_key().run.samples) {
    if (sample.t < kTurnsFrom || sample.t > kTurnsTo) continue;
    const double behind = sample.q[turned_key().hand_q] - sample.q[turned_key().key_q];
    least = std::min(least, behind);
    most = std::max(most, behind);
  }
  EXPECT_LT(most - least, 0.04 * kDegree);
  EXPECT_GT(least, 0);
}

}  // namespace
}  // namespace thenar
