// What the default human's thumb reaches, by grasp/compare/opposition.cpp.

#include <algorithm>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "grasp/compare/opposition.h"
#include "hand_versions/human_hand.h"

namespace thenar {
namespace {

// As every healthy thumb, it meets the tips of all fingers and comes to the creases of the little
// finger: healthy hands score 9 to 10 [Kapandji1986]. It does not come to the palm (10): its
// metacarpals IV and V do not move.
TEST(HumanOpposition, MeetsFingertipsAndTheCreasesOfTheLittleFinger) {
  HumanHandOptions options;
  options.cover = Cover::kNone;
  HumanHand human = build_human_hand(default_human(), HumanVersion::kSkewedThumb, options);
  ComparedHand compared;
  compared.hand = std::move(human.hand);
  for (const OppositionTarget& target : human.targets)
    compared.places.push_back({target.name, target.mark.link, target.mark.p, target.score});
  const SkinLandmark& pad = pad_of(human.patches, "thumb");
  compared.thumb = {"thumb", pad.link, pad.p, 0};
  std::mt19937 random(1);
  const Opposition found = measure_opposition(compared, random);
  EXPECT_GE(found.score, 9);
  for (const char* digit : {"index", "middle", "ring", "little"}) {
    const std::string place = std::string("tip of the ") + digit + " finger";
    EXPECT_EQ(std::count(found.reached.begin(), found.reached.end(), place), 1) << place;
  }
}

}  // namespace
}  // namespace thenar
