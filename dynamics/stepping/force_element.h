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

/// Parts of an action that a step needs. Elements may leave out other parts; the parts that they
/// compute do not depend on the need.
enum class ElementNeed {
  kAll,    // efforts, rates of states, slopes
  kRates,  // efforts, rates of states
  kStates  // rates of states alone; then that of the work means nothing
};

/// State of a scene, as its elements see it.
struct ElementInput {
  double t;                          // [s]
  double acting;                     // whose law acts: a step keeps to that of its beginning [s]
  const Eigen::VectorXd& q;          // positions (q)
  const Eigen::VectorXd& v;          // speeds (v)
  const Eigen::VectorXd& z;          // states of all elements (z)
  const TreeMotion<double>& motion;  // poses and velocities of links at q and v
  Eigen::Index first_z;              // where the states of this element begin
  ElementNeed need = ElementNeed::kAll;
};

/// Action of all elements at a state; each element adds its part.
struct ElementAction {
  Eigen::VectorXd tau;        // efforts [N m] or [N] (v)
  Eigen::MatrixXd stiffness;  // -d tau / d position, positions moved by the speeds, the symmetric
                              // part; what is left out costs steps, not accuracy (v, v)
  Eigen::MatrixXd damping;    // -d tau / d v, likewise (v, v)
  Eigen::VectorXd z_rate;     // d z / d t (z)
  Eigen::VectorXd z_decay;    // -d z_rate / d z of each state by itself, >= 0 [1/s] (z)

  /// All zero. @param states  of all elements
  void clear(Eigen::Index speeds, Eigen::Index states);
};

/// A number of an element that may be set between steps, as the tension of a muscle.
struct ElementControl {
  std::string name;             // "human/index/FDP2"
  std::string unit;             // "N": a tension; "1": an excitation
  double lower = 0, upper = 0;  // what it may be, in its unit; upper may be infinite
  std::optional<double> set;    // to what it was set; absent: it is as the scene says
};

/// Value that an element reports at an instant.
struct ElementValue {
  std::string name;  // "human/index/FDP2"
  std::string unit;  // "N", "1"
  double value = 0;
};

/// A force element of a scene. Each run of a scene has a clone of its own, so that it may remember
/// where a search of its own ended; but between two accept() it is a function of its input alone.
class ForceElement {
 public:
  virtual ~ForceElement() = default;
  [[nodiscard]] virtual std::unique_ptr<ForceElement> clone() const = 0;
  [[nodiscard]] virtual std::string name() const = 0;

  /// Names of its states, with their units: "activation FDP [1]".
  [[nodiscard]] virtual std::vector<std::string> state_names() const { return {}; }
  /// Returns the element's states at the start of a scene (its states).
  [[nodiscard]] virtual Eigen::VectorXd start(const Eigen::VectorXd& /*q*/) const { return {}; }

  /// Adds what it does.
  /// @return false if it found no answer that it can stand for: the step counts as unsolved
  virtual bool act(const ElementInput& at, ElementAction& out) = 0;

  /// Returns true if the element only stores and dissipates energy, as ligaments do: then the
  /// energy that it takes counts as dissipation, and not as work on the scene.
  [[nodiscard]] virtual bool is_passive() const { return false; }

  /// Energy that it stores [J].
  [[nodiscard]] virtual double energy(const ElementInput& /*at*/) { return 0; }

  /// Error of its action over the step that ends here, relative to what it allows. Above 1 the step
  /// is made again, shorter, where steps have no fixed length; its action may be another one then.
  virtual double doubt(const ElementInput& /*at*/) { return 0; }

  /// A step ended here.
  virtual void accept(const ElementInput& /*at*/) {}

  /// Returns the longest step for which the force is valid after accept() [s].
  [[nodiscard]] virtual double foresees() const { return std::numeric_limits<double>::infinity(); }

  /// Adds the contacts that it stands for, as a pad does that presses on something.
  virtual void add_contacts(const ElementInput& /*at*/, std::vector<ContactSample>& /*out*/) {}

  /// Instants at which its law changes suddenly; which one holds, ElementInput::acting says [s].
  [[nodiscard]] virtual std::vector<double> switches() const { return {}; }

  /// Returns true if the element may set a resting scene in motion, though no position changes.
  [[nodiscard]] virtual bool moves(const ElementInput& /*at*/) const { return false; }

  /// Numbers that may be set between steps.
  [[nodiscard]] virtual std::vector<ElementControl> controls() const { return {}; }
  /// Sets one of its controls, from the next step on. @return false if it has none of that name
  /// @throws InputError if the value is not within the control's range.
  virtual bool set_control(const std::string& /*name*/, double /*value*/) { return false; }
  /// Returns the values of the element at a state, with names and units.
  [[nodiscard]] virtual std::vector<ElementValue> readings(const ElementInput& /*at*/) {
    return {};
  }
};

/// All elements of a scene, with the work of those that are not passive as a last state. Without
/// elements there is no state at all. `first_z` of what is passed in means nothing.
class SceneElements {
 public:
  /// @param speeds  of the scene
  SceneElements(const std::vector<std::shared_ptr<const ForceElement>>& elements,
                Eigen::Index speeds);

  [[nodiscard]] bool empty() const { return elements_.empty(); }
  /// States of all elements and the work (z).
  [[nodiscard]] Eigen::VectorXd start(const Eigen::VectorXd& q) const;

  /// Acts with all elements; see action(). @return whether all could
  bool act(const ElementInput& at);
  [[nodiscard]] const ElementAction& action() const { return action_; }
  /// Power of the passive ones on the scene, of the last act() [W].
  [[nodiscard]] double passive_power() const { return passive_power_; }

  /// Energies that elements store [J].
  struct Energy {
    double all = 0, active = 0;  // of all; of those that are not passive
  };
  [[nodiscard]] Energy energy(const ElementInput& at);
  /// The largest doubt of any of them [1].
  [[nodiscard]] double doubt(const ElementInput& at);
  void accept(const ElementInput& at);
  /// The least of all [s].
  [[nodiscard]] double foresees() const;
  void add_contacts(const ElementInput& at, std::vector<ContactSample>& out);
  [[nodiscard]] bool moves(const ElementInput& at) const;
  /// Returns the controls of all elements.
  [[nodiscard]] std::vector<ElementControl> controls() const;
  /// @throws InputError with the nearest name if no element has such a control, or if it cannot
  /// have that value.
  void set_control(const std::string& name, double value);
  [[nodiscard]] std::vector<ElementValue> readings(const ElementInput& at);

 private:
  [[nodiscard]] ElementInput input_of(std::size_t i, const ElementInput& at) const {
    return {at.t, at.acting, at.q, at.v, at.z, at.motion, first_z_[i], at.need};
  }

  std::vector<std::unique_ptr<ForceElement>> elements_;
  std::vector<Eigen::Index> first_z_;
  Eigen::Index states_ = 0;  // with the work
  ElementAction action_;
  double passive_power_ = 0;
};

/// Names of all states of a scene's elements, the work last; empty: it has no elements.
[[nodiscard]] std::vector<std::string> element_state_names(
    const std::vector<std::shared_ptr<const ForceElement>>& elements);

}  // namespace thenar
