#include "tendons/net/net_pull.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Length of a band through its exit,  sqrt(L^2 + kExitRadius^2),  and its derivative by L.
struct OverExit {
  explicit OverExit(double L) : length(std::hypot(L, kExitRadius)), slope(L / length) {}
  double length, slope;
};

/// Law of a band that carries a share of the tension of a tendon.
class ShareOfTendon : public TensionLaw {
 public:
  /// Refers to the tendon. @param beyond  length of the tendon less the band's share of it [m]
  ShareOfTendon(std::shared_ptr<const TensionLaw> tendon, double share, double beyond)
      : tendon_(std::move(tendon)), share_(share), beyond_(beyond) {}
  [[nodiscard]] BandResponse response_at(double length) const override {
    const OverExit over(length);
    const BandResponse whole = tendon_->response_at(share_ * over.length + beyond_);
    const double slope = share_ * over.slope, turn = 1 - over.slope * over.slope;
    return {whole.energy, slope * whole.tension,
            slope * slope * whole.stiffness + share_ * whole.tension * turn / over.length};
  }

 private:
  std::shared_ptr<const TensionLaw> tendon_;
  double share_, beyond_;
};

/// Computes the excess length of muscle lines at exits [m] (muscles).
VectorXd excess_of_exits(const NetTendons& tendons, const NetEquilibrium& rest) {
  const VectorXd band = muscle_band_length(tendons.net().net, rest);
  const VectorXd more = band.unaryExpr([](double L) { return OverExit(L).length - L; });
  return tendons.shares().transpose() * more;
}

}  // namespace

TendonTorque infinite_torque(Index joints, Index muscles, std::string why) {
  TendonTorque pull;
  pull.tau = VectorXd::Constant(joints, HUGE_VAL);
  pull.R = MatrixXd::Zero(muscles, joints);
  pull.status = TendonStatus::kUnbalanced;
  pull.warning = std::move(why);
  return pull;
}

NetDrive PullByTension::drive(const PostureAndLoad& at) const {
  return {tendons().drive(at.load), {}};
}

PullRates PullByTension::rates(const PostureAndLoad& at, const NetEquilibrium& /*rest*/) const {
  return {MatrixXd::Zero(tendons().shares().rows(), at.q.size()), tendons().shares()};
}

NetPotential PullByTension::potential(const PostureAndLoad& at, const NetEquilibrium& rest) const {
  const Net& net = tendons().net().net;
  const TendonModel<double>& model = tendons().digit().model;
  NetPotential out;
  out.by_load = tendons().shares().transpose() * muscle_band_length(net, rest);
  out.energy = strain_energy(net, rest) + at.load.dot(out.by_load);
  out.tau = net_torque(net, model.tree, pose_tree(model.tree, at.q), rest, model.coordinates);
  return out;
}

TendonTorque PullByTension::torque(const PostureAndLoad& at, NetEquilibrium rest) const {
  return tendons().torque_at_equilibrium(at.q, at.load, std::move(rest));
}

bool PullByTension::pulls(const VectorXd& load) const {
  constexpr double kSlackTension = 1e-6;  // tension below which a muscle does not pull the net [N]
  const VectorXd drive = tendons().drive(load);
  return drive.size() > 0 && drive.maxCoeff() > kSlackTension;
}

double PullByTension::min_change(const VectorXd& from, const VectorXd& to, double share) const {
  constexpr double kMinReferenceTension =
      1e-3;  // smallest reference tension of a relative change [N]
  double most = kMinReferenceTension;
  if (from.size() > 0) most = std::max({most, from.maxCoeff(), to.maxCoeff()});
  return share * most;
}

bool pulls_one_band_each(const NetTendons& tendons) {
  // Count bands of each pull, and pulls of each muscle.
  const Net& net = tendons.net().net;
  VectorXd bands = VectorXd::Zero(static_cast<Index>(net.muscles.size()));
  for (const NetBand& band : net.bands)
    if (band.muscle >= 0) bands[band.muscle] += 1;
  const VectorXd pulls = (tendons.shares().array() != 0).cast<double>().matrix().colwise().sum();
  return (bands.array() == 1).all() && (pulls.array() <= 1).all();
}

