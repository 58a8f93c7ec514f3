// Tests for live/recorded_digit_motion.cpp, digit_picture.cpp and api/read_motion.cpp.

#include "live/recorded_digit_motion.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/simulate.h"
#include "base/units.h"
#include "data/io/result_file.h"
#include "live/live_digit.h"
#include "tests/data_folder.h"
#include "tests/live/changed_result.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

DigitMotionRequest flexing_index(const std::string& net = "") {
  DigitMotionRequest request;
  request.digit.subject = kData + "/subjects/an_chao_index.toml";
  request.digit.net = net;
  request.excitation = {{"FDP", 0.2}, {"EDC", 0.1}};
  request.muscle = Muscle::kBounds;
  request.seconds = 0.04;
  return request;
}

/// Every number of an instant, but the time and the forces at the tip.
std::vector<double> numbers_of(const LiveInstant& instant) {
  std::vector<double> all;
  for (const Pose<double>& pose : instant.bodies) {
    all.insert(all.end(), pose.p.begin(), pose.p.end());
    for (const double r : pose.R.reshaped()) all.push_back(r);
  }
  all.insert(all.end(), instant.joints.begin(), instant.joints.end());
  for (const Eigen::Vector3d& p : instant.line_points) all.insert(all.end(), p.begin(), p.end());
  for (const double t : instant.tensions) all.push_back(std::isnan(t) ? -1 : t);
  return all;
}

class RecordedDigitFile : public TemporaryFolder {
 protected:
  DigitMotionResult record(const DigitMotionRequest& request) const {
    DigitMotionResult motion = simulate_digit(request);
    write_motion(motion, path("motion.h5"));
    return motion;
  }
  [[nodiscard]] RecordedDigit read() const { return read_motion(path("motion.h5")); }
  /// What reading says once something in the file is another one.
  template <typename Change>
  std::string trouble_with(const Change& change) const {
    return trouble_with_change(
        path("motion.h5"), path("changed.h5"), change,
        [](const std::string& file) { (void)RecordedDigitMotion(read_motion(file)).instant(); });
  }
};

// The picture is that of a live digit which is put into the same posture under the same tensions.
TEST_F(RecordedDigitFile, ShowsWhatALiveDigitShows) {
  for (const std::string net : {"", "chao_an"}) {
    SCOPED_TRACE("net '" + net + "'");
    DigitMotionRequest request = flexing_index(net);
    // Far from limits, at which a live digit would end.
    request.digit.posture.named = {{"MCP2_FE", 0.4}, {"PIP2", 0.4}, {"DIP2", 0.4}};
    request.seconds = 0.012;
    request.sample = 1e-3;
    const DigitMotionResult motion = record(request);
    const Trajectory& t = motion.trajectory;
    RecordedDigitMotion recorded(read());
    DigitRequest same = request.digit;
    if (net.empty()) same.hood = Hood::kFractions;
    LiveDigit live(same);
    ASSERT_EQ(recorded.shape().lines.size(), live.shape().lines.size());
    ASSERT_EQ(recorded.shape().bodies.size(), live.shape().bodies.size());
    for (const Eigen::Index i : {Eigen::Index{0}, t.time.size() / 2, t.time.size() - 1}) {
      (void)recorded.seek(t.time[i]);
      DigitInputs inputs;
      for (std::size_t j = 0; j < t.joints.size(); ++j)
        inputs.posture[t.joints[j]] = t.angle(i, static_cast<Eigen::Index>(j));
      for (std::size_t m = 0; m < t.muscles.size(); ++m)
        inputs.tension[t.muscles[m]] = t.tension(i, static_cast<Eigen::Index>(m));
      ASSERT_THAT(live.set(inputs), testing::IsEmpty()) << i;
      const LiveInstant instant = recorded.instant();
      EXPECT_NO_THROW(check_instant(recorded.shape(), instant));
      EXPECT_EQ(instant.time, t.time[i]);
      const std::vector<double> got = numbers_of(instant), wanted = numbers_of(live.instant());
      ASSERT_EQ(got.size(), wanted.size());
      for (std::size_t k = 0; k < got.size(); ++k) EXPECT_NEAR(got[k], wanted[k], 1e-9);
    }
  }
}

TEST_F(RecordedDigitFile, TellsTheNumbersOfTheMotion) {
  const DigitMotionResult motion = record(flexing_index());
  const Trajectory& t = motion.trajectory;
  RecordedDigitMotion recorded(read());
  EXPECT_EQ(recorded.live_time().duration, 0.04);
  EXPECT_TRUE(recorded.live_time().recorded);
  const Eigen::Index i = 3;
  EXPECT_EQ(recorded.seek(t.time[i]), t.time[i]);
  const TimelineState state = recorded.state({true, true, true, true, true});
  ASSERT_EQ(state.joints.size(), t.joints.size());
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    EXPECT_EQ(state.joints[j].name, t.joints[j]);
    EXPECT_EQ(state.joints[j].value, t.angle(i, static_cast<Eigen::Index>(j)));
    EXPECT_EQ(state.joints[j].rate, t.speed(i, static_cast<Eigen::Index>(j)));
  }
  ASSERT_EQ(state.muscles.size(), 2 * t.muscles.size());
  EXPECT_EQ(state.muscles[4].name, "FDP");
  EXPECT_EQ(state.muscles[4].value, t.tension(i, 2));
  EXPECT_EQ(state.muscles[5].name, "FDP activation");
  EXPECT_EQ(state.muscles[5].value, t.activation(i, 2));
  EXPECT_GT(state.muscles[5].value, 0);
  EXPECT_EQ(state.energy->total, t.energy[i]);
  EXPECT_NEAR(state.energy->balance->error, -energy_drift(t)[i], 1e-15);
  // Half way between two instants, numbers are half way between theirs.
  (void)recorded.seek(0.5 * (t.time[i] + t.time[i + 1]));
  EXPECT_NEAR(recorded.state({true, false, false, false, false}).joints[1].value,
              0.5 * (t.angle(i, 1) + t.angle(i + 1, 1)), 1e-12);
}

