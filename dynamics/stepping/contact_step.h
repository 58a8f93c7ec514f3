#pragma once

/// Single steps of a scene with contacts, joint limits and dry friction, and impacts.
///
/// One Euler substep, ContactStep::take_euler_substep(); a midpoint step has the same stages:
///   1. advance_positions() moves the positions with the present velocities.
///   2. SceneMotion updates poses and velocities of all links.
///   3. SceneContacts finds contacts, joint limits and dry frictions there, with gaps.
///   4. AppliedEfforts evaluates springs, dampers, drives, loads and force elements, with slopes.
///   5. FreeVelocity computes the velocity without contact impulses, and factorises A = M + slopes.
///   6. ContactRows assembles the contact problem: Jacobian J, W = J A^-1 J' and b = J v.
///   7. ContactSolver solves it for the contact impulses.
///   8. FreeVelocity adds the velocity change of the impulses; ContactRows stores impulses,
///      velocities and modes in the contacts.
///   9. AppliedEfforts and add_impulse_losses() integrate the energy flows.
/// EventStepper (variable length) and FixedStep (fixed length) decide which steps are taken.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "contact/contact_solver.h"
#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/contact_sample.h"
#include "dynamics/stepping/scene_run.h"
#include "dynamics/stepping/scene_state.h"
#include "geometry/manifold/collision_world.h"

namespace thenar {

/// Outcome of a step.
struct StepOutcome {
  bool solved = true;            // the contact problem was solved to its tolerance
  double residual = 0;           // ContactResidual::natural [1]
  double min_new_gap = 0;        // most negative gap of a contact that was not closed before [m]
  double new_closing_speed = 0;  // speed at which that contact closes its gap [m/s]
  std::vector<ActiveContact> active;  // contacts, then joint limits and frictions; stable order

  /// Resets to an unsolved step without contacts, and keeps the capacity of `active`.
  void clear() {
    solved = false;
    residual = min_new_gap = new_closing_speed = 0;
    active.clear();
  }
};

/// Steps of one scene. Owns their workspace; one object per thread.
class ContactStep {
 public:
  // Configuration.

  /// Copies a scene and prepares its model. @throws InputError as check_scene(), tree_model() and
  /// collision_body().
  explicit ContactStep(const MovingScene& scene);
  ~ContactStep();
  ContactStep(ContactStep&&) noexcept;
  ContactStep& operator=(ContactStep&&) noexcept;

  /// Replaces the scene's drives for all later steps; they must satisfy check_scene().
  void set_drives(std::vector<SceneDrive> drives);

  /// Sets the options of the contact solver for all later steps.
  void set_solver_options(const ContactSolverOptions& options);

  /// Selects the forces and drives that act: those whose time span contains t. A step keeps the
  /// selection of its start, even at its very end. @param t  [s]
  void select_active_forces(double t);

  /// Resets collision pairs, elements and the solver's warm start to those after construction;
  /// unsets all element controls.
  void clear_memory();

  [[nodiscard]] const MovingScene& scene() const;
  [[nodiscard]] const TreeModel& model() const;

  // State and kinematics.

  /// Returns the scene's initial state, at t = 0.
  [[nodiscard]] SceneState initial_state() const;

  /// Finds all contacts and joint limits within a margin, and all dry frictions, with velocities.
  /// @param margin  largest gap [m]
  /// @param out     replaced; its capacity is reused
  void find_contacts(const SceneState& state, double margin, std::vector<ActiveContact>& out);

  /// Sets `min_new_gap` and `new_closing_speed` of an outcome from the contacts of `found` that
  /// are not in `closed`.
  static void find_deepest_new(const std::vector<ActiveContact>& found,
                               const std::vector<ActiveContact>& closed, StepOutcome& outcome);

  /// Computes how close two states are to a missed collision: for each pair of bodies that could
  /// have met in between, the sum of their largest displacements over half the thickness of the
  /// thinner body. Above 1 they may have passed through each other. [1]
  /// @param touching  contacts in force, whose pairs of bodies are exempt
  [[nodiscard]] double tunnelling_ratio(const SceneState& from, const SceneState& to,
                                        const std::vector<ActiveContact>& touching);

  /// Computes the poses of all bodies in the world. @param out  (bodies)
  void compute_poses(const SceneState& state, std::vector<Pose<double>>& out);

  /// Scales all quaternions of q to length 1. @param q  (q)
  void normalise_quaternions(Eigen::VectorXd& q) const;

  /// Computes the rates of the state without contacts, joint limits and dry friction.
  /// @param q_dot  (q);  @param v_dot  (v);  @param z_dot  (z)
  /// @return false if an element has no valid force here
  bool compute_free_rates(const SceneState& state, Eigen::VectorXd& q_dot, Eigen::VectorXd& v_dot,
                          Eigen::VectorXd& z_dot);

  /// Returns true if springs, dampers and drives are so stiff that an explicit step of this length
  /// would be unstable: h D > M or h^2 K > M on the diagonal, or h times the decay rate of an
  /// element state above 1. @param h  [s]
  [[nodiscard]] bool is_stiff(const SceneState& state, double h);

  // Steps.

