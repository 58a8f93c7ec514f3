#include "grasp/closing/collision_hand.h"

#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/lists.h"
#include "grasp/closing/closing_drives.h"

namespace thenar {
namespace {

constexpr double kMinAlongsideCosine = 0.7;  // cosine between closing axes of adjacent links [1]

/// Returns which coordinates move each surface.
MovedBy moved_by(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  const Eigen::VectorXd q = (layout.lower + layout.upper) / 2;
  const Eigen::Vector3d probe(0.1, 0.2, 0.3);  // a point off all likely axes [m]
  // A coordinate moves a surface if its Jacobian column is not zero.
  MovedBy moves(hand.surfaces().size(), q.size());
  for (Eigen::Index s = 0; s < moves.rows(); ++s) {
    const int link = hand.surfaces()[s].link;
    moves.row(s) = false;
    if (link >= 0) moves.row(s) = hand.jacobian(q, link, probe).colwise().norm().array() > 0;
  }
  return moves;
}

/// Returns the nearest link towards the base, including itself, that has a surface; -1: the base.
int nearest_surface_link(const Hand& hand, int link) {
  const auto has_surface = [&](int l) {
    return any_of(hand.surfaces(), [l](const LinkSurface& s) { return s.link == l; });
  };
  while (link >= 0 && !has_surface(link)) link = hand.layout().parents[link];
  return link;
}

/// Returns whether b is a, or carries a over at most `steps` links with surfaces.
bool is_carried_by(const Hand& hand, int a, int b, int steps) {
  for (; a != b && a >= 0 && steps > 0; --steps)
    a = nearest_surface_link(hand, hand.layout().parents[a]);
  return a == b;
}

/// Computes the angular velocity of a link in closing by coordinates that do not move the other
/// one, with drives at their speeds and joints in the middle of their ranges [rad/s] (3).
Eigen::Vector3d relative_rotation(const Hand& hand, const MovedBy& moves, int surface, int other) {
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
  const Eigen::Vector3d one = relative_rotation(hand, moves, a, b),
                        other = relative_rotation(hand, moves, b, a);
  return one.dot(other) > kMinAlongsideCosine * one.norm() * other.norm();
}

/// Returns the pair of two surfaces; nothing if contact between them is ignored.
std::optional<SurfacePair> pair_of(const Hand& hand, const MovedBy& moves,
                                   const Materials& materials, int a, int b) {
  const LinkSurface &first = hand.surfaces()[a], &second = hand.surfaces()[b];
  // Neighbours are ignored; soft links also over one more joint, as flesh folds there.
  const double layers[] = {soft_layer_depth(first, materials), soft_layer_depth(second, materials)};
  const int steps = layers[0] > 0 && layers[1] > 0 ? 2 : 1;
  if (is_carried_by(hand, first.link, second.link, steps) ||
      is_carried_by(hand, second.link, first.link, steps))
    return std::nullopt;
  // Soft pairs stop each other when both layers are compressed, and stick within the friction cone.
  SurfacePair pair{a, b, layers[0] + layers[1]};
  if (steps > 1) {
    if (curl_alongside(hand, moves, a, b)) return std::nullopt;
    const double mu = materials.between(first.material, second.material).static_coefficient;
    pair.sticking_cosine = 1 / std::sqrt(1 + mu * mu);
  }
  return pair;
}

}  // namespace

double soft_layer_depth(const LinkSurface& surface, const Materials& materials) {
  const Material* material = find_named(materials.materials, surface.material);
  return material == nullptr ? 0 : material->layer_thickness;
}

CollisionHand collision_hand(const Hand& hand, const Materials& materials) {
  const std::vector<LinkSurface>& surfaces = hand.surfaces();
  require(!surfaces.empty(), "the hand has no surface that could touch");
  CollisionHand built{&hand, {}, moved_by(hand), {}};
  // Build a tree for each surface, and list the pairs that may stop each other.
  for (const LinkSurface& surface : surfaces) built.trees.push_back(collision_tree(*surface.solid));
  for (int a = 0; a < static_cast<int>(surfaces.size()); ++a)
    for (int b = 0; b < a; ++b)
      if (const auto pair = pair_of(hand, built.moved_by, materials, a, b))
        built.self_pairs.push_back(*pair);
  return built;
}

}  // namespace thenar
