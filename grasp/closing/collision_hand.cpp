#include "grasp/closing/collision_hand.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "grasp/closing/closing_drives.h"

namespace thenar {
namespace {

constexpr double kAlongsideCosine = 0.7;  // Least cosine between the axes of links side by side [1]

MovedBy moved_by(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  const Eigen::VectorXd q = (layout.lower + layout.upper) / 2;
  const Eigen::Vector3d somewhere(0.1, 0.2, 0.3);  // off every likely axis [m]
  // A coordinate moves a surface if its Jacobian column is not zero.
  MovedBy moves(hand.surfaces().size(), q.size());
  for (Eigen::Index s = 0; s < moves.rows(); ++s) {
    const int link = hand.surfaces()[s].link;
    moves.row(s) = false;
    if (link >= 0) moves.row(s) = hand.jacobian(q, link, somewhere).colwise().norm().array() > 0;
  }
  return moves;
}

/// The nearest link towards the base, itself included, that has a surface; -1: the base.
int carrier(const Hand& hand, int link) {
  const auto carries = [&](int l) {
    return std::any_of(hand.surfaces().begin(), hand.surfaces().end(),
                       [l](const LinkSurface& s) { return s.link == l; });
  };
  while (link >= 0 && !carries(link)) link = hand.layout().parents[link];
  return link;
}

/// Returns whether b is a, or carries a at most `steps` surfaces farther out.
bool carries(const Hand& hand, int a, int b, int steps) {
  for (; a != b && a >= 0 && steps > 0; --steps) a = carrier(hand, hand.layout().parents[a]);
  return a == b;
}

/// Angular velocity of a link in closing, by coordinates that move it and not the other, with
/// drives at their speeds and joints in the middle of their ranges [rad/s] (3).
Eigen::Vector3d own_turn(const Hand& hand, const MovedBy& moves, int surface, int other) {
  const HandLayout& layout = hand.layout();
  const int link = hand.surfaces()[surface].link;
  if (link < 0) return Eigen::Vector3d::Zero();
  Eigen::VectorXd rates = ClosingDrives(layout).rates();
  for (Eigen::Index j = 0; j < rates.size(); ++j)
    if (moves(other, j)) rates[j] = 0;
  const Eigen::VectorXd q = (layout.lower + layout.upper) / 2;
  return hand.jacobian(q, link, Eigen::Vector3d::Zero()).topRows<3>() * rates;
}

/// Returns whether two links curl in the same direction.
bool curl_alongside(const Hand& hand, const MovedBy& moves, int a, int b) {
  const Eigen::Vector3d one = own_turn(hand, moves, a, b), other = own_turn(hand, moves, b, a);
  return one.dot(other) > kAlongsideCosine * one.norm() * other.norm();
}

/// The pair of two surfaces; nothing if they never meet.
std::optional<SurfacePair> pair_of(const Hand& hand, const MovedBy& moves,
                                   const Materials& materials, int a, int b) {
  const LinkSurface &first = hand.surfaces()[a], &second = hand.surfaces()[b];
  // Two soft links fold over each other across one more joint.
  const double layers[] = {soft_layer(first, materials), soft_layer(second, materials)};
  const int steps = layers[0] > 0 && layers[1] > 0 ? 2 : 1;
  if (carries(hand, first.link, second.link, steps) ||
      carries(hand, second.link, first.link, steps))
    return std::nullopt;
  // Soft pairs yield by both layers, and stick within the friction cone.
  SurfacePair pair{a, b, layers[0] + layers[1]};
  if (steps > 1) {
    if (curl_alongside(hand, moves, a, b)) return std::nullopt;
    const double mu = materials.between(first.material, second.material).static_coefficient;
    pair.sticking_cosine = 1 / std::sqrt(1 + mu * mu);
  }
  return pair;
}

}  // namespace

double soft_layer(const LinkSurface& surface, const Materials& materials) {
  for (const Material& material : materials.materials)
    if (material.name == surface.material) return material.layer_thickness;
  return 0;
}

CollisionHand collision_hand(const Hand& hand, const Materials& materials) {
  const std::vector<LinkSurface>& surfaces = hand.surfaces();
  require(!surfaces.empty(), "the hand has no surface that could touch");
  CollisionHand built{&hand, {}, moved_by(hand), {}};
  // A tree of triangles for each surface, and the pairs that may meet.
  for (const LinkSurface& surface : surfaces) built.trees.push_back(collision_tree(*surface.solid));
  for (int a = 0; a < static_cast<int>(surfaces.size()); ++a)
    for (int b = 0; b < a; ++b)
      if (const auto pair = pair_of(hand, built.moved_by, materials, a, b))
        built.self.push_back(*pair);
  return built;
}

}  // namespace thenar
