// Tests for server/methods/motion_methods.cpp: requests as a client sends them.

#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "api/simulate.h"
#include "server/frame.h"
#include "server/methods/method_table.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

/// A session with the table, without transports.
class MotionMethods : public testing::Test {
 protected:
  MotionMethods() {
    internal::add_motion_methods(table_);
    internal::add_world_methods(table_);
    SessionFolders places;
    places.data = kData;
    session_ = std::make_unique<Session>(places);
  }

  OrderedJson call(const std::string& method, const Json& params = Json::object()) {
    const RpcMethod& row = table_.method_named(method);
    return row.handler(*session_, validated(row.params, params, "params"), {});
  }
  /// As call(), from text to text, as through a line.
  std::string call_text(const std::string& method, const std::string& params) {
    return json_text(call(method, Json::parse(params)), -1);
  }
  std::string refusal(const std::string& method, const Json& params = Json::object()) {
    return message_of([&] { (void)call(method, params); });
  }

  MethodTable table_;
  std::unique_ptr<Session> session_;
};

TEST_F(MotionMethods, ExamplesAreAnswered) {
  for (const RpcMethod& row : table_.methods()) {
    if (row.name == "motion.record" || row.name.rfind("motion.", 0) != 0) continue;
    SCOPED_TRACE(row.name);
    (void)call("motion.open", {{"scene", "pinch"}});
    EXPECT_NO_THROW((void)call(row.name, Json::parse(row.example)));
  }
}

TEST_F(MotionMethods, SayWhatIsNotOpen) {
  for (const char* method : {"motion.step", "motion.state", "motion.reset", "motion.inputs"})
    EXPECT_EQ(refusal(method), "no scene that moves is open: call motion.open or motion.record");
  EXPECT_THAT(refusal("motion.open", {{"scene", "pnch"}}), HasSubstr("pinch"));
}

// The cube of 100 g hangs between two balls: each bears half of its weight by friction.
TEST_F(MotionMethods, StateOfAPinchIsThatOfStatics) {
  (void)call("motion.open", {{"scene", "pinch"}, {"step", 0.002}});
  const OrderedJson reply =
      call("motion.step", {{"steps", 250}, {"want", {"joints", "bodies", "contacts", "energy"}}});
  EXPECT_EQ(reply["steps"], 250);
  EXPECT_EQ(reply["unsolved"], 0);
  EXPECT_LT(reply["worst_residual"].get<double>(), 1e-9);
  EXPECT_DOUBLE_EQ(reply["t"].get<double>(), 0.5);
  EXPECT_EQ(reply["joints"]["left"][2], 2.0);
  EXPECT_NEAR(reply["bodies"]["cube"]["position"][2].get<double>(), 0, 1e-9);
  ASSERT_EQ(reply["contacts"].size(), 2u);
  double up = 0;
  for (const OrderedJson& contact : reply["contacts"]) {
    EXPECT_EQ(contact["mode"], "stick");
    const double sign = contact["a"] == "cube" ? 1 : -1;
    up += sign * contact["force"][2].get<double>();
    EXPECT_NEAR(std::abs(contact["force"][0].get<double>()), 2, 1e-6);
  }
  EXPECT_NEAR(up, 0.1 * 9.81, 1e-6);
  EXPECT_NEAR(reply["energy"]["error"].get<double>(), 0, 1e-9);
  EXPECT_EQ(reply["energy_error"], reply["energy"]["error"]);
  EXPECT_EQ(reply["energy_balances"], true);
  EXPECT_GE(reply["energy_turned_over"].get<double>(), 0);
  EXPECT_TRUE(reply["limits_passed"].empty());
  EXPECT_EQ(reply["restitution_ignored"], 0.0);
}

TEST_F(MotionMethods, KeysEndInTheirUnits) {
  (void)call("motion.open", {{"scene", "pinch"}, {"step", 0.002}});
  const OrderedJson reply =
      call("motion.step", {{"steps", 2}, {"want", {"bodies", "contacts", "energy"}}});
  EXPECT_DOUBLE_EQ(reply["t_s"].get<double>(), 0.004);
  const auto same = [](const OrderedJson& of, const std::string& key, const std::string& unit) {
    ASSERT_TRUE(of.contains(key + unit)) << key;
    EXPECT_EQ(of[key], of[key + unit]) << key;
  };
  same(reply, "deepest", "_m");
  same(reply, "energy_error", "_J");
  same(reply["energy"], "kinetic", "_J");
  same(reply["bodies"]["cube"], "velocity", "_m_per_s");
  same(reply["bodies"]["cube"], "spin", "_rad_per_s");
  for (const OrderedJson& contact : reply["contacts"]) {
    same(contact, "force", "_N");
    same(contact, "torsion", "_N_m");
    same(contact, "gap", "_m");
  }
}

