#include "kinematics_fit/force_jacobian.h"

#include <optional>
#include <utility>

#include <ceres/jet.h>

#include "base/lists.h"
#include "hand/axis_distance.h"
#include "kinematics_fit/model/net_trials.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/tangent_net.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {
namespace {

// Derivatives propagated at once; they fill two AVX or four SSE registers
constexpr int kJetLanes = 8;
using Jet = ceres::Jet<double, kJetLanes>;

/// Returns u with unit derivatives for coordinates first .. first + kJetLanes - 1.
std::vector<Jet> seed(const Eigen::VectorXd& u, int first) {
  std::vector<Jet> jets(u.data(), u.data() + u.size());
  for (int lane = 0; lane < kJetLanes && first + lane < u.size(); ++lane)
    jets[first + lane].v[lane] = 1;
  return jets;
}

/// Returns one lane of the derivatives of a vector.
Eigen::Vector3d lane_of(const Vec3<Jet>& v, int lane) {
  return {v.x().v[lane], v.y().v[lane], v.z().v[lane]};
}

/// Returns the twist of a link from the derivatives of its pose:  dR R' = [w],  v = dp - w x p.
internal::BodyTwist twist_of(const Pose<Jet>& X, int lane) {
  Eigen::Matrix3d R, dR;
  for (int i = 0; i < 9; ++i) {
    R.data()[i] = X.R.data()[i].a;
    dR.data()[i] = X.R.data()[i].v[lane];
  }
  const Eigen::Matrix3d W = dR * R.transpose();
  const Eigen::Vector3d w(W(2, 1), W(0, 2), W(1, 0)), p(X.p.x().a, X.p.y().a, X.p.z().a);
  return {lane_of(X.p, lane) - w.cross(p), w};
}

/// Returns the perturbation of one lane: of bones, hinges, nodes, radii, and of tensions at fixed
/// lengths.
internal::NetPerturbation perturbation_of(const SpecimenNet<Jet>& specimen_net,
                                          const TreeState<Jet>& state,
                                          const internal::TangentNet& tangent,
                                          const VectorX<Jet>& pulls, int lane) {
  const Net& net = tangent.net;
  internal::NetPerturbation input = internal::zero_perturbation(net, state.size());
  // Perturb bones and hinges.
  for (std::size_t i = 0; i < state.size(); ++i) {
    input.link[i + 1] = twist_of(state[i].X, lane);
    input.axis[i] = lane_of(state[i].axis, lane);
    input.point[i] = lane_of(state[i].point, lane);
  }
  // Perturb the places of fixed nodes on their bones, and the bones' radii.
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    if (net.nodes[i].free) continue;
    Vec3<Jet> along = specimen_net.place[i];
    for (int c = 0; c < 3; ++c) along[c].a = 0;
    const int link = net.nodes[i].link;
    if (link >= 0) along = (state[link].X.R * along).eval();
    input.node.col(static_cast<Eigen::Index>(i)) = lane_of(along, lane);
  }
  for (Eigen::Index s = 0; s < input.radius.size(); ++s)
    input.radius[s] = specimen_net.radius[s].v[lane];
  // Perturb tensions: pulls, and the laws of bands in terms of log EA and log slack length.
  for (Eigen::Index b = 0; b < input.tension.size(); ++b) {
    const int muscle = net.bands[b].muscle;
    if (muscle >= 0) {
      input.tension[b] = pulls[muscle].v[lane];
      continue;
    }
    const internal::BandState& band = tangent.band[b];
    input.tension[b] = band.pull.tension * specimen_net.EA[b].v[lane] / specimen_net.EA[b].a -
                       band.pull.stiffness * band.chord.length * specimen_net.slack[b].v[lane] /
                           specimen_net.slack[b].a;
  }
  return input;
}

bool is_still(const internal::NetPerturbation& input) {
  const auto zero = [](const auto& v) { return v.isZero(0); };
  return zero(input.tension) && zero(input.node) && zero(input.radius) &&
         all_of(input.axis, zero) && all_of(input.point, zero) &&
         all_of(input.link,
                [&](const internal::BodyTwist& body) { return zero(body.v) && zero(body.w); });
}

/// Equilibria of a specimen's net in all trials, with derivatives by implicit differentiation.
class NetSlopes {
 public:
  NetSlopes(const SpecimenModel<double>& model, const ExperimentPlan& plan)
      : plan_(plan),
        tree_(model.digit.tree),
        at_(net_trials(model, plan)),
        tangent_(at_.trials.size()) {
    // Skip trials in which the net is not differentiable: their slopes are 0.
    for (std::size_t i = 0; i < tangent_.size(); ++i)
      if (at_.trials[i] &&
          why_not_differentiable(at_.net, at_.trials[i]->rest, kMaxSettledResidual).empty())
        tangent_[i] = std::make_unique<internal::TangentNet>(
            at_.net, at_.trials[i]->state, at_.trials[i]->drive, at_.trials[i]->rest);
  }

