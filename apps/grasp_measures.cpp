#include "apps/grasp_measures.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/progress_parts.h"
#include "data/io/world/world.h"
#include "grasp/quality/task_margin.h"
#include "report/answers/grasp_words.h"
#include "report/table.h"

namespace thenar {
namespace {

constexpr double kGravity = 9.81;  // [m/s^2]

template <typename Value>
Measured<Value> none(const std::string& reason) {
  return {{}, reason};
}

/// Everything that loads are asked of.
struct Asked {
  const GraspQuestion& question;
  const CollisionHand& touching;
  const Grasp& grasp;
  HeldObject hand;
  HandForceInputs held;
  ForceSet forces;  // within what drives the hand
};

Measured<double> weight_of(const GraspQuestion& question) {
  for (const PlacedBody& placed : question.world.bodies) {
    if (placed.body.name != question.scene.object.name) continue;
    try {
      return {kGravity * body_mass(placed.body, question.world.materials).mass, ""};
    } catch (const InputError& unknown) {
      return none<double>(unknown.what());
    }
  }
  return none<double>("the object's mass is unknown");
}

/// Exactly zero against a load that is proven not to be supported: bounds within kNegligibleLoad of
/// zero are the programs' rounding, and so is the direction that comes with them.
Measured<InscribedBall> zero_ball(const Asked& asked, InscribedBall ball) {
  const std::optional<ScaledWrench> load = unsupported_load(asked.forces);
  if (load) ball.worst_load = *load;
  if (!load && !(ball.upper < kNegligibleLoad))
    return none<InscribedBall>("the search gave up early" +
                               (std::isfinite(ball.upper)
                                    ? fmt::format("; at most {} N", shown(ball.upper))
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
                         const std::string& failure) {
  const GraspForce hold = minimum_grasp_force(forces, load, GraspForceObjective::kSum);
  if (hold.status == Status::kInfeasible) return none<double>(failure);
  if (hold.status != Status::kSolved) return none<double>("the programme did not converge");
  return {hold.objective, ""};
}

/// The weight as the object stands: along -z of the world.
ScaledWrench weight_load(const SceneBody& object, double weight) {
  ScaledWrench load = ScaledWrench::Zero();
  load.head<3>() = -weight * object.X_WB.R.transpose().col(2);
  return load;
}

/// Why what drives the hand does not hold a load: it bears none of it, or not all.
std::string why_not_held(const Asked& asked, const ScaledWrench& load) {
  const WrenchSupport reach = load_margin(asked.forces, load);
  const std::string cannot = "what drives the hand cannot make forces that hold the weight: ";
  if (reach.status != Status::kSolved || reach.value * load.norm() < kNegligibleLoad)
    return cannot + explain_zero_margin(asked.held, {load});
  return cannot + fmt::format("it bears {:.3g} N of it", reach.value * load.norm());
}

void add_holds(const Asked& asked, GraspMeasures& measures) {
  if (!measures.weight.value) {
    measures.hold = measures.hold_actuated = none<double>(measures.weight.reason);
    return;
  }
  const ScaledWrench load = weight_load(asked.question.scene.object, *measures.weight.value);
  measures.hold = hold_of(free_forces(asked.held.set), load,
                          "no forces within friction hold the weight as the object stands");
  if (!measures.hold.value) {
    measures.hold_actuated = none<double>(measures.hold.reason);
    return;
  }
  const std::string unknown = explain_unknown_effort(asked.held);
  measures.hold_actuated =
      unknown.empty() ? hold_of(asked.forces, load, "") : none<double>(unknown);
  if (!measures.hold_actuated.value && measures.hold_actuated.reason.empty())
    measures.hold_actuated.reason = why_not_held(asked, load);
}

Measured<double> margin_of(const GraspLoads& loads, GraspTask task) {
  const auto found = loads.margin.find(name_of(task));
  if (found == loads.margin.end()) return none<double>("not asked");
  const auto why = loads.reasons.find(name_of(task));
  const std::string reason = why == loads.reasons.end() ? "" : why->second;
  if (!std::isfinite(found->second)) return none<double>(reason);
  return {found->second, reason};
}

/// Says how much of a load efforts hold by themselves, where that is less than half of it.
void tell_efforts(const Asked& asked, GraspTask task, double weight, Measured<double>& margin) {
  if (margin.value.value_or(0) == 0 || asked.forces.passive_contacts.empty()) return;
  const TaskMargin pressed = margin_of_loads(
      active_only(asked.forces), task_loads(task, weight, asked.question.scene.object.reach));
  if (pressed.status == Status::kSolved && pressed.lower < *margin.value / 2)
    margin.reason = fmt::format("{:.4g} by efforts and friction, the rest is borne by structure",
                                pressed.lower);
}

void add_margins(const Asked& asked, GraspMeasures& measures) {
  const double mass = measures.weight.value.value_or(kGravity) / kGravity;
  const GraspLoads loads =
      grasp_loads(asked.hand, asked.question.scene.object, mass,
                  {GraspTask::kHoldWeight, GraspTask::kPull, GraspTask::kTurn});
  measures.times_weight = measures.weight.value ? margin_of(loads, GraspTask::kHoldWeight)
                                                : none<double>(measures.weight.reason);
  if (measures.times_weight.value == 0.0) {  // along one axis, maybe not along z
    const std::optional<ScaledWrench> load = unsupported_load(asked.forces);
    if (load && !load->head<3>().isZero(0))
      measures.times_weight.reason += ": nothing withstands " + direction_words(*load);
  }
  measures.pull = margin_of(loads, GraspTask::kPull);
  measures.turn = margin_of(loads, GraspTask::kTurn);
  tell_efforts(asked, GraspTask::kHoldWeight, kGravity * mass, measures.times_weight);
  tell_efforts(asked, GraspTask::kPull, kGravity * mass, measures.pull);
  tell_efforts(asked, GraspTask::kTurn, kGravity * mass, measures.turn);
}

Measured<GraspStiffness> stiffness_of(const Asked& asked) {
  const SceneBody& object = asked.question.scene.object;
  const Materials& materials = asked.question.scene.materials;
  const PosedCollisionHand posed{asked.touching, asked.grasp.approached.X_WH,
                                 asked.touching.hand->pose(asked.grasp.closed.q)};
  const PadBody held{object.solid, materials.at(object.material), {}};
  PadOptions options;
  options.force = kPadForce;
  std::vector<PadStiffness> pads;
  for (const ContactPatch& patch : patches_of(asked.grasp.contacts)) {
    const int surface = patch.contacts[0].surface;
    const LinkSurface& link = asked.touching.hand->surfaces()[static_cast<std::size_t>(surface)];
    const PadBody pad{*link.solid, materials.at(link.material),
                      object.X_WB.inverse() * posed.of_surface(surface)};
    const auto springs = pad_stiffness(patch, pad, held, options);
    if (!springs)
      return none<GraspStiffness>(
          fmt::format("neither {} nor {} has a soft layer: contacts of {} are rigid", link.material,
                      object.material, link.name));
    pads.insert(pads.end(), patch.contacts.size(), *springs);
  }
  return {
      grasp_stiffness(contacts_without_hand(asked.grasp.contacts), object.com, object.reach, pads),
      ""};
}

Measured<ObjectMotion> manipulability_of(const Asked& asked) {
  try {
    return {object_motion(*asked.touching.hand, asked.grasp.closed.q,
                          contacts_without_hand(asked.grasp.contacts), asked.question.scene.object,
                          asked.held.T),
            ""};
  } catch (const InputError& free) {
    return none<ObjectMotion>(free.what());
  }
}

}  // namespace

GraspMeasures measure(const GraspQuestion& question, const CollisionHand& touching,
                      const GraspAnswer& answer, const Progress& progress) {
  const Grasp& grasp = answer.grasp;
  const SceneBody& object = question.scene.object;
  const HeldObject hand{*touching.hand, grasp.closed.q, grasp.contacts,
                        grasp.approached.X_WH.inverse() * object.X_WB};
  HandForceInputs held = hand_force_inputs(hand, object);
  ForceSet forces = hand_forces(held.set, held.T, held.actuation);
  const Asked asked{question, touching, grasp, hand, std::move(held), std::move(forces)};
  VolumeOptions of_volume;
  of_volume.limit = question.limit;
  of_volume.progress.stop_requested = progress.stop_requested;
  GraspMeasures measures;
  measures.edges = question.edges;
  report_or_stop(progress, 0, "volume of wrenches");
  measures.volume = volume(answer.wrenches, of_volume);
  report_or_stop(progress, 0.3, "epsilon of the driven hand");
  measures.actuated = ball_of(asked);
  report_or_stop(progress, 0.7, "loads");
  measures.weight = weight_of(question);
  add_holds(asked, measures);
  add_margins(asked, measures);
  measures.stiffness = stiffness_of(asked);
  measures.manipulability = manipulability_of(asked);
  return measures;
}

}  // namespace thenar
