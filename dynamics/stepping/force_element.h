#pragma once

/// Interface of force elements: force laws with internal states, such as ligaments, tendons,
/// muscles and pads.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/contact_sample.h"

namespace thenar {

template <typename T>
class TreeMotion;

/// Parts of ElementAction that a step needs. An element may skip the others; the parts that it
/// computes do not depend on the need.
enum class ElementNeed {
  kAll,    // efforts, rates of states, slopes
  kRates,  // efforts, rates of states
  kStates  // rates of states alone; the rate of the work state is then meaningless
};

/// State of a scene at which elements are evaluated.
struct ElementInput {
  double t;                          // time [s]
  double selection_time;             // start of the step, which selects the law in force [s]
  const Eigen::VectorXd& q;          // positions (q)
  const Eigen::VectorXd& v;          // velocities (v)
  const Eigen::VectorXd& z;          // states of all elements (z)
  const TreeMotion<double>& motion;  // poses and velocities of links at q and v
  Eigen::Index first_z;              // index in z of the first state of this element
  ElementNeed need = ElementNeed::kAll;
};

/// Sum of the actions of all elements at a state.
struct ElementAction {
  Eigen::VectorXd tau;        // generalized forces [N m] or [N] (v)
  Eigen::MatrixXd stiffness;  // symmetric part of -d tau / d position, positions displaced along
                              // the velocities; omitted terms cost steps, not accuracy (v, v)
  Eigen::MatrixXd damping;    // symmetric part of -d tau / d v, likewise (v, v)
  Eigen::VectorXd z_rate;     // d z / d t (z)
  Eigen::VectorXd z_decay;    // decay rate of each state, -d z_rate[i] / d z[i] >= 0 [1/s] (z)

  /// Sets everything to zero. @param speeds  size of v;  @param states  size of z
  void clear(Eigen::Index speeds, Eigen::Index states);
};

/// Number of an element that may be set between steps, such as the tension of a muscle.
struct ElementControl {
  std::string name;             // "human/index/FDP2"
  std::string unit;             // "N" for a tension, "1" for an excitation
  double lower = 0, upper = 0;  // range of the value, in its unit; upper may be infinite
  std::optional<double> set;    // value that was set; absent: the scene's own schedule applies
};

/// Value that an element reports at an instant.
struct ElementValue {
  std::string name;  // "human/index/FDP2"
  std::string unit;  // "N", "1"
  double value = 0;  // value in that unit
};

/// Force element of a scene. Each run evaluates its own clone, which may remember, for example, the
/// solution of its last iteration; but between two calls of accept_step() the action must be a
/// function of the input alone.
class ForceElement {
 public:
  virtual ~ForceElement() = default;
  [[nodiscard]] virtual std::unique_ptr<ForceElement> clone() const = 0;
  [[nodiscard]] virtual std::string name() const = 0;

  // States and action.

  /// Returns the names of the element's states with their units: "activation FDP [1]".
  [[nodiscard]] virtual std::vector<std::string> state_names() const { return {}; }
  /// Returns the element's states at the start of a scene (states of the element).
  [[nodiscard]] virtual Eigen::VectorXd initial_states(const Eigen::VectorXd& /*q*/) const {
    return {};
  }
  /// Adds the element's efforts, slopes and rates to the action.
  /// @return false if it has no valid solution: the step then counts as unsolved
  virtual bool add_action(const ElementInput& at, ElementAction& out) = 0;
  /// Returns the instants at which the law switches discontinuously; ElementInput::selection_time
  /// selects the law [s].
  [[nodiscard]] virtual std::vector<double> switching_times() const { return {}; }
  /// Returns true if the element may set a resting scene in motion although no position changes.
  [[nodiscard]] virtual bool may_start_motion(const ElementInput& /*at*/) const { return false; }

  // Energy.

  /// Returns true if the element only stores and dissipates energy, as ligaments do: its work then
  /// counts as dissipation rather than as work on the scene.
  [[nodiscard]] virtual bool is_passive() const { return false; }
  /// Returns the energy that the element stores [J].
  [[nodiscard]] virtual double energy(const ElementInput& /*at*/) { return 0; }

  // Step control.

