#include "tendons/net/net_derivatives.h"

#include <cmath>

#include "base/error.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::NetPerturbation;
using internal::TangentNet;

TangentNet tangent_at(const Net& net, const TreeState<double>& state, const NetDrive& drive,
                      const NetEquilibrium& rest, double settled = 0) {
  require(drive.law.empty(), "net {}: slopes of tendons on laws are those of PullByTendon",
          net.name);
  const std::string why = why_not_differentiable(net, rest, settled);
  require(why.empty(), "net {}: no slopes, since {}", net.name, why);
  return {net, state, drive, rest};
}

/// d tension / d slack at fixed length [N/m]; a band of constant pull has none.
double by_slack(const TangentNet& tangent, std::size_t b) {
  if (tangent.scene.pull[b] >= 0) return 0;
  return -tangent.band[b].pull.stiffness * tangent.band[b].chord.length / tangent.scene.slack[b];
}

/// d tension / d EA at fixed length [1].
// NOLINTNEXTLINE(readability-identifier-naming): EA is the axial stiffness
double by_EA(const TangentNet& tangent, std::size_t b) {
  if (tangent.scene.pull[b] >= 0) return 0;
  return tangent.band[b].pull.tension / tangent.net.bands[b].EA;
}

bool driven_by_length(const NetDrive& drive, int muscle) {
  return muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(muscle));
}

/// d tension / d drive at fixed length (bands, muscles).
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
  // One joint coordinate at a time: nodes follow, bands change length.
  MatrixXd slopes(static_cast<Index>(tangent.band.size()), coordinates);
  for (int l = 0; l < coordinates; ++l) {
    const NetPerturbation input = internal::joint_perturbation(tangent.net, tree, state, l);
    const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
    for (Index b = 0; b < slopes.rows(); ++b)
      slopes(b, l) = internal::band_rate(tangent, b, input, v).length;
  }
  return slopes;
}

/// One column of slopes an input.
NetJacobian follow(const TangentNet& tangent, const Tree<double>& tree,
                   const TreeState<double>& state, const std::vector<NetPerturbation>& inputs,
                   int coordinates) {
  // One column for each input.
  const auto count = static_cast<Index>(inputs.size());
  const auto bands = static_cast<Index>(tangent.band.size());
  NetJacobian out{MatrixXd(tangent.rest.x.size(), count), MatrixXd(bands, count),
                  MatrixXd(coordinates, count)};
  // Nodes, then tensions and torque at their velocities.
  for (Index i = 0; i < count; ++i) {
    const NetPerturbation& input = inputs[i];
    const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
    out.x.col(i) = Eigen::Map<const VectorXd>(v.data(), v.size());
    for (Index b = 0; b < bands; ++b)
      out.tension(b, i) =
          tangent.collapsed[b] >= 0 ? 0 : internal::band_rate(tangent, b, input, v).tension;
    out.tau.col(i) = internal::torque_rate(tangent, tree, state, input, v, coordinates);
  }
  return out;
}

/// Inputs that change tensions at fixed lengths, one a column of D (bands, inputs).
std::vector<NetPerturbation> tightening(const TangentNet& tangent, std::size_t links,
                                        const MatrixXd& D) {
  std::vector<NetPerturbation> inputs;
  for (Index i = 0; i < D.cols(); ++i) {
    inputs.push_back(internal::zero_perturbation(tangent.net, links));
    inputs.back().tension = D.col(i);
  }
  return inputs;
}

/// Inputs that move one fixed node along x, y or z each.
std::vector<NetPerturbation> displacing(const Net& net, std::size_t links) {
  std::vector<NetPerturbation> inputs;
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    for (Index c = 0; c < 3; ++c) {
      inputs.push_back(internal::zero_perturbation(net, links));
      if (!net.nodes[i].free) inputs.back().node(c, static_cast<Index>(i)) = 1;
    }
  return inputs;
}

/// Inputs that thicken one bone each.
std::vector<NetPerturbation> thickening(const Net& net, std::size_t links) {
  std::vector<NetPerturbation> inputs;
  for (std::size_t s = 0; s < net.surfaces.size(); ++s) {
    inputs.push_back(internal::zero_perturbation(net, links));
    if (internal::has_radius(net.surfaces[s])) inputs.back().radius[s] = 1;
  }
  return inputs;
}

}  // namespace

std::string why_not_differentiable(const Net& net, const NetEquilibrium& rest, double settled) {
  // Status of the equilibrium.
  const bool stalled = rest.status == NetStatus::kStalled && !(rest.residual < settled);
  if (stalled || rest.status == NetStatus::kFarSideWrap)
    return fmt::format("it is not balanced: {:.2g} N are left", rest.residual);
  if (rest.status == NetStatus::kUnstable) return "it is at a saddle";
  // Two floating nodes in one place have no derivative.
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
  // Response of band lengths to the tensions of each muscle.
  const MatrixXd D = tension_by_drive(tangent, drive);
  MatrixXd length(D.rows(), D.cols());
  Index i = 0;
  for (const NetPerturbation& input : tightening(tangent, state.size(), D)) {
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
  // One column for each coordinate.
  MatrixXd slope(coordinates, coordinates);
  for (int l = 0; l < coordinates; ++l) {
    const NetPerturbation input = internal::joint_perturbation(net, tree, state, l);
    slope.col(l) = internal::torque_rate(tangent, tree, state, input,
                                         internal::node_rates(tangent, input), coordinates);
  }
  return slope;
}

NetDerivatives net_derivatives(const Net& net, const Tree<double>& tree,
                               const TreeState<double>& state, const NetDrive& drive,
                               const NetEquilibrium& rest, int coordinates) {
  const TangentNet tangent = tangent_at(net, state, drive, rest);
  // Inputs: bands' stiffness and slack length.
  const auto bands = static_cast<Index>(net.bands.size());
  VectorXd EA(bands), slack(bands);
  for (std::size_t b = 0; b < net.bands.size(); ++b) {
    EA(static_cast<Index>(b)) = by_EA(tangent, b);
    slack(static_cast<Index>(b)) =
        driven_by_length(drive, net.bands[b].muscle) ? 0 : by_slack(tangent, b);
  }
  // Joint coordinates.
  std::vector<NetPerturbation> turns;
  turns.reserve(static_cast<std::size_t>(coordinates));
  for (int l = 0; l < coordinates; ++l)
    turns.push_back(internal::joint_perturbation(net, tree, state, l));
  const auto slopes = [&](const std::vector<NetPerturbation>& inputs) {
    return follow(tangent, tree, state, inputs, coordinates);
  };
  return {slopes(turns),
          slopes(tightening(tangent, tree.size(), tension_by_drive(tangent, drive))),
          slopes(tightening(tangent, tree.size(), EA.asDiagonal())),
          slopes(tightening(tangent, tree.size(), slack.asDiagonal())),
          slopes(displacing(net, tree.size())),
          slopes(thickening(net, tree.size()))};
}

}  // namespace thenar
