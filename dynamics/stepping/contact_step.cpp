#include "dynamics/stepping/contact_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
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

constexpr double kUnderflowSpeed = 1e-150;  // Speeds below this become 0, because their squares
                                            // underflow [m/s], [rad/s]
constexpr double kMostTolerance = 1e-9;  // tolerance of contact problems, whatever rounding is [1]
constexpr double kGapRoundings = 8;      // of positions, in gaps [1]
constexpr double kLeastSize = 0.1;       // of a scene, for its rounding [m]

/// Notes a contact that was not closed before.
void note_deeper(const ActiveContact& contact, StepOutcome& outcome) {
  if (contact.kind == Kind::kJointFriction || !(contact.gap < outcome.deepest_new)) return;
  outcome.deepest_new = contact.gap;
  outcome.closing_new = -contact.approach;
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

  /// Speeds of links at the mean of those before and after a midpoint step, and the states of
  /// elements at its end by their rates in its middle. @param state  positions and states of the
  /// middle, speeds after
  bool end_elements(double h, SceneState& state) {
    v_mean = 0.5 * (v_before + state.v);
    motion.speed_up(v_mean);
    if (efforts.elements.empty()) return true;
    const bool acted = efforts.elements.act({state.t, efforts.acting(), state.q, v_mean, state.z,
                                             motion.links(), 0, ElementNeed::kRates});
    state.z = z_before + h * efforts.elements.action().z_rate;
    return acted;
  }

  /// Flows of a midpoint step, after end_elements().
  void end_flows(double h, SceneState& state) {
    // Powers of efforts with their slopes over the step, and their sums.
    efforts.find_powers(motion, {state.t, efforts.acting(), h, 0.5, state.q, v_before, state.v});
    state.w += h * efforts.power;
    state.w[kWorked] += h * std::abs(efforts.power[kApplied]);
    if (!efforts.elements.empty()) state.w[kWorked] += std::abs((state.z - z_before).tail<1>()[0]);
    state.w[kMostKinetic] = std::max(state.w[kMostKinetic], motion.links().kinetic_energy());
  }

  /// Residual that rounding of gaps amounts to in the problem of a midpoint step [1].
  [[nodiscard]] double rounding_of_gaps(double h) const {
    // Rounding of positions, as a speed over the largest velocity of the problem.
    const double size = contacts->extent(kLeastSize);
    const double rounding = kGapRoundings * std::numeric_limits<double>::epsilon() * size;
    const double share = 2 * rounding / (h * rows.problem.b.lpNorm<Eigen::Infinity>());
    return std::max(solver_options.tolerance, std::min(share, kMostTolerance));
  }

  /// Sets the rows of contacts, with their velocities without impulses.
  void set_rows(const std::vector<ActiveContact>& list, double h) {
    rows.set(list, h, motion.links(), free.mass);
    rows.problem.b.noalias() = rows.J.transpose() * free.v;
  }

  /// Solves, moves the speeds, and writes impulses, velocities and modes into the list.
  /// @param aim  0: to the tolerance; otherwise the residual to go to, 1e-9 being enough
  void solve(std::vector<ActiveContact>& list, SceneState& state, StepOutcome& outcome,
             ImpulseBooking booking, double aim = 0) {
    const ContactProblem& problem = rows.problem;
    if (!problem.W.allFinite() || !problem.b.allFinite()) {
      // Speeds have overflowed: the caller sees a state that is no number.
      state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
      outcome.solved = false;
      return;
    }
    // Contact problem; with an aim, 1e-9 is good enough where the solver stops short of it.
    ContactSolverOptions options = solver_options;
    double enough = options.tolerance;
    if (aim > 0) {
      options.tolerance = aim;
      enough = std::max(enough, kMostTolerance);
    }
    const ContactSolution& answer = solver.solve(problem, rows.warm_start(list), options);
    const bool arrived = solver_options.method == ContactMethod::kPyramid
                             ? answer.status == Status::kSolved
                             : answer.residual.is_within(enough);
    outcome.solved = outcome.solved && arrived;
    outcome.residual = answer.residual.natural;
    // Impulses change the speeds, take energy and leave modes.
    pushed.noalias() = rows.J * answer.f;
    free.push(pushed);
    v_mean = 0.5 * (state.v + free.v);
    mean_u.noalias() = rows.J.transpose() * v_mean;
    add_impulse_losses(list, problem.blocks, answer.f, mean_u, booking, state.w);
    state.v = free.v;
    rows.read(answer, list);
  }

  MovingScene scene;
  TreeModel model;
  SceneMotion motion;
  std::optional<SceneContacts> contacts;  // made after the scene was checked
  AppliedEfforts efforts;
  FreeVelocity free;
  ContactRows rows;
  std::unique_ptr<ArticulatedBody<double>> articulated;  // null: joints share coordinates
  ContactSolver solver;
  ContactSolverOptions solver_options;
  // Room of a step.
  Eigen::VectorXd v_mean, pushed;
  Eigen::VectorXd mean_u;              // of rows, before and after their impulses (rows)
  Eigen::VectorXd z_before, v_before;  // of a midpoint step
  std::vector<ActiveContact> found;
};