  [[nodiscard]] VectorX<Jet> torque(const SpecimenModel<Jet>& model, const PosedSpecimen<Jet>& at,
                                    std::size_t i) const {
    const NetTrial& trial = *at_.trials[i];
    VectorX<Jet> tau = trial.tau.cast<Jet>();
    if (!tangent_[i]) return tau;
    // Compute the pulls of this trial, then the torque rates lane by lane.
    const VectorX<Jet> pulls =
        net_pulls(*model.net, mcp_angle<Jet>(model.digit, at.angles),
                  VectorX<Jet>(model.gain.cwiseProduct(plan_.tension[i].cast<Jet>())));
    for (int lane = 0; lane < kJetLanes; ++lane) {
      const internal::NetPerturbation input =
          perturbation_of(*model.net, at.state, *tangent_[i], pulls, lane);
      if (is_still(input)) continue;
      const Eigen::VectorXd rate =
          internal::torque_rate(*tangent_[i], tree_, trial.state, input,
                                internal::node_rates(*tangent_[i], input), model.digit.coordinates);
      for (Eigen::Index j = 0; j < tau.size(); ++j) tau[j].v[lane] = rate[j];
    }
    return tau;
  }

 private:
  const ExperimentPlan& plan_;
  Tree<double> tree_;
  NetTrials at_;
  std::vector<std::unique_ptr<internal::TangentNet>> tangent_;  // refer to at_
};

}  // namespace

std::shared_ptr<const ForceKernel> compile_forces(const TendonDigit& digit,
                                                  const FitParameters& parameters,
                                                  const ExperimentPlan& plan) {
  if (!ForceKernel::supports(digit, plan)) return nullptr;
  return std::make_shared<const ForceKernel>(digit, parameters, plan);
}

Eigen::Matrix3Xd force_values(const TendonDigit& digit, const FitParameters& parameters,
                              const ExperimentPlan& plan, const Eigen::VectorXd& u,
                              const ForceKernel* kernel) {
  if (kernel != nullptr) return kernel->forces(u).reshaped(3, plan.force.cols());
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  if (!model.net) return predict_forces(model, plan);
  const NetTrials nets = net_trials(model, plan);
  return predict_forces<double>(
      model, plan, [&](const PosedSpecimen<double>& /*at*/, Eigen::Index i) -> Eigen::VectorXd {
        return nets.trials[i]->tau;
      });
}

ForceJacobian force_jacobian(const TendonDigit& digit, const FitParameters& parameters,
                             const ExperimentPlan& plan, const Eigen::VectorXd& u,
                             const ForceKernel* kernel) {
  if (kernel != nullptr) {
    ForceKernel::Slopes at = kernel->slopes(u);
    return {at.forces.reshaped(3, plan.force.cols()), std::move(at.J)};
  }
  // Differentiate by eight coordinates at a time; each pass yields the forces, too.
  const int n = parameters.coordinates();
  ForceJacobian out{Eigen::Matrix3Xd(3, plan.force.cols()),
                    Eigen::MatrixXd(3 * plan.force.cols(), n)};
  std::optional<NetSlopes> nets;  // equilibria, solved once for all lanes
  if (digit.net)
    nets.emplace(specimen_model(digit, parameters, parameter_values<double>(parameters, u)), plan);
  for (int first = 0; first < n; first += kJetLanes) {
    const SpecimenModel<Jet> model =
        specimen_model(digit, parameters, parameter_values<Jet>(parameters, seed(u, first)));
    const auto forces = predict_forces<Jet>(
        model, plan, [&](const PosedSpecimen<Jet>& at, Eigen::Index i) -> VectorX<Jet> {
          return nets->torque(model, at, static_cast<std::size_t>(i));
        });
    // Store values, and derivatives into their columns.
    for (Eigen::Index i = 0; i < forces.size(); ++i) {
      const Jet& f = forces.data()[i];
      out.force.data()[i] = f.a;
      for (int lane = 0; lane < kJetLanes && first + lane < n; ++lane)
        out.J(i, first + lane) = f.v[lane];
    }
  }
  return out;
}

ConstraintValues axis_constraints(const TendonDigit& digit, const FitParameters& parameters,
                                  const std::vector<AxisPair>& pairs, const Eigen::VectorXd& u) {
  // Differentiate by eight coordinates at a time, as for forces.
  const int n = parameters.coordinates();
  const auto count = static_cast<Eigen::Index>(pairs.size());
  ConstraintValues out{Eigen::VectorXd(count), Eigen::MatrixXd(count, n)};
  for (int first = 0; first < n; first += kJetLanes) {
    const Tree<Jet> tree =
        specimen_model(digit, parameters, parameter_values<Jet>(parameters, seed(u, first)))
            .digit.tree;
    for (Eigen::Index k = 0; k < count; ++k) {
      // Divide the squared distance by the squared upper limit.
      const AxisPair& pair = pairs[k];
      const Jet c =
          squared_axis_distance(tree[pair.first], tree[pair.second]) / (pair.upper * pair.upper);
      out.c[k] = c.a;
      for (int lane = 0; lane < kJetLanes && first + lane < n; ++lane)
        out.C(k, first + lane) = c.v[lane];
    }
  }
  return out;
}

}  // namespace thenar
