// Tests for server/methods/tendon_methods.cpp and fit_methods.cpp: what clients get and may not
// ask.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "api/fit.h"
#include "base/error.h"
#include "live/live_digit.h"
#include "live/live_fit.h"
#include "server/methods/method_table.h"
#include "tests/api/small_fit.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

class LiveClient : public sample::SmallFit {
 protected:
  OrderedJson call(const std::string& method, const Json& params) {
    const RpcMethod& row = table_.method_named(method);
    return row.handler(session_, validated(row.params, params, "params"), {});
  }
  OrderedJson call(const std::string& method, const char* params) {
    return call(method, Json::parse(params));
  }
  std::string refusal(const std::string& method, const char* params) {
    return message_of([&] { (void)call(method, params); });
  }
  void open_middle(const std::string& more = "") {
    (void)call("tendons.open", (R"({"subject": "synek2019_middle")" + more + "}").c_str());
  }

  MethodTable table_ = method_table();
  Session session_{{kData, "."}};
};

using TendonMethods = LiveClient;

TEST_F(TendonMethods, GiveSlidersTheirNamesLimitsAndValues) {
  open_middle();
  const OrderedJson state = call("tendons.state", "{}");
  const auto& digit = session_.model<LiveDigit>(LiveMode::kTendons);
  const TendonDigit& bones = digit.digit_case().bones();
  ASSERT_EQ(state["joints"].size(), bones.names.hinges.size());
  EXPECT_EQ(state["joints"][0]["name"], bones.names.hinges[0]);
  EXPECT_EQ(state["joints"][0]["lower"], bones.skeleton.limits[0].lower);
  ASSERT_EQ(state["muscles"].size(), bones.names.muscles.size());
  EXPECT_EQ(state["muscles"][0]["max_force"], bones.max_tension[0]);
  EXPECT_TRUE(state["muscles"][0]["excitation"].is_null());
  EXPECT_EQ(session_.mode(), LiveMode::kTendons);
}

// Power: arms times joint speeds is the rate at which tendons shorten, also through the message.
TEST_F(TendonMethods, TellTorqueThatIsArmsTimesTensions) {
  open_middle(R"(, "hood": "fractions")");
  const OrderedJson state =
      call("tendons.set", R"({"posture": {"PIP3": 0.5}, "tensions": {"EDC": 3, "FDP": 5}})");
  for (const auto& [joint, torque] : state["torques"].items()) {
    double sum = 0;
    for (const OrderedJson& muscle : state["muscles"])
      sum += muscle["arms"][joint].get<double>() * muscle["tension"].get<double>();
    EXPECT_NEAR(torque.get<double>(), sum, 1e-12) << joint;
  }
  EXPECT_EQ(state["trusted"], true);
  // Both directions of the force have one length.
  const auto f = state["tip_force"].get<std::vector<double>>();
  const OrderedJson& own = state["tip_force_axes"];
  EXPECT_NEAR(std::hypot(f[0], f[1], f[2]),
              std::hypot(own["proximal"].get<double>(), own["dorsal"].get<double>(),
                         own["radial"].get<double>()),
              1e-12);
}

TEST_F(TendonMethods, SayWhichBandsAreSlack) {
  open_middle(R"(, "net": "winslow")");
  OrderedJson state = call("tendons.state", "{}");
  EXPECT_EQ(state["net"], "winslow");
  for (const OrderedJson& band : state["bands"]) EXPECT_EQ(band["slack"], true) << band["name"];
  state = call("tendons.set", R"({"tensions": {"EDC": 5}})");
  const auto taut = std::count_if(state["bands"].begin(), state["bands"].end(),
                                  [](const OrderedJson& band) { return band["slack"] == false; });
  EXPECT_GT(taut, 3);
}

TEST_F(TendonMethods, SayWhatWasLimited) {
  open_middle();
  const OrderedJson state = call("tendons.set", R"({"posture": {"PIP3": 6, "DIP3": 0.2}})");
  EXPECT_EQ(state["limited"], OrderedJson({"PIP3"}));
  for (const OrderedJson& joint : state["joints"])
    if (joint["name"] == "PIP3") {
      EXPECT_EQ(joint["value"], joint["upper"]);
    }
}

