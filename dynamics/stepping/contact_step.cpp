#include "dynamics/stepping/contact_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/stepping/applied_efforts.h"
#include "dynamics/stepping/contact_rows.h"
#include "dynamics/stepping/free_velocity.h"
#include "dynamics/stepping/impulse_losses.h"
#include "dynamics/stepping/scene_contacts.h"
#include "dynamics/stepping/scene_motion.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

constexpr double kUnderflowSpeed = 1e-150;  // speed whose square underflows; becomes 0 [m/s],
                                            // [rad/s]
constexpr double kMaxTolerance = 1e-9;      // residual that counts as solved in midpoint steps [1]
constexpr double kGapRoundings = 8;         // rounding error of a gap over that of a position [1]
constexpr double kMinSceneSize = 0.1;       // smallest scene size for rounding errors [m]
constexpr double kExtraMargin = 1e-5;       // added to the approach within a midpoint step [m]
constexpr double kMaxMargin = 0.05;         // largest margin of the contact search of that step [m]
constexpr int kProjections = 3;             // largest number of iterations of close_gaps()
constexpr double kGapLimit = 1e-13;         // gap at which close_gaps() has converged [m], [rad]

/// Records a contact that was not closed before if it is the deepest so far.
void record_if_deepest(const ActiveContact& contact, StepOutcome& outcome) {
  if (contact.kind == Kind::kJointFriction || !(contact.gap < outcome.min_new_gap)) return;
  outcome.min_new_gap = contact.gap;
  outcome.new_closing_speed = -contact.approach;
}

}  // namespace

struct ContactStep::Parts {
  explicit Parts(MovingScene s)
      : scene(std::move(s)),
        model(tree_model(scene.mechanism)),
        motion(model),
        efforts(scene, model),
        free(scene, model),
        rows(scene, model) {
    check_scene(scene);
    if (!model.has_couplings) articulated = std::make_unique<ArticulatedBody<double>>(model);
    contacts.emplace(scene, model);
  }

  /// Advances positions and time by h. @return false if they overflow: velocities are then NaN
  bool advance(double h, SceneState& state) const {
    advance_positions(scene.mechanism, model.layout, state.v, h, state.q);
    state.t += h;
    if (state.q.allFinite()) return true;
    state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
    return false;
  }

  /// Returns the input of elements at a state, with the links moved there if there are elements.
  ElementInput element_input(const SceneState& state) {
    if (!efforts.elements.empty()) motion.set_state(state);
    return efforts.element_input(motion, state);
  }

  /// Sets the links' velocities to the mean over a midpoint step, and advances the element states
  /// to its end with their rates at the midpoint.
  /// @param state  positions and element states at the midpoint, velocities at the end
  /// @return false if an element has no valid force
  bool finish_elements(double h, SceneState& state) {
    v_mean = 0.5 * (v_before + state.v);
    motion.set_speeds(v_mean);
    if (efforts.elements.empty()) return true;
    const bool acted =
        efforts.elements.compute_action({state.t, efforts.selection_time(), state.q, v_mean,
                                         state.z, motion.links(), 0, ElementNeed::kRates});
    state.z = z_before + h * efforts.elements.action().z_rate;
    return acted;
  }

  /// Adds the energy flows of a midpoint step. Call after finish_elements().
  void add_flows(double h, SceneState& state) {
    // Integrate mean powers; update the measures of turned-over energy.
    efforts.compute_powers(motion,
                           {state.t, efforts.selection_time(), h, 0.5, state.q, v_before, state.v});
    state.w += h * efforts.power;
    state.w[kWorkMagnitude] += h * std::abs(efforts.power[kAppliedWork]);
    if (!efforts.elements.empty())
      state.w[kWorkMagnitude] += std::abs((state.z - z_before).tail<1>()[0]);
    state.w[kMaxKinetic] = std::max(state.w[kMaxKinetic], motion.links().kinetic_energy());
  }

  /// Computes the tolerance of a midpoint step's contact problem: the rounding error of gaps, as a
  /// velocity over the largest velocity of the problem [1].
  [[nodiscard]] double gap_rounding(double h) const {
    const double size = contacts->extent(kMinSceneSize);
    const double rounding = kGapRoundings * std::numeric_limits<double>::epsilon() * size;
    const double residual = 2 * rounding / (h * rows.problem.b.lpNorm<Eigen::Infinity>());
    return std::max(solver_options.tolerance, std::min(residual, kMaxTolerance));
  }

