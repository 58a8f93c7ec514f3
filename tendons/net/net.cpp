#include "tendons/net/net.h"

#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

/// Returns whether a size is positive and finite.
bool is_valid_size(double size) { return size > 0 && std::isfinite(size); }

void check_surface(const BoneSurface& s) {
  require(s.link >= -1, "surface {}: no link {}", s.name, s.link);
  require(is_valid_size(s.size[0]), "surface {}: size must be > 0, got {}", s.name, s.size[0]);
  if (s.shape == SurfaceShape::kEllipsoid)
    require(is_valid_size(s.size[1]) && is_valid_size(s.size[2]),
            "surface {}: semi-axes must be > 0, got {} {}", s.name, s.size[1], s.size[2]);
  require(s.size.allFinite() && s.X.R.allFinite() && s.X.p.allFinite(),
          "surface {}: a number is not finite", s.name);
}

void check_node(const Net& net, const NetNode& node) {
  require(node.p.allFinite(), "node {}: its place is not finite", node.name);
  require(node.link >= -1, "node {}: no link {}", node.name, node.link);
  for (int s : node.surfaces)
    require(s >= 0 && s < static_cast<int>(net.surfaces.size()), "node {}: no surface {}",
            node.name, s);
}

void check_over(const Net& net, const NetBand& band) {
  if (band.over == -1) return;
  require(band.over >= 0 && band.over < static_cast<int>(net.surfaces.size()),
          "band {}: no surface {}", band.name, band.over);
  const BoneSurface& s = net.surfaces[band.over];
  require(s.shape == SurfaceShape::kSphere || s.shape == SurfaceShape::kCylinder,
          "band {}: {} is neither sphere nor cylinder", band.name, s.name);
  require(band.side.allFinite(), "band {}: its side is not finite", band.name);
  require(s.shape == SurfaceShape::kSphere || band.side.head<2>().norm() > 1e-9 * band.side.norm(),
          "band {}: its side points along the cylinder {}", band.name, s.name);
}

void check_law(const Net& net, const NetBand& band) {
  require(band.muscle >= -1 && band.muscle < static_cast<int>(net.muscles.size()),
          "band {}: no muscle {}", band.name, band.muscle);
  for (double number : {band.slack, band.EA, band.toe})
    require(number >= 0 && std::isfinite(number),
            "band {}: slack length, EA and toe must be finite and >= 0, got {}", band.name, number);
  require(band.muscle >= 0 || band.slack > 0, "band {}: needs a slack length", band.name);
  require(band.muscle >= 0 || band.EA > 0, "band {}: needs a stiffness", band.name);
}

void check_band(const Net& net, const NetBand& band) {
  const int nodes = static_cast<int>(net.nodes.size());
  require(band.a >= 0 && band.a < nodes, "band {}: no node {}", band.name, band.a);
  require(band.b >= 0 && band.b < nodes, "band {}: no node {}", band.name, band.b);
  require(band.a != band.b, "band {}: joins node {} to itself", band.name, net.nodes[band.a].name);
  check_over(net, band);
  check_law(net, band);
}

}  // namespace

void check_net(const Net& net) {
  for (const BoneSurface& surface : net.surfaces) check_surface(surface);
  for (const NetNode& node : net.nodes) check_node(net, node);
  for (const NetBand& band : net.bands) check_band(net, band);
  require(net.friction == 0,
          "net {}: nodes slide without friction here, got {}; solve_net_friction() has it",
          net.name, net.friction);
}

void check_drive(const Net& net, const NetDrive& drive) {
  const auto muscles = static_cast<Eigen::Index>(net.muscles.size());
  // Check sizes: one tension per muscle, and lengths and laws for all or for none.
  require(drive.tension.size() == muscles, "net {} has {} muscles, drive has {} tensions", net.name,
          muscles, drive.tension.size());
  require(drive.length.size() == muscles || drive.length.size() == 0,
          "net {} has {} muscles, drive has {} lengths", net.name, muscles, drive.length.size());
  const auto laws = static_cast<Eigen::Index>(drive.law.size());
  require(laws == muscles || laws == 0, "net {} has {} muscles, drive has {} laws", net.name,
          muscles, laws);
  // Check values; a length needs a band with stiffness.
  for (Eigen::Index m = 0; m < muscles; ++m) {
    const bool by_length = drive.length.size() > 0 && std::isfinite(drive.length(m));
    const double given = by_length ? drive.length(m) : drive.tension(m);
    require(by_length ? given > 0 : given >= 0 && std::isfinite(given),
            "muscle {}: cannot be given {}", net.muscles[m], given);
    for (const NetBand& band : net.bands)
      require(!by_length || band.muscle != m || band.EA > 0,
              "muscle {} is given a length, but its band {} has no stiffness", net.muscles[m],
              band.name);
  }
}

void check_state(const Net& net, const TreeState<double>& state) {
  const int links = static_cast<int>(state.size());
  for (const NetNode& node : net.nodes)
    require(node.link < links, "node {}: no link {} among {}", node.name, node.link, links);
  for (const BoneSurface& surface : net.surfaces)
    require(surface.link < links, "surface {}: no link {} among {}", surface.name, surface.link,
            links);
  for (int i = 0; i < links; ++i)
    require(state[i].X.R.allFinite() && state[i].X.p.allFinite(),
            "the pose of link {} is not finite", i);
}

void check_start(const Net& net, const Eigen::Matrix3Xd* start) {
  if (start == nullptr) return;
  require(start->cols() == static_cast<Eigen::Index>(net.nodes.size()),
          "net {} has {} nodes, start has {}", net.name, net.nodes.size(), start->cols());
  require(start->allFinite(), "net {}: start is not finite", net.name);
}

}  // namespace thenar
