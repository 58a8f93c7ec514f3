#include "live/world/live_quality.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/compare/grasp_loads.h"

namespace thenar {
namespace {

PosedCollisionHand posed(const LiveMeeting& meeting) {
  return {meeting.collision, meeting.stands.stand.X_WH,
          meeting.stands.built->model().pose(meeting.stands.stand.q)};
}

std::vector<HandContact> contacts_at(const LiveWorld& live, const LiveMeeting& meeting) {
  const double within = ContactPatchOptions{}.tolerance;
  if (!may_touch(meeting.stands, live.state().bodies[meeting.object], within)) return {};
  PadOptions pads;
  pads.contact = meeting.stands.built->hand.named.contact;
  return find_contacts(posed(meeting), meeting.setup, {}, pads);
}

std::vector<std::string> deep_overlaps(const LiveMeeting& meeting) {
  // Soft layers may overlap by their thickness; only deeper overlaps are errors.
  std::vector<std::string> warnings;
  for (const Overlap& overlap : find_overlaps(posed(meeting), meeting.setup, 1e-5)) {
    const double soft =
        soft_layer_depth(*find_named(meeting.stands.built->model().surfaces(), overlap.surface),
                         meeting.setup.materials);
    if (overlap.depth > std::max(kDeepOverlap, soft))
      warnings.push_back(fmt::format("{} is {:.1f} mm deep in {}", overlap.surface,
                                     1000 * overlap.depth, overlap.other));
  }
  return warnings;
}

/// The world as measure_grasp() has it.
WorldCase case_of(const LiveWorld& live, const LiveMeeting& meeting) {
  // Describe the world as a file would, with the hand where it stands now.
  const WorldState& state = live.state();
  WorldCase setting;
  setting.path = state.file.empty() ? state.header->name : state.file;
  setting.data = live.data();
  setting.world = spec_of(state);
  setting.hand = meeting.stands.built->hand;
  setting.hand.parts = meeting.stands.parts;
  setting.hand.X_WH = meeting.stands.stand.X_WH;
  setting.hand.q = meeting.stands.stand.q;
  setting.hand.named.name = name_of(state, meeting.stands);
  append_all(setting.hand.named.warnings, missing_material_warnings(setting.world));
  setting.files = setting.world.files;
  setting.files.insert(setting.hand.named.files.begin(), setting.hand.named.files.end());
  return setting;
}

/// Sets the approach and closing of a grasp, if they are known of this very posture and object.
void tell_closing(const LiveWorld& live, const LiveMeeting& meeting, Grasp& grasp) {
  // A hand that was moved since it closed is known by its pose and posture alone.
  grasp.approached.X_WH = meeting.stands.stand.X_WH;
  grasp.closed.q = meeting.stands.stand.q;
  const std::optional<HandClosing>& closing = live.closing();
  if (!closing || closing->hand != meeting.hand || closing->object != meeting.object) return;
  if (closing->closed.q != grasp.closed.q || closing->outcome == GraspOutcome::kOverlaps ||
      closing->outcome == GraspOutcome::kMissed)
    return;
  grasp.approached = closing->approached;
  grasp.closed = closing->closed;
}

}  // namespace

LiveContacts contacts_of(const LiveWorld& live, const LivePair& pair) {
  // Find contacts within the tolerance, without moving the hand.
  const LiveMeeting meeting = meeting_of(live, pair);
  LiveContacts out;
  out.contacts = contacts_at(live, meeting);
  out.X_WO = meeting.setup.object.X_WB;
  for (const HandContact& contact : out.contacts)
    out.links.push_back(meeting.stands.built->model().surfaces()[contact.surface].name);
  out.warnings = deep_overlaps(meeting);
  return out;
}

GraspResult standing_grasp(const LiveWorld& live, const LivePair& pair,
                           const LiveQualityRequest& request) {
  require(request.tolerance > 0, "wanted a tolerance of epsilon above 0, got {}",
          request.tolerance);
  const LiveMeeting meeting = meeting_of(live, pair);
  // Setting of the request, without an approach.
  GraspResult result{};
  result.request.approach = false;
  result.request.limit = request.norm;
  result.request.tolerance = request.tolerance;
  result.setting = case_of(live, meeting);
  result.setting.setup = meeting.setup;
  result.collision_hand = meeting.collision;
  // Contacts and their quality, about the centre of mass.
  Grasp& grasp = result.grasp;
  tell_closing(live, meeting, grasp);
  grasp.contacts = contacts_at(live, meeting);
  grasp.outcome = grasp.contacts.empty() ? GraspOutcome::kEmpty : GraspOutcome::kGrasped;
  const GraspBody& object = meeting.setup.object;
  result.wrenches =
      wrench_set(contacts_without_hand(grasp.contacts), object.com, object.torque_scale);
  EpsilonOptions options;
  options.limit = request.norm;
  options.gap = request.tolerance;
  if (!grasp.contacts.empty()) grasp.quality = epsilon(result.wrenches, options);
  result.start = {grasp.approached.X_WH, grasp.closed.q, 0};
  result.outcome.warnings = grasp_warnings(result);
  result.outcome.warn(deep_overlaps(meeting));
  return result;
}

GraspResult show_quality(LiveWorld& live, const LivePair& pair, const LiveQualityRequest& request) {
  GraspResult result = standing_grasp(live, pair, request);
  if (result.grasp.outcome == GraspOutcome::kGrasped)
    live.set_disturbance({object_index(live.state(), pair.object),
                          unscaled_wrench(result.grasp.quality.worst_wrench,
                                          result.setting.setup.object.torque_scale)});
  return result;
}

WrenchSetMesh live_wrench_set(const LiveWorld& live, const LivePair& pair,
                              const std::array<int, 3>& axes, PictureKind kind, WrenchLimits limits,
                              int pieces) {
  const GraspResult result = standing_grasp(live, pair);
  require(result.grasp.outcome == GraspOutcome::kGrasped,
          "hand '{}' does not touch '{}': there is no wrench set", result.setting.hand.named.name,
          result.setting.setup.object.name);
  // Geometric limits need the contacts alone, those of the hand its actuation.
  if (limits == WrenchLimits::kGeometric)
    return wrench_set_mesh(unit_forces(result.wrenches, ForceNorm::kL1), axes, kind, pieces);
  // Limits of the hand need the efforts of its motors or muscles at this posture.
  const GraspBody& object = result.setting.setup.object;
  const HeldObject held{*result.collision_hand.hand, result.grasp.closed.q, result.grasp.contacts,
                        result.grasp.approached.X_WH.inverse() * object.X_WB};
  const HandForceInputs inputs = hand_force_inputs(held, object);
  const std::string unknown = explain_unknown_effort(inputs);
  require(unknown.empty(), "the wrench set within the hand's limits is not known: {}", unknown);
  return wrench_set_mesh(hand_forces(inputs.set, inputs.T, inputs.actuation), axes, kind, pieces);
}

GraspResult measured_grasp(const LiveWorld& live, const LivePair& pair,
                           const LiveQualityRequest& request, const Progress& progress) {
  GraspResult result = standing_grasp(live, pair, request);
  if (result.grasp.outcome == GraspOutcome::kGrasped)
    result.measures = grasp_measures_of(result, progress);
  return result;
}

}  // namespace thenar