  /// Takes a half-explicit Euler step on the contacts of `closed`:
  ///   q+ = q + h v,   v+ = v + A^-1 (h f(q+, v) + J(q+)' P),   A = M(q+) + h D + h^2 K,
  /// with the damping D and stiffness K of joints, drives and elements, so that stiff ones do not
  /// limit the step size, and  z+ = z + h z'(q+, v, z) / (1 + h decay)  for states of elements. The
  /// impulses P keep the velocities J v+ from closing gaps and obey Coulomb's law with the exact
  /// cone. The step is of first order, its error has an expansion in h while no contact changes its
  /// mode, and J v+ = 0 holds to rounding where contacts stick.
  ///
  /// A contact of `closed` with a force takes part at any gap; one that has opened takes part again
  /// once its gap is below `touch`. Other contacts only set `outcome.min_new_gap`.
  /// @param h        [s]
  /// @param closed   contacts that touch, with modes and impulses for the warm start
  /// @param touch    largest gap that counts as closed [m]
  /// @param outcome  replaced; its capacity is reused
  void take_euler_substep(SceneState& state, double h, const std::vector<ActiveContact>& closed,
                          double touch, StepOutcome& outcome);

  /// Takes Moreau's midpoint step on all contacts nearby, for steps of fixed length:
  ///   q_m = q + h/2 v,   v+ = v + A^-1 (h f(q_m) + J(q_m)' P),   q+ = q_m + h/2 v+,
  /// A = M(q_m) + h/2 D + h^2/4 K with the damping D and stiffness K of joints, drives and
  /// elements, f with springs and dampers at v, and the velocity product at the mean of v and of
  /// the velocity without impulses. It is of second order while no mode changes. A contact may
  /// close its gap by the next midpoint, u_n+ >= -gap(q_m) / h; penetration is pushed out no faster
  /// than `recovery`; restitution is not modelled. Source: [Moreau1988].
  ///
  /// A contact that touched or stuck before obeys its law in the mean of both ends, u+ = -u~, which
  /// keeps second order where its Jacobian turns; u~ is 2 gap(q_m) / h or J(q_m)' v. On its own
  /// this leaves an undamped alternation of velocities and forces, because v+ = -v has a mean of
  /// zero. Therefore u~ is 3/4 of this step's value and 1/4 of the previous step's: alternation
  /// decays by sqrt(1/2) per step along the normal and by 1/2 across it, and smooth motion stays
  /// second order.
  ///
  /// The contact problem is solved to the rounding error of gaps, as a velocity over the largest
  /// one of the problem: a larger residual would remain in the gaps, and redundant contacts could
  /// not all stick in the next step. A residual of 1e-9 counts as solved.
  /// @param h         [s]
  /// @param last      contacts of the previous step, with modes and impulses for the warm start
  /// @param recovery  largest speed at which penetration is pushed out [m/s]
  /// @param outcome   replaced; its capacity is reused
  void take_midpoint_step(SceneState& state, double h, const std::vector<ActiveContact>& last,
                          double recovery, StepOutcome& outcome);

  // Impact and projection.

  /// Resolves the impacts of all contacts in `touching` at once, by impulses at a fixed position;
  /// Newton's restitution  u_n+ >= -e u_n-.
  ///
  /// Impulses dissipate energy. Energy that they add nevertheless, here and in
  /// take_midpoint_step(), is not booked as a flow and appears as an error in flow_balance().
  void resolve_impact(SceneState& state, const std::vector<ActiveContact>& touching,
                      StepOutcome& outcome);

  /// Moves positions so that the gaps of contacts of `touching` with a force become zero, by the
  /// least motion in the metric of the mass matrix. The projection is not booked as an energy flow:
  /// neither the energy that weights and springs gain, nor the work of drives along the way.
  /// @param max_correction  largest correction of one gap in one of the three iterations [m]
  void close_gaps(SceneState& state, const std::vector<ActiveContact>& touching,
                  double max_correction);

  // Energy.

  /// Computes kinetic, gravitational and spring energies [J].
  [[nodiscard]] SceneEnergy energy(const SceneState& state);
  /// Computes the kinetic energy [J].
  [[nodiscard]] double kinetic_energy(const SceneState& state);
  /// Returns the number of energy flows without contacts: kFreeFlowCount, or 0 if nothing acts.
  [[nodiscard]] Eigen::Index free_flow_count() const;
  /// Returns the powers of these flows at the last compute_free_rates() [W] (free_flow_count()).
  [[nodiscard]] Eigen::VectorBlock<const EnergyFlows> free_powers() const;

  // Force elements (see ForceElement).

  /// Returns the largest error of any element over the step that ends at a state, relative to its
  /// tolerance [1].
  [[nodiscard]] double element_step_error(const SceneState& state);
  /// Ends a step at a state: elements update what they remember.
  void accept_step(const SceneState& state);
  /// Returns the longest step for which the forces of all elements are valid [s].
  [[nodiscard]] double max_element_step() const;
  /// Appends the contacts that elements model.
  void add_element_contacts(const SceneState& state, std::vector<ContactSample>& out);
  /// Returns true if an element may set a resting scene in motion.
  [[nodiscard]] bool elements_may_start_motion(const SceneState& state);
  /// Returns the controls of all elements.
  [[nodiscard]] std::vector<ElementControl> element_controls() const;
  /// Sets a control of an element from the next step on.
  /// @throws InputError if no element has that control, or the value is out of range.
  void set_element_control(const std::string& name, double value);
  /// Returns the values that elements report at a state.
  [[nodiscard]] std::vector<ElementValue> element_readings(const SceneState& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
