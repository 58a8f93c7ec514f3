// Tests for data/io/pad/law_file.cpp.

#include "data/io/pad/law_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/numbers.h"
#include "tests/data/broken_files.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

CalibratedLaws some_laws() {
  CalibratedLaws laws;
  laws.name = "a pad";
  laws.pad_digest = std::string(32, '0') + std::string(32, 'f');
  laws.power = {0.1 + 0.2, 1.9, 4e-3, 1.0 / 3, 0.6};
  laws.soft_finger = {1.0 / 3, 1.8, 0.4, 4e-3, 0.22, -0.3, 0.55, 0.6};
  laws.foundation = {2e4 / 3, 0.8, 6, 0.5, 1.4, 5e-3, 7e3};
  laws.relaxation = {{0.1, 0.1 / 3}, {0.2, 1.4}};
  laws.bed_error.force = {0.01, 0.02};
  laws.power_error.torsion = {0.3, 1.0 / 7};
  laws.evidence = {20, 12, 2e-3, 1.7, 0.04};
  return laws;
}

TEST(LawFile, EveryBitComesBack) {
  const CalibratedLaws before = some_laws();
  const std::string text = laws_text(before, "made up");
  const CalibratedLaws after = parse_laws(text, "laws.toml");
  EXPECT_EQ(laws_text(after, "made up"), text);
  EXPECT_EQ(after.pad_digest, before.pad_digest);
  EXPECT_EQ(after.power.force, before.power.force);
  EXPECT_EQ(after.soft_finger.patch_radius, before.soft_finger.patch_radius);
  EXPECT_EQ(after.foundation.modulus, before.foundation.modulus);
  EXPECT_EQ(after.foundation.shear, before.foundation.shear);
  EXPECT_EQ(after.relaxation[0].time, before.relaxation[0].time);
  EXPECT_EQ(after.power_error.torsion.worst, before.power_error.torsion.worst);
  EXPECT_EQ(after.evidence.checked, before.evidence.checked);
  EXPECT_EQ(after.evidence.force_error, before.evidence.force_error);
}

TEST(LawFile, NeedsNoDigestOfItsPad) {
  CalibratedLaws laws = some_laws();
  laws.pad_digest.clear();
  const std::string text = laws_text(laws, "made up");
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("pad_digest")));
  EXPECT_EQ(parse_laws(text, "laws.toml").pad_digest, "");
}

using LawFiles = TemporaryFolder;

TEST_F(LawFiles, AreWrittenAndRead) {
  write_file(path("pad.toml"), laws_text(some_laws(), "made up"));
  EXPECT_EQ(read_laws(path("pad.toml")).name, "a pad");
  EXPECT_THROW((void)read_laws(path("none.toml")), DataError);
}

TEST_F(LawFiles, BrokenOnesDoNoHarm) {
  expect_no_harm(laws_text(some_laws(), "made up"), path("pad.toml"),
                 [](const std::string& file) { (void)read_laws(file); });
}

/// The message when one line of a good file is another.
std::string complaint(const std::string& line, const std::string& instead) {
  std::string text = laws_text(some_laws(), "made up");
  const std::size_t at = text.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  text.replace(at, line.size(), instead);
  return message_of<DataError>([&] { (void)parse_laws(text, "pad.toml"); });
}

TEST(LawFile, MistakesAreNamedByTheirLine) {
  EXPECT_THAT(complaint("fitted = 20", "fitted = 2.5"),
              testing::AllOf(testing::StartsWith("pad.toml:9: "), testing::HasSubstr("whole")));
  EXPECT_THAT(complaint("pad_digest = \"0", "pad_digest = \"g"),
              testing::AllOf(testing::StartsWith("pad.toml:2: "), testing::HasSubstr("64 hexa")));
  EXPECT_THAT(complaint("share = 0.1", "share = 0.9"), testing::HasSubstr("less than 1"));
  EXPECT_THAT(complaint("torsion = 0.6", "torsion = 2"), testing::HasSubstr("[0, 1]"));
  EXPECT_THAT(complaint("spread = 1.4", "spread = 0.4"), testing::HasSubstr("1 or more"));
  EXPECT_THAT(complaint("modulus_Pa", "modulus_mm"), testing::HasSubstr("modulus"));
  EXPECT_THAT(complaint("[soft_finger]", "[hard_finger]"), testing::HasSubstr("soft_finger"));
  EXPECT_THAT(complaint("force_error = 0.04", "force_error = nan"), testing::StartsWith("pad"));
}

TEST(LawFile, OnlyGoodLawsAreWritten) {
  CalibratedLaws laws = some_laws();
  laws.power.patch_exponent = 0.5;
  EXPECT_THROW((void)laws_text(laws, "made up"), InputError);
  laws = some_laws();
  laws.bed_error.force.rms = kNaN;
  EXPECT_THROW((void)laws_text(laws, "made up"), InputError);
  EXPECT_THROW((void)laws_text(some_laws(), ""), InputError);
}

}  // namespace
}  // namespace thenar