ContactStep::ContactStep(const MovingScene& scene) : parts_(std::make_unique<Parts>(scene)) {}
ContactStep::~ContactStep() = default;
ContactStep::ContactStep(ContactStep&&) noexcept = default;
ContactStep& ContactStep::operator=(ContactStep&&) noexcept = default;

void ContactStep::act_as_at(double t) { parts_->efforts.act_as_at(t); }

void ContactStep::set_drives(std::vector<SceneDrive> drives) {
  parts_->scene.drives = std::move(drives);
  parts_->efforts.note_what_acts();
}

void ContactStep::solve_contacts_by(const ContactSolverOptions& options) {
  parts_->solver_options = options;
}

const MovingScene& ContactStep::scene() const { return parts_->scene; }
const TreeModel& ContactStep::model() const { return parts_->model; }

void ContactStep::find(const SceneState& state, double margin, std::vector<ActiveContact>& out) {
  Parts& p = *parts_;
  if (p.contacts->may_touch()) p.motion.place(state);
  p.contacts->find(p.motion, state, margin, out);
}

void ContactStep::substep(SceneState& state, double h, const std::vector<ActiveContact>& closed,
                          double touch, StepOutcome& outcome) {
  Parts& p = *parts_;
  outcome.clear();
  // Positions at the end of the substep.
  advance(p.scene.mechanism, p.model.layout, state.v, h, state.q);
  state.t += h;
  if (!state.q.allFinite()) {
    state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  // Contacts there: contacts of `closed` act on, the others only tell how deep they are.
  p.motion.place(state);
  p.contacts->find(p.motion, state, touch + kNearGap, p.found);
  for (ActiveContact& contact : p.found) {
    const auto old = find_same(closed, contact);
    if (old == closed.end()) {
      note_deeper(contact, outcome);
      continue;
    }
    if (old->mode == ContactMode::kOpen && contact.gap > touch) continue;
    contact.impulse = old->impulse;
    contact.torsion = old->torsion;
    outcome.active.push_back(contact);
  }
  // Speeds without impulses, by forces at q+ and v with their slopes at the end.
  const bool acted = p.efforts.load(p.motion, state);
  outcome.solved = p.free.set(p.motion, p.efforts, state, h, 1) && acted;
  p.efforts.advance_states(h, state);
  // Impulses on contacts, if there are any.
  if (outcome.active.empty()) {
    state.v = p.free.v;
  } else {
    p.set_rows(outcome.active, h);
    p.solve(outcome.active, state, outcome, ImpulseBooking::kNet);
  }
  // Energy flows of the substep.
  p.efforts.find_powers(
      p.motion, {state.t, p.efforts.acting(), h, 1, state.q, p.motion.placed_speeds(), state.v});
  state.w += h * p.efforts.power;
}

void ContactStep::time_step(SceneState& state, double h, const std::vector<ActiveContact>& last,
                            double recovery, StepOutcome& outcome) {
  Parts& p = *parts_;
  const MechanismLayout& layout = p.model.layout;
  outcome.clear();
  // Positions at the middle of the step.
  advance(p.scene.mechanism, layout, state.v, 0.5 * h, state.q);
  state.t += 0.5 * h;
  if (!state.q.allFinite()) {
    state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  p.motion.place(state);
  // States of elements at the middle, then their efforts there.
  p.z_before = state.z;
  p.v_before = state.v;
  bool acted = true;
  if (!p.efforts.elements.empty()) {
    acted = p.efforts.elements.act(p.efforts.input_at(p.motion, state, ElementNeed::kStates));
    p.efforts.advance_states(0.5 * h, state);
  }
  // Speeds without impulses, by efforts with their slopes in the mean of the step.
  acted = p.efforts.load(p.motion, state) && acted;
  outcome.solved = p.free.set(p.motion, p.efforts, state, h, 0.5) && acted;
  // Repeat with the velocity product at the mean of the speeds before and after. Efforts stay,
  // because the mass matrix has their slopes.
  p.v_mean = 0.5 * (state.v + p.free.v);
  p.motion.speed_up(p.v_mean);
  p.free.v = state.v;
  p.free.add_efforts(p.motion, p.efforts, h);
  // Joints that friction has stopped keep ever smaller rests of speed, whose squares underflow.
  p.free.v = (p.free.v.array().abs() < kUnderflowSpeed).select(0, p.free.v);
  // Contacts that may close their gaps within the step, with modes and impulses of the part before.
  const double margin = h * p.contacts->fastest(p.motion, p.free.v) + 1e-5;
  p.contacts->find(p.motion, state, std::min(margin, 0.05), outcome.active);
  for (ActiveContact& contact : outcome.active)
    for (const ActiveContact& old : last)
      if (old.same(contact)) {
        contact.impulse = old.impulse;
        contact.torsion = old.torsion;
        contact.mode = old.mode;
        contact.before = old.before;
      }
  // Impulses, with gaps and the mean of both ends in the velocities without impulses.
  if (outcome.active.empty()) {
    state.v = p.free.v;
  } else {
    p.set_rows(outcome.active, h);
    p.rows.add_speeds_before(state.v, h, recovery, outcome.active);
    p.solve(outcome.active, state, outcome, ImpulseBooking::kLosses, p.rounding_of_gaps(h));
  }
  // States of elements and energy flows, then positions at the end.
  outcome.solved = p.end_elements(h, state) && outcome.solved;
  p.end_flows(h, state);
  advance(p.scene.mechanism, layout, state.v, 0.5 * h, state.q);
  state.t += 0.5 * h;
}

double ContactStep::motion_between(const SceneState& from, const SceneState& to,
                                   const std::vector<ActiveContact>& touching) {
  return parts_->contacts->motion_between(parts_->motion, from, to, touching);
}

void ContactStep::impact(SceneState& state, const std::vector<ActiveContact>& touching,
                         StepOutcome& outcome) {
  Parts& p = *parts_;
  // Contact problem at a fixed position and over no time: efforts do not count.
  outcome = {};
  if (touching.empty()) return;
  p.motion.place(state);
  outcome.solved = p.free.set(p.motion, p.efforts, state, 0, 0);
  outcome.active = touching;
  p.set_rows(outcome.active, 0);
  p.rows.bounce(outcome.active);
  p.solve(outcome.active, state, outcome, ImpulseBooking::kLosses);
}

void ContactStep::close_gaps(SceneState& state, const std::vector<ActiveContact>& touching,
                             double most) {
  Parts& p = *parts_;
  // Repeat up to three times, because gaps do not close linearly.
  for (int round = 0; round < 3; ++round) {
    p.motion.place(state);
    p.contacts->find(p.motion, state, kNearGap, p.found);
    // Normal rows of contacts that have a force.
    std::vector<ActiveContact> pressed;
    double worst = 0;
    for (ActiveContact& contact : p.found) {
      const bool has_force =
          std::any_of(touching.begin(), touching.end(), [&](const ActiveContact& old) {
            return old.same(contact) && old.mode != ContactMode::kOpen;
          });
      if (!has_force || contact.kind == Kind::kJointFriction) continue;
      contact.friction = {};
      worst = std::max(worst, std::abs(contact.gap));
      pressed.push_back(contact);
    }
    if (worst < 1e-13) break;
    // Least motion in the metric of M that closes all gaps, also where they are redundant.
    p.free.mass.set(p.motion.links());
    p.rows.set(pressed, 0, p.motion.links(), p.free.mass);
    Eigen::VectorXd gaps(static_cast<Eigen::Index>(pressed.size()));
    for (std::size_t k = 0; k < pressed.size(); ++k)
      gaps[static_cast<Eigen::Index>(k)] = std::clamp(-pressed[k].gap, -most, most);
    Eigen::VectorXd move =
        p.rows.J * p.rows.problem.W.completeOrthogonalDecomposition().solve(gaps);
    p.free.mass.solve(p.model, move);
    advance(p.scene.mechanism, p.model.layout, move, 1, state.q);
    if (worst > most) break;  // more would be too fast
  }
}

void ContactStep::poses(const SceneState& state, std::vector<Pose<double>>& out) {
  parts_->motion.move_to(state.q);
  out.resize(parts_->scene.mechanism.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = parts_->motion.links().pose(static_cast<int>(i));
}

SceneEnergy ContactStep::energy(const SceneState& state) {
  // Kinetic energy, weights and springs of joints.
  Parts& p = *parts_;
  p.motion.place(state);
  SceneEnergy out;
  out.kinetic = p.motion.links().kinetic_energy();
  out.weight = p.motion.links().weight_energy(p.scene.gravity);
  out.springs = p.efforts.spring_energy(state);
  // Elements, of which passive ones are told apart.
  const SceneElements::Energy stored =
      p.efforts.elements.energy(p.efforts.input_at(p.motion, state));
  out.of_elements = stored.active;
  out.of_passive = stored.all - stored.active;
  out.springs += stored.all;
  return out;
}

double ContactStep::kinetic_energy(const SceneState& state) {
  parts_->motion.place(state);
  return parts_->motion.links().kinetic_energy();
}

bool ContactStep::free_rates(const SceneState& state, Eigen::VectorXd& q_dot,
                             Eigen::VectorXd& v_dot, Eigen::VectorXd& z_dot) {
  Parts& p = *parts_;
  // Efforts and powers at the state.
  p.motion.place(state);
  const bool acted = p.efforts.load(p.motion, state, ElementNeed::kRates);
  z_dot = p.efforts.elements.action().z_rate;
  p.efforts.find_powers(p.motion, {state.t, p.efforts.acting(), 0, 0, state.q, state.v, state.v});
  position_rates(p.scene.mechanism, p.model.layout, state.q, state.v, q_dot);
  // Accelerations by articulated bodies, or by the mass matrix where joints share coordinates.
  if (p.articulated) {
    p.articulated->accelerations(p.motion.links(), p.scene.gravity, p.efforts.tau, v_dot);
    return acted;
  }
  p.free.mass.set(p.motion.links());
  p.free.solve_efforts(p.motion, p.efforts, 1, v_dot);
  return acted;
}

Eigen::Index ContactStep::free_flows() const {
  return parts_->efforts.has_flows() ? kFreeFlows : 0;
}

Eigen::VectorBlock<const EnergyFlows> ContactStep::free_powers() const {
  const EnergyFlows& power = parts_->efforts.power;
  return power.head(free_flows());
}

SceneState ContactStep::start() const {
  const Parts& p = *parts_;
  return {0, p.scene.q, p.scene.v, p.efforts.elements.start(p.scene.q)};
}

void ContactStep::accept(const SceneState& state) {
  Parts& p = *parts_;
  if (p.efforts.elements.empty()) return;
  p.motion.place(state);
  p.efforts.elements.accept(p.efforts.input_at(p.motion, state));
}

double ContactStep::elements_doubt(const SceneState& state) {
  Parts& p = *parts_;
  if (p.efforts.elements.empty()) return 0;
  p.motion.place(state);
  return p.efforts.elements.doubt(p.efforts.input_at(p.motion, state));
}

double ContactStep::elements_foresee() const { return parts_->efforts.elements.foresees(); }

void ContactStep::add_element_contacts(const SceneState& state, std::vector<ContactSample>& out) {
  Parts& p = *parts_;
  if (p.efforts.elements.empty()) return;
  p.motion.place(state);
  p.efforts.elements.add_contacts(p.efforts.input_at(p.motion, state), out);
}

bool ContactStep::elements_move(const SceneState& state) {
  Parts& p = *parts_;
  if (p.efforts.elements.empty()) return false;
  p.motion.place(state);
  return p.efforts.elements.moves(p.efforts.input_at(p.motion, state));
}

std::vector<ElementControl> ContactStep::controls() const {
  return parts_->efforts.elements.controls();
}

void ContactStep::set_control(const std::string& name, double value) {
  parts_->efforts.elements.set_control(name, value);
}

std::vector<ElementValue> ContactStep::readings(const SceneState& state) {
  Parts& p = *parts_;
  if (p.efforts.elements.empty()) return {};
  p.motion.place(state);
  return p.efforts.elements.readings(p.efforts.input_at(p.motion, state));
}

void ContactStep::forget() {
  Parts& p = *parts_;
  p.contacts->forget();
  p.efforts.forget();
  p.solver = ContactSolver();
  p.motion.forget();
}

void ContactStep::note_new(const std::vector<ActiveContact>& found,
                           const std::vector<ActiveContact>& closed, StepOutcome& outcome) {
  outcome.deepest_new = outcome.closing_new = 0;
  for (const ActiveContact& contact : found)
    if (find_same(closed, contact) == closed.end()) note_deeper(contact, outcome);
}

bool ContactStep::is_stiff(const SceneState& state, double h) {
  Parts& p = *parts_;
  if (!p.efforts.has_slopes()) return false;
  // Slopes at the state against the diagonal of the mass matrix.
  p.motion.place(state);
  p.efforts.load(p.motion, state);
  p.free.mass.set(p.motion.links());
  const ElementAction& action = p.efforts.elements.action();
  for (int i = 0; i < p.model.layout.v; ++i) {
    double slope = h * p.efforts.damping[i] + h * h * p.efforts.stiffness[i];
    if (!p.efforts.elements.empty())
      slope += h * action.damping(i, i) + h * h * action.stiffness(i, i);
    if (slope > p.free.mass(i, i)) return true;
  }
  // Decay of element states, which an explicit step must not overshoot.
  return !p.efforts.elements.empty() && (h * action.z_decay).maxCoeff() > 1;
}

void ContactStep::normalise(Eigen::VectorXd& q) const {
  if (has_no_quaternion(parts_->model.layout)) return;
  const std::vector<MechanismJoint>& joints = parts_->scene.mechanism.joints;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].kind == JointKind::kBall || joints[i].kind == JointKind::kFree)
      q.segment<4>(parts_->model.layout.first_q[i]).normalize();
}

}  // namespace thenar
