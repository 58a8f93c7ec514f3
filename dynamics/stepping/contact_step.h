#pragma once

/// One short step of a scene with contacts, and impacts.

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
  bool solved = true;      // the contact problem was solved to its tolerance
  double residual = 0;     // ContactResidual::natural [1]
  double deepest_new = 0;  // most negative gap of a contact that was not closed before [m]
  double closing_new = 0;  // speed at which that one closes its gap [m/s]
  std::vector<ActiveContact> active;  // contacts, then joints; in a lasting order

  /// Begins another step, unsolved, in the room of this one.
  void clear() {
    solved = false;
    residual = deepest_new = closing_new = 0;
    active.clear();
  }
};

/// Steps of a scene. Owns all room that they need; one object per thread.
class ContactStep {
 public:
  /// @throws InputError as check_scene(), tree_model() and collision_body().
  explicit ContactStep(const MovingScene& scene);
  ~ContactStep();
  ContactStep(ContactStep&&) noexcept;
  ContactStep& operator=(ContactStep&&) noexcept;

  /// Selects the forces and drives that are active at time t: those whose span holds t. A step
  /// keeps the selection of its beginning, also at its very end.
  void act_as_at(double t);

  /// Replaces the scene's drives from now on; the drives must satisfy check_scene().
  void set_drives(std::vector<SceneDrive> drives);

  /// Sets the options of the contact solver from now on.
  void solve_contacts_by(const ContactSolverOptions& options);

  [[nodiscard]] const MovingScene& scene() const;
  [[nodiscard]] const TreeModel& model() const;

  /// All contacts nearer than a margin and all joint limits at a state, with velocities.
  /// @param margin  [m]
  void find(const SceneState& state, double margin, std::vector<ActiveContact>& out);

  /// Half-explicit Euler step on the contacts of `closed`:
  ///   q+ = q + h v,   v+ = v + A^-1 (h f(q+, v) + J(q+)' P),   A = M(q+) + h D + h^2 K,
  /// D and K the damping and stiffness of joints, drives and elements, so that stiff ones ask for
  /// no short step, and  z+ = z + h z'(q+, v, z) / (1 + h decay)  for states of elements; where the
  /// impulses P keep the velocities J v+ from closing gaps and obey Coulomb's law with the exact
  /// cone. It is of first order, its error has an expansion in h while all modes stay, and J v+ = 0
  /// holds to rounding where contacts stick.
  ///
  /// A contact of `closed` counts as long as it has a force, whatever its gap; one that has opened
  /// counts again when its gap is below `touch`. Others count only in `outcome.deepest_new`.
  /// @param closed   contacts that touch, with modes and impulses to start from
  /// @param touch    [m]
  /// @param outcome  its room is used again
  void substep(SceneState& state, double h, const std::vector<ActiveContact>& closed, double touch,
               StepOutcome& outcome);

  /// Moreau's midpoint step on whatever is near, for steps of fixed length:
  ///   q_m = q + h/2 v,   v+ = v + A^-1 (h f(q_m) + J(q_m)' P),   q+ = q_m + h/2 v+,
  /// A = M(q_m) + h/2 D + h^2/4 K with the damping D and stiffness K of joints and drives,
  /// f with springs and dampers at v, and the velocity product at the mean of v and of the speeds
  /// without impulses. It is of second order while no mode changes. A contact may close its gap by
  /// the next middle, u_n+ >= -gap(q_m) / h, and depth is pushed out at no more than `recovery`;
  /// nothing bounces. Source: [Moreau1988].
  ///
  /// A contact that touched or stuck before goes on in the mean of both ends, u+ = -u~, which keeps
  /// second order where its Jacobian turns; u~ is 2 gap(q_m) / h or J(q_m)' v. By itself that would
  /// let speeds and forces alternate for ever, as v+ = -v is at rest in the mean. So u~ is 3/4 of
  /// this step's and 1/4 of that of the step before: what alternates becomes less by sqrt(1/2) a
  /// step along the normal and by 1/2 across it, and what is smooth stays to second order.
  ///
  /// The contact problem is solved towards the rounding of gaps, as speeds over those of the
  /// problem: what one step leaves over stays in the gaps, and contacts that are more than the
  /// freedoms of the bodies then cannot all stick in the next one. 1e-9 counts as solved.
  /// @param recovery  [m/s]
  void time_step(SceneState& state, double h, const std::vector<ActiveContact>& last,
                 double recovery, StepOutcome& outcome);