// A pendulum with a period of 0.96 s in steps of 100 ms: a tenth of its energy is made of nothing.
TEST_F(MotionMethods, SayThatEnergyDoesNotBalance) {
  (void)call("motion.open", {{"scene", "pendulum"}, {"step", 0.1}});
  (void)call("motion.step", {{"steps", 12}});
  const OrderedJson reply = call("motion.state", {{"want", OrderedJson::array()}});
  const double error = reply["energy_error"], turned_over = reply["energy_turned_over"];
  EXPECT_GT(std::abs(error), 0.01 * turned_over);
  EXPECT_EQ(reply["energy_balances"], false);
}

TEST_F(MotionMethods, AllInputsAreSetOrNone) {
  (void)call("motion.open", {{"scene", "pinch"}});
  EXPECT_THAT(refusal("motion.set", {{"efforts", {{"left", 9}, {"rigth", 1}}}}),
              HasSubstr("did you mean 'right'"));
  EXPECT_THAT(refusal("motion.set", {{"targets", {{"left", 0.1}}}}), HasSubstr("set its effort"));
  EXPECT_THAT(refusal("motion.step", {{"efforts", {{"left", "x"}}}}), HasSubstr("params.efforts"));
  EXPECT_EQ(call("motion.state")["joints"]["left"][2], 2.0);
  (void)call("motion.set", {{"efforts", {{"left", 9}}}});
  EXPECT_EQ(call("motion.state")["joints"]["left"][2], 9.0);
  (void)call("motion.set", {{"release", {"left"}}});
  EXPECT_EQ(call("motion.state")["joints"]["left"][2], 2.0);
}

TEST_F(MotionMethods, WorldsMoveAsTheyStand) {
  EXPECT_THAT(refusal("motion.open"), HasSubstr("call world.new or world.load"));
  (void)call("world.load", {{"world", "jaw_box"}});
  EXPECT_THAT(refusal("motion.open", {{"pads", "elements"}}), HasSubstr("no pads"));
  EXPECT_THAT(refusal("motion.open", {{"scene", "pinch"}, {"drives", "hold"}}),
              HasSubstr("of a world"));
  const OrderedJson opened = call("motion.open", {{"step", 0.002}, {"drives", "hold"}});
  EXPECT_EQ(opened["name"], "jaw_box");
  EXPECT_EQ(opened["step"], 0.002);
  EXPECT_EQ(session_->mode(), LiveMode::kMotion);
  const OrderedJson reply = call("motion.step", {{"steps", 100}, {"want", {"joints", "bodies"}}});
  EXPECT_EQ(reply["unsolved"], 0);
  EXPECT_GT(reply["joints"].size(), 0u);
}

TEST_F(MotionMethods, RefuseInputsFarOutOfSense) {
  (void)call("motion.open", {{"scene", "human_cylinder"}});
  const std::string joint = "human:skewed/PIP2", muscle = "human:skewed/index/FDP2";
  const std::vector<std::tuple<const char*, std::string, double, const char*>> refused{
      {"efforts", joint, 1e308, "-10000 to 10000"},
      {"targets", joint, -1e6, "-1000 to 1000"},
      {"tensions", muscle, -1, "0 to 5000"},
      {"tensions", muscle, 1e6, "0 to 5000"},
      {"excitations", muscle, 1.5, "0 to 1"}};
  for (const char* method : {"motion.set", "motion.step"})
    for (const auto& [kind, name, value, range] : refused) {
      // What comes along with it is not set either.
      Json params{{"efforts", {{"human:skewed/DIP2", 0.1}}}};
      params[kind][name] = value;
      EXPECT_THAT(
          refusal(method, params),
          testing::AllOf(HasSubstr("params." + std::string(kind) + "." + name), HasSubstr(range)))
          << method;
    }
  EXPECT_EQ(call("motion.state")["t"], 0.0);
  const OrderedJson inputs = call("motion.inputs");
  EXPECT_GT(inputs["inputs"].size(), 50U);
  for (const OrderedJson& input : inputs["inputs"]) {
    EXPECT_EQ(input["set"], nullptr) << input["name"];
  }
}

