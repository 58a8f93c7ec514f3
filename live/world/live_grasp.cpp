#include "live/world/live_grasp.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/progress_parts.h"
#include "grasp/compare/pregrasp.h"

namespace thenar {
namespace {

/// A hand, an object, and how the hand closes.
struct Setting {
  LiveMeeting at;
  GraspOptions options;
};

/// Rates of closing that hear of a stop between two postures.
ClosingRates stopping_rates(ClosingRates rates, const Progress& progress) {
  if (!rates || !progress.stop_requested) return rates;
  return [rates = std::move(rates), progress](const auto& q, const auto& free) {
    if (progress.stop()) throw Stopped("the hand was stopped: it stays where it was");
    return rates(q, free);
  };
}

Setting setting_of(const LiveWorld& live, const LivePair& pair, const Progress& progress) {
  report_or_stop(progress, 0, "surfaces of the hand");
  Setting setting{meeting_of(live, pair), {}};
  const NamedHand& named = setting.at.stands.built->hand.named;
  setting.options.pads.contact = named.contact;
  setting.options.close.rates = stopping_rates(named.rates, progress);
  return setting;
}

void require_distance(double distance) {
  require(std::isfinite(distance) && distance > 0, "wanted an approach distance above 0 m, got {}",
          distance);
}

bool is_mounted(const StateHand& hand) { return hand.parts.size() > 1; }

/// Returns true if the hand is to be moved to the pose in which an outcome left it.
bool moves_hand(GraspOutcome outcome) {
  return outcome != GraspOutcome::kOverlaps && outcome != GraspOutcome::kMissed;
}

/// Takes over how a grasp ended, as one edit.
HandClosing take_over(LiveWorld& live, const Setting& setting, Grasp grasp,
                      const std::string& text) {
  // Change the world only if the hand moved; a refused grasp leaves it as it was.
  HandClosing closing{setting.at.hand, setting.at.object, grasp.outcome,
                      std::move(grasp.approached), std::move(grasp.closed)};
  if (moves_hand(closing.outcome)) {
    WorldState next = live.state();
    if (!is_mounted(setting.at.stands))
      next = with_hand_placed(std::move(next), setting.at.hand, closing.approached.X_WH);
    next = with_posture(std::move(next), setting.at.hand, closing.closed.q);
    live.apply(std::move(next), text + " " + name_of(live.state(), setting.at.stands));
  }
  live.set_closing(closing);
  return closing;
}

}  // namespace

LiveMeeting meeting_of(const LiveWorld& live, const LivePair& pair) {
  const WorldState& state = live.state();
  const std::size_t hand = hand_index(state, pair.hand), object = object_index(state, pair.object);
  const StateHand& stands = state.hands[hand];
  require(!stands.built->model().surfaces().empty(), "hand '{}' has no surface that could touch",
          name_of(state, stands));
  return {hand, object, stands, live.touch().collision_of(state, stands), setup_of(state, object)};
}

void open_hand(LiveWorld& live, const std::string& hand) {
  const std::size_t index = hand_index(live.state(), hand);
  const StateHand& stands = live.state().hands[index];
  const Eigen::VectorXd open = open_posture(stands.built->model().layout());
  Eigen::VectorXd q = stands.stand.q;
  for (const int c : stands.built->hand.places.front()) q[c] = open[c];
  live.apply(with_posture(live.state(), index, q), "open " + name_of(live.state(), stands));
}

ApproachResult approach_object(LiveWorld& live, const LivePair& pair, double distance,
                               const Progress& progress) {
  require_distance(distance);
  // Only a hand that stands by itself can approach; an arm would have to plan its way.
  const Setting setting = setting_of(live, pair, progress);
  const std::string name = name_of(live.state(), setting.at.stands);
  require(!is_mounted(setting.at.stands), "hand '{}' is mounted on '{}': it does not approach",
          name, root_of(live.state(), setting.at.stands));
  // The hand may step aside by a share of the object's size.
  const double aside = setting.options.side_step * setting.at.setup.object.torque_scale;
  ApproachResult met = yielding_approach(setting.at.collision, setting.at.stands.stand.X_WH,
                                         setting.at.stands.stand.q, setting.at.setup,
                                         {distance, aside}, setting.options.close);
  if (met.touches)
    live.apply(with_hand_placed(live.state(), setting.at.hand, met.X_WH), "approach with " + name);
  return met;
}

HandClosing close_on_object(LiveWorld& live, const LivePair& pair, const Progress& progress) {
  const Setting setting = setting_of(live, pair, progress);
  report_or_stop(progress, 0.1, "closing the hand");
  GraspOptions here = setting.options;
  here.approach_distance = 0;
  Grasp closed = grasp(setting.at.collision, setting.at.stands.stand.X_WH,
                       setting.at.stands.stand.q, setting.at.setup, here);
  return take_over(live, setting, std::move(closed), "close");
}

HandClosing grasp_object(LiveWorld& live, const LivePair& pair, double distance,
                         const Progress& progress) {
  require_distance(distance);
  // Approach, close and take over how it ended, as one step to undo.
  const Setting setting = setting_of(live, pair, progress);
  if (is_mounted(setting.at.stands)) return close_on_object(live, pair, progress);
  report_or_stop(progress, 0.1, "approaching and closing the hand");
  const Pregrasp start{setting.at.stands.stand.X_WH, setting.at.stands.stand.q, distance};
  Grasp found = attempt_grasp(setting.at.collision, start, setting.at.setup, setting.options);
  return take_over(live, setting, std::move(found), "grasp with");
}

}  // namespace thenar
