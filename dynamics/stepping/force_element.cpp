#include "dynamics/stepping/force_element.h"

#include <algorithm>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"

namespace thenar {

void ElementAction::clear(Eigen::Index speeds, Eigen::Index states) {
  tau.setZero(speeds);
  stiffness.setZero(speeds, speeds);
  damping.setZero(speeds, speeds);
  z_rate.setZero(states);
  z_decay.setZero(states);
}

SceneElements::SceneElements(const std::vector<std::shared_ptr<const ForceElement>>& elements,
                             Eigen::Index speeds) {
  // Clone the elements and assign their states; the work is the last state.
  for (const std::shared_ptr<const ForceElement>& element : elements) {
    elements_.push_back(element->clone());
    first_z_.push_back(states_);
    states_ += static_cast<Eigen::Index>(element->state_names().size());
  }
  if (!elements_.empty()) ++states_;
  action_.clear(speeds, states_);
}

Eigen::VectorXd SceneElements::initial_states(const Eigen::VectorXd& q) const {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(states_);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const Eigen::VectorXd own = elements_[i]->initial_states(q);
    z.segment(first_z_[i], own.size()) = own;
  }
  return z;
}

bool SceneElements::compute_action(const ElementInput& at) {
  bool solved = true;
  // Clear slopes only if they are needed.
  if (at.need == ElementNeed::kAll) {
    action_.clear(at.v.size(), states_);
  } else {
    action_.tau.setZero(at.v.size());
    action_.z_rate.setZero(states_);
    action_.z_decay.setZero(states_);
  }
  // Add all actions; the power of an element is the change that it makes to  tau . v.
  double before = 0, power = 0;  // power of elements so far; of those that are not passive [W]
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    solved = elements_[i]->add_action(input_of(i, at), action_) && solved;
    const double after = action_.tau.dot(at.v);
    if (!elements_[i]->is_passive()) power += after - before;
    before = after;
  }
  if (states_ > 0) action_.z_rate[states_ - 1] = power;
  passive_power_ = before - power;
  return solved;
}

SceneElements::Energy SceneElements::energy(const ElementInput& at) {
  Energy sum;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const double stored = elements_[i]->energy(input_of(i, at));
    sum.total += stored;
    if (!elements_[i]->is_passive()) sum.active += stored;
  }
  return sum;
}

double SceneElements::max_step_error(const ElementInput& at) {
  double max_error = 0;
  for (std::size_t i = 0; i < elements_.size(); ++i)
    max_error = std::max(max_error, elements_[i]->step_error(input_of(i, at)));
  return max_error;
}

double SceneElements::max_step_length() const {
  double max_length = std::numeric_limits<double>::infinity();
  for (const std::unique_ptr<ForceElement>& element : elements_)
    max_length = std::min(max_length, element->max_step_length());
  return max_length;
}

void SceneElements::add_contacts(const ElementInput& at, std::vector<ContactSample>& out) {
  for (std::size_t i = 0; i < elements_.size(); ++i)
    elements_[i]->add_contacts(input_of(i, at), out);
}

void SceneElements::accept_step(const ElementInput& at) {
  for (std::size_t i = 0; i < elements_.size(); ++i) elements_[i]->accept_step(input_of(i, at));
}

bool SceneElements::may_start_motion(const ElementInput& at) const {
  for (std::size_t i = 0; i < elements_.size(); ++i)
    if (elements_[i]->may_start_motion(input_of(i, at))) return true;
  return false;
}

std::vector<ElementControl> SceneElements::controls() const {
  std::vector<ElementControl> all;
  for (const std::unique_ptr<ForceElement>& element : elements_)
    append_all(all, element->controls());
  return all;
}

void SceneElements::set_control(const std::string& name, double value) {
  // Offer the control to each element; if none has it, throw with the nearest name.
  for (const std::unique_ptr<ForceElement>& element : elements_)
    if (element->set_control(name, value)) return;
  (void)index_of_name(name, names_of(controls()), "muscle or other control");
}

std::vector<ElementValue> SceneElements::readings(const ElementInput& at) {
  std::vector<ElementValue> all;
  for (std::size_t i = 0; i < elements_.size(); ++i)
    append_all(all, elements_[i]->readings(input_of(i, at)));
  return all;
}

std::vector<std::string> element_state_names(
    const std::vector<std::shared_ptr<const ForceElement>>& elements) {
  std::vector<std::string> names;
  for (const std::shared_ptr<const ForceElement>& element : elements)
    for (const std::string& state : element->state_names())
      names.push_back(element->name() + "/" + state);
  if (!elements.empty()) names.emplace_back("work of elements [J]");
  return names;
}

}  // namespace thenar
