// Tests for api/named/hands.cpp.

#include "api/named/hands.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

TEST(FindHand, KnowsVersionsByTheirNamesAndByTheOldOnes) {
  const HandSource found = find_hand("human:soft", {kData});
  EXPECT_TRUE(found.human);
  EXPECT_EQ(found.version, HumanVersion::kSoftPads);
  EXPECT_EQ(find_hand("human:tier3", {kData}).version, HumanVersion::kSoftPads);
  EXPECT_EQ(find_hand("human", {kData}).version, HumanVersion::kTendonNet);
  EXPECT_EQ(find_hand("human:tier4:wrapped", {kData}).path, Path::kWrapped);
}

TEST(HandByName, WrapsUnlessItsNameOrTheOptionsSayOtherwise) {
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  const auto path_of = [&](const std::string& name) {
    return hand_by_name(name, {kData}, bare).path;
  };
  EXPECT_EQ(path_of("human:tendons"), Path::kWrapped);
  EXPECT_EQ(path_of("human:skewed"), Path::kWrapped);  // the rung of its motors' limits
  EXPECT_EQ(path_of("human:tendons:via"), Path::kViaPoint);
  bare.path = Path::kViaPoint;
  EXPECT_EQ(path_of("human:tendons"), Path::kViaPoint);
  EXPECT_EQ(path_of("human:tendons:wrapped"), Path::kWrapped);
}

TEST(FindHand, TakesSubjectsFromFiles) {
  const std::string file = std::string(kData) + "/subjects/mirakhorlo2016.toml";
  EXPECT_EQ(find_hand(file, {kData}).version,
            HumanVersion::kSkewedThumb);  // which wants no tendons
  EXPECT_EQ(find_hand(file + ":tendons", {kData}).version, HumanVersion::kTendonNet);
  EXPECT_EQ(find_hand(file + ":tendons", {kData}).file, file);
}

TEST(FindHand, RefusesWhatIsNoVersion) {
  EXPECT_THROW((void)find_hand("human:tier5", {kData}), InputError);
  EXPECT_THROW((void)find_hand("barrett:soft", {kData}), InputError);
  EXPECT_THROW((void)find_hand("human:soft:curved", {kData}), InputError);
}

TEST(FindHand, KnowsHandsWithoutPassiveMoments) {
  for (const auto& [name, path] :
       {std::pair{"human:tendons:passive-off", std::optional<Path>()},
        std::pair{"human:tier4:wrapped:passive-off", std::optional(Path::kWrapped)}}) {
    const HandSource source = find_hand(name, {kData});
    EXPECT_EQ(source.passive, PassiveMoments::kOff) << name;
    EXPECT_EQ(source.path, path) << name;
  }
  EXPECT_EQ(find_hand("human:tendons:wrapped", {kData}).passive, PassiveMoments::kOn);
  EXPECT_THROW((void)find_hand("human:tendons:passive-off:wrapped", {kData}), InputError);
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  const NamedHand on = hand_by_name("human:skewed", {kData}, bare),
                  off = hand_by_name("human:skewed:passive-off", {kData}, bare);
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(on.skeleton->coordinates());
  EXPECT_GT(on.hand->actuation(q).tau_0.norm(), 0.01);  // [N m]
  EXPECT_TRUE(off.hand->actuation(q).tau_0.isZero(0));
  EXPECT_EQ(off.name, "human:skewed:passive-off");
}

TEST(CurrentHandName, RenamesVersionsAlone) {
  EXPECT_EQ(current_hand_name("human:tier1"), "human:orthogonal");
  EXPECT_EQ(current_hand_name("a/b.toml:tier4:wrapped"), "a/b.toml:tendons:wrapped");
  EXPECT_EQ(current_hand_name("human:tier4:wrapped:passive-off"),
            "human:tendons:wrapped:passive-off");
  EXPECT_EQ(current_hand_name("human:skewed"), "human:skewed");
  EXPECT_EQ(current_hand_name("barrett"), "barrett");
  EXPECT_EQ(version_of_hand("human:tendons:wrapped"), ":tendons:wrapped");
  EXPECT_EQ(version_of_hand("barrett"), "");
}

}  // namespace
}  // namespace thenar
