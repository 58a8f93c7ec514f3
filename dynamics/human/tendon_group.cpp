#include "dynamics/human/tendon_group.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the indices of names in a list, to which new names are appended.
std::vector<int> index_names(const std::vector<std::string>& names, std::vector<std::string>& all) {
  std::vector<int> indices;
  for (const std::string& name : names) {
    if (!contains(all, name)) all.push_back(name);
    indices.push_back(place_in(all, name));
  }
  return indices;
}

bool share_a_name(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return any_of(a, [&](const std::string& each) { return contains(b, each); });
}

}  // namespace

void gather(const VectorXd& from, const std::vector<int>& indices, VectorXd& out) {
  out.resize(static_cast<Eigen::Index>(indices.size()));
  Eigen::Index next = 0;
  for (const int index : indices) out[next++] = from[index];
}

void scatter(const MatrixXd& added, const std::vector<int>& rows, const std::vector<int>& columns,
             MatrixXd& out) {
  for (Eigen::Index j = 0; j < added.cols(); ++j)
    for (Eigen::Index i = 0; i < added.rows(); ++i) out(rows[i], columns[j]) += added(i, j);
}

std::vector<std::vector<int>> contracting_groups(
    const std::vector<std::vector<std::string>>& muscles, const std::vector<bool>& excited) {
  // Label of each digit's group: the index of its first digit. Digits that join take the lower one.
  const std::size_t digits = muscles.size();
  std::vector<std::size_t> group(digits);
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<bool> contracts = excited;
  for (bool any = true; any;) {
    any = false;
    for (std::size_t i = 0; i < digits; ++i)
      for (std::size_t j = 0; j < digits; ++j) {
        if (!contracts[i] || group[i] == group[j] || !share_a_name(muscles[i], muscles[j]))
          continue;
        any = contracts[j] = true;
        const std::size_t from = std::max(group[i], group[j]), to = std::min(group[i], group[j]);
        std::replace(group.begin(), group.end(), from, to);
      }
  }
  // Collect the members of each group.
  std::vector<std::vector<int>> out;
  for (std::size_t first = 0; first < digits; ++first) {
    std::vector<int> members;
    for (std::size_t i = 0; i < digits; ++i)
      if (group[i] == first) members.push_back(static_cast<int>(i));
    if (!members.empty()) out.push_back(std::move(members));
  }
  return out;
}

TendonGroup::TendonGroup(std::vector<std::shared_ptr<const DigitTendons>> digits) {
  // List coordinates and muscles of all digits, each once.
  for (std::shared_ptr<const DigitTendons>& tendons : digits) {
    const TendonDigit& digit = tendons->digit();
    has_net_ = has_net_ || digit.fidelity.hood == Hood::kFloatingNet;
    has_friction_ = has_friction_ || !digit.model.friction.isZero(0);
    Digit part{nullptr, index_names(digit.names.coordinates, coordinates_),
               index_names(digit.names.muscles, muscles_)};
    part.tendons = std::move(tendons);
    digits_.push_back(std::move(part));
  }
}

TendonGroup TendonGroup::smoothed(double strain) const {
  std::vector<std::shared_ptr<const DigitTendons>> digits;
  for (const Digit& digit : digits_) {
    const std::shared_ptr<const DigitTendons> blended = digit.tendons->smoothed(strain);
    digits.push_back(blended ? blended : digit.tendons);
  }
  return TendonGroup(std::move(digits));
}

GroupTorque TendonGroup::evaluate(const VectorXd& q, const VectorXd& t,
                                  const GroupNodes& start) const {
  GroupTorque out;
  out.tau = VectorXd::Zero(q.size());
  out.R = MatrixXd::Zero(t.size(), q.size());
  // Evaluate each digit, and add its torque and arms to those of the group.
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Digit& digit = digits_[i];
    static const Eigen::Matrix3Xd kNone;
    out.digits.push_back(digit.tendons->evaluate(q(digit.coordinates), t(digit.muscles),
                                                 start.empty() ? kNone : start[i]));
    const TendonTorque& part = out.digits.back();
    out.tau(digit.coordinates) += part.tau;
    out.R(digit.muscles, digit.coordinates) += part.R;
    out.status = worse(out.status, part.status);
    if (out.warning.empty()) out.warning = part.warning;
  }
  return out;
}

GroupArms::GroupArms(const TendonGroup& group) : group_(&group), q_(group.digits_.size()) {
  require(!group.has_net(), "arms of a group with a net depend on tensions");
  for (const TendonGroup::Digit& digit : group.digits_)
    solvers_.push_back(digit.tendons->arm_solver());
}

