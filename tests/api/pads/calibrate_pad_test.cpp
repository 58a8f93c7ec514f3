// Tests for api/pads/calibrate_pad.cpp.

#include "api/pads/calibrate_pad.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/pad/law_file.h"
#include "data/io/pad/pad_digest.h"
#include "tests/api/pads/small_presses.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::HasSubstr;

class CalibratePad : public TemporaryFolder {
 protected:
  /// Few presses on few cells: with fewer, patches are so rough that no bed fits them.
  [[nodiscard]] PadLawsRequest request(const std::string& more = "") const {
    std::ofstream(path("pad.toml")) << sample::pad_text(12, 1.5) << more;
    PadLawsRequest out;
    out.pad.pad = path("pad.toml");
    out.depths = {0.8e-3, 1.6e-3};
    out.force_error = 0.1;
    out.max_penetration = 1;
    out.max_elements = 1000;
    return out;
  }
};

TEST_F(CalibratePad, FindsLawsThatTheirPadIsTakenWith) {
  std::vector<double> shares;
  Progress progress;
  progress.report = [&](double share, const std::string&) { shares.push_back(share); };
  const PadLaws found = calibrate_pad(request(), progress);
  EXPECT_EQ(refusal_of(found), "") << found.calibration.message;
  const CalibratedLaws& laws = found.calibration.laws;
  EXPECT_EQ(laws.evidence.fitted, 10);
  EXPECT_EQ(laws.evidence.checked, 6);
  ASSERT_EQ(found.presses.size(), 16U);
  EXPECT_THAT(found.outcome.warnings,
              Contains(HasSubstr("is assumed, not measured, in 2 numbers")));
  // As far as their errors say, laws have the force of the presses that were checked.
  for (const LawPress& press : found.presses) {
    ASSERT_TRUE(press.laws.has_value());
    if (press.fitted) continue;
    const double force = press.elements.force;
    EXPECT_LE(std::abs(press.laws->power / force - 1), laws.power_error.force.worst + 1e-12);
    EXPECT_LE(std::abs(press.laws->bed / force - 1), laws.bed_error.force.worst + 1e-12);
  }
  // The file is of this pad.
  const CalibratedLaws read = parse_laws(pad_laws_text(found), "laws.toml");
  EXPECT_EQ(read.name, "pad");
  EXPECT_EQ(read.soft_finger.force, laws.soft_finger.force);
  EXPECT_EQ(version_doubt(read, found.pad.spec), "");
  EXPECT_EQ(read.pad_digest, pad_digest(found.pad.spec));
  // Press by press, forward.
  EXPECT_GE(shares.size(), 16U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1);
}

TEST_F(CalibratePad, StopsWithThePressesByThen) {
  Progress progress;
  int presses = 0;
  progress.report = [&](double, const std::string&) { ++presses; };
  progress.stop_requested = [&] { return presses > 3; };
  const PadLaws found = calibrate_pad(request(), progress);
  EXPECT_TRUE(found.outcome.stopped());
  EXPECT_EQ(refusal_of(found), "");
  EXPECT_EQ(found.presses.size(), 3U);
  EXPECT_FALSE(found.has_laws());
  EXPECT_THROW((void)pad_laws_text(found), InputError);
}

TEST_F(CalibratePad, WarnsOfPressesThatFailedAndRefusesTooFew) {
  PadLawsRequest shallow = request();
  shallow.depths = {1e-6};  // one node touches, two at most
  shallow.force_error = 0.99;
  shallow.max_elements = 1;
  const PadLaws found = calibrate_pad(shallow);
  EXPECT_FALSE(found.has_laws());
  EXPECT_FALSE(found.calibration.failures.empty());
  EXPECT_THAT(found.outcome.warnings, Contains(HasSubstr("a press failed and was left out")));
  EXPECT_THAT(refusal_of(found), HasSubstr("laws need 4 and 2"));
}

TEST_F(CalibratePad, RefusesNonsense) {
  PadLawsRequest bad = request();
  for (const double error : {0.0, 1.0}) {
    bad.force_error = error;
    EXPECT_THAT(message_of([&] { (void)calibrate_pad(bad); }), HasSubstr("below 100 %, got"));
  }
  bad = request();
  bad.depths = {2e-3, 1e-3};
  EXPECT_THAT(message_of([&] { (void)calibrate_pad(bad); }), HasSubstr("depths above 0 that rise"));
}

}  // namespace
}  // namespace thenar
