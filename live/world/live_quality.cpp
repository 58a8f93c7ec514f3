#include "live/world/live_quality.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/compare/grasp_loads.h"

namespace thenar {
namespace {

/// Returns the collision model of the hand in its current pose and posture.
PosedCollisionHand posed(const LivePairSetup& current) {
  return {current.collision, current.state_hand.placement.X_WH,
          current.state_hand.built->model().pose(current.state_hand.placement.q)};
}

std::vector<HandContact> contacts_at(const LiveWorld& live, const LivePairSetup& current) {
  const double within = ContactPatchOptions{}.tolerance;
  if (!may_touch(current.state_hand, live.state().bodies[current.object], within)) return {};
  PadOptions pads;
  pads.contact = current.state_hand.built->hand.named.contact;
  return find_contacts(posed(current), current.setup, {}, pads);
}

std::vector<std::string> deep_overlaps(const LivePairSetup& current) {
  // Report overlaps that exceed the thickness of the soft layer.
  std::vector<std::string> warnings;
  for (const Overlap& overlap : find_overlaps(posed(current), current.setup, 1e-5)) {
    const double soft =
        soft_layer_depth(*find_named(current.state_hand.built->model().surfaces(), overlap.surface),
                         current.setup.materials);
    if (overlap.depth > std::max(kReportedOverlap, soft))
      warnings.push_back(fmt::format("{} is {:.1f} mm deep in {}", overlap.surface,
                                     1000 * overlap.depth, overlap.other));
  }
  return warnings;
}

/// Builds the world case of measure_grasp() for the current state.
WorldCase case_of(const LiveWorld& live, const LivePairSetup& current) {
  // Convert the state to the content of a world file.
  const WorldState& state = live.state();
  WorldCase setting;
  setting.path = state.file.empty() ? state.header->name : state.file;
  setting.data = live.data_folders();
  setting.world = world_spec(state);
  // Set the hand in its current pose and posture.
  setting.hand = current.state_hand.built->hand;
  setting.hand.parts = current.state_hand.parts;
  setting.hand.X_WH = current.state_hand.placement.X_WH;
  setting.hand.q = current.state_hand.placement.q;
  setting.hand.named.name = hand_name(state, current.state_hand);
  // Add warnings and files of the world to those of the hand.
  append_all(setting.hand.named.warnings, missing_material_warnings(setting.world));
  setting.files = setting.world.files;
  setting.files.insert(setting.hand.named.files.begin(), setting.hand.named.files.end());
  return setting;
}

/// Sets the approach and closing of a grasp: the last closing of the hand if it led to this state,
/// else pose and posture alone.
void set_closing(const LiveWorld& live, const LivePairSetup& current, Grasp& grasp) {
  // Set pose and posture.
  grasp.approached.X_WH = current.state_hand.placement.X_WH;
  grasp.closed.q = current.state_hand.placement.q;
  const std::optional<HandClosing>& closing = live.closing();
  if (!closing || closing->hand != current.hand || closing->object != current.object) return;
  if (closing->closed.q != grasp.closed.q || closing->outcome == GraspOutcome::kOverlaps ||
      closing->outcome == GraspOutcome::kMissed)
    return;
  // The closing belongs to this pair and posture: use it.
  grasp.approached = closing->approached;
  grasp.closed = closing->closed;
}

}  // namespace

LiveContacts current_contacts(const LiveWorld& live, const LivePair& pair) {
  const LivePairSetup current = pair_setup(live, pair);
  LiveContacts out;
  out.contacts = contacts_at(live, current);
  out.X_WO = current.setup.object.X_WB;
  for (const HandContact& contact : out.contacts)
    out.links.push_back(current.state_hand.built->model().surfaces()[contact.surface].name);
  out.warnings = deep_overlaps(current);
  return out;
}

GraspResult current_grasp(const LiveWorld& live, const LivePair& pair,
                          const LiveQualityRequest& request) {
  require(request.tolerance > 0, "wanted a tolerance of epsilon above 0, got {}",
          request.tolerance);
  const LivePairSetup current = pair_setup(live, pair);
  // Set the request and the world, without an approach.
  GraspResult result{};
  result.request.approach = false;
  result.request.limit = request.norm;
  result.request.tolerance = request.tolerance;
  result.setting = case_of(live, current);
  result.setting.setup = current.setup;
  result.collision_hand = current.collision;
  // Find the contacts and their wrenches about the centre of mass.
  Grasp& grasp = result.grasp;
  set_closing(live, current, grasp);
  grasp.contacts = contacts_at(live, current);
  grasp.outcome = grasp.contacts.empty() ? GraspOutcome::kEmpty : GraspOutcome::kGrasped;
  const GraspBody& object = current.setup.object;
  result.wrenches =
      wrench_set(contacts_without_hand(grasp.contacts), object.com, object.torque_scale);
  // Compute epsilon, and collect the warnings.
  EpsilonOptions options;
  options.limit = request.norm;
  options.gap = request.tolerance;
  if (!grasp.contacts.empty()) grasp.quality = epsilon(result.wrenches, options);
  result.start = {grasp.approached.X_WH, grasp.closed.q, 0};
  result.outcome.warnings = grasp_warnings(result);
  result.outcome.warn(deep_overlaps(current));
  return result;
}

GraspResult show_quality(LiveWorld& live, const LivePair& pair, const LiveQualityRequest& request) {
  GraspResult result = current_grasp(live, pair, request);
  if (result.grasp.outcome == GraspOutcome::kGrasped)
    live.set_disturbance({object_index(live.state(), pair.object),
                          unscaled_wrench(result.grasp.quality.worst_wrench,
                                          result.setting.setup.object.torque_scale)});
  return result;
}

WrenchSetMesh live_wrench_set(const LiveWorld& live, const LivePair& pair,
                              const std::array<int, 3>& axes, PictureKind kind, WrenchLimits limits,
                              int pieces) {
  const GraspResult result = current_grasp(live, pair);
  require(result.grasp.outcome == GraspOutcome::kGrasped,
          "hand '{}' does not touch '{}': there is no wrench set", result.setting.hand.named.name,
          result.setting.setup.object.name);
  // Geometric limits need only the contacts.
  if (limits == WrenchLimits::kGeometric)
    return wrench_set_mesh(unit_forces(result.wrenches, ForceNorm::kL1), axes, kind, pieces);
  // Limits of the hand need the efforts of its motors or muscles in this posture.
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
  GraspResult result = current_grasp(live, pair, request);
  if (result.grasp.outcome == GraspOutcome::kGrasped)
    result.measures = grasp_measures_of(result, progress);
  return result;
}

}  // namespace thenar