void GroupArms::slopes(const VectorXd& q, GroupSlopes& out) {
  out.exist = true;
  out.digits.resize(solvers_.size());
  // The slopes exist only if those of every digit do.
  for (std::size_t i = 0; i < solvers_.size() && out.exist; ++i) {
    out.exist = solvers_[i] != nullptr;
    if (!out.exist) return;
    gather(q, group_->digits_[i].coordinates, q_[i]);
    solvers_[i]->slopes(q_[i], out.digits[i]);
    out.exist = out.digits[i].exist;
  }
}

void GroupArms::solve(const VectorXd& q, GroupTorque& out) {
  const TendonGroup& group = *group_;
  const bool alone = solvers_.size() == 1;  // its indices are then those of the group
  if (!alone) out.R.setZero(static_cast<Eigen::Index>(group.muscles_.size()), q.size());
  out.status = TendonStatus::kValid;
  out.warning.clear();
  out.digits.resize(solvers_.size());
  // Compute the arms of each digit, by its solver or from its torque at zero tension.
  for (std::size_t i = 0; i < solvers_.size(); ++i) {
    const TendonGroup::Digit& digit = group.digits_[i];
    TendonTorque& part = out.digits[i];
    gather(q, digit.coordinates, q_[i]);
    if (solvers_[i])
      solvers_[i]->solve(q_[i], part);
    else
      part = digit.tendons->evaluate(
          q_[i], VectorXd::Zero(static_cast<Eigen::Index>(digit.muscles.size())));
    // Add them to the arms of the group, and keep the worst status.
    if (alone)
      out.R = part.R;
    else
      scatter(part.R, digit.muscles, digit.coordinates, out.R);
    out.status = worse(out.status, part.status);
    if (out.warning.empty()) out.warning = part.warning;
  }
}

MatrixXd TendonGroup::torque_by_posture(const VectorXd& q, const VectorXd& t,
                                        const GroupTorque& at) const {
  MatrixXd out = MatrixXd::Zero(q.size(), q.size());
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const auto& [tendons, coordinates, muscles] = digits_[i];
    out(coordinates, coordinates) +=
        tendons->torque_by_posture(q(coordinates), t(muscles), at.digits[i]);
  }
  return out;
}

void TendonGroup::add_stiffness(const GroupSlopes& slopes, const VectorXd& t,
                                const std::vector<int>& indices, VectorXd& workspace,
                                MatrixXd& out) const {
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const auto& [tendons, coordinates, muscles] = digits_[i];
    // Sum the slopes of all pairs of coordinates over the muscles.
    const MatrixXd& of_pair = slopes.digits[i].of_pair;
    const Eigen::Index pairs = of_pair.rows();
    workspace.setZero(pairs);
    double* const sum = workspace.data();
    for (std::size_t m = 0; m < muscles.size(); ++m) {
      const double tension = t[muscles[m]];
      const double* const slope = of_pair.data() + static_cast<Eigen::Index>(m) * pairs;
      for (Eigen::Index pair = 0; pair < pairs; ++pair) sum[pair] += tension * slope[pair];
    }
    // Add them to both halves of the symmetric matrix.
    const double* next = sum;
    for (std::size_t k = 0; k < coordinates.size(); ++k)
      for (std::size_t j = 0; j <= k; ++j, ++next) {
        const int at_j = indices[coordinates[j]], at_k = indices[coordinates[k]];
        out(at_j, at_k) += *next;
        if (j < k) out(at_k, at_j) += *next;
      }
  }
}

MatrixXd TendonGroup::compliance(const VectorXd& q, const VectorXd& t,
                                 const GroupTorque& at) const {
  MatrixXd out = MatrixXd::Zero(t.size(), t.size());
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const auto& [tendons, coordinates, muscles] = digits_[i];
    out(muscles, muscles) += tendons->compliance(q(coordinates), t(muscles), at.digits[i]);
  }
  return out;
}

VectorXd TendonGroup::lengths(const VectorXd& q, const VectorXd& t, const GroupTorque& at) const {
  VectorXd out = VectorXd::Zero(t.size());
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const auto& [tendons, coordinates, muscles] = digits_[i];
    out(muscles) += tendons->lengths(q(coordinates), t(muscles), at.digits[i]);
  }
  return out;
}

Excursion TendonGroup::excursion(const VectorXd& q) const {
  Excursion out{VectorXd::Zero(static_cast<Eigen::Index>(muscles_.size())), ""};
  // Follow each digit from posture zero to q, with all tendons taut at 1 N.
  for (const auto& [tendons, coordinates, muscles] : digits_) {
    const VectorXd posture = q(coordinates);
    const VectorXd tension = VectorXd::Ones(static_cast<Eigen::Index>(muscles.size()));  // [N]
    const Excursion part =
        thenar::excursion(*tendons, VectorXd::Zero(posture.size()), posture, tension);
    out.e(muscles) += part.e;
    if (out.warning.empty()) out.warning = part.warning;
  }
  return out;
}

}  // namespace thenar
