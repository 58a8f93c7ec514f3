#include "dynamics/stepping/impulse_losses.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

/// Work that the impulses of a pair of bodies, or of a joint, took [J].
struct PairLosses {
  double went_on = 0;  // of normals of contacts that touched before
  double struck = 0;   // of all other normals
  double rubbed = 0;   // of friction

  void add_to(ImpulseBooking booking, EnergyFlows& w) const {
    const bool all = booking == ImpulseBooking::kNet;
    if (all || went_on > 0) w[kStruck] += went_on;
    if (!all && struck + rubbed < 0) return;
    w[kStruck] += struck;
    w[kRubbed] += rubbed;
  }
};

/// Returns true if two contacts are of the same bodies, or of the same joint and kind.
bool is_same_pair(const ActiveContact& one, const ActiveContact& other) {
  return one.kind == other.kind && one.a == other.a && one.b == other.b;
}

}  // namespace

void add_impulse_losses(const std::vector<ActiveContact>& list,
                        const std::vector<ContactBlock>& blocks,
                        const Eigen::Ref<const Eigen::VectorXd>& f,
                        const Eigen::Ref<const Eigen::VectorXd>& mean_u, ImpulseBooking booking,
                        EnergyFlows& w) {
  PairLosses pair;
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const ActiveContact& contact = list[k];
    // A new pair of bodies: book what the last one took.
    if (k > 0 && !is_same_pair(list[k - 1], contact)) {
      pair.add_to(booking, w);
      pair = {};
    }
    // Work of the normal, by what the contact did before; then of friction.
    const Eigen::Index across = rows_of(blocks[k].law) - 1;
    const double first = -f[at] * mean_u[at];
    double& taken = contact.kind == Kind::kJointFriction ? pair.rubbed
                    : contact.mode == ContactMode::kOpen ? pair.struck
                                                         : pair.went_on;
    taken += first;
    pair.rubbed -= f.segment(at + 1, across).dot(mean_u.segment(at + 1, across));
    at += across + 1;
  }
  pair.add_to(booking, w);
}

}  // namespace thenar
