// hand.*: joints, and the actions open, approach, close and grasp.

#include <nlohmann/json.hpp>

#include "base/field_names.h"
#include "grasp/closing/describe_grasp.h"
#include "live/world/live_quality.h"
#include "live/world/world_edits.h"
#include "report/answers/grasp.h"
#include "server/methods/method_table.h"
#include "server/methods/world_requests.h"

namespace thenar::internal {

namespace {

/// Returns the outcome of a closing, and the reason why each joint stopped, as JSON.
OrderedJson closing_json(const LiveWorld& live, const LivePair& pair, const HandClosing& closing) {
  OrderedJson stopped = OrderedJson::array();
  const GraspResult standing = current_grasp(live, pair);
  for (const JointRow& row : joint_rows(standing))
    stopped.push_back({{"joint", row.name}, {"by", row.stopped_by}, {"why", row.reason}});
  Grasp closed{};
  closed.outcome = closing.outcome;
  closed.approached = closing.approached;
  closed.closed = closing.closed;
  closed.contacts = standing.grasp.contacts;
  closed.quality = standing.grasp.quality;
  return {{"outcome", name_of(closing.outcome)},
          {"explanation", describe_outcome(closed)},
          {"stopped", stopped}};
}

OrderedJson joint_list(const LiveWorld& live, std::size_t index) {
  const StateHand& hand = live.state().hands[index];
  const HandLayout& layout = hand.built->model().layout();
  // Find the sliding joints: the units of values depend on it.
  std::vector<bool> slides(layout.coordinates.size(), false);
  for (const HandJoint& joint : hand.built->joints) slides[joint.coordinate] = joint.slides;
  OrderedJson list = OrderedJson::array();
  for (std::size_t c = 0; c < layout.coordinates.size(); ++c) {
    const int leader = hand.built->couplings[c].leader;
    list.push_back({{"name", layout.coordinates[c]},
                    {"field", field_name(layout.coordinates[c])},
                    {"value", hand.placement.q[c]},
                    {"lower", number_or_null(layout.lower[c])},
                    {"upper", number_or_null(layout.upper[c])},
                    {"slides", bool(slides[c])},
                    {"led_by", leader < 0 ? Json() : Json(layout.coordinates[leader])}});
  }
  return list;
}

OrderedJson get_joints(Session& session, const Json& params, const Progress& /*progress*/) {
  const LiveWorld& live = live_world(session);
  const std::size_t hand = hand_index(live.state(), text_param(params, "hand"));
  return {{"hand", hand_name(live.state(), live.state().hands[hand])},
          {"joints", joint_list(live, hand)}};
}

OrderedJson put_joints(Session& session, const Json& params, const Progress& /*progress*/) {
  const JointChange set =
      set_joints(live_world(session), text_param(params, "hand"), named_numbers(params, "joints"),
                 text_param(params, "gesture"));
  return {{"joints", set.joints}, {"limited", set.limited}, {"parted", set.parted}};
}

OrderedJson open(Session& session, const Json& params, const Progress& /*progress*/) {
  LiveWorld& live = live_world(session);
  const std::string hand = text_param(params, "hand");
  open_hand(live, hand);
  return {{"joints", joints_of(live.state(), hand_index(live.state(), hand))}};
}

OrderedJson approach(Session& session, const Json& params, const Progress& progress) {
  const ApproachResult met = approach_object(live_world(session), pair_param(params),
                                             params["distance"].get<double>(), progress);
  const std::string outcome = !met.overlaps.empty() ? "overlaps" : met.touches ? "met" : "missed";
  return {{"outcome", outcome},
          {"body", met.touches ? Json(met.body) : Json()},
          {"surface", met.touches ? Json(met.surface) : Json()},
          {"explanation", met.overlaps.empty() ? "" : describe_overlaps(met.overlaps)}};
}

OrderedJson close(Session& session, const Json& params, const Progress& progress) {
  LiveWorld& live = live_world(session);
  const LivePair pair = pair_param(params);
  const HandClosing closing = close_on_object(live, pair, progress);
  return closing_json(live, pair, closing);
}

OrderedJson grasp(Session& session, const Json& params, const Progress& progress) {
  LiveWorld& live = live_world(session);
  const LivePair pair = pair_param(params);
  const HandClosing closing = grasp_object(live, pair, params["distance"].get<double>(), progress);
  return closing_json(live, pair, closing);
}

constexpr const char* kClosingReturns =
    "outcome: grasped, overlaps, missed, blocked, too long or empty; explanation; stopped: joint, "
    "by (free, limit, contact, coupling, no drive), why. A hand that overlaps or misses stays.";

}  // namespace

void add_hand_methods(MethodTable& table) {
  const SchemaMember distance{"distance", number_schema("m", 1e-6, 100), "Largest distance.", false,
                              1};
  table.add({"hand.get", "All joints of a hand.", object_schema({hand_member()}),
             "hand; joints: name, field (the name in structures of MATLAB, which does for it), "
             "value [rad "
             "or m], lower, upper, slides, led_by",
             "{}", get_joints});
  table.add(
      {"hand.set_joints",
       "Sets joints within their limits. One that is named alone of its drive moves all joints of "
       "the drive; several that are named part, as a clutch that has opened leaves them.",
       object_schema(
           {hand_member(),
            {"joints", map_schema(number_schema("rad or m", -1000, 1000)), "Joint -> value.", true},
            gesture_member()}),
       "joints: all of the hand [rad or m]; limited: those that stopped at a limit; parted: those "
       "of the hand that are not where their drive would take them",
       R"({"joints": {"opening": 0.03}})", put_joints});
  table.add({"hand.open", "Opens a hand; an arm that carries it stays.",
             object_schema({hand_member()}), "joints: all of the hand [rad or m]", "{}", open});
  table.add({"hand.approach", "Moves a free hand along its palm until it meets the object.",
             object_schema({hand_member(), object_member(), distance}),
             "outcome: met, missed or overlaps; body, surface: what met; explanation", "{}",
             approach});
  table.add({"hand.close", "Closes a hand in place.",
             object_schema({hand_member(), object_member()}), kClosingReturns, "{}", close});
  table.add({"hand.grasp", "Approaches and closes, as `thenar grasp` does.",
             object_schema({hand_member(), object_member(), distance}), kClosingReturns, "{}",
             grasp});
}

}  // namespace thenar::internal
