#include "dynamics/stepping/contact_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/stepping/impulse_losses.h"
#include "dynamics/stepping/meeting_pairs.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

constexpr double kNoSlip = 1e-9;  // slower is sticking [m/s], [rad/s]
constexpr double kUnderflowSpeed =
    1e-150;                              // slower is at rest: squares are no numbers [m/s], [rad/s]
constexpr double kMostTolerance = 1e-9;  // tolerance of contact problems, whatever rounding is [1]
constexpr double kGapRoundings = 8;      // of positions, in gaps [1]
constexpr double kLeastSize = 0.1;       // of a scene, for its rounding [m]
constexpr double kMeanWeight = 0.75;     // share of this step in what the mean takes up [1]

/// Notes a contact that was not closed before.
void note_deeper(const ActiveContact& contact, StepOutcome& outcome) {
  if (contact.kind == Kind::kJointFriction || !(contact.gap < outcome.deepest_new)) return;
  outcome.deepest_new = contact.gap;
  outcome.closing_new = -contact.approach;
}

}  // namespace

struct ContactStep::Parts {
  explicit Parts(const MovingScene& s)
      : scene(s),
        model(tree_model(scene.mechanism)),
        motion(model),
        mass(model),
        inverse(model),
        elements(scene.elements, model.layout.v) {
    check_scene(scene);
    if (!model.has_couplings) articulated = std::make_unique<ArticulatedBody<double>>(model);
    const int n = model.layout.v;
    tau = v_free = zero = change = stiffness = damping = implicit = Eigen::VectorXd::Zero(n);
    motion.clear_loads();
    for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i)
      if (is_scalar(scene.mechanism.joints[i].kind) && resists(scene.mechanism.joints[i]))
        resisting.push_back(i);
    note_what_acts();
    build_collision();
  }

  template <typename Each>
  static bool resists(const Each& each) {
    return each.stiffness > 0 || each.damping > 0;
  }

  /// Notes what kinds of forces there are at all.
  void note_what_acts() {
    has_slopes = !elements.empty() || !resisting.empty() ||
                 std::any_of(scene.drives.begin(), scene.drives.end(), resists<SceneDrive>);
    has_flows = !elements.empty() || has_powers(scene);
  }

  void build_collision() {
    std::vector<std::shared_ptr<const CollisionBody>> bodies;
    for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i) {
      const std::shared_ptr<const Solid>& solid = scene.mechanism.bodies[i].solid;
      if (!solid) continue;
      bodies.push_back(collision_body(*solid));
      body_of.push_back(static_cast<int>(i));
    }
    X_WB.resize(body_of.size());
    X_before.resize(body_of.size());
    way.resize(body_of.size());
    may_meet.assign(body_of.size() * body_of.size(), false);
    // Only these pairs are asked for contacts.
    const std::vector<std::pair<int, int>> pairs = pairs_that_may_meet(scene, model);
    for (std::size_t i = 0; i < body_of.size(); ++i)
      for (std::size_t j = i + 1; j < body_of.size(); ++j)
        if (std::binary_search(pairs.begin(), pairs.end(), std::pair(body_of[i], body_of[j])))
          may_touch = may_meet[i * body_of.size() + j] = true;
    set_world(std::move(bodies));
  }

  /// A world in which no pair has met yet.
  void set_world(std::vector<std::shared_ptr<const CollisionBody>> bodies) {
    world = std::make_unique<CollisionWorld>(std::move(bodies));
    for (std::size_t i = 0; i < body_of.size(); ++i)
      for (std::size_t j = i + 1; j < body_of.size(); ++j)
        if (!may_meet[i * body_of.size() + j])
          world->exclude(static_cast<int>(i), static_cast<int>(j));
  }

  /// Links at a state; nothing is done where they are there already.
  void place(const SceneState& state) {
    if (is_placed && placed_q == state.q && placed_v == state.v) return;
    motion.set_position(state.q);
    motion.set_speed(state.v);
    placed_q = state.q;
    placed_v = state.v;
    is_placed = true;
  }
  /// Links at a position, or at other speeds, for once.
  void move_to(const Eigen::VectorXd& q) {
    is_placed = false;
    motion.set_position(q);
  }
  void speed_up(const Eigen::VectorXd& v) {
    is_placed = false;
    motion.set_speed(v);
  }

  /// Largest displacement of a point of a collision body between two poses.
  [[nodiscard]] double displacement(std::size_t i) const {
    const Ball& ball = world->bodies()[i]->ball;
    return (X_WB[i] * ball.c - X_before[i] * ball.c).norm() +
           (X_WB[i].R - X_before[i].R).norm() * ball.r;
  }

  /// Whether two collision bodies press on each other.
  [[nodiscard]] bool press(const std::vector<ActiveContact>& touching, std::size_t i,
                           std::size_t j) const {
    return std::any_of(touching.begin(), touching.end(), [&](const ActiveContact& contact) {
      return contact.kind == Kind::kContact && contact.a == body_of[i] && contact.b == body_of[j] &&
             contact.mode != ContactMode::kOpen;
    });
  }

  /// Value and rate of a joint's limit at a state.
  [[nodiscard]] JointValue value_of(std::size_t joint, const SceneState& state) const {
    return joint_value(scene.mechanism.joints[joint], state.q[model.layout.first_q[joint]]);
  }

  /// All contacts within the margin, limits within it, and dry frictions; after place(), where
  /// bodies may touch.
  void find(const SceneState& state, double margin, std::vector<ActiveContact>& out) {
    out.clear();
    if (may_touch) find_contacts(margin, out);
    for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i)
      find_joint(i, state, margin, out);
  }

  void find_contacts(double margin, std::vector<ActiveContact>& out) {
    for (std::size_t i = 0; i < body_of.size(); ++i) X_WB[i] = motion.pose(body_of[i]);
    for (const BodyContact& pair : world->update(X_WB, margin))
      for (const ManifoldPoint& point : *pair.manifold) {
        ActiveContact contact;
        contact.a = body_of[static_cast<std::size_t>(pair.a)];
        contact.b = body_of[static_cast<std::size_t>(pair.b)];
        contact.id = point.id;
        contact.feature = point.feature;
        contact.point = 0.5 * (point.on_a + point.on_b);
        contact.normal = point.normal;
        contact.gap = point.gap;
        contact.friction = pair_friction(scene, contact.a, contact.b);
        const Eigen::Vector3d u = motion.velocity(motion.link_of(contact.a), contact.point) -
                                  motion.velocity(motion.link_of(contact.b), contact.point);
        contact.approach = u.dot(contact.normal);
        contact.slip = (u - contact.approach * contact.normal).norm();
        out.push_back(contact);
      }
  }

  void find_joint(std::size_t i, const SceneState& state, double margin,
                  std::vector<ActiveContact>& out) const {
    const MechanismJoint& joint = scene.mechanism.joints[i];
    if (!is_scalar(joint.kind)) return;
    const JointValue at = value_of(i, state);
    const double rate = at.slope * state.v[model.layout.first_v[i]];
    const auto add = [&](Kind kind, double gap, double approach) {
      if (!(gap <= margin)) return;
      ActiveContact limit;
      limit.kind = kind;
      limit.a = static_cast<int>(i);
      limit.gap = gap;
      limit.approach = approach;
      out.push_back(limit);
    };
    add(Kind::kLowerLimit, at.value - joint.lower, rate);
    add(Kind::kUpperLimit, joint.upper - at.value, -rate);
    if (joint.friction > 0) add(Kind::kJointFriction, 0, rate);
  }

  /// Efforts of springs, dampers, drives and elements, their slopes, and loads on bodies, after
  /// place(). @return whether all elements could act
  bool load(const SceneState& state, ElementNeed need = ElementNeed::kAll) {
    tau.setZero();
    stiffness.setZero();
    damping.setZero();
    for (const std::size_t i : resisting) {
      const MechanismJoint& joint = scene.mechanism.joints[i];
      const JointValue at = value_of(i, state);
      const int row = model.layout.first_v[i];
      tau[row] -= at.slope * (joint.stiffness * (at.value - joint.rest) +
                              joint.damping * at.slope * state.v[row]);
      stiffness[row] += at.slope * at.slope * joint.stiffness;
      damping[row] += at.slope * at.slope * joint.damping;
    }
    for (const SceneDrive& drive : scene.drives)
      if (drive.when.holds(acting)) add_drive(drive, state);
    if (!scene.forces.empty()) motion.clear_loads();
    for (const SceneForce& force : scene.forces) {
      if (!force.when.holds(acting)) continue;
      motion.add_load(motion.link_of(force.body), motion.pose(force.body) * force.point,
                      force.force, force.moment);
    }
    return act(state, need);
  }

  [[nodiscard]] ElementInput seen_by_elements(const SceneState& state,
                                              ElementNeed need = ElementNeed::kAll) const {
    return {state.t, acting, state.q, state.v, state.z, motion, 0, need};
  }

  /// Adds what elements do.
  bool act(const SceneState& state, ElementNeed need) {
    if (elements.empty()) return true;
    const bool acted = elements.act(seen_by_elements(state, need));
    tau += elements.action().tau;
    return acted;
  }

  /// States of elements after h, by what act() found [SceneElements].
  void advance_elements(double h, SceneState& state) const {
    if (elements.empty()) return;
    const ElementAction& action = elements.action();
    state.z.array() += h * action.z_rate.array() / (1 + h * action.z_decay.array());
  }

  /// Speeds of links at the mean of those before and after a midpoint step, and the states of
  /// elements at its end by their rates in its middle. @param state  positions and states of the
  /// middle, speeds after
  bool end_elements(double h, SceneState& state) {
    v_mean = 0.5 * (v_before + state.v);
    speed_up(v_mean);
    if (elements.empty()) return true;
    const bool acted =
        elements.act({state.t, acting, state.q, v_mean, state.z, motion, 0, ElementNeed::kRates});
    state.z = z_before + h * elements.action().z_rate;
    return acted;
  }

  /// Flows of a midpoint step, after end_elements().
  void end_flows(double h, SceneState& state) {
    find_powers({state.t, acting, h, 0.5, state.q, v_before, state.v});
    state.w += h * power;
    state.w[kWorked] += h * std::abs(power[kApplied]);
    if (!elements.empty()) state.w[kWorked] += std::abs((state.z - z_before).tail<1>()[0]);
    state.w[kMostKinetic] = std::max(state.w[kMostKinetic], motion.kinetic_energy());
  }

  void add_drive(const SceneDrive& drive, const SceneState& state) {
    const auto c = static_cast<std::size_t>(drive.coordinate);
    const int row = model.layout.coordinate_v[c];
    const double effort =
        drive_effort(drive, state.q[model.layout.coordinate_q[c]], state.v[row], state.t, acting);
    tau[row] += effort;
    // At its largest effort it is no spring.
    if (std::abs(effort) >= drive.max_effort) return;
    stiffness[row] += drive.stiffness;
    damping[row] += drive.damping;
  }

  /// Mean powers over a step of all but contacts, kept in `power`, after load().
  void find_powers(const StepEfforts& at) {
    if (!has_flows) return;
    power.head<kFreeFlows>() << applied_powers(scene, model.layout, motion, at),
        elements.passive_power();
  }

  /// v_free = v + A^-1 h (tau - h(q, v)), after place() and load(). h = 0: v alone.
  /// A = M + d h damping + (d h)^2 stiffness, so that springs and dampers are taken at the end of
  /// the step (d = 1) or in its mean (d = 1/2), to first order.
  bool free_velocity(const SceneState& state, double h, double d) {
    implicit = (d * h) * damping + (d * h * d * h) * stiffness;
    const bool positive =
        h > 0 && !elements.empty() ? set_with_elements(d * h) : mass.set(motion, implicit);
    v_free = state.v;
    if (h > 0) add_efforts(h);
    return positive;
  }

  /// The factor of A with the slopes of elements; where these pull A below zero, as a tendon over a
  /// bent joint may, what is positive on their diagonal alone.
  bool set_with_elements(double dh) {
    const ElementAction& action = elements.action();
    slopes = dh * action.damping + (dh * dh) * action.stiffness;
    if (mass.set(motion, implicit, slopes)) return true;
    slopes = Eigen::MatrixXd(slopes.diagonal().cwiseMax(0).asDiagonal());
    implicit += slopes.diagonal();
    return mass.set(motion, implicit);
  }

  /// v_free += A^-1 h (tau - h(q, v)).
  void add_efforts(double h) {
    solve_efforts(h, change);
    v_free += change;
  }

  /// out = A^-1 h (tau - h(q, v)), with the factor that `mass` has. @param out  (v)
  void solve_efforts(double h, Eigen::VectorXd& out) {
    inverse.efforts(motion, scene.gravity, zero, out);
    out = h * (tau - out);
    mass.solve(model, out);
  }

  /// Rows and blocks of the contacts in `list`, and W. @param h  of the step, for dry friction [s]
  void set_rows(const std::vector<ActiveContact>& list, double h) {
    int rows = 0;
    problem.blocks.clear();
    for (const ActiveContact& contact : list) {
      problem.blocks.push_back(block_of(contact, h));
      rows += rows_of(problem.blocks.back().law);
    }
    J.setZero(model.layout.v, rows);
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      fill(list[k], problem.blocks[k].law, at);
      at += rows_of(problem.blocks[k].law);
    }
    // W = J' M^-1 J from half of the factor.
    Y = J;
    for (int i = 0; i < rows; ++i) mass.half_solve(model, Y.col(i));
    problem.W.resize(rows, rows);
    problem.W.noalias() = Y.transpose() * Y;
  }

  /// What contacts ask of the speeds after a midpoint step beyond their laws: gaps, and the mean of
  /// both ends where they went on.
  void add_speeds_before(const Eigen::VectorXd& v, double h, double recovery,
                         std::vector<ActiveContact>& list) {
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      ActiveContact& contact = list[k];
      const int rows = rows_of(problem.blocks[k].law);
      BeforeSpeeds now;
      if (contact.kind != Kind::kJointFriction) {
        double gap_speed = contact.gap / h;
        if (contact.mode != ContactMode::kOpen) {
          now.closing = 2 * gap_speed;
          gap_speed = settled(now.closing, contact.before.closing);
        }
        problem.b[at] += std::max(gap_speed, -recovery);
      }
      if (contact.kind == Kind::kContact && contact.mode == ContactMode::kStick && rows > 1) {
        const Tangents sides = tangents(contact.normal);
        now.drift = J.col(at + 1).dot(v) * sides.e1 + J.col(at + 2).dot(v) * sides.e2;
        Eigen::Vector3d drift;
        for (int i = 0; i < 3; ++i) drift[i] = settled(now.drift[i], contact.before.drift[i]);
        problem.b[at + 1] += sides.e1.dot(drift);
        problem.b[at + 2] += sides.e2.dot(drift);
        if (rows > 3) {
          now.spin = J.col(at + 3).dot(v);
          problem.b[at + 3] += settled(now.spin, contact.before.spin);
        }
      }
      contact.before = now;
      at += rows;
    }
  }

  /// Without what alternates from step to step. @param before  NaN: there was none
  static double settled(double now, double before) {
    return std::isnan(before) ? now : kMeanWeight * now + (1 - kMeanWeight) * before;
  }

  [[nodiscard]] ContactBlock block_of(const ActiveContact& contact, double h) const {
    if (contact.kind == Kind::kJointFriction) {
      const double most = h * scene.mechanism.joints[static_cast<std::size_t>(contact.a)].friction;
      return box_block(-most, most);
    }
    if (contact.kind != Kind::kContact || contact.friction.coefficient == 0)
      return unilateral_block();
    if (contact.friction.torsion_radius == 0) return coulomb_block(contact.friction.coefficient);
    return soft_finger_block(contact.friction.coefficient, contact.friction.torsion_radius);
  }

  void fill(const ActiveContact& contact, ConstraintLaw law, int at) {
    if (contact.kind != Kind::kContact) {
      const auto joint = static_cast<std::size_t>(contact.a);
      const double sign = contact.kind == Kind::kUpperLimit ? -1 : 1;
      J(model.layout.first_v[joint], at) = sign * slope_of_link(joint);
      return;
    }
    const int a = motion.link_of(contact.a), b = motion.link_of(contact.b);
    const auto add = [&](int column, const Eigen::Vector3d& along, const Eigen::Vector3d& about) {
      motion.add_row_against(a, b, contact.point, along, about, J.col(column));
    };
    const Eigen::Vector3d none(0, 0, 0);
    add(at, contact.normal, none);
    if (law == ConstraintLaw::kUnilateral) return;
    const Tangents sides = tangents(contact.normal);
    add(at + 1, sides.e1, none);
    add(at + 2, sides.e2, none);
    if (law == ConstraintLaw::kSoftFinger) add(at + 3, none, contact.normal);
  }

  /// d value / d coordinate of a joint at the placed position.
  [[nodiscard]] double slope_of_link(std::size_t joint) const {
    return motion.links()[static_cast<std::size_t>(model.bodies[joint].link)].slope;
  }

  /// Impulses of a list as rows, for a warm start.
  void warm_start(const std::vector<ActiveContact>& list) {
    start.setZero(problem.W.rows());
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const ActiveContact& contact = list[k];
      const ConstraintLaw law = problem.blocks[k].law;
      if (contact.kind != Kind::kContact) {
        start[at] = contact.impulse.x();
      } else {
        start[at] = contact.impulse.dot(contact.normal);
        if (law != ConstraintLaw::kUnilateral) {
          const Tangents sides = tangents(contact.normal);
          start[at + 1] = contact.impulse.dot(sides.e1);
          start[at + 2] = contact.impulse.dot(sides.e2);
          if (law == ConstraintLaw::kSoftFinger) start[at + 3] = contact.torsion;
        }
      }
      at += rows_of(law);
    }
  }

  /// Residual that rounding of gaps amounts to in the problem of a midpoint step [1].
  [[nodiscard]] double rounding_of_gaps(double h) const {
    double size = kLeastSize;
    for (const Pose<double>& X : X_WB) size = std::max(size, X.p.norm());
    const double rounding = kGapRoundings * std::numeric_limits<double>::epsilon() * size;
    const double share = 2 * rounding / (h * problem.b.lpNorm<Eigen::Infinity>());
    return std::max(solver_options.tolerance, std::min(share, kMostTolerance));
  }

  /// Solves, moves the speeds, and writes impulses, velocities and modes into the list.
  /// @param aim  0: to the tolerance; otherwise the residual to go to, 1e-9 being enough
  void solve(std::vector<ActiveContact>& list, SceneState& state, StepOutcome& outcome,
             ImpulseBooking booking, double aim = 0) {
    if (!problem.W.allFinite() || !problem.b.allFinite()) {
      // Speeds have become too large for numbers.
      state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
      outcome.solved = false;
      return;
    }
    warm_start(list);
    ContactSolverOptions options = solver_options;
    double enough = options.tolerance;
    if (aim > 0) {
      options.tolerance = aim;
      enough = std::max(enough, kMostTolerance);
    }
    const ContactSolution& answer = solver.solve(problem, start, options);
    const bool arrived = solver_options.method == ContactMethod::kPyramid
                             ? answer.status == Status::kSolved
                             : answer.residual.is_within(enough);
    outcome.solved = outcome.solved && arrived;
    outcome.residual = answer.residual.natural;
    pushed.noalias() = J * answer.f;
    change = pushed;
    mass.solve(model, change);
    v_free += change;
    v_mean = 0.5 * (state.v + v_free);
    mean_u.noalias() = J.transpose() * v_mean;
    add_impulse_losses(list, problem.blocks, answer.f, mean_u, booking, state.w);
    state.v = v_free;
    int at = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      read(answer, at, problem.blocks[k], list[k]);
      at += rows_of(problem.blocks[k].law);
    }
  }

  /// Modes are those of the motion: of redundant contacts some may have no force, and which ones is
  /// chance.
  static void read(const ContactSolution& answer, int at, const ContactBlock& block,
                   ActiveContact& contact) {
    const double f = answer.f[at];
    contact.approach = answer.u[at];
    contact.slip = 0;
    if (contact.kind == Kind::kJointFriction) {
      contact.impulse = {f, 0, 0};
      contact.mode =
          std::abs(contact.approach) > kNoSlip ? ContactMode::kSlide : ContactMode::kStick;
      return;
    }
    contact.mode = contact.approach > kNoSlip ? ContactMode::kOpen : ContactMode::kStick;
    if (contact.kind != Kind::kContact) {
      contact.impulse = {f, 0, 0};
      return;
    }
    contact.impulse = f * contact.normal;
    if (block.law == ConstraintLaw::kUnilateral) return;
    const Tangents sides = tangents(contact.normal);
    contact.impulse += answer.f[at + 1] * sides.e1 + answer.f[at + 2] * sides.e2;
    contact.slip = std::hypot(answer.u[at + 1], answer.u[at + 2]);
    double spin = 0;
    if (block.law == ConstraintLaw::kSoftFinger) {
      contact.torsion = answer.f[at + 3];
      spin = block.torsion_radius * std::abs(answer.u[at + 3]);
    }
    if (contact.mode == ContactMode::kStick && std::max(contact.slip, spin) > kNoSlip)
      contact.mode = ContactMode::kSlide;
  }

  /// Largest speed of a point of a collision body, after place(), if the speeds were v [m/s].
  [[nodiscard]] double fastest(const Eigen::VectorXd& v) {
    speed_up(v);
    double most = 0;
    for (std::size_t i = 0; i < body_of.size(); ++i) {
      const int link = motion.link_of(body_of[i]);
      if (link < 0) continue;
      const Ball& ball = world->bodies()[i]->ball;
      const Eigen::Vector3d centre = motion.pose(body_of[i]) * ball.c;
      most = std::max(most, motion.velocity(link, centre).norm() +
                                motion.links()[static_cast<std::size_t>(link)].w.norm() * ball.r);
    }
    return 2 * most;
  }

  MovingScene scene;
  TreeModel model;
  TreeMotion<double> motion;
  MassMatrix<double> mass;
  InverseDynamics<double> inverse;
  std::unique_ptr<ArticulatedBody<double>> articulated;  // null: joints share coordinates
  std::vector<int> body_of;                              // of the collision world's bodies
  std::unique_ptr<CollisionWorld> world;
  std::vector<Pose<double>> X_WB, X_before;
  std::vector<double> way;             // of collision bodies [m]
  std::vector<bool> may_meet;          // (bodies x bodies)
  bool may_touch = false;              // some of them
  std::vector<std::size_t> resisting;  // joints with springs or dampers
  Eigen::VectorXd placed_q, placed_v;  // where place() has put the links (q), (v)
  bool is_placed = false;              // and they still are
  Eigen::VectorXd tau, v_free, v_mean, zero, start, change, pushed;
  Eigen::VectorXd mean_u;                   // of rows, before and after their impulses (rows)
  Eigen::VectorXd z_before, v_before;       // of a midpoint step
  EnergyFlows power = EnergyFlows::Zero();  // [W]
  Eigen::VectorXd stiffness, damping;       // of springs, dampers and drives, over the speeds (v)
  Eigen::VectorXd implicit;                 // what they add to the mass matrix (v)
  SceneElements elements;
  Eigen::MatrixXd slopes;  // of elements, as they enter A (v, v)
  Eigen::MatrixXd J, Y;    // rows as columns (v, rows)
  ContactProblem problem;
  ContactSolver solver;
  ContactSolverOptions solver_options;
  std::vector<ActiveContact> found;
  bool has_slopes = false;  // some spring, damper or drive may be stiff
  bool has_flows = false;   // energy flows where nothing touches
  double acting = 0;        // instant whose forces and drives act [s]
};