  /// Assembles the contact problem, with b the velocities without impulses.
  void assemble_rows(const std::vector<ActiveContact>& list, double h) {
    rows.assemble(list, h, motion.links(), free.mass);
    rows.problem.b.noalias() = rows.Jt.transpose() * free.v;
  }

  /// Solves the contact problem, applies the impulses, books their losses, and stores impulses,
  /// velocities and modes in the list.
  /// @param target_residual  0: use the solver's tolerance; otherwise iterate to this residual, but
  ///                         count kMaxTolerance as solved [1]
  void solve_contacts(std::vector<ActiveContact>& list, SceneState& state, StepOutcome& outcome,
                      ImpulseBooking booking, double target_residual = 0) {
    const ContactProblem& problem = rows.problem;
    if (!problem.W.allFinite() || !problem.b.allFinite()) {
      // Velocities have overflowed: return NaN.
      state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
      outcome.solved = false;
      return;
    }
    // Solve from the impulses in the list.
    ContactSolverOptions options = solver_options;
    double accepted = options.tolerance;
    if (target_residual > 0) {
      options.tolerance = target_residual;
      accepted = std::max(accepted, kMaxTolerance);
    }
    const ContactSolution& answer = solver.solve(problem, rows.warm_start(list), options);
    const bool converged = solver_options.method == ContactMethod::kPyramid
                               ? answer.status == Status::kSolved
                               : answer.residual.is_within(accepted);
    outcome.solved = outcome.solved && converged;
    outcome.residual = answer.residual.natural;
    // Apply impulses, book the energy that they dissipate, and store the solution.
    pushed.noalias() = rows.Jt * answer.f;
    free.apply_impulses(pushed);
    v_mean = 0.5 * (state.v + free.v);
    mean_u.noalias() = rows.Jt.transpose() * v_mean;
    add_impulse_losses(list, problem.blocks, answer.f, mean_u, booking, state.w);
    state.v = free.v;
    rows.store_solution(answer, list);
  }

  MovingScene scene;
  TreeModel model;
  SceneMotion motion;
  std::optional<SceneContacts> contacts;  // constructed after check_scene()
  AppliedEfforts efforts;
  FreeVelocity free;
  ContactRows rows;
  std::unique_ptr<ArticulatedBody<double>> articulated;  // null if joints share coordinates
  ContactSolver solver;
  ContactSolverOptions solver_options;
  // Workspace of a step.
  Eigen::VectorXd v_mean, pushed;      // mean velocity; generalized impulses J' P (v), (v)
  Eigen::VectorXd mean_u;              // mean of the velocities before and after impulses (rows)
  Eigen::VectorXd z_before, v_before;  // element states and velocities at the start (z), (v)
  std::vector<ActiveContact> found;
};

ContactStep::ContactStep(const MovingScene& scene) : parts_(std::make_unique<Parts>(scene)) {}
ContactStep::~ContactStep() = default;
ContactStep::ContactStep(ContactStep&&) noexcept = default;
ContactStep& ContactStep::operator=(ContactStep&&) noexcept = default;

void ContactStep::set_drives(std::vector<SceneDrive> drives) {
  parts_->scene.drives = std::move(drives);
  parts_->efforts.update_force_kinds();
}

void ContactStep::set_solver_options(const ContactSolverOptions& options) {
  parts_->solver_options = options;
}

void ContactStep::select_active_forces(double t) { parts_->efforts.select_active_forces(t); }

void ContactStep::clear_memory() {
  Parts& p = *parts_;
  p.contacts->reset_pairs();
  p.efforts.reset_elements();
  p.solver = ContactSolver();
  p.motion.invalidate();
}

const MovingScene& ContactStep::scene() const { return parts_->scene; }
const TreeModel& ContactStep::model() const { return parts_->model; }

// State and kinematics.

SceneState ContactStep::initial_state() const {
  const Parts& p = *parts_;
  return {0, p.scene.q, p.scene.v, p.efforts.elements.initial_states(p.scene.q)};
}

