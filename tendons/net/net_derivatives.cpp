#include "tendons/net/net_derivatives.h"

#include <cmath>

#include "base/error.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using internal::NetPerturbation;
using internal::TangentNet;

/// Linearises a net. @throws InputError if it is not differentiable
TangentNet tangent_at(const Net& net, const TreeState<double>& state, const NetDrive& drive,
                      const NetEquilibrium& rest, double settled = 0) {
  require(drive.law.empty(), "net {}: slopes of tendons on laws are those of PullByTendon",
          net.name);
  const std::string why = why_not_differentiable(net, rest, settled);
  require(why.empty(), "net {}: no slopes, since {}", net.name, why);
  return {net, state, drive, rest};
}

/// Computes d tension / d slack at fixed length [N/m]; 0 for a band of constant pull.
double by_slack(const TangentNet& tangent, std::size_t b) {
  if (tangent.scene.pull[b] >= 0) return 0;
  return -tangent.band[b].pull.stiffness * tangent.band[b].chord.length / tangent.scene.slack[b];
}

/// Returns whether a muscle is given by its length.
bool driven_by_length(const NetDrive& drive, int muscle) {
  return muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(muscle));
}

/// Computes d tension / d drive at fixed length (bands, muscles).
MatrixXd tension_by_drive(const TangentNet& tangent, const NetDrive& drive) {
  const std::vector<NetBand>& bands = tangent.net.bands;
  MatrixXd D = MatrixXd::Zero(static_cast<Index>(bands.size()),
                              static_cast<Index>(tangent.net.muscles.size()));
  for (std::size_t b = 0; b < bands.size(); ++b)
    if (bands[b].muscle >= 0)
      D(static_cast<Index>(b), bands[b].muscle) =
          driven_by_length(drive, bands[b].muscle) ? by_slack(tangent, b) : 1;
  return D;
}

MatrixXd length_by_posture(const TangentNet& tangent, const Tree<double>& tree,
                           const TreeState<double>& state, int coordinates) {
  // Move one joint coordinate at a time, and compute the length rates of all bands.
  MatrixXd slopes(static_cast<Index>(tangent.band.size()), coordinates);
  for (int l = 0; l < coordinates; ++l) {
    const NetPerturbation input = internal::joint_perturbation(tangent.net, tree, state, l);
    const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
    for (Index b = 0; b < slopes.rows(); ++b)
      slopes(b, l) = internal::band_rate(tangent, b, input, v).length;
  }
  return slopes;
}

/// Builds inputs that change tensions at fixed lengths, one per column of D (bands, inputs).
std::vector<NetPerturbation> tension_inputs(const TangentNet& tangent, std::size_t links,
                                            const MatrixXd& D) {
  std::vector<NetPerturbation> inputs;
  for (Index i = 0; i < D.cols(); ++i) {
    inputs.push_back(internal::zero_perturbation(tangent.net, links));
    inputs.back().tension = D.col(i);
  }
  return inputs;
}

}  // namespace

std::string why_not_differentiable(const Net& net, const NetEquilibrium& rest, double settled) {
  // Check the status of the equilibrium.
  const bool stalled = rest.status == NetStatus::kStalled && !(rest.residual < settled);
  if (stalled || rest.status == NetStatus::kFarSideWrap)
    return fmt::format("it is not balanced: {:.2g} N are left", rest.residual);
  if (rest.status == NetStatus::kUnstable) return "it is at a saddle";
  // Check for floating nodes drawn together, which have no derivative.
  for (const CollapsedBand& collapsed : rest.collapsed) {
    const NetBand& band = net.bands[collapsed.band];
    if (net.nodes[band.a].free && net.nodes[band.b].free)
      return fmt::format("band '{}' has drawn two floating nodes together", band.name);
  }
  return "";
}

MatrixXd length_by_posture(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                           const NetDrive& drive, const NetEquilibrium& rest,
                           const LengthSlopes& wanted) {
  return length_by_posture(tangent_at(net, state, drive, rest, wanted.settled), tree, state,
                           wanted.coordinates);
}

MatrixXd torque_by_drive(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                         const NetDrive& drive, const NetEquilibrium& rest, int coordinates) {
  const TangentNet tangent = tangent_at(net, state, drive, rest);
  return -length_by_posture(tangent, tree, state, coordinates).transpose() *
         tension_by_drive(tangent, drive);
}

MatrixXd muscle_compliance(const Net& net, const TreeState<double>& state, const NetDrive& drive,
                           const NetEquilibrium& rest) {
  const TangentNet tangent = tangent_at(net, state, drive, rest);
  // Compute the response of band lengths to the tension of each muscle.
  const MatrixXd D = tension_by_drive(tangent, drive);
  MatrixXd length(D.rows(), D.cols());
  Index i = 0;
  for (const NetPerturbation& input : tension_inputs(tangent, state.size(), D)) {
    const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
    for (Index b = 0; b < D.rows(); ++b)
      length(b, i) = internal::band_rate(tangent, b, input, v).length;
    ++i;
  }
  return D.transpose() * length;
}

MatrixXd torque_by_posture(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                           const NetDrive& drive, const NetEquilibrium& rest, int coordinates) {
  const TangentNet tangent = tangent_at(net, state, drive, rest);
  // Compute one column per coordinate.
  MatrixXd slope(coordinates, coordinates);
  for (int l = 0; l < coordinates; ++l) {
    const NetPerturbation input = internal::joint_perturbation(net, tree, state, l);
    slope.col(l) = internal::torque_rate(tangent, tree, state, input,
                                         internal::node_rates(tangent, input), coordinates);
  }
  return slope;
}

}  // namespace thenar
