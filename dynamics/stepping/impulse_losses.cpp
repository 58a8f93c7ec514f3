#include "dynamics/stepping/impulse_losses.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

/// Energy dissipated by the impulses of a pair of bodies, or of a joint [J].
struct PairLosses {
  double persisting = 0;   // loss at normals of contacts that touched before
  double new_normals = 0;  // loss at all other normals
  double friction = 0;     // loss by friction

  void add_to(ImpulseBooking booking, EnergyFlows& w) const {
    const bool all = booking == ImpulseBooking::kNet;
    if (all || persisting > 0) w[kImpactLoss] += persisting;
    if (!all && new_normals + friction < 0) return;
    w[kImpactLoss] += new_normals;
    w[kFrictionLoss] += friction;
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
    // Book the previous pair of bodies when a new one starts.
    if (k > 0 && !is_same_pair(list[k - 1], contact)) {
      pair.add_to(booking, w);
      pair = {};
    }
    // Add the work of the normal to the sum that its previous mode selects, then that of friction.
    const Eigen::Index tangent_rows = row_count(blocks[k].law) - 1;
    const double first_loss = -f[at] * mean_u[at];
    double& loss = contact.kind == Kind::kJointFriction ? pair.friction
                   : contact.mode == ContactMode::kOpen ? pair.new_normals
                                                        : pair.persisting;
    loss += first_loss;
    pair.friction -= f.segment(at + 1, tangent_rows).dot(mean_u.segment(at + 1, tangent_rows));
    at += tangent_rows + 1;
  }
  pair.add_to(booking, w);
}

}  // namespace thenar
