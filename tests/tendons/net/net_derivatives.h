#pragma once

/// Derivatives of a net's equilibrium by all inputs, for tests of its linearisation.

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/tangent_net.h"

namespace thenar {

/// Derivatives of (x, tension, tau) by one group of inputs.
struct NetJacobian {
  Eigen::MatrixXd x;        // positions of all nodes, stacked (3 nodes, inputs)
  Eigen::MatrixXd tension;  // tensions of all bands (bands, inputs)
  Eigen::MatrixXd tau;      // joint torque (coordinates, inputs)
};

/// Derivatives of an equilibrium by all inputs.
struct NetDerivatives {
  NetJacobian by_posture;  // by q [1/rad]
  NetJacobian by_drive;    // by each muscle's tension [1/N], or length [1/m]
  NetJacobian by_EA;       // by each band's EA [1/N]
  NetJacobian by_slack;    // by each band's slack length [1/m]
  NetJacobian by_place;  // by world x, y, z of each fixed node in turn, on its link; 0 for floating
                         // nodes [1/m]
  NetJacobian by_radius;  // by the radius of each surface; 0 for ellipsoids and tori [1/m]
};

/// Computes one column of derivatives per input.
inline NetJacobian jacobian_of(const internal::TangentNet& tangent, const Tree<double>& tree,
                               const TreeState<double>& state,
                               const std::vector<internal::NetPerturbation>& inputs,
                               int coordinates) {
  // Allocate one column per input.
  const auto count = static_cast<Eigen::Index>(inputs.size());
  const auto bands = static_cast<Eigen::Index>(tangent.band.size());
  NetJacobian out{Eigen::MatrixXd(tangent.rest.x.size(), count), Eigen::MatrixXd(bands, count),
                  Eigen::MatrixXd(coordinates, count)};
  // Compute node velocities, then rates of tensions and torque.
  for (Eigen::Index i = 0; i < count; ++i) {
    const internal::NetPerturbation& input = inputs[i];
    const Eigen::Matrix3Xd v = internal::node_rates(tangent, input);
    out.x.col(i) = Eigen::Map<const Eigen::VectorXd>(v.data(), v.size());
    for (Eigen::Index b = 0; b < bands; ++b)
      out.tension(b, i) =
          tangent.collapsed[b] >= 0 ? 0 : internal::band_rate(tangent, b, input, v).tension;
    out.tau.col(i) = internal::torque_rate(tangent, tree, state, input, v, coordinates);
  }
  return out;
}

/// Builds inputs that change the tension of one band each at a fixed length [N per input] (bands).
inline std::vector<internal::NetPerturbation> band_inputs(const internal::TangentNet& tangent,
                                                          std::size_t links,
                                                          const Eigen::VectorXd& by) {
  std::vector<internal::NetPerturbation> inputs;
  for (Eigen::Index b = 0; b < by.size(); ++b) {
    inputs.push_back(internal::zero_perturbation(tangent.net, links));
    inputs.back().tension(b) = by(b);
  }
  return inputs;
}

/// Builds inputs that move one fixed node along x, y or z each.
inline std::vector<internal::NetPerturbation> place_inputs(const Net& net, std::size_t links) {
  std::vector<internal::NetPerturbation> inputs;
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c) {
      inputs.push_back(internal::zero_perturbation(net, links));
      if (!net.nodes[i].free) inputs.back().node(c, static_cast<Eigen::Index>(i)) = 1;
    }
  return inputs;
}

/// Builds inputs that increase the radius of one bone each.
inline std::vector<internal::NetPerturbation> radius_inputs(const Net& net, std::size_t links) {
  std::vector<internal::NetPerturbation> inputs;
  for (std::size_t s = 0; s < net.surfaces.size(); ++s) {
    inputs.push_back(internal::zero_perturbation(net, links));
    if (internal::has_radius(net.surfaces[s])) inputs.back().radius[s] = 1;
  }
  return inputs;
}

/// Computes all derivatives, one linear solve per input.
/// @throws InputError if the net is not differentiable, see why_not_differentiable().
inline NetDerivatives net_derivatives(const Net& net, const Tree<double>& tree,
                                      const TreeState<double>& state, const NetDrive& drive,
                                      const NetEquilibrium& rest, int coordinates) {
  const std::string why = why_not_differentiable(net, rest);
  require(why.empty(), "net {}: no slopes, since {}", net.name, why);
  const internal::TangentNet tangent(net, state, drive, rest);
  // Compute the change of each band's tension at a fixed length by its EA, slack length and drive.
  const auto bands = static_cast<Eigen::Index>(net.bands.size());
  Eigen::VectorXd EA = Eigen::VectorXd::Zero(bands), slack = EA;
  std::vector<internal::NetPerturbation> drives(net.muscles.size(),
                                                internal::zero_perturbation(net, tree.size()));
  for (std::size_t b = 0; b < net.bands.size(); ++b) {
    const auto i = static_cast<Eigen::Index>(b);
    const int muscle = net.bands[b].muscle;
    const internal::BandState& band = tangent.band[b];
    const bool constant = tangent.scene.pull[b] >= 0;
    const double by_slack =
        constant ? 0 : -band.pull.stiffness * band.chord.length / tangent.scene.slack[b];
    const bool by_length =
        muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(muscle));
    EA(i) = constant ? 0 : band.pull.tension / net.bands[b].EA;
    slack(i) = by_length ? 0 : by_slack;
    if (muscle >= 0) drives[static_cast<std::size_t>(muscle)].tension(i) = by_length ? by_slack : 1;
  }
  // Build the inputs by joint coordinates.
  std::vector<internal::NetPerturbation> turns;
  for (int l = 0; l < coordinates; ++l)
    turns.push_back(internal::joint_perturbation(net, tree, state, l));
  const auto slopes = [&](const std::vector<internal::NetPerturbation>& inputs) {
    return jacobian_of(tangent, tree, state, inputs, coordinates);
  };
  return {slopes(turns),
          slopes(drives),
          slopes(band_inputs(tangent, tree.size(), EA)),
          slopes(band_inputs(tangent, tree.size(), slack)),
          slopes(place_inputs(net, tree.size())),
          slopes(radius_inputs(net, tree.size()))};
}

}  // namespace thenar
