#include "tendons/net/tangent_net.h"

#include <limits>

#include <Eigen/QR>

#include "base/error.h"
#include "tendons/net/world_surface.h"

namespace thenar::internal {

using Eigen::Index;
using Eigen::Matrix3d;

TangentNet::TangentNet(const Net& of, const TreeState<double>& state, const NetDrive& drive,
                       const NetEquilibrium& at)
    : net(of), rest(at), scene(pose_scene(of, state, drive)), drawn(of.bands.size(), -1) {
  number_nodes();
  let_go();
  probe_contacts();
  state_bands();
  free_directions();
  factor();
}

void TangentNet::number_nodes() {
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    row.push_back(net.nodes[i].free ? static_cast<int>(nodes.size()) : -1);
    if (!net.nodes[i].free) continue;
    nodes.emplace_back();
    nodes.back().node = static_cast<int>(i);
  }
  for (std::size_t d = 0; d < rest.drawn.size(); ++d) {
    const NetBand& pulled = net.bands[static_cast<std::size_t>(rest.drawn[d].band)];
    require(row[pulled.a] < 0 || row[pulled.b] < 0,
            "net {}: {} has drawn two floating nodes together: no derivative", net.name,
            pulled.name);
    drawn[static_cast<std::size_t>(rest.drawn[d].band)] = static_cast<int>(d);
    TangentNode& node = nodes[static_cast<std::size_t>(std::max(row[pulled.a], row[pulled.b]))];
    node.exit = row[pulled.a] >= 0 ? pulled.b : pulled.a;
    ++node.drawn;
  }
}

/// Bands of constant pull that have drawn nothing in pull as they are, however short: the spring
/// that the search for rest puts in their place is none of the net's.
void TangentNet::let_go() {
  for (std::size_t b = 0; b < drawn.size(); ++b)
    if (drawn[b] < 0) scene.grip[b] = std::numeric_limits<double>::infinity();
}

void TangentNet::probe_contacts() {
  for (std::size_t c = 0; c < rest.contacts.size(); ++c) {
    const NetContact& contact = rest.contacts[c];
    probe.push_back(probe_world(net, scene, contact.surface, x(contact.node)));
    nodes[static_cast<std::size_t>(row[contact.node])].contact.push_back(static_cast<int>(c));
  }
}

void TangentNet::state_bands() {
  band.reserve(net.bands.size());
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    band.push_back(
        band_state(net, scene, static_cast<int>(b), x(net.bands[b].a), x(net.bands[b].b)));
}

void TangentNet::free_directions() {
  std::vector<bool> held(net.nodes.size(), false);
  for (std::size_t b = 0; b < band.size(); ++b)
    if (drawn[b] < 0 && (band[b].pull.stiffness != 0 || band[b].pull.tension != 0))
      held[net.bands[b].a] = held[net.bands[b].b] = true;
  Index column = 0;
  for (TangentNode& node : nodes) {
    node.column = column;
    node.free = Matrix3d::Identity();
    if (!node.contact.empty()) {
      Columns3 N(3, static_cast<Index>(node.contact.size()));
      for (Index i = 0; i < N.cols(); ++i) N.col(i) = probe[node.contact[i]].normal;
      const Eigen::CompleteOrthogonalDecomposition<Columns3> split(N);
      const Matrix3d Q = split.householderQ() * Matrix3d::Identity();
      node.free = Q.rightCols(3 - split.rank());
      node.bear = split.pseudoInverse();
    }
    if (node.exit >= 0 || !held[static_cast<std::size_t>(node.node)]) node.free.resize(3, 0);
    column += node.free.cols();
  }
}

void TangentNet::factor() {
  const Index size = nodes.empty() ? 0 : nodes.back().column + nodes.back().free.cols();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  const auto add = [&](int i, int j, const Matrix3d& K) {
    if (i < 0 || j < 0) return;
    const TangentNode &a = nodes[static_cast<std::size_t>(i)],
                      &b = nodes[static_cast<std::size_t>(j)];
    H.block(a.column, b.column, a.free.cols(), b.free.cols()) +=
        a.free.transpose().lazyProduct((K * b.free).eval());
  };
  for (std::size_t b = 0; b < band.size(); ++b) {
    if (drawn[b] >= 0) continue;
    const int ends[] = {row[net.bands[b].a], row[net.bands[b].b]};
    const Chord& chord = band[b].chord;
    for (int i : {0, 1})
      for (int j : {0, 1})
        add(ends[i], ends[j],
            band[b].pull.stiffness * chord.slope.segment<3>(3 * i) *
                    chord.slope.segment<3>(3 * j).transpose() +
                band[b].pull.tension * chord.curve.block<3, 3>(3 * i, 3 * j));
  }
  for (std::size_t c = 0; c < probe.size(); ++c) {
    const int k = row[rest.contacts[c].node];
    add(k, k, -rest.contacts[c].force * probe[c].curvature);
  }
  stiffness.compute(H);
}

}  // namespace thenar::internal
