#include "bench/net_rivals/dynamic_relaxation.h"

#include "bench/net_rivals/bone_reaction.h"

namespace thenar::bench {
namespace {

/// Least stable masses per node and direction, at a time step of 1 [N/m] (3, nodes).
/// @param margin  on the stiffness, which changes until the next stop [1]
Eigen::Matrix3Xd min_masses(const PosedNet& net, const Eigen::Matrix3Xd& x, double margin) {
  constexpr double kShortest = 5e-4;  // free run of a bent band that is reckoned with [m]
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, x.cols());
  double largest = 0;
  for (std::size_t k = 0; k < net.net().bands.size(); ++k) {
    const NetBand& band = net.net().bands[k];
    const BandForce at = net.band(static_cast<int>(k), x);
    // A slack band may tighten before the next stop: it counts as taut. One that hugs a bone is
    // stiff without bound across the bone, where its nodes do not go.
    const double most = at.pull.tension / kShortest;
    const Eigen::Matrix<double, 6, 6> axial = at.along * at.along.transpose();
    const Eigen::Matrix<double, 6, 6> across = at.slope - at.pull.stiffness * axial;
    const Eigen::Matrix<double, 6, 1> row =
        (net.recruited(static_cast<int>(k)) * axial.cwiseAbs() + across.cwiseAbs().cwiseMin(most))
            .rowwise()
            .sum();
    sums.col(band.a) += row.head<3>();
    sums.col(band.b) += row.tail<3>();
  }
  for (const int i : net.free_nodes()) largest = std::max(largest, sums.col(i).maxCoeff());
  // A node whose bands are all slack must not weigh nothing.
  return margin / 4 * sums.cwiseMax(1e-3 * largest);
}

constexpr double kBlownUp = 100;  // of the first residual: the step was not stable [1]

/// Where the nodes are, and where they go.
struct Moving {
  Eigen::Matrix3Xd x, v;
  double energy = 0;  // kinetic
};

}  // namespace

RivalRest relax(const PosedNet& net, const Eigen::Matrix3Xd& start,
                const RelaxationOptions& options, const Watch& watch) {
  const auto count = static_cast<Eigen::Index>(net.net().nodes.size());
  Eigen::RowVectorXd free = Eigen::RowVectorXd::Zero(count);
  for (const int i : net.free_nodes()) free[i] = 1;
  Moving now{settled(net, net.from(start)), Eigen::Matrix3Xd::Zero(3, count), 0};
  const Moving begin = now;
  double margin = 1.05, first = 0;
  Eigen::Matrix3Xd mass = min_masses(net, now.x, margin);
  bool stopped = true;

  RivalRest rest;
  for (rest.iterations = 0; rest.iterations < options.max_steps; ++rest.iterations) {
    const Eigen::Matrix3Xd pull = net.band_forces(now.x);
    const std::vector<BoneProbe> bones = pressed(net, now.x, pull);
    const Eigen::Matrix3Xd force = kept_out(bones, pull);
    rest.residual = largest_free(net, force);
    rest.balanced = rest.residual <= options.tolerance;
    if (rest.balanced) break;
    if (rest.iterations == 0) first = rest.residual;
    if (!(rest.residual < kBlownUp * first)) {  // as Barnes advises: begin again with more mass
      now = begin;
      margin *= 2;
      mass = min_masses(net, now.x, margin);
      stopped = true;
      continue;
    }

    // A first half step after every stop puts velocities between places.
    const Eigen::Matrix3Xd push = force.cwiseQuotient(mass).array().rowwise() * free.array();
    const Eigen::Matrix3Xd v = kept_out(bones, now.v + (stopped ? 0.5 : 1.0) * push);
    const double energy = 0.5 * (mass.array() * v.array().square()).sum();
    if (!stopped && energy < now.energy) {
      // The peak lay half a step back: stop there.
      now = {settled(net, now.x - 0.5 * now.v, bones), Eigen::Matrix3Xd::Zero(3, count), 0};
      mass = min_masses(net, now.x, margin);
      stopped = true;
      continue;
    }
    now = {settled(net, now.x + v, bones), v, energy};
    stopped = false;
    if (watch) watch(now.x);
  }
  rest.x = now.x;
  return rest;
}

}  // namespace thenar::bench