void ContactStep::find_contacts(const SceneState& state, double margin,
                                std::vector<ActiveContact>& out) {
  Parts& p = *parts_;
  if (p.contacts->may_touch()) p.motion.set_state(state);
  p.contacts->find_contacts(p.motion, state, margin, out);
}

void ContactStep::find_deepest_new(const std::vector<ActiveContact>& found,
                                   const std::vector<ActiveContact>& closed, StepOutcome& outcome) {
  outcome.min_new_gap = outcome.new_closing_speed = 0;
  for (const ActiveContact& contact : found)
    if (find_contact(closed, contact) == nullptr) record_if_deepest(contact, outcome);
}

double ContactStep::tunnelling_ratio(const SceneState& from, const SceneState& to,
                                     const std::vector<ActiveContact>& touching) {
  return parts_->contacts->tunnelling_ratio(parts_->motion, from, to, touching);
}

void ContactStep::compute_poses(const SceneState& state, std::vector<Pose<double>>& out) {
  parts_->motion.set_position(state.q);
  out.resize(parts_->scene.mechanism.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = parts_->motion.links().pose(static_cast<int>(i));
}

void ContactStep::normalise_quaternions(Eigen::VectorXd& q) const {
  const MechanismLayout& layout = parts_->model.layout;
  for (const int i : layout.quaternion_joints) q.segment<4>(layout.first_q[i]).normalize();
}

bool ContactStep::compute_free_rates(const SceneState& state, Eigen::VectorXd& q_dot,
                                     Eigen::VectorXd& v_dot, Eigen::VectorXd& z_dot) {
  Parts& p = *parts_;
  // Compute efforts and powers at the state.
  p.motion.set_state(state);
  const bool acted = p.efforts.compute(p.motion, state, ElementNeed::kRates);
  z_dot = p.efforts.elements.action().z_rate;
  p.efforts.compute_powers(p.motion,
                           {state.t, p.efforts.selection_time(), 0, 0, state.q, state.v, state.v});
  position_rates(p.scene.mechanism, p.model.layout, state.q, state.v, q_dot);
  // Compute accelerations by articulated bodies, or by the mass matrix if joints share coordinates.
  if (p.articulated) {
    p.articulated->accelerations(p.motion.links(), p.scene.gravity, p.efforts.tau, v_dot);
    return acted;
  }
  p.free.mass.compute(p.motion.links());
  p.free.solve_efforts(p.motion, p.efforts, 1, v_dot);
  return acted;
}

bool ContactStep::is_stiff(const SceneState& state, double h) {
  Parts& p = *parts_;
  if (!p.efforts.has_slopes()) return false;
  // Compare slopes at the state with the diagonal of the mass matrix.
  p.motion.set_state(state);
  p.efforts.compute(p.motion, state);
  p.free.mass.compute(p.motion.links());
  const ElementAction& action = p.efforts.elements.action();
  for (int i = 0; i < p.model.layout.v; ++i) {
    double slope = h * p.efforts.damping[i] + h * h * p.efforts.stiffness[i];
    if (!p.efforts.elements.empty())
      slope += h * action.damping(i, i) + h * h * action.stiffness(i, i);
    if (slope > p.free.mass(i, i)) return true;
  }
  // An explicit step would overshoot a faster decay of element states.
  return !p.efforts.elements.empty() && (h * action.z_decay).maxCoeff() > 1;
}

// Steps.

void ContactStep::take_euler_substep(SceneState& state, double h,
                                     const std::vector<ActiveContact>& closed, double touch,
                                     StepOutcome& outcome) {
  Parts& p = *parts_;
  outcome.clear();
  // Advance positions to the end of the substep.
  if (!p.advance(h, state)) return;
  // Find contacts there. Contacts of `closed` stay active; others only set min_new_gap.
  p.motion.set_state(state);
  p.contacts->find_contacts(p.motion, state, touch + kSearchMargin, p.found);
  for (ActiveContact& contact : p.found) {
    const ActiveContact* const old = find_contact(closed, contact);
    if (old == nullptr) {
      record_if_deepest(contact, outcome);
      continue;
    }
    if (old->mode == ContactMode::kOpen && contact.gap > touch) continue;
    contact.impulse = old->impulse;
    contact.torsion = old->torsion;
    outcome.active.push_back(contact);
  }
  // Compute the velocity without impulses, by forces at (q+, v), implicit in springs and dampers.
  const bool acted = p.efforts.compute(p.motion, state);
  outcome.solved = p.free.compute(p.motion, p.efforts, state, h, 1) && acted;
  p.efforts.advance_states(h, state);
  // Solve for the impulses of active contacts.
  if (outcome.active.empty()) {
    state.v = p.free.v;
  } else {
    p.assemble_rows(outcome.active, h);
    p.solve_contacts(outcome.active, state, outcome, ImpulseBooking::kNet);
  }
  // Add the energy flows of the substep.
  p.efforts.compute_powers(
      p.motion, {state.t, p.efforts.selection_time(), h, 1, state.q, p.motion.speeds(), state.v});
  state.w += h * p.efforts.power;
}

void ContactStep::take_midpoint_step(SceneState& state, double h,
                                     const std::vector<ActiveContact>& last, double recovery,
                                     StepOutcome& outcome) {
  Parts& p = *parts_;
  outcome.clear();
  // Advance positions to the midpoint.
  if (!p.advance(0.5 * h, state)) return;
  p.motion.set_state(state);
  // Advance element states to the midpoint.
  p.z_before = state.z;
  p.v_before = state.v;
  bool acted = true;
  if (!p.efforts.elements.empty()) {
    acted = p.efforts.elements.compute_action(
        p.efforts.element_input(p.motion, state, ElementNeed::kStates));
    p.efforts.advance_states(0.5 * h, state);
  }
  // Compute the velocity without impulses, by efforts at the midpoint.
  acted = p.efforts.compute(p.motion, state) && acted;
  outcome.solved = p.free.compute(p.motion, p.efforts, state, h, 0.5) && acted;
  // Recompute it with the velocity product at the mean velocity. Efforts remain those at v, because
  // A contains their slopes.
  p.v_mean = 0.5 * (state.v + p.free.v);
  p.motion.set_speeds(p.v_mean);
  p.free.v = state.v;
  p.free.add_efforts(p.motion, p.efforts, h);
  // Zero the residual speeds of joints that friction has stopped: their squares would underflow.
  p.free.v = (p.free.v.array().abs() < kUnderflowSpeed).select(0, p.free.v);
  // Find contacts that may close within the step; copy modes and impulses of the previous step.
  const double margin = h * p.contacts->max_relative_speed(p.motion, p.free.v) + kExtraMargin;
  p.contacts->find_contacts(p.motion, state, std::min(margin, kMaxMargin), outcome.active);
  for (ActiveContact& contact : outcome.active)
    for (const ActiveContact& old : last)
      if (old.is_same_contact(contact)) {
        contact.impulse = old.impulse;
        contact.torsion = old.torsion;
        contact.mode = old.mode;
        contact.previous = old.previous;
      }
  // Solve for the impulses, with gap and mean-of-both-ends terms in b.
  if (outcome.active.empty()) {
    state.v = p.free.v;
  } else {
    p.assemble_rows(outcome.active, h);
    p.rows.add_midpoint_terms(state.v, h, recovery, outcome.active);
    p.solve_contacts(outcome.active, state, outcome, ImpulseBooking::kLosses, p.gap_rounding(h));
  }
  // Advance element states, energy flows and positions to the end.
  outcome.solved = p.finish_elements(h, state) && outcome.solved;
  p.add_flows(h, state);
  advance_positions(p.scene.mechanism, p.model.layout, state.v, 0.5 * h, state.q);
  state.t += 0.5 * h;
}

// Impact and projection.

void ContactStep::resolve_impact(SceneState& state, const std::vector<ActiveContact>& touching,
                                 StepOutcome& outcome) {
  Parts& p = *parts_;
  // Set up the contact problem at a fixed position and h = 0, where efforts have no effect.
  outcome = {};
  if (touching.empty()) return;
  p.motion.set_state(state);
  outcome.solved = p.free.compute(p.motion, p.efforts, state, 0, 0);
  outcome.active = touching;
  p.assemble_rows(outcome.active, 0);
  p.rows.apply_restitution(outcome.active);
  p.solve_contacts(outcome.active, state, outcome, ImpulseBooking::kLosses);
}

void ContactStep::close_gaps(SceneState& state, const std::vector<ActiveContact>& touching,
                             double max_correction) {
  Parts& p = *parts_;
  // Iterate, because gaps are nonlinear in the positions.
  for (int iteration = 0; iteration < kProjections; ++iteration) {
    p.motion.set_state(state);
    p.contacts->find_contacts(p.motion, state, kSearchMargin, p.found);
    // Collect contacts with a force, without friction: they have normal rows only.
    std::vector<ActiveContact> pressed;
    double max_gap = 0;
    for (ActiveContact& contact : p.found) {
      const bool has_force = any_of(touching, [&](const ActiveContact& old) {
        return old.is_same_contact(contact) && old.mode != ContactMode::kOpen;
      });
      if (!has_force || contact.kind == Kind::kJointFriction) continue;
      contact.friction = {};
      max_gap = std::max(max_gap, std::abs(contact.gap));
      pressed.push_back(contact);
    }
    if (max_gap < kGapLimit) break;
    // Assemble J and W = J M^-1 J', and the corrections of the gaps.
    p.free.mass.compute(p.motion.links());
    p.rows.assemble(pressed, 0, p.motion.links(), p.free.mass);
    Eigen::VectorXd gaps(static_cast<Eigen::Index>(pressed.size()));
    for (std::size_t k = 0; k < pressed.size(); ++k)
      gaps[k] = std::clamp(-pressed[k].gap, -max_correction, max_correction);
    // Solve for the least motion in the metric of M; contacts may be redundant.
    Eigen::VectorXd move =
        p.rows.Jt * p.rows.problem.W.completeOrthogonalDecomposition().solve(gaps);
    p.free.mass.solve(p.model, move);
    advance_positions(p.scene.mechanism, p.model.layout, move, 1, state.q);
    if (max_gap > max_correction) break;  // correct the rest in later steps
  }
}

// Energy.

SceneEnergy ContactStep::energy(const SceneState& state) {
  // Compute kinetic, gravitational and joint spring energies.
  Parts& p = *parts_;
  p.motion.set_state(state);
  SceneEnergy out;
  out.kinetic = p.motion.links().kinetic_energy();
  out.weight = p.motion.links().weight_energy(p.scene.gravity);
  out.springs = p.efforts.spring_energy(state);
  // Add the energy of elements, passive ones separately.
  const SceneElements::Energy stored = p.efforts.elements.energy(p.element_input(state));
  out.of_elements = stored.active;
  out.of_passive = stored.total - stored.active;
  out.springs += stored.total;
  return out;
}

double ContactStep::kinetic_energy(const SceneState& state) {
  parts_->motion.set_state(state);
  return parts_->motion.links().kinetic_energy();
}

Eigen::Index ContactStep::free_flow_count() const {
  return parts_->efforts.has_flows() ? kFreeFlowCount : 0;
}

Eigen::VectorBlock<const EnergyFlows> ContactStep::free_powers() const {
  const EnergyFlows& power = parts_->efforts.power;
  return power.head(free_flow_count());
}

// Force elements.

double ContactStep::element_step_error(const SceneState& state) {
  return parts_->efforts.elements.max_step_error(parts_->element_input(state));
}

void ContactStep::accept_step(const SceneState& state) {
  parts_->efforts.elements.accept_step(parts_->element_input(state));
}

double ContactStep::max_element_step() const { return parts_->efforts.elements.max_step_length(); }

void ContactStep::add_element_contacts(const SceneState& state, std::vector<ContactSample>& out) {
  parts_->efforts.elements.add_contacts(parts_->element_input(state), out);
}

bool ContactStep::elements_may_start_motion(const SceneState& state) {
  return parts_->efforts.elements.may_start_motion(parts_->element_input(state));
}

std::vector<ElementControl> ContactStep::element_controls() const {
  return parts_->efforts.elements.controls();
}

void ContactStep::set_element_control(const std::string& name, double value) {
  parts_->efforts.elements.set_control(name, value);
}

std::vector<ElementValue> ContactStep::element_readings(const SceneState& state) {
  return parts_->efforts.elements.readings(parts_->element_input(state));
}

}  // namespace thenar