ContactStep::ContactStep(const MovingScene& scene) : parts_(std::make_unique<Parts>(scene)) {}
ContactStep::~ContactStep() = default;
ContactStep::ContactStep(ContactStep&&) noexcept = default;
ContactStep& ContactStep::operator=(ContactStep&&) noexcept = default;

void ContactStep::act_as_at(double t) { parts_->acting = t; }

void ContactStep::set_drives(std::vector<SceneDrive> drives) {
  parts_->scene.drives = std::move(drives);
  parts_->note_what_acts();
}

void ContactStep::solve_contacts_by(const ContactSolverOptions& options) {
  parts_->solver_options = options;
}

const MovingScene& ContactStep::scene() const { return parts_->scene; }
const TreeModel& ContactStep::model() const { return parts_->model; }

void ContactStep::find(const SceneState& state, double margin, std::vector<ActiveContact>& out) {
  if (parts_->may_touch) parts_->place(state);
  parts_->find(state, margin, out);
}

void ContactStep::substep(SceneState& state, double h, const std::vector<ActiveContact>& closed,
                          double touch, StepOutcome& outcome) {
  Parts& p = *parts_;
  outcome.active.clear();
  outcome.deepest_new = outcome.closing_new = outcome.residual = 0;
  advance(p.scene.mechanism, p.model.layout, state.v, h, state.q);
  state.t += h;
  if (!state.q.allFinite()) {
    state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  p.place(state);
  p.find(state, touch + kNearGap, p.found);
  // Contacts that were closed act on; the others only tell how deep they are.
  for (ActiveContact& contact : p.found) {
    const auto old = std::find_if(closed.begin(), closed.end(),
                                  [&](const ActiveContact& c) { return c.same(contact); });
    if (old == closed.end()) {
      note_deeper(contact, outcome);
      continue;
    }
    if (old->mode == ContactMode::kOpen && contact.gap > touch) continue;
    contact.impulse = old->impulse;
    contact.torsion = old->torsion;
    outcome.active.push_back(contact);
  }
  const bool acted = p.load(state);
  outcome.solved = p.free_velocity(state, h, 1) && acted;
  p.advance_elements(h, state);
  if (outcome.active.empty()) {
    state.v = p.v_free;
  } else {
    p.set_rows(outcome.active, h);
    p.problem.b.noalias() = p.J.transpose() * p.v_free;
    p.solve(outcome.active, state, outcome, ImpulseBooking::kNet);
  }
  p.find_powers({state.t, p.acting, h, 1, state.q, p.placed_v, state.v});
  state.w += h * p.power;
}

void ContactStep::time_step(SceneState& state, double h, const std::vector<ActiveContact>& last,
                            double recovery, StepOutcome& outcome) {
  Parts& p = *parts_;
  const MechanismLayout& layout = p.model.layout;
  outcome.active.clear();
  advance(p.scene.mechanism, layout, state.v, 0.5 * h, state.q);
  state.t += 0.5 * h;
  if (!state.q.allFinite()) {
    state.v.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  p.place(state);
  // States of elements at the middle, then their efforts there.
  p.z_before = state.z;
  p.v_before = state.v;
  bool acted = true;
  if (!p.elements.empty()) {
    acted = p.elements.act(p.seen_by_elements(state, ElementNeed::kStates));
    p.advance_elements(0.5 * h, state);
  }
  acted = p.load(state) && acted;
  outcome.solved = p.free_velocity(state, h, 0.5) && acted;
  outcome.residual = 0;
  // Once more with the velocity product at the mean of the speeds before and after; efforts stay,
  // as the mass matrix has their slopes.
  p.v_mean = 0.5 * (state.v + p.v_free);
  p.speed_up(p.v_mean);
  p.v_free = state.v;
  p.add_efforts(h);
  // What dry friction has stopped keeps last bits of its speed, and bits of those in the next step.
  p.v_free = (p.v_free.array().abs() < kUnderflowSpeed).select(0, p.v_free);
  // Whatever may close its gap within the step.
  const double margin = h * p.fastest(p.v_free) + 1e-5;
  p.find(state, std::min(margin, 0.05), outcome.active);
  for (ActiveContact& contact : outcome.active)
    for (const ActiveContact& old : last)
      if (old.same(contact)) {
        contact.impulse = old.impulse;
        contact.torsion = old.torsion;
        contact.mode = old.mode;
        contact.before = old.before;
      }
  if (outcome.active.empty()) {
    state.v = p.v_free;
  } else {
    p.set_rows(outcome.active, h);
    p.problem.b.noalias() = p.J.transpose() * p.v_free;
    p.add_speeds_before(state.v, h, recovery, outcome.active);
    p.solve(outcome.active, state, outcome, ImpulseBooking::kLosses, p.rounding_of_gaps(h));
  }
  outcome.solved = p.end_elements(h, state) && outcome.solved;
  p.end_flows(h, state);
  advance(p.scene.mechanism, layout, state.v, 0.5 * h, state.q);
  state.t += 0.5 * h;
}

double ContactStep::motion_between(const SceneState& from, const SceneState& to,
                                   const std::vector<ActiveContact>& touching) {
  Parts& p = *parts_;
  const std::size_t n = p.body_of.size();
  if (n < 2) return 0;
  p.move_to(from.q);
  for (std::size_t i = 0; i < n; ++i) p.X_before[i] = p.motion.pose(p.body_of[i]);
  p.move_to(to.q);
  for (std::size_t i = 0; i < n; ++i) p.X_WB[i] = p.motion.pose(p.body_of[i]);
  for (std::size_t i = 0; i < n; ++i) p.way[i] = p.displacement(i);
  double most = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double moved = p.way[i] + p.way[j];
      const double over =
          2 * moved / std::min(p.world->bodies()[i]->thickness, p.world->bodies()[j]->thickness);
      if (over <= most || !p.may_meet[i * n + j]) continue;
      // Balls that stay apart cannot have met.
      const Ball &a = p.world->bodies()[i]->ball, &b = p.world->bodies()[j]->ball;
      const double apart = (p.X_before[i] * a.c - p.X_before[j] * b.c).norm() - a.r - b.r;
      if (apart < moved && !p.press(touching, i, j)) most = over;
    }
  return most;
}

void ContactStep::impact(SceneState& state, const std::vector<ActiveContact>& touching,
                         StepOutcome& outcome) {
  Parts& p = *parts_;
  outcome = {};
  if (touching.empty()) return;
  p.place(state);
  outcome.solved = p.free_velocity(state, 0, 0);
  outcome.active = touching;
  p.set_rows(outcome.active, 0);
  p.problem.b.noalias() = p.J.transpose() * p.v_free;
  // Bounces.
  int at = 0;
  for (std::size_t k = 0; k < touching.size(); ++k) {
    outcome.active[k].impulse.setZero();
    outcome.active[k].torsion = 0;
    if (touching[k].kind == Kind::kContact && p.problem.b[at] < 0)
      p.problem.b[at] *= 1 + touching[k].friction.restitution;
    at += rows_of(p.problem.blocks[k].law);
  }
  p.solve(outcome.active, state, outcome, ImpulseBooking::kLosses);
}

void ContactStep::close_gaps(SceneState& state, const std::vector<ActiveContact>& touching,
                             double most) {
  Parts& p = *parts_;
  for (int round = 0; round < 3; ++round) {
    p.place(state);
    p.find(state, kNearGap, p.found);
    // Their normal rows alone.
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
    // Least motion that closes all gaps, also where there are more than it needs.
    p.mass.set(p.motion);
    p.set_rows(pressed, 0);
    Eigen::VectorXd gaps(static_cast<Eigen::Index>(pressed.size()));
    for (std::size_t k = 0; k < pressed.size(); ++k)
      gaps[static_cast<Eigen::Index>(k)] = std::clamp(-pressed[k].gap, -most, most);
    Eigen::VectorXd move = p.J * p.problem.W.completeOrthogonalDecomposition().solve(gaps);
    p.mass.solve(p.model, move);
    advance(p.scene.mechanism, p.model.layout, move, 1, state.q);
    if (worst > most) break;  // more would be too fast
  }
}

void ContactStep::poses(const SceneState& state, std::vector<Pose<double>>& out) {
  parts_->move_to(state.q);
  out.resize(parts_->scene.mechanism.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = parts_->motion.pose(static_cast<int>(i));
}

ContactStep::Energy ContactStep::energy(const SceneState& state) {
  Parts& p = *parts_;
  p.place(state);
  Energy out;
  out.kinetic = p.motion.kinetic_energy();
  out.weight = p.motion.weight_energy(p.scene.gravity);
  for (std::size_t i = 0; i < p.scene.mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = p.scene.mechanism.joints[i];
    if (!is_scalar(joint.kind) || joint.stiffness == 0) continue;
    const double stretch = p.value_of(i, state).value - joint.rest;
    out.springs += 0.5 * joint.stiffness * stretch * stretch;
  }
  const SceneElements::Energy stored = p.elements.energy(p.seen_by_elements(state));
  out.of_elements = stored.active;
  out.of_passive = stored.all - stored.active;
  out.springs += stored.all;
  return out;
}

double ContactStep::kinetic_energy(const SceneState& state) {
  parts_->place(state);
  return parts_->motion.kinetic_energy();
}

bool ContactStep::free_rates(const SceneState& state, Eigen::VectorXd& q_dot,
                             Eigen::VectorXd& v_dot, Eigen::VectorXd& z_dot) {
  Parts& p = *parts_;
  p.place(state);
  const bool acted = p.load(state, ElementNeed::kRates);
  z_dot = p.elements.action().z_rate;
  p.find_powers({state.t, p.acting, 0, 0, state.q, state.v, state.v});
  position_rates(p.scene.mechanism, p.model.layout, state.q, state.v, q_dot);
  if (p.articulated) {
    p.articulated->accelerations(p.motion, p.scene.gravity, p.tau, v_dot);
    return acted;
  }
  p.mass.set(p.motion);
  p.solve_efforts(1, v_dot);
  return acted;
}

Eigen::Index ContactStep::free_flows() const { return parts_->has_flows ? kFreeFlows : 0; }

Eigen::VectorBlock<const EnergyFlows> ContactStep::free_powers() const {
  const EnergyFlows& power = parts_->power;
  return power.head(free_flows());
}

SceneState ContactStep::start() const {
  const Parts& p = *parts_;
  return {0, p.scene.q, p.scene.v, p.elements.start(p.scene.q)};
}

void ContactStep::accept(const SceneState& state) {
  Parts& p = *parts_;
  if (p.elements.empty()) return;
  p.place(state);
  p.elements.accept(p.seen_by_elements(state));
}

double ContactStep::elements_doubt(const SceneState& state) {
  Parts& p = *parts_;
  if (p.elements.empty()) return 0;
  p.place(state);
  return p.elements.doubt(p.seen_by_elements(state));
}

double ContactStep::elements_foresee() const { return parts_->elements.foresees(); }

void ContactStep::add_element_contacts(const SceneState& state, std::vector<ContactSample>& out) {
  Parts& p = *parts_;
  if (p.elements.empty()) return;
  p.place(state);
  p.elements.add_contacts(p.seen_by_elements(state), out);
}

bool ContactStep::elements_move(const SceneState& state) {
  Parts& p = *parts_;
  if (p.elements.empty()) return false;
  p.place(state);
  return p.elements.moves(p.seen_by_elements(state));
}

std::vector<ElementControl> ContactStep::controls() const { return parts_->elements.controls(); }

void ContactStep::set_control(const std::string& name, double value) {
  parts_->elements.set_control(name, value);
}

std::vector<ElementValue> ContactStep::readings(const SceneState& state) {
  Parts& p = *parts_;
  if (p.elements.empty()) return {};
  p.place(state);
  return p.elements.readings(p.seen_by_elements(state));
}

void ContactStep::forget() {
  Parts& p = *parts_;
  p.set_world(p.world->bodies());
  p.elements = SceneElements(p.scene.elements, p.model.layout.v);
  p.solver = ContactSolver();
  p.is_placed = false;
}

void ContactStep::note_new(const std::vector<ActiveContact>& found,
                           const std::vector<ActiveContact>& closed, StepOutcome& outcome) {
  outcome.deepest_new = outcome.closing_new = 0;
  for (const ActiveContact& contact : found)
    if (std::none_of(closed.begin(), closed.end(),
                     [&](const ActiveContact& c) { return c.same(contact); }))
      note_deeper(contact, outcome);
}

bool ContactStep::is_stiff(const SceneState& state, double h) {
  Parts& p = *parts_;
  if (!p.has_slopes) return false;
  p.place(state);
  p.load(state);
  p.mass.set(p.motion);
  const ElementAction& action = p.elements.action();
  for (int i = 0; i < p.model.layout.v; ++i) {
    double slope = h * p.damping[i] + h * h * p.stiffness[i];
    if (!p.elements.empty()) slope += h * action.damping(i, i) + h * h * action.stiffness(i, i);
    if (slope > p.mass(i, i)) return true;
  }
  return !p.elements.empty() && (h * action.z_decay).maxCoeff() > 1;
}

void ContactStep::normalise(Eigen::VectorXd& q) const {
  if (has_no_quaternion(parts_->model.layout)) return;
  const std::vector<MechanismJoint>& joints = parts_->scene.mechanism.joints;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].kind == JointKind::kBall || joints[i].kind == JointKind::kFree)
      q.segment<4>(parts_->model.layout.first_q[i]).normalize();
}

}  // namespace thenar
