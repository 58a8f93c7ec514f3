#include "studies/thumb/coordination_tasks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/random_stream.h"
#include "solvers/least_squares.h"
#include "studies/thumb/thumb_experiment.h"
#include "tendons/forces/tip_force.h"

namespace thenar {

namespace {

// Purposes of the random streams of people's habits and of readings
constexpr std::uint32_t kHabitStream = 211, kTaskReadingStream = 212;
constexpr double kTorqueScale = 0.1;       // Unbalanced torque that counts as one residual [N m]
constexpr double kActivationWeight = 0.1;  // Weight of the cost of activation [1]

/// Activations of least cost, see simulate_tasks().
Eigen::VectorXd share_load(const TipStatics& statics, const Eigen::Vector3d& f,
                           const Eigen::VectorXd& cost) {
  // Rows: unbalanced torque, and the cost of each activation.
  const Eigen::Index n = statics.J.cols(), m = cost.size();
  Eigen::MatrixXd A(n + m, m);
  A << statics.R.transpose() * statics.max_tension.asDiagonal() / kTorqueScale,
      Eigen::MatrixXd((kActivationWeight * cost).asDiagonal());
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + m);
  b.head(n) = statics.J.transpose() * f / kTorqueScale;
  // Linear least squares within 0 .. 1.
  LeastSquares problem;
  problem.lower = Eigen::VectorXd::Zero(m);
  problem.upper = Eigen::VectorXd::Ones(m);
  problem.residuals = [&](const Eigen::VectorXd& a, WithJacobian) {
    return Residuals{A * a - b, A};
  };
  SolveOptions options;
  options.tolerance = 1e-12;
  return solve(problem, Eigen::VectorXd::Constant(m, 0.2), options).z;
}

/// One task of one person, read with noise.
ActivationRow read_task(const TendonDigit& truth, const Eigen::VectorXd& q,
                        const Eigen::VectorXd& activation, const TaskOptions& options,
                        RandomStream random) {
  // The force that the tip makes of these activations, in its own axes.
  const TipStatics statics = tip_statics(truth, q);
  const Eigen::VectorXd t = activation.cwiseProduct(statics.max_tension);
  ActivationRow row;
  row.force = tip_axes(truth, q).transpose() * tip_force(statics, t).f_W;
  // Read with noise, its sd known.
  const double sd = std::hypot(options.floor, options.noise * row.force.norm());
  row.force_sd = Eigen::Vector3d::Constant(sd);
  for (int k = 0; k < 3; ++k) row.force[k] += sd * random.normal();
  for (Eigen::Index i = 0; i < activation.size(); ++i) {
    // Activations read with noise, within 0 .. 1.
    const std::string& muscle = truth.names.muscles[static_cast<std::size_t>(i)];
    const double read = activation[i] + options.activation_sd * random.normal();
    row.activation[muscle] = std::clamp(read, 0.0, 1.0);
    row.sd[muscle] = options.activation_sd;
  }
  return row;
}

}  // namespace

Experiment simulate_tasks(const TendonDigit& truth, const TaskOptions& options) {
  // Palmar, dorsal, radial, ulnar and distal.
  require(truth.max_tension.allFinite(), "every muscle of '{}' needs a max_force", "thumb");
  const std::array<Eigen::Vector3d, 5> directions{
      {{0, -1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {-1, 0, 0}}};
  // The protocol of the pulls, without their trials.
  SimulatedPullOptions pulls;
  pulls.postures = options.postures;
  pulls.add_noise = false;
  Experiment tasks = simulate_pulls(truth, pulls);
  tasks.name = "tasks";
  tasks.trials.clear();
  for (int person = 0; person < options.people; ++person) {
    // A person: what each muscle costs.
    RandomStream habit(options.seed, static_cast<std::uint32_t>(person), 0, kHabitStream);
    Eigen::VectorXd cost(truth.max_tension.size());
    for (double& c : cost) c = std::exp(options.habit * habit.normal());
    for (const PostureRecord& record : tasks.postures) {
      // The same tasks in every posture.
      const Eigen::VectorXd q = posture(truth.skeleton, record.angles);
      const Eigen::Matrix3d axes = tip_axes(truth, q);
      for (const Eigen::Vector3d& direction : directions) {
        const Eigen::VectorXd activation =
            share_load(tip_statics(truth, q), options.force * (axes * direction), cost);
        const auto number = static_cast<std::uint32_t>(tasks.activations.size());
        tasks.activations.push_back(
            read_task(truth, q, activation, options,
                      RandomStream(options.seed, number, 0, kTaskReadingStream)));
        tasks.activations.back().posture = record.name;
      }
    }
  }
  return tasks;
}

std::vector<TaskMisfit> task_misfits(const TendonDigit& model, const Experiment& tasks) {
  const auto muscles = static_cast<Eigen::Index>(model.names.muscles.size());
  std::vector<TaskMisfit> misfits;
  for (const PostureRecord& record : tasks.postures) {
    // Forces of unit tensions in this posture.
    const Eigen::VectorXd q = posture(model.skeleton, record.angles);
    const TipStatics statics = tip_statics(model, q);
    const Eigen::Matrix3d axes = tip_axes(model, q);
    Eigen::Matrix3Xd unit(3, muscles);  // tip force per tension
    for (Eigen::Index i = 0; i < muscles; ++i)
      unit.col(i) = axes.transpose() * tip_force(statics, Eigen::VectorXd::Unit(muscles, i)).f_W;
    for (const ActivationRow& row : tasks.activations) {
      // Tensions of the task, and the covariance of what they make.
      if (row.posture != record.name) continue;
      Eigen::VectorXd t(muscles);
      Eigen::Matrix3d S = row.force_sd->cwiseAbs2().asDiagonal();
      for (Eigen::Index i = 0; i < muscles; ++i) {
        const std::string& muscle = model.names.muscles[static_cast<std::size_t>(i)];
        t[i] = model.max_tension[i] * row.activation.at(muscle);
        const Eigen::Vector3d by_error = model.max_tension[i] * row.sd.at(muscle) * unit.col(i);
        S += by_error * by_error.transpose();
      }
      // Angle, torque left over, and distance in sds.
      const Eigen::Vector3d made = unit * t, off = row.force - made;
      misfits.push_back(
          {std::atan2(made.cross(row.force).norm(), made.dot(row.force)),
           (statics.R.transpose() * t - statics.J.transpose() * (axes * row.force)).norm(),
           off.dot(S.llt().solve(off))});
    }
  }
  return misfits;
}

}  // namespace thenar
