// Tests for hand/skin/skin_landmarks.cpp.

#include "hand/skin/skin_landmarks.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

struct Marked {
  explicit Marked(const Subject& subject, const SkeletonOptions& options = {})
      : hand(find_anatomy(subject)),
        bodies(skin_bodies(hand)),
        skeleton(build_skeleton(subject, options)),
        patches(skin_patches(hand, skeleton)),
        targets(kapandji_targets(hand, skeleton)) {}
  HandAnatomy hand;
  std::map<std::string, ImplicitBody> bodies;
  Skeleton skeleton;
  std::vector<SkinPatch> patches;
  std::vector<OppositionTarget> targets;
};

TEST(HandMarks, LieOnTheSkin) {
  const Marked human(sample::subject("mirakhorlo2016"));
  const auto check = [&](const SkinLandmark& mark) {
    EXPECT_NEAR(implicit_height(human.bodies.at(mark.segment), mark.p), 0, 1e-8) << mark.segment;
    EXPECT_NEAR(mark.outward.norm(), 1, 1e-12);
    EXPECT_GT(implicit_height(human.bodies.at(mark.segment), mark.p + 1e-3 * mark.outward), 5e-4);
    EXPECT_EQ(mark.link, human.skeleton.link_of_segment.at(mark.segment));
  };
  ASSERT_EQ(human.patches.size(), 10U);
  for (const SkinPatch& patch : human.patches) check(patch.middle);
  ASSERT_EQ(human.targets.size(), 10U);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(human.targets[i].score, i + 1);
    check(human.targets[i].mark);
  }
}

TEST(HandMarks, PutPadsAcrossFromNails) {
  for (const Subject& subject : {sample::scaled(), sample::subject("mirakhorlo2016")}) {
    const Marked human(subject);
    for (std::size_t i = 0; i < human.patches.size(); i += 2) {
      const SkinPatch &pad = human.patches[i], &nail = human.patches[i + 1];
      EXPECT_EQ(pad.kind, PatchKind::kPad);
      EXPECT_EQ(nail.kind, PatchKind::kNail);
      EXPECT_LT(pad.middle.outward.dot(nail.middle.outward), -0.5) << pad.middle.digit;
      EXPECT_TRUE(on_patch(pad, pad.middle.p));
      EXPECT_FALSE(on_patch(pad, nail.middle.p));
      EXPECT_FALSE(on_patch(nail, pad.middle.p));
      EXPECT_EQ(&pad_of(human.patches, pad.middle.digit), &pad.middle);
    }
  }
}

// On a flat hand: z is dorsal, y proximal, x radial.
TEST(HandMarks, KnowWhichWayIsUp) {
  const Marked human(sample::scaled());
  EXPECT_GT(human.targets[0].mark.outward.x(), 0.9);   // radial side of the index finger
  EXPECT_LT(human.targets[2].mark.outward.y(), -0.4);  // its tip
  for (int i = 6; i < 10; ++i) EXPECT_LT(human.targets[i].mark.outward.z(), -0.9) << i;
  for (int i = 7; i < 10; ++i)  // ever nearer to the wrist
    EXPECT_GT(human.targets[i].mark.p.y(), human.targets[i - 1].mark.p.y()) << i;
}

TEST(HandMarks, LeaveOutDigitsThatAreNotKept) {
  const Marked two(sample::subject("mirakhorlo2016"), {{"thumb", "index"}, {}});
  EXPECT_EQ(two.patches.size(), 4U);
  std::vector<int> scores;
  for (const OppositionTarget& target : two.targets) scores.push_back(target.score);
  EXPECT_EQ(scores, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(message_of([&] { (void)pad_of(two.patches, "ring"); }), "no pad on digit 'ring'");
}

// Across the bone, on the palmar side, and with what a frozen joint moved.
TEST(HandMarks, PadsLookAcrossTheirBones) {
  const Subject subject = sample::scaled();
  const Marked straight(subject), bent(subject, {{}, {{"PIP2", 0.5}}});
  const Eigen::Vector3d normal = pad_normal(subject, straight.skeleton, "index");
  EXPECT_NEAR(normal.norm(), 1, 1e-12);
  for (const Segment& segment : subject.segments) {
    if (segment.name != "DP2") continue;
    EXPECT_NEAR(normal.dot(segment.distal - segment.proximal), 0, 1e-12);
  }
  EXPECT_LT(normal.z(), -0.9);
  const Eigen::Matrix3d turn = bent.skeleton.segment_at.at("DP2").R;
  EXPECT_LT((turn * normal - pad_normal(subject, bent.skeleton, "index")).norm(), 1e-12);
}

// Marks move with what a frozen joint moved.
TEST(HandMarks, FollowFrozenJoints) {
  const Subject subject = sample::scaled();
  const Marked straight(subject), bent(subject, {{}, {{"PIP2", 0.5}}});
  const Pose<double> moved = bent.skeleton.segment_at.at("DP2");
  EXPECT_LT((moved * pad_of(straight.patches, "index").p - pad_of(bent.patches, "index").p).norm(),
            1e-12);
  EXPECT_GT((pad_of(straight.patches, "index").p - pad_of(bent.patches, "index").p).norm(), 0.01);
}

}  // namespace
}  // namespace thenar
