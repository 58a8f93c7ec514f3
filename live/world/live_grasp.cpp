#include "live/world/live_grasp.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/progress_parts.h"
#include "grasp/compare/pregrasp.h"

namespace thenar {
namespace {

/// Hand, object and options of a closing.
struct GraspAction {
  LivePairSetup pair;
  GraspOptions options;
};

/// Wraps closing rates so that they throw Stopped if a stop is requested.
ClosingRates stopping_rates(ClosingRates rates, const Progress& progress) {
  if (!rates || !progress.stop_requested) return rates;
  return [rates = std::move(rates), progress](const auto& q, const auto& free) {
    if (progress.stop()) throw Stopped("the hand was stopped: it stays where it was");
    return rates(q, free);
  };
}

GraspAction grasp_action(const LiveWorld& live, const LivePair& pair, const Progress& progress) {
  report_or_stop(progress, 0, "surfaces of the hand");
  GraspAction action{pair_setup(live, pair), {}};
  const NamedHand& named = action.pair.state_hand.built->hand.named;
  action.options.pads.contact = named.contact;
  action.options.close.rates = stopping_rates(named.rates, progress);
  return action;
}

void require_distance(double distance) {
  require(std::isfinite(distance) && distance > 0, "wanted an approach distance above 0 m, got {}",
          distance);
}

bool is_mounted(const StateHand& hand) { return hand.parts.size() > 1; }

/// Returns true if the hand takes the pose and posture of an attempt with this outcome.
bool moves_hand(GraspOutcome outcome) {
  return outcome != GraspOutcome::kOverlaps && outcome != GraspOutcome::kMissed;
}

/// Applies the final pose and posture of a grasp as one edit, and stores the closing.
HandClosing apply_grasp(LiveWorld& live, const GraspAction& action, Grasp grasp,
                        const std::string& text) {
  HandClosing closing{action.pair.hand, action.pair.object, grasp.outcome,
                      std::move(grasp.approached), std::move(grasp.closed)};
  // Move the hand unless it overlapped or missed.
  if (moves_hand(closing.outcome)) {
    WorldState next = live.state();
    if (!is_mounted(action.pair.state_hand))
      next = with_hand_placed(std::move(next), action.pair.hand, closing.approached.X_WH);
    next = with_posture(std::move(next), action.pair.hand, closing.closed.q);
    live.apply(std::move(next), text + " " + hand_name(live.state(), action.pair.state_hand));
  }
  live.set_closing(closing);
  return closing;
}

}  // namespace

LivePairSetup pair_setup(const LiveWorld& live, const LivePair& pair) {
  const WorldState& state = live.state();
  const std::size_t hand = hand_index(state, pair.hand), object = object_index(state, pair.object);
  const StateHand& state_hand = state.hands[hand];
  require(!state_hand.built->model().surfaces().empty(),
          "hand '{}' has no surface that could touch", hand_name(state, state_hand));
  return {hand, object, state_hand, live.contact_cache().collision_of(state, state_hand),
          grasp_setup(state, object)};
}

void open_hand(LiveWorld& live, const std::string& hand) {
  const std::size_t index = hand_index(live.state(), hand);
  const StateHand& state_hand = live.state().hands[index];
  const Eigen::VectorXd open = open_posture(state_hand.built->model().layout());
  Eigen::VectorXd q = state_hand.placement.q;
  for (const int c : state_hand.built->hand.places.front()) q[c] = open[c];
  live.apply(with_posture(live.state(), index, q), "open " + hand_name(live.state(), state_hand));
}

ApproachResult approach_object(LiveWorld& live, const LivePair& pair, double distance,
                               const Progress& progress) {
  require_distance(distance);
  // Check that the hand is free; a mounted hand would need a motion plan of its arm.
  const GraspAction action = grasp_action(live, pair, progress);
  const std::string name = hand_name(live.state(), action.pair.state_hand);
  require(!is_mounted(action.pair.state_hand), "hand '{}' is mounted on '{}': it does not approach",
          name, root_name(live.state(), action.pair.state_hand));
  // Approach; the hand may step aside by a fraction of the object's size.
  const double aside = action.options.side_step * action.pair.setup.object.torque_scale;
  ApproachResult met =
      yielding_approach(action.pair.collision, action.pair.state_hand.placement.X_WH,
                        action.pair.state_hand.placement.q, action.pair.setup, {distance, aside},
                        action.options.close);
  if (met.touches)
    live.apply(with_hand_placed(live.state(), action.pair.hand, met.X_WH), "approach with " + name);
  return met;
}

HandClosing close_on_object(LiveWorld& live, const LivePair& pair, const Progress& progress) {
  const GraspAction action = grasp_action(live, pair, progress);
  report_or_stop(progress, 0.1, "closing the hand");
  GraspOptions here = action.options;
  here.approach_distance = 0;
  Grasp closed = grasp(action.pair.collision, action.pair.state_hand.placement.X_WH,
                       action.pair.state_hand.placement.q, action.pair.setup, here);
  return apply_grasp(live, action, std::move(closed), "close");
}

HandClosing grasp_object(LiveWorld& live, const LivePair& pair, double distance,
                         const Progress& progress) {
  require_distance(distance);
  // A mounted hand closes without an approach.
  const GraspAction action = grasp_action(live, pair, progress);
  if (is_mounted(action.pair.state_hand)) return close_on_object(live, pair, progress);
  // Approach and close from the current pose.
  report_or_stop(progress, 0.1, "approaching and closing the hand");
  const Pregrasp start{action.pair.state_hand.placement.X_WH, action.pair.state_hand.placement.q,
                       distance};
  Grasp found = attempt_grasp(action.pair.collision, start, action.pair.setup, action.options);
  return apply_grasp(live, action, std::move(found), "grasp with");
}

}  // namespace thenar