TEST_F(TendonMethods, SweepOverTheRangeOfAJoint) {
  open_middle(R"(, "hood": "separate")");
  const OrderedJson curves =
      call("tendons.sweep", R"({"joint": "PIP3", "count": 11, "what": ["arms"]})");
  EXPECT_EQ(curves["x"].size(), 11U);
  EXPECT_FALSE(curves.contains("lengths"));
  const auto& digit = session_.model<LiveDigit>(LiveMode::kTendons);
  const DigitCurves expected = digit.sweep("PIP3", 11);
  const std::vector<std::string>& muscles = digit.digit_case().bones().names.muscles;
  for (std::size_t m = 0; m < muscles.size(); ++m)
    EXPECT_EQ(curves["arms"][muscles[m]][4], expected.arms(static_cast<Eigen::Index>(m), 4));
}

TEST_F(TendonMethods, RefuseWhatCannotBe) {
  EXPECT_THAT(refusal("tendons.state", "{}"), HasSubstr("call tendons.open"));
  EXPECT_THAT(refusal("tendons.open", R"({"subject": "synek2019_midle"})"),
              HasSubstr("synek2019_middle"));
  EXPECT_THAT(refusal("tendons.open", R"({"subject": "human_hand"})"), HasSubstr("thumb"));
  EXPECT_THAT(refusal("tendons.open", R"({"subject": "synek2019_middle", "hood": "nett"})"),
              HasSubstr("one of separate, fractions, net"));
  EXPECT_THAT(refusal("tendons.open",
                      R"({"subject": "synek2019_middle", "hood": "separate", "net": "winslow"})"),
              HasSubstr("needs a hood that is a net"));
  open_middle();
  EXPECT_THAT(refusal("tendons.set", R"({"tensions": {"EDC": -1}})"), HasSubstr("from 0 to"));
  EXPECT_THAT(refusal("tendons.set", R"({"posture": {"PIP2": 0}})"), HasSubstr("PIP3"));
  EXPECT_THAT(refusal("tendons.set", R"({"posture": {"PIP3": "x"}})"), HasSubstr("[rad]"));
  EXPECT_THAT(refusal("tendons.set", R"({"tension": {"EDC": 1}})"), HasSubstr("tensions"));
  EXPECT_THAT(refusal("tendons.set", R"({"tensions": {"EDC": 1}, "excitations": {"EDC": 1}})"),
              HasSubstr("got both"));
  EXPECT_THAT(refusal("tendons.sweep", R"({"joint": "PIP3", "count": 1})"), HasSubstr("from 2"));
  EXPECT_THAT(refusal("tendons.sweep", R"({"joint": "PIP9"})"), HasSubstr("PIP3"));
}

TEST_F(TendonMethods, TakeTheirOwnExamples) {
  for (const char* name : {"tendons.open", "tendons.set", "tendons.state", "tendons.sweep"})
    EXPECT_FALSE(call(name, table_.method_named(name).example.c_str()).empty()) << name;
}

using FitMethods = LiveClient;

TEST_F(FitMethods, TellTrialsAndMoveToOne) {
  FitRequest request;
  request.sources = sources();
  request.output = path("fit.h5");
  (void)fit_digit(request);
  EXPECT_THAT(refusal("fit.state", "{}"), HasSubstr("call fit.open"));
  const OrderedJson state = call("fit.open", Json{{"file", path("fit.h5")}});
  EXPECT_EQ(state["kind"], "fit");
  const auto& fit = session_.model<LiveFit>(LiveMode::kFit);
  ASSERT_EQ(state["trials"].size(), fit.trials().size());
  const OrderedJson& last = state["trials"].back();
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(last["residual"][i].get<double>(),
                last["predicted"][i].get<double>() - last["measured"][i].get<double>(), 1e-15);
  const OrderedJson shown = call("fit.trial", Json{{"trial", last["trial"]}});
  EXPECT_EQ(shown["measured"], last["measured"]);
  EXPECT_EQ(call("fit.state", "{}")["trial"], last["trial"]);
  EXPECT_THAT(refusal("fit.trial", R"({"trial": 5000})"), HasSubstr("counted from 0"));
  EXPECT_THAT(refusal("fit.trial", R"({"trial": -1})"), HasSubstr("from 0"));
  EXPECT_THAT(refusal("fit.trial", R"({"trial": 0.5})"), HasSubstr("whole number"));
  // Neighbouring axes of a fit have no interval.
  for (const OrderedJson& pair : state["pairs"])
    EXPECT_EQ(pair["angle"]["lower"], pair["angle"]["upper"]);
}

}  // namespace
}  // namespace thenar
