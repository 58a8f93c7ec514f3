#include "kinematics_fit/bands/net_records.h"

#include <utility>

#include "base/error.h"
#include "kinematics_fit/model/fit_parameters.h"
#include "kinematics_fit/model/tip_constraint.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ExperimentPlan plan_of(const NetTendons& tendons, const Experiment& experiment) {
  return plan_experiment(tendons.digit(), choose_parameters(tendons.digit(), {}, {}), experiment);
}

std::string loading_name(const TendonDigit& digit, const std::string& posture, const VectorXd& t) {
  std::string name = posture;
  for (Eigen::Index m = 0; m < t.size(); ++m)
    if (t(m) > 0) name += fmt::format(" {}={:.3g}", digit.names.muscles[m], t(m));
  return name;
}

/// Builds a test of the net in a posture [rad] under tensions t [N].
TendonTest test_of(const NetTendons& tendons, const ExperimentPlan& plan, int posture,
                   const VectorXd& t) {
  const TendonModel<double>& model = tendons.digit().model;
  // Set the posture, the tensions of the net's muscles, and a name of both.
  TendonTest test;
  test.q = plan.postures[posture];
  test.tension = tendons.drive(t);
  test.name = loading_name(tendons.digit(), plan.posture_names[posture], t);

  // Solve the net; torque that its bands do not explain belongs to the tendons outside it.
  test.start = start_from_straight(tendons, test.q, t);
  const NetEquilibrium rest = tendons.rest(test.q, t, test.start);
  test.tau_own = tendons.torque(test.q, t, rest) - net_torque(tendons.net().net, model.tree,
                                                              pose_tree(model.tree, test.q), rest,
                                                              model.coordinates);
  test.map = cell_map(model, plan, test.q).topRows(plan.measured);
  return test;
}

/// Returns the largest loads of the muscles that pull the net: all together, each alone, and in
/// pairs [N] (muscles).
/// @param tension  tensions of every trial [N] (muscles)
std::vector<VectorXd> possible_loads(const BuiltNet& net, const std::vector<VectorXd>& tension) {
  VectorXd largest = VectorXd::Zero(tension.front().size());
  for (const VectorXd& t : tension)
    for (const MuscleAttachment& pull : net.pulls)
      largest(pull.muscle) = std::max(largest(pull.muscle), t(pull.muscle));
  // Add single muscles (a = b), and pairs.
  std::vector<VectorXd> loads{largest};
  for (Eigen::Index a = 0; a < largest.size(); ++a)
    for (Eigen::Index b = a; b < largest.size(); ++b) {
      if (largest(a) <= 0 || largest(b) <= 0) continue;
      loads.emplace_back(VectorXd::Zero(largest.size()));
      loads.back()(a) = largest(a);
      loads.back()(b) = largest(b);
    }
  return loads;
}

/// Returns the tension of each of the digit's muscles in a trial [N] (muscles).
VectorXd tensions_of(const TendonDigit& digit, const Trial& trial) {
  const std::vector<std::string>& names = digit.names.muscles;
  VectorXd t = VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (std::size_t m = 0; m < names.size(); ++m)
    if (const auto at = trial.tension.find(names[m]); at != trial.tension.end())
      t(static_cast<Eigen::Index>(m)) = at->second;
  return t;
}

}  // namespace

MatrixXd cell_map(const TendonModel<double>& model, const ExperimentPlan& plan, const VectorXd& q) {
  // Solve for the loads of the constraint under a unit torque about each joint.
  const TreeState<double> state = pose_tree(model.tree, q);
  const MatrixXd L = tip_constraint_loads(model, state, plan.hold, plan.known, 0.0);
  const MatrixX<double> each = MatrixX<double>::Identity(model.coordinates, model.coordinates);
  const MatrixX<double> loads =
      L.rows() < L.cols() ? solve_least_norm(L, each) : solve_least_squares(L, each);

  // Rotate forces from the tip's axes to the stated ones; none acts across a plane of flexion.
  Eigen::Matrix3Xd forces = loads.topRows(3);
  if (plan.known == DecidedForces::kInPlane) forces.row(2).setZero();
  const auto axes = [&](int link) -> Eigen::Matrix3d {
    return link < 0 ? model.tip_axes : Eigen::Matrix3d(state[link].X.R * model.tip_axes);
  };
  return plan.components * axes(plan.force_link).transpose() * axes(model.tip_link) * forces;
}

CandidateNet candidate_of(const NetTendons& tendons) {
  const TendonModel<double>& model = tendons.digit().model;
  const Net& net = tendons.net().net;
  return {net, model.tree, model.coordinates, passive_candidates(net)};
}

std::vector<TendonRecord> net_records(const NetTendons& tendons, const Experiment& experiment) {
  const ExperimentPlan plan = plan_of(tendons, experiment);
  std::vector<TendonRecord> records;
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    // Skip trials that do not load the net.
    const VectorXd& t = plan.tension[i];
    require(site_of(plan, static_cast<std::size_t>(i)) < 0,
            "experiment {}: bands are inferred from tip forces; leave out trials measured at "
            "other segments",
            experiment.name);
    if (tendons.drive(t).isZero(0)) continue;
    records.push_back({test_of(tendons, plan, plan.posture_of_trial[i], t),
                       plan.force.col(i).head(plan.measured), plan.sd.col(i).head(plan.measured)});
  }
  require(!records.empty(), "experiment {}: no muscle of net {} is loaded", experiment.name,
          tendons.net().net.name);
  return records;
}

std::vector<TendonTest> possible_tests(const NetTendons& tendons, const Experiment& experiment) {
  const ExperimentPlan plan = plan_of(tendons, experiment);
  const std::vector<VectorXd> loads = possible_loads(tendons.net(), plan.tension);
  // Combine each load with every posture.
  std::vector<TendonTest> tests;
  for (int p = 0; p < static_cast<int>(plan.postures.size()); ++p)
    for (const VectorXd& t : loads) tests.push_back(test_of(tendons, plan, p, t));
  return tests;
}

std::vector<Trial> possible_trials(const TendonDigit& digit, const Experiment& experiment) {
  require(digit.net != nullptr, "trials for bands are wanted of a digit without a net");
  std::vector<VectorXd> measured;
  for (const Trial& trial : experiment.trials) measured.push_back(tensions_of(digit, trial));
  // Combine each load with every posture.
  std::vector<Trial> trials;
  for (const PostureRecord& posture : experiment.postures)
    for (const VectorXd& t : possible_loads(*digit.net, measured)) {
      Trial trial;
      trial.posture = posture.name;
      for (Eigen::Index m = 0; m < t.size(); ++m)
        if (t(m) > 0) trial.tension[digit.names.muscles[m]] = t(m);
      trials.push_back(std::move(trial));
    }
  return trials;
}

std::string trial_name(const TendonDigit& digit, const Trial& trial) {
  return loading_name(digit, trial.posture, tensions_of(digit, trial));
}

}  // namespace thenar
