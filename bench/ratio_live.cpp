// What a person or a program waits for in a live session, against what the answer is made of.

#include <string>

#include "api/pads/press_pad.h"
#include "bench/ratios.h"
#include "live/live_digit.h"
#include "live/world/live_grasp.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "report/json.h"
#include "server/methods/method_table.h"

namespace thenar::bench {
namespace {

const std::string kLiveData = THENAR_DATA_DIR;

/// A request as a line holds it, and its answer as one.
std::string asked(Session& session, const MethodTable& table, const std::string& method,
                  const std::string& params) {
  const RpcMethod& row = table.method_named(method);
  return json_text(row.handler(session, validated(row.params, Json::parse(params), "params"), {}),
                   -1);
}

}  // namespace

Row ratio_closed_loop() {
  SessionFolders places;
  places.data = kLiveData;
  Session session(places);
  const MethodTable table = method_table();
  (void)asked(session, table, "motion.open", R"({"scene": "pinch", "step": 0.002})");
  const auto ask = [&](const char* params) { keep(asked(session, table, "motion.step", params)); };
  const char* const inputs =
      R"({"efforts": {"left": 2.5, "right": -2.5}, "want": ["joints", "bodies"]})";
  ask(inputs);
  Duel duel{"closed loop of pinch: step alone", {}, {}, 0.1, 0, 0};
  duel.ours = [=] { ask(inputs); };
  duel.rival = [=] { ask(R"({"steps": 1, "want": []})"); };
  return measure(duel, {21, 0.01});
}

Row ratio_digit_slider() {
  DigitRequest request;
  request.subject = kLiveData + "/subjects/synek2019_middle.toml";
  request.hood = Hood::kFloatingNet;
  LiveDigit digit(request);
  const DigitInputs pulled{{{"MCP3_FE", 0.3}, {"PIP3", 0.5}, {"DIP3", 0.2}},
                           {{"EDC", 2.9}, {"LU", 0.4}, {"FDP", 5}},
                           {}};
  digit.set(pulled);
  Duel duel{"slider of a digit with a net: built anew", {}, {}, 5, 0, 0};
  duel.ours = [&, k = 0]() mutable {
    digit.set({{{"PIP3", 0.02 * (k++ % 60)}}, {}, {}});
    keep(digit.instant());
  };
  duel.rival = [&] {
    LiveDigit anew(request);
    anew.set(pulled);
    keep(anew.instant());
  };
  return measure(duel, {21, 0.02});
}

Row ratio_hand_instant() {
  LiveWorld live({kLiveData, "."});
  (void)load_world(live, "human_mug");
  (void)grasp_object(live, {}, 1);
  const WorldState held = live.state();
  Duel duel{"instant of a held mug: to grasp it", {}, {}, 3, 0, 0};
  duel.ours = [&, k = 0]() mutable {
    const Eigen::Vector3d by(0, 0, 1e-6 * (k++ % 2));  // contacts are found anew
    place_thing(live, "mug", held.bodies[0].X_WB.p + by, {});
    keep(live.instant());
  };
  duel.rival = [&] {
    (void)load_world(live, "human_mug");
    keep(grasp_object(live, {}, 1));
  };
  return measure(duel, {5, 0.02});
}

Row ratio_pad_laws() {
  PressRequest request;
  request.pad.pad = kLiveData + "/pads/index_pad.toml";
  request.force_error = 0.2;
  request.points = 1;
  request.depth = 1e-3;
  request.object.name = "sphere";
  const PressResult pressed = press_pad(request);
  Progress laws_alone;
  laws_alone.stop_requested = [] { return true; };
  Duel duel{"five laws of a pad: its elements", {}, {}, 1, 0, 0};
  duel.ours = [&] { keep(compare_rungs(pressed, laws_alone)); };
  duel.rival = [&] { keep(press_pad(request)); };
  return measure(duel, {3, 0.02});
}

}  // namespace thenar::bench