TEST_F(RecordedDigitFile, BuildsFrozenJointsAgain) {
  DigitMotionRequest request = flexing_index();
  request.digit.frozen.named = {{"PIP2", 30 * kDegree}};
  const DigitMotionResult motion = record(request);
  const RecordedDigit got = read();
  EXPECT_EQ(got.tendons->digit().names.coordinates, motion.trajectory.joints);
  EXPECT_THAT(trouble_with([](ResultFile& file) {
                file.arrays.at("rungs/frozen_angle").values[0] = 10 * kDegree;
              }),
              HasSubstr("the tip of its digit"));
}

// Files from before rungs were kept have words for them in their provenance.
TEST_F(RecordedDigitFile, ReadsFilesWithoutRungs) {
  for (const std::string net : {"", "chao_an"}) {
    (void)record(flexing_index(net));
    EXPECT_EQ(trouble_with([](ResultFile& file) {
                for (const char* key : {"rungs/path", "rungs/hood", "rungs/wrist"})
                  file.texts.erase(key);
              }),
              "nothing was thrown");
  }
}

TEST_F(RecordedDigitFile, RefusesWhatDoesNotFitTogether) {
  (void)record(flexing_index());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(trouble_with([](ResultFile&) {}), "nothing was thrown");
  EXPECT_THAT(trouble_with(set_number("time", 2, nan)), HasSubstr("'time'"));
  EXPECT_THAT(trouble_with(set_number("time", 2, 0)), HasSubstr("does not rise"));
  EXPECT_THAT(trouble_with(set_number("angle", 5, nan)), HasSubstr("'angle': it has numbers"));
  EXPECT_THAT(trouble_with(set_number("angle", 5, 1e300)), HasSubstr("'angle': wanted up to"));
  EXPECT_THAT(trouble_with(set_number("angle", 5, 0.5)), HasSubstr("the tip of its digit"));
  EXPECT_THAT(trouble_with(set_number("tension", 0, -1)), HasSubstr("'tension': wanted 0 to"));
  EXPECT_THAT(trouble_with(set_number("tension", 0, 1e9)), HasSubstr("'tension': wanted 0 to"));
  EXPECT_THAT(trouble_with(set_number("speed", 0, nan)), HasSubstr("'speed'"));
  for (const char* key :
       {"time", "angle", "speed", "activation", "tension", "tip", "energy", "work", "lost"}) {
    EXPECT_THAT(trouble_with([&](ResultFile& file) { file.arrays.erase(key); }), HasSubstr(key));
    EXPECT_THAT(trouble_with([&](ResultFile& file) {
                  ResultArray& array = file.arrays.at(key);
                  array.values.resize(array.values.size() / array.shape[0]);
                  array.shape[0] = 1;
                }),
                HasSubstr("wanted"))
        << key;
  }
  EXPECT_THAT(trouble_with(set_text("format", "thenar scene run 1")), HasSubstr("it is missing"));
  EXPECT_THAT(trouble_with(set_text("digit", "thumb")), HasSubstr("cannot be built again"));
  EXPECT_THAT(trouble_with(set_text("rungs/hood", "silk")), HasSubstr("cannot be built again"));
  EXPECT_THAT(trouble_with(set_text("rungs/hood", "floating net")), HasSubstr("text of its net"));
  EXPECT_THAT(trouble_with(set_text("inputs/1/text", "name = 3")),
              HasSubstr("cannot be built again"));
  EXPECT_THAT(trouble_with([](ResultFile& file) { file.texts.erase("inputs/1/text"); }),
              HasSubstr("does not keep the text"));
  EXPECT_THAT(trouble_with([](ResultFile& file) { file.texts.erase("name/joint"); }),
              HasSubstr("name/joint"));
  EXPECT_THAT(trouble_with([](ResultFile& file) { file.texts.at("name/muscle")[0] = "biceps"; }),
              HasSubstr("biceps"));
  EXPECT_THAT(trouble_with(set_text("name/frozen", "PIP2")),
              HasSubstr("'rungs/frozen_angle': it is missing"));
}

TEST_F(RecordedDigitFile, SaysHowTheMotionEnded) {
  (void)record(flexing_index());
  EXPECT_TRUE(read().warnings.empty());
  ResultFile file = read_result(path("motion.h5"));
  file.texts["status"] = {"stuck"};
  file.texts["trouble"] = {"no step was found"};
  write_result(file, path("motion.h5"));
  EXPECT_THAT(read().warnings,
              testing::ElementsAre("the motion ended so: stuck", "no step was found"));
}

}  // namespace
}  // namespace thenar