PullByTendon::PullByTendon(const NetTendons& tendons,
                           std::vector<std::shared_ptr<const TensionLaw>> laws,
                           const NetEquilibrium& first)
    : NetPull(tendons), laws_(std::move(laws)) {
  require(laws_.size() == tendons.digit().names.muscles.size(), "{} tendons for {} muscles",
          laws_.size(), tendons.digit().names.muscles.size());
  require(pulls_one_band_each(tendons),
          "net '{}' has a muscle that does not pull just one band, or pulls it twice",
          tendons.net().net.name);
  first_excess_ = excess_of_exits(tendons, first);
}

VectorXd PullByTendon::line_offsets(const VectorXd& q) const {
  return tendons().lengths_outside(q) - first_excess_;
}

MatrixXd PullByTendon::arms_outside(const VectorXd& q) const {
  return tendons().torque_outside(q, VectorXd::Zero(first_excess_.size())).R;
}

NetDrive PullByTendon::drive(const PostureAndLoad& at) const {
  require(at.load.size() == first_excess_.size() && at.load.allFinite(),
          "wanted {} ends of tendons, got {}, all finite: {}", first_excess_.size(), at.load.size(),
          at.load.allFinite());
  const VectorXd outside = line_offsets(at.q);
  const std::vector<MuscleAttachment>& pulls = tendons().net().pulls;
  NetDrive drive;
  drive.tension = VectorXd::Zero(static_cast<Index>(pulls.size()));
  for (const MuscleAttachment& pull : pulls)
    drive.law.push_back(std::make_shared<const ShareOfTendon>(
        laws_[pull.muscle], pull.share, outside[pull.muscle] - at.load[pull.muscle]));
  return drive;
}

PullByTendon::Stretched PullByTendon::stretched(const PostureAndLoad& at,
                                                const NetEquilibrium& rest) const {
  // Compute the lines, in the net through their exits.
  Stretched now;
  now.length = line_offsets(at.q);
  const VectorXd band = muscle_band_length(tendons().net().net, rest);
  now.exit_slope.resize(band.size());
  for (Index p = 0; p < band.size(); ++p) {
    const OverExit over(band[p]);
    const MuscleAttachment& pull = tendons().net().pulls[p];
    now.length[pull.muscle] += pull.share * over.length;
    now.exit_slope[p] = over.slope;
  }
  // Evaluate the tendons by their laws.
  now.tension.resize(now.length.size());
  now.stiffness.resize(now.length.size());
  for (Index m = 0; m < now.length.size(); ++m) {
    const BandResponse tendon = laws_[m]->response_at(now.length[m] - at.load[m]);
    now.energy += tendon.energy;
    now.tension[m] = tendon.tension;
    now.stiffness[m] = tendon.stiffness;
  }
  return now;
}

PullRates PullByTendon::rates_of(const Stretched& now, const MatrixXd& R) const {
  // Compute the rate of each pull: share stiffness (dL - dp) of the line outside the net.
  const std::vector<MuscleAttachment>& pulls = tendons().net().pulls;
  const auto count = static_cast<Index>(pulls.size());
  PullRates out{MatrixXd::Zero(count, R.cols()), MatrixXd::Zero(count, R.rows())};
  for (Index p = 0; p < count; ++p) {
    const MuscleAttachment& pull = pulls[p];
    const double k = pull.share * now.exit_slope[p] * now.stiffness[pull.muscle];
    out.by_posture.row(p) = -k * R.row(pull.muscle);
    out.by_load(p, pull.muscle) = -k;
  }
  return out;
}

PullRates PullByTendon::rates(const PostureAndLoad& at, const NetEquilibrium& rest) const {
  const Stretched now = stretched(at, rest);
  return rates_of(now, arms_outside(at.q));
}

std::vector<int> PullByTendon::drawn_bands(const Stretched& now) const {
  constexpr double kPullShare = 0.01;  // largest fraction of a pull that a net may miss [1]
  constexpr double kPullError = 0.05;  // largest force that a net may miss [N]
  const NetTendons& all = tendons();
  std::vector<int> bands;
  for (std::size_t b = 0; b < all.net().net.bands.size(); ++b) {
    const int p = all.net().net.bands[b].muscle;
    if (p < 0) continue;
    const MuscleAttachment& pull = all.net().pulls[p];
    const double missing = 1 - now.exit_slope[p];
    if (missing > kPullShare && missing * pull.share * now.tension[pull.muscle] > kPullError)
      bands.push_back(static_cast<int>(b));
  }
  return bands;
}

