#include "api/grasp_measures.h"

#include <cmath>

#include <fmt/format.h>

#include "api/grasp.h"
#include "base/error.h"
#include "base/progress_parts.h"
#include "data/io/world/world.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/limits/grasp_force.h"

namespace thenar {
namespace {

constexpr double kGravity = 9.81;  // Acceleration of free fall [m/s^2]

template <typename Value>
Measured<Value> none(const std::string& message) {
  return {{}, message};
}

/// Inputs from which loads are computed.
struct Asked {
  const GraspResult& result;
  HeldObject hand;
  HandForceInputs held;
  ForceSet forces;  // within what drives the hand
};

Measured<double> weight_of(const WorldCase& setting) {
  for (const PlacedBody& placed : setting.world.bodies) {
    if (placed.body.name != setting.setup.object.name) continue;
    try {
      return {kGravity * body_mass(placed.body, setting.world.materials).mass, ""};
    } catch (const InputError& unknown) {
      return none<double>(unknown.what());
    }
  }
  return none<double>("the object's mass is unknown");
}

/// Exactly zero against a load that is proven not to be supported: bounds within kNegligibleLoad of
/// zero are the programs' rounding, and so is the direction that comes with them.
Measured<InscribedBall> zero_ball(const Asked& asked, InscribedBall ball) {
  // A proof that a load is not supported makes the ball exactly empty, without rounding.
  const std::optional<ScaledWrench> load = unsupported_load(asked.forces);
  if (load) ball.worst_load = *load;
  // Without a proof and without a small upper bound the answer is open, not zero.
  if (!load && !(ball.upper < kNegligibleLoad))
    return none<InscribedBall>("the search gave up early" +
                               (std::isfinite(ball.upper)
                                    ? fmt::format("; at most {:.4g} N", ball.upper)
                                    : std::string()));
  ball.status = Status::kSolved;
  ball.lower = ball.upper = 0;
  return {ball, explain_zero_margin(asked.held, {ball.worst_load})};
}

Measured<InscribedBall> ball_of(const Asked& asked) {
  const std::string unknown = explain_unknown_effort(asked.held);
  if (!unknown.empty()) return none<InscribedBall>(unknown);
  const InscribedBall ball = inscribed_ball(asked.forces);
  if (ball.status == Status::kInfeasible)
    return none<InscribedBall>("no effort keeps the hand's own torques in balance");
  if (ball.status == Status::kUnbounded) return none<InscribedBall>(kSupportedByStructure);
  if (ball.lower >= kNegligibleLoad || ball.upper <= -kNegligibleLoad) return {ball, ""};
  return zero_ball(asked, ball);
}

Measured<double> hold_of(const ForceSet& forces, const ScaledWrench& load,
                         const std::string& if_infeasible) {
  const GraspForce hold = minimum_grasp_force(forces, load, GraspForceObjective::kSum);
  if (hold.status == Status::kInfeasible) return none<double>(if_infeasible);
  if (hold.status != Status::kSolved) return none<double>("the programme did not converge");
  return {hold.objective, ""};
}

/// Returns the weight of the object in its present orientation: along -z of the world.
ScaledWrench weight_load(const GraspBody& object, double weight) {
  return {-weight * object.X_WB.R.transpose().col(2), {0, 0, 0}};
}

/// Returns the reason why the hand's motors do not hold a load: they support none of it, or a part.
std::string why_not_held(const Asked& asked, const ScaledWrench& load) {
  const WrenchSupport reach = load_margin(asked.forces, load);
  const std::string cannot = "what drives the hand cannot make forces that hold the weight: ";
  if (reach.status != Status::kSolved || reach.value * load.norm() < kNegligibleLoad)
    return cannot + explain_zero_margin(asked.held, {load});
  return cannot + fmt::format("it carries {:.3g} N of it", reach.value * load.norm());
}

void add_holds(const Asked& asked, GraspMeasures& measures) {
  // An object of unknown mass has no weight to hold.
  if (!measures.weight.value) {
    measures.hold = measures.hold_actuated = none<double>(measures.weight.message);
    return;
  }
  const ScaledWrench load = weight_load(asked.result.setting.setup.object, *measures.weight.value);
  // Solve first for unlimited contact forces: if friction itself is too low, motors cannot help.
  measures.hold =
      hold_of(free_forces(asked.held.set), load,
              "no forces within friction hold the weight in the present orientation of the object");
  if (!measures.hold.value) {
    measures.hold_actuated = none<double>(measures.hold.message);
    return;
  }
  // Then limit the forces by the efforts of motors or muscles.
  const std::string unknown = explain_unknown_effort(asked.held);
  measures.hold_actuated =
      unknown.empty() ? hold_of(asked.forces, load, "") : none<double>(unknown);
  if (!measures.hold_actuated.value && measures.hold_actuated.message.empty())
    measures.hold_actuated.message = why_not_held(asked, load);
}

Measured<SupportedLoad> load_of(const GraspLoads& loads, GraspTask task) {
  const auto found = loads.with_structure.find(name_of(task));
  if (found == loads.with_structure.end()) return none<SupportedLoad>("not asked");
  const auto reason = loads.reasons.find(name_of(task));
  const std::string message = reason == loads.reasons.end() ? "" : reason->second;
  if (!std::isfinite(found->second)) return none<SupportedLoad>(message);
  SupportedLoad load{{}, found->second};
  if (const double active = loads.margin.at(name_of(task)); std::isfinite(active))
    load.active = active;
  return {load, load.active == 0.0 && load.with_structure > 0 ? "" : message};
}

void add_margins(const Asked& asked, GraspMeasures& measures) {
  // Without a mass the loads are scaled by 1 kg, which matters for multiples of the weight only.
  const GraspLoads loads =
      grasp_loads(asked.hand, asked.result.setting.setup.object,
                  measures.weight.value.value_or(kGravity) / kGravity,
                  {GraspTask::kHoldWeight, GraspTask::kPull, GraspTask::kTurn});
  measures.times_weight = measures.weight.value ? load_of(loads, GraspTask::kHoldWeight)
                                                : none<SupportedLoad>(measures.weight.message);
  // A zero is along one axis, maybe not along z.
  if (measures.times_weight.value && measures.times_weight.value->with_structure == 0) {
    const std::optional<ScaledWrench> load = unsupported_load(asked.forces);
    if (load && !load->force.isZero(0))
      measures.times_weight.message += ": nothing withstands " + direction_words(*load);
  }
  // Pull and turn are loads along and about every axis, in newtons and newton metres.
  measures.pull = load_of(loads, GraspTask::kPull);
  measures.turn = load_of(loads, GraspTask::kTurn);
}

Measured<GraspStiffness> stiffness_of(const Asked& asked) {
  // Gather the geometry of the grasp: object, link surfaces and their materials.
  const GraspBody& object = asked.result.setting.setup.object;
  const Materials& materials = asked.result.setting.setup.materials;
  const PosedCollisionHand posed{
      asked.result.collision_hand, asked.result.grasp.approached.X_WH,
      asked.result.collision_hand.hand->pose(asked.result.grasp.closed.q)};
  const PadBody held{object.solid, materials.at(object.material), {}};
  // Linearise the pads at the force of a gentle hold.
  PadOptions options;
  options.force = kPadForce;
  std::vector<PadStiffness> pads;
  // Each contact of a patch shares the springs of its pad.
  for (const ContactPatch& patch : group_into_patches(asked.result.grasp.contacts)) {
    const int surface = patch.contacts[0].surface;
    const LinkSurface& link =
        asked.result.collision_hand.hand->surfaces()[static_cast<std::size_t>(surface)];
    const PadBody pad{*link.solid, materials.at(link.material),
                      object.X_WB.inverse() * posed.surface_pose(surface)};
    const auto springs = pad_stiffness(patch, pad, held, options);
    // Two rigid surfaces have no finite stiffness, so that of the grasp is undefined.
    if (!springs)
      return none<GraspStiffness>(
          fmt::format("neither {} nor {} has a soft layer: the contacts of {} are rigid",
                      link.material, object.material, link.name));
    pads.insert(pads.end(), patch.contacts.size(), *springs);
  }
  return {grasp_stiffness(contacts_without_hand(asked.result.grasp.contacts), object.com,
                          object.torque_scale, pads),
          ""};
}

Measured<ObjectMotion> manipulability_of(const Asked& asked) {
  try {
    return {object_motion(*asked.result.collision_hand.hand, asked.result.grasp.closed.q,
                          contacts_without_hand(asked.result.grasp.contacts),
                          asked.result.setting.setup.object, asked.held.T),
            ""};
  } catch (const InputError& free) {
    return none<ObjectMotion>(free.what());
  }
}

}  // namespace

GraspMeasures grasp_measures_of(const GraspResult& result, const Progress& progress) {
  const Grasp& grasp = result.grasp;
  // Express the grasp in the frame of the hand, in which efforts are stated.
  const GraspBody& object = result.setting.setup.object;
  const HeldObject hand{*result.collision_hand.hand, grasp.closed.q, grasp.contacts,
                        grasp.approached.X_WH.inverse() * object.X_WB};
  HandForceInputs held = hand_force_inputs(hand, object);
  ForceSet forces = hand_forces(held.set, held.T, held.actuation);
  const Asked asked{result, hand, std::move(held), std::move(forces)};
  // Volumes are costly, so the request may limit their facets and stop them.
  VolumeOptions of_volume;
  of_volume.limit = result.request.limit;
  of_volume.progress.stop_requested = progress.stop_requested;
  GraspMeasures measures;
  measures.edges = result.request.edges;
  // Measure from the wrench set alone first, then with the limits of the hand.
  report_or_stop(progress, 0, "volume of the wrench set");
  measures.volume = volume(result.wrenches, of_volume);
  report_or_stop(progress, 0.3, "epsilon within the hand's limits");
  measures.actuated = ball_of(asked);
  report_or_stop(progress, 0.7, "loads");
  // Loads need the weight; stiffness and manipulability do not.
  measures.weight = weight_of(result.setting);
  add_holds(asked, measures);
  add_margins(asked, measures);
  measures.stiffness = stiffness_of(asked);
  measures.manipulability = manipulability_of(asked);
  return measures;
}

}  // namespace thenar
