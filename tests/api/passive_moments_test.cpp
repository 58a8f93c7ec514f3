// Passive moments of joints in answers about a digit.

#include <fstream>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "api/feasible_force.h"
#include "api/tip_force.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class PassiveAnswers : public TemporaryFolder {
 protected:
  /// A request for the index finger of human_hand, bent, or of its file without [[passive]].
  [[nodiscard]] DigitRequest index_of(bool with_tables, PassiveMoments passive) const {
    const std::string text = read_text_file(kData + "/subjects/human_hand.toml");
    const std::string without =
        std::regex_replace(text, std::regex(R"(\[\[passive\]\]\n([^\n]+\n)+)"), "");
    EXPECT_EQ(without.find("[[passive]]"), std::string::npos);
    const std::string file = path(with_tables ? "with.toml" : "without.toml");
    std::ofstream(file) << (with_tables ? text : without);
    DigitRequest request;
    request.subject = file;
    request.digit = "index";
    request.posture.named = {
        {"MCP2_FE", 60 * kDegree}, {"PIP2", 50 * kDegree}, {"DIP2", 30 * kDegree}};
    request.passive = passive;
    return request;
  }
  [[nodiscard]] Eigen::Vector3d force(const DigitRequest& digit, double tension) const {
    TipForceRequest request;
    request.digit = digit;
    request.tension = {{"FDP2", tension}};
    return compute_tip_force(request).points.front().force;
  }
};

TEST_F(PassiveAnswers, WithoutThemAreThoseOfASubjectThatStatesNone) {
  const DigitRequest off = index_of(true, PassiveMoments::kOff),
                     none = index_of(false, PassiveMoments::kOn);
  EXPECT_EQ(force(off, 10), force(none, 10));
  FeasibleForceRequest largest;
  largest.direction = Eigen::Vector3d(0, 0, -1);
  largest.digit = off;
  const double component = compute_feasible_force(largest).points.front().largest->component;
  largest.digit = none;
  EXPECT_EQ(component, compute_feasible_force(largest).points.front().largest->component);
  largest.digit = index_of(true, PassiveMoments::kOn);
  EXPECT_NE(component, compute_feasible_force(largest).points.front().largest->component);
}

// J' f = R' t + tau_0 is linear: what passive moments add to f hangs on no tension.
TEST_F(PassiveAnswers, AddTheSameForceAtAnyTension) {
  const DigitRequest on = index_of(true, PassiveMoments::kOn),
                     off = index_of(true, PassiveMoments::kOff);
  const Eigen::Vector3d slack = force(on, 0);
  EXPECT_GT(slack.norm(), 0.1);  // [N]
  EXPECT_TRUE(force(off, 0).isZero(0));
  EXPECT_TRUE(matrix_near(force(on, 20) - force(off, 20), slack, 1e-9));
}

}  // namespace
}  // namespace thenar