  /// Ends all approach of the contacts in `touching` at once, by impulses at a fixed position;
  /// Newton's restitution  u_n+ >= -e u_n-.
  ///
  /// Impulses take energy. What they make all the same, here and in time_step(), is no flow: it is
  /// missing in the balance (flow_balance()).
  void impact(SceneState& state, const std::vector<ActiveContact>& touching, StepOutcome& outcome);

  /// Moves positions so that gaps of `touching` that have a force become zero, by the least motion
  /// in the metric of the mass matrix. It is no flow of energy: what weights and springs gain by it
  /// is made of nothing, and what drives do on that way is not told. @param most  of each gap [m]
  void close_gaps(SceneState& state, const std::vector<ActiveContact>& touching, double most);

  /// Computes how far surfaces have moved between two states, relative to the motion that may pass
  /// unseen: for each pair of bodies that could have met, the sum of their largest displacements
  /// over half the thinner one's thickness. Above 1 they may have gone through each other. [1]
  /// @param touching  contacts whose pairs need no look
  [[nodiscard]] double motion_between(const SceneState& from, const SceneState& to,
                                      const std::vector<ActiveContact>& touching);

  /// Poses of all bodies at a state.
  void poses(const SceneState& state, std::vector<Pose<double>>& out);

  [[nodiscard]] SceneEnergy energy(const SceneState& state);
  /// Computes the kinetic energy alone [J].
  [[nodiscard]] double kinetic_energy(const SceneState& state);

  /// Rates of the state without contacts, limits and dry friction.
  /// @param q_dot  (q);  @param v_dot  (v);  @param z_dot  (z)
  /// @return whether all elements could act
  bool free_rates(const SceneState& state, Eigen::VectorXd& q_dot, Eigen::VectorXd& v_dot,
                  Eigen::VectorXd& z_dot);
  /// Returns the number of energy flows that go on where nothing touches: kFreeFlows, or 0.
  [[nodiscard]] Eigen::Index free_flows() const;
  /// Their powers at the last free_rates() [W] (free_flows()).
  [[nodiscard]] Eigen::VectorBlock<const EnergyFlows> free_powers() const;

  /// The scene's beginning.
  [[nodiscard]] SceneState start() const;
  /// Returns the largest error of elements in the step that ends at a state: ForceElement::doubt()
  /// [1].
  [[nodiscard]] double elements_doubt(const SceneState& state);
  /// A step ended at a state: elements go on from there.
  void accept(const SceneState& state);
  /// Returns the longest step for which the forces of all elements are valid [s].
  [[nodiscard]] double elements_foresee() const;
  /// Adds the contacts that elements stand for.
  void add_element_contacts(const SceneState& state, std::vector<ContactSample>& out);
  /// Returns true if an element may set a resting scene in motion.
  [[nodiscard]] bool elements_move(const SceneState& state);
  /// Returns the numbers of elements that may be set; readings() returns the values that elements
  /// report: see ForceElement.
  [[nodiscard]] std::vector<ElementControl> controls() const;
  /// @throws InputError if no element has such a control, or it cannot have that value.
  void set_control(const std::string& name, double value);
  [[nodiscard]] std::vector<ElementValue> readings(const SceneState& state);

  /// Resets to the state after construction: pairs of bodies and elements remember nothing, and no
  /// control is set.
  void forget();

  /// Most negative gap among contacts that are not in `closed`, and how fast it closes.
  static void note_new(const std::vector<ActiveContact>& found,
                       const std::vector<ActiveContact>& closed, StepOutcome& outcome);

  /// Returns true if springs, dampers and drives are so stiff that an explicit step of this length
  /// would be unstable: h D > M or h^2 K > M on the diagonal.
  [[nodiscard]] bool is_stiff(const SceneState& state, double h);

  /// Quaternions to length 1.
  void normalise(Eigen::VectorXd& q) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