  /// Returns the error of the action over the step that ends here, relative to the element's
  /// tolerance. Above 1 a stepper of variable step size repeats the step with a shorter length, and
  /// the action may change [1].
  virtual double step_error(const ElementInput& /*at*/) { return 0; }
  /// Ends an accepted step at a state: the element updates what it remembers.
  virtual void accept_step(const ElementInput& /*at*/) {}
  /// Returns the longest step after accept_step() for which the action is valid [s].
  [[nodiscard]] virtual double max_step_length() const {
    return std::numeric_limits<double>::infinity();
  }

  // Outputs and controls.

  /// Appends the contacts that the element models, such as a pad pressed on an object.
  virtual void add_contacts(const ElementInput& /*at*/, std::vector<ContactSample>& /*out*/) {}
  /// Returns the numbers that may be set between steps.
  [[nodiscard]] virtual std::vector<ElementControl> controls() const { return {}; }
  /// Sets one of the controls from the next step on. @return false if no control has that name
  /// @throws InputError if the value is not within the control's range.
  virtual bool set_control(const std::string& /*name*/, double /*value*/) { return false; }
  /// Returns the values of the element at a state, with names and units.
  [[nodiscard]] virtual std::vector<ElementValue> readings(const ElementInput& /*at*/) {
    return {};
  }
};

/// Elements of a scene, evaluated together. The states z of the scene are those of all elements,
/// then the work of those that are not passive; z is empty without elements. Functions set
/// `first_z` of the input themselves.
class SceneElements {
 public:
  /// Clones the elements. @param speeds  size of v
  SceneElements(const std::vector<std::shared_ptr<const ForceElement>>& elements,
                Eigen::Index speeds);

  [[nodiscard]] bool empty() const { return elements_.empty(); }
  /// Returns the initial states of all elements, and zero work (z).
  [[nodiscard]] Eigen::VectorXd initial_states(const Eigen::VectorXd& q) const;

  /// Computes the action of all elements, see action().
  /// @return false if an element has no valid solution
  bool compute_action(const ElementInput& at);
  [[nodiscard]] const ElementAction& action() const { return action_; }
  /// Returns the power of the passive elements on the scene at the last compute_action() [W].
  [[nodiscard]] double passive_power() const { return passive_power_; }

  /// Energy stored in elements [J].
  struct Energy {
    double total = 0, active = 0;  // energy of all elements; part of those that are not passive [J]
  };
  [[nodiscard]] Energy energy(const ElementInput& at);
  /// Returns the largest ForceElement::step_error() [1].
  [[nodiscard]] double max_step_error(const ElementInput& at);
  /// Calls ForceElement::accept_step() of all elements.
  void accept_step(const ElementInput& at);
  /// Returns the smallest ForceElement::max_step_length() [s].
  [[nodiscard]] double max_step_length() const;
  /// Appends the contacts that elements model.
  void add_contacts(const ElementInput& at, std::vector<ContactSample>& out);
  /// Returns true if an element may set a resting scene in motion.
  [[nodiscard]] bool may_start_motion(const ElementInput& at) const;
  /// Returns the controls of all elements.
  [[nodiscard]] std::vector<ElementControl> controls() const;
  /// Sets a control of an element.
  /// @throws InputError with the nearest name if no element has such a control, or if the value is
  /// out of range.
  void set_control(const std::string& name, double value);
  /// Returns the values that all elements report at a state.
  [[nodiscard]] std::vector<ElementValue> readings(const ElementInput& at);

 private:
  [[nodiscard]] ElementInput input_of(std::size_t i, const ElementInput& at) const {
    return {at.t, at.selection_time, at.q, at.v, at.z, at.motion, first_z_[i], at.need};
  }

  std::vector<std::unique_ptr<ForceElement>> elements_;
  std::vector<Eigen::Index> first_z_;  // index of each element's first state (elements)
  Eigen::Index states_ = 0;            // number of states, including the work
  ElementAction action_;
  double passive_power_ = 0;  // [W]
};

/// Returns the names of all states of a scene's elements, the work last; empty without elements.
[[nodiscard]] std::vector<std::string> element_state_names(
    const std::vector<std::shared_ptr<const ForceElement>>& elements);

}  // namespace thenar