TendonTorque PullByTendon::torque(const PostureAndLoad& at, NetEquilibrium rest) const {
  Stretched now = stretched(at, rest);
  if (!now.finite())
    return infinite_torque(at.q.size(), at.load.size(), "a tendon is stretched beyond all bounds");
  TendonTorque pull = tendons().torque_without_net_arms(at.q, now.tension, std::move(rest));
  // Report nodes that the net does not hold.
  if (const std::string drawn = drawn_band_names(tendons().net().net, drawn_bands(now));
      !drawn.empty()) {
    pull.status = worse(pull.status, TendonStatus::kNodeCollapsed);
    add_warning(drawn, pull);
  }
  pull.R.resize(0, 0);
  pull.tension = std::move(now.tension);
  pull.length = std::move(now.length);
  return pull;
}

NetPotential PullByTendon::potential(const PostureAndLoad& at, const NetEquilibrium& rest) const {
  const Stretched now = stretched(at, rest);
  if (!now.finite()) return {HUGE_VAL, VectorXd::Zero(at.q.size()), -now.tension};
  return {strain_energy(tendons().net().net, rest) + now.energy,
          tendons().torque(at.q, now.tension, rest), -now.tension};
}

double PullByTendon::min_change(const VectorXd& /*from*/, const VectorXd& /*to*/,
                                double /*share*/) const {
  return 1e-7;  // 0.02 N of a tendon of 2e5 N/m [m]
}

EndSlopes PullByTendon::slopes(const PostureAndLoad& at, const NetEquilibrium& rest) const {
  const Net& net = tendons().net().net;
  const TendonModel<double>& model = tendons().digit().model;
  const Index joints = at.q.size(), muscles = at.load.size();
  // Compute the derivatives of tendons outside the net.
  const Stretched now = stretched(at, rest);
  const MatrixXd R = arms_outside(at.q);
  EndSlopes out;
  out.torque_by_posture = tendons().torque_by_posture_outside(at.q, now.tension);
  out.length_by_posture = -R;
  out.length_by_end = MatrixXd::Zero(muscles, muscles);
  // Add the net, one joint or tendon end at a time.
  if (why_not_differentiable(net, rest).empty()) {
    const TreeState<double> state = pose_tree(model.tree, at.q);
    const internal::TangentNet tangent(net, state, drive(at), rest);
    const PullRates rate = rates_of(now, R);
    const auto length_rates = [&](const internal::NetPerturbation& input,
                                  const Eigen::Matrix3Xd& v) {
      VectorXd of_pulls = VectorXd::Zero(rate.by_load.rows());
      for (std::size_t b = 0; b < net.bands.size(); ++b) {
        const int p = net.bands[b].muscle;
        if (p < 0) continue;
        of_pulls[p] = now.exit_slope[p] *
                      internal::band_rate(tangent, static_cast<Index>(b), input, v).length;
      }
      return VectorXd(tendons().shares().transpose() * of_pulls);
    };
    for (Index j = 0; j < joints; ++j) {
      internal::NetPerturbation input =
          internal::joint_perturbation(net, model.tree, state, static_cast<int>(j));
      internal::add_pull_rates(net, rate.by_posture.col(j), input);
      const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
      out.torque_by_posture.col(j) +=
          internal::torque_rate(tangent, model.tree, state, input, v, model.coordinates);
      out.length_by_posture.col(j) += length_rates(input, v);
    }
    for (Index m = 0; m < muscles; ++m) {
      internal::NetPerturbation input = internal::zero_perturbation(net, model.tree.size());
      internal::add_pull_rates(net, rate.by_load.col(m), input);
      out.length_by_end.col(m) = length_rates(input, internal::node_rates(tangent, input));
    }
  }
  // Apply the tendon laws; torques by ends equal tensions by posture, since both are second
  // derivatives of one energy.
  out.tension_by_posture = now.stiffness.asDiagonal() * out.length_by_posture;
  out.tension_by_end =
      now.stiffness.asDiagonal() * (out.length_by_end - MatrixXd::Identity(muscles, muscles));
  out.torque_by_posture += R.transpose() * out.tension_by_posture;
  out.torque_by_end = out.tension_by_posture.transpose();
  return out;
}

}  // namespace thenar
