#include "tendons/wrapping/bead_string.h"

#include <algorithm>
#include <array>

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kBeads = 24;  // a surface
constexpr double kRelax = 1.7;

/// A bead, and the surface that it rests on.
struct Bead {
  Vector3d p;
  int on = -1;
};
using Beads = std::array<Bead, kBeads * kMostBends + 2>;

/// Even beads on the polygon from a over the start of every arc to b.
std::size_t lay(const Vector3d& a, const Vector3d& b, const std::vector<ChainArc>& chain,
                Beads& beads) {
  std::size_t count = 0;
  beads[count++] = {a};
  Vector3d from = a;
  const std::size_t legs = chain.size() + 1, each = kBeads * chain.size() / legs;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const Vector3d to = leg + 1 == legs ? b : Vector3d(chain[leg].X * chain[leg].arc.start.p);
    for (std::size_t i = 1; i <= each; ++i)
      beads[count++] = {from + static_cast<double>(i) / static_cast<double>(each) * (to - from)};
    from = to;
  }
  return count;
}

/// Out of the surface that the bead is in, if any.
void push_out(Bead& bead, const std::vector<ChainArc>& chain) {
  bead.on = -1;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainArc& link = chain[i];
    const Vector3d p = link.X.R.transpose() * (bead.p - link.X.p);
    if (level(*link.surface, p) >= 0) continue;
    bead.p = link.X * settle(*link.surface, {p, Vector3d::UnitX()}).p;
    bead.on = static_cast<int>(i);
  }
}

}  // namespace

void contract_beads(const Vector3d& a, const Vector3d& b, int sweeps,
                    std::vector<ChainArc>& chain) {
  Beads beads;
  const std::size_t count = lay(a, b, chain, beads);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const Vector3d middle = 0.5 * (beads[i - 1].p + beads[i + 1].p);
      // Plain at the end: over-relaxed beads hop on the surface.
      beads[i].p += (sweep < sweeps * 3 / 4 ? kRelax : 1.0) * (middle - beads[i].p);
      push_out(beads[i], chain);
    }
  std::size_t kept = 0;
  for (std::size_t s = 0; s < chain.size(); ++s) {
    std::size_t first = 0, last = 0;
    double length = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (beads[i].on != static_cast<int>(s)) continue;
      if (first == 0) first = i;
      last = i;
    }
    if (first == 0) continue;
    for (std::size_t i = first; i < last; ++i) length += (beads[i + 1].p - beads[i].p).norm();
    ChainArc link = chain[s];
    const Pose<double> to_S = link.X.inverse();
    link.arc = {settle(*link.surface,
                       {to_S * beads[first].p, to_S.R * (beads[first + 1].p - beads[first - 1].p)}),
                length};
    chain[kept++] = link;
  }
  chain.resize(kept);
}

}  // namespace thenar