// The same requests have the same replies, to the last bit.
TEST_F(MotionMethods, RequestsRepeat) {
  const auto play = [&] {
    std::string all = call_text("motion.open", R"({"scene": "swinging_pinch"})");
    for (int i = 0; i < 40; ++i) {
      const double effort = 2 + 0.01 * i;
      const Json params{{"steps", 3},
                        {"efforts", {{"left", effort}, {"right", -effort}}},
                        {"want", {"joints", "bodies", "contacts", "energy"}}};
      all += json_text(call("motion.step", params), -1);
      if (i == 20) all += call_text("motion.seek", R"({"t": 0.03})");
      if (i == 30) all += call_text("motion.reset", "{}");
    }
    return all;
  };
  const std::string first = play();
  EXPECT_EQ(first, play());
}

TEST_F(MotionMethods, NumbersAreWholeDoubles) {
  (void)call("motion.open", {{"scene", "pendulum"}});
  const OrderedJson reply = call("motion.step", {{"steps", 7}});
  const Json read = Json::parse(json_text(reply, -1));
  EXPECT_EQ(read["joints"].begin().value()[0].get<double>(),
            reply["joints"].begin().value()[0].get<double>());
}

// What the page draws of a hand with tendons in one frame.
TEST_F(MotionMethods, FramesOfHandsWithTendonsAreSmall) {
  (void)call("motion.open", {{"scene", "human_cylinder"}, {"step", 0.002}});
  (void)call("motion.step", {{"steps", 20}});
  const LiveInstant instant = session_->shown_model()->instant();
  EXPECT_GT(instant.tensions.size(), 30u);
  EXPECT_LT(encode_frame(instant, 1, 1).size(), 4000u);
}

TEST_F(MotionMethods, RecordedMotionsOfDigitsAreShown) {
  DigitMotionRequest request;
  request.digit.subject = kData + "/subjects/an_chao_index.toml";
  request.excitation = {{"FDP", 0.2}};
  request.muscle = Muscle::kBounds;
  request.seconds = 0.02;
  const std::string file = testing::TempDir() + "recorded_digit.h5";
  write_motion(simulate_digit(request), file);
  const OrderedJson opened = call("motion.record", {{"file", file}});
  EXPECT_EQ(opened["name"], "an_chao_index/index");
  EXPECT_EQ(opened["duration"], 0.02);
  EXPECT_EQ(session_->mode(), LiveMode::kMotion);
  (void)call("motion.seek", {{"t", 0.01}});
  const OrderedJson state = call("motion.state", {{"want", {"joints", "muscles", "energy"}}});
  EXPECT_EQ(state["joints"].size(), 4u);
  EXPECT_EQ(state["joints"]["PIP2"][2], nullptr);
  EXPECT_GT(state["muscles"]["FDP"].get<double>(), 0);
  EXPECT_EQ(state["energy"]["kinetic"], nullptr);
  EXPECT_THAT(refusal("motion.set", {{"efforts", {{"PIP2", 1}}}}), HasSubstr("recorded run"));
  EXPECT_THAT(refusal("motion.record", {{"file", kData + "/scenes/pinch.toml"}}),
              HasSubstr("wanted a scene run or a motion"));
  std::remove(file.c_str());
}

// A digit's first contact divides a step: there it is stopped, and the motion stands before it.
TEST_F(MotionMethods, StopsWithinAStep) {
  (void)call("motion.open", {{"scene", "thumb_key"}});
  Json params{{"steps", 5}, {"want", Json::array()}};
  int asked = 0;
  Progress progress;
  progress.stop_requested = [&] { return ++asked == 20; };
  const RpcMethod& row = table_.method_named("motion.step");
  const OrderedJson reply =
      row.handler(*session_, validated(row.params, params, "params"), progress);
  EXPECT_EQ(asked, 20);
  EXPECT_LT(reply["steps"], 5);
  EXPECT_DOUBLE_EQ(reply["t"].get<double>(), 1e-3 * reply["steps"].get<double>());
  EXPECT_EQ(call("motion.step", {{"steps", 1}})["steps"], 1);
}

}  // namespace
}  // namespace thenar
