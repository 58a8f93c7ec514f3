#include "grasp/touching_hand.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {
namespace {

MovedBy moved_by(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  const Eigen::VectorXd q = (layout.lower + layout.upper) / 2;
  const Eigen::Vector3d somewhere(0.1, 0.2, 0.3);  // off every likely axis [m]
  MovedBy moves(hand.surfaces().size(), q.size());
  for (Eigen::Index s = 0; s < moves.rows(); ++s) {
    const int link = hand.surfaces()[s].link;
    moves.row(s) = false;
    if (link >= 0) moves.row(s) = hand.jacobian(q, link, somewhere).colwise().norm().array() > 0;
  }
  return moves;
}

/// The nearest link towards the base, itself included, that carries a surface; -1: the base.
int carrier(const Hand& hand, int link) {
  const auto carries = [&](int l) {
    return std::any_of(hand.surfaces().begin(), hand.surfaces().end(),
                       [l](const LinkSurface& s) { return s.link == l; });
  };
  while (link >= 0 && !carries(link)) link = hand.layout().parents[link];
  return link;
}

bool are_neighbours(const Hand& hand, int a, int b) {
  const auto below = [&](int link) {
    return link < 0 ? -2 : carrier(hand, hand.layout().parents[link]);
  };
  return a == b || below(a) == b || below(b) == a;
}

}  // namespace

TouchingHand touching_hand(const Hand& hand) {
  const std::vector<LinkSurface>& surfaces = hand.surfaces();
  require(!surfaces.empty(), "the hand has no surface that could touch");
  TouchingHand built{&hand, {}, moved_by(hand), {}};
  for (const LinkSurface& surface : surfaces) built.touch.push_back(touch_body(*surface.solid));
  for (int a = 0; a < static_cast<int>(surfaces.size()); ++a)
    for (int b = 0; b < a; ++b)
      if (!are_neighbours(hand, surfaces[a].link, surfaces[b].link)) built.self.push_back({a, b});
  return built;
}

}  // namespace thenar
