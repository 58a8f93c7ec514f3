#include "hand/skin/skin_mass.h"

#include <algorithm>

#include "hand/segment_mass.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A joint between two bodies: the plane through its centre, facing the outer one.
struct Border {
  const SoftBody* other;
  Vector3d center, outward;  // outward of the body that asks
};

/// Appends the border between two segments to both.
void add_border(const std::map<std::string, SoftBody>& bodies, const std::string& inner,
                const std::string& outer, const Vector3d& center, const Vector3d& outward,
                std::map<std::string, std::vector<Border>>& borders) {
  if (bodies.count(inner) == 0 || bodies.count(outer) == 0) return;
  borders[inner].push_back({&bodies.at(outer), center, outward});
  borders[outer].push_back({&bodies.at(inner), center, -outward});
}

std::map<std::string, std::vector<Border>> borders_of(
    const HandAnatomy& hand, const std::map<std::string, SoftBody>& bodies) {
  std::map<std::string, std::vector<Border>> borders;
  for (const DigitAnatomy& digit : hand.digits) {
    std::string inner = digit.root;
    Vector3d before = (digit.bones[0].distal - digit.bones[0].proximal).normalized();
    for (const DigitBone& bone : digit.bones) {
      const Vector3d along = (bone.distal - bone.proximal).normalized();
      add_border(bodies, inner, bone.segment, bone.proximal, (before + along).normalized(),
                 borders);
      inner = bone.segment;
      before = along;
    }
  }
  return borders;
}

/// Share of a cell that neighbours leave to a body [1].
double share_left(const std::vector<Border>& borders, const Vector3d& p, double step) {
  double share = 1;
  for (const Border& border : borders) {
    const double beyond = (p - border.center).dot(border.outward) / step;
    if (beyond > -0.5 && soft_height(*border.other, p) < 0) share *= std::max(0.5 - beyond, 0.0);
  }
  return share;
}

/// Sums over the cells of a grid.
LinkMass integrate(const SoftBody& body, const std::vector<Border>& borders) {
  const Eigen::AlignedBox3d box = soft_bounds(body);
  const double step = box.diagonal().norm() / 80;
  const Eigen::Vector3i cells = (box.sizes() / step).array().ceil().cast<int>();
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int i = 0; i < cells.x(); ++i)
    for (int j = 0; j < cells.y(); ++j)
      for (int k = 0; k < cells.z(); ++k) {
        const Vector3d p = box.min() + step * Vector3d(i + 0.5, j + 0.5, k + 0.5);
        double part = std::clamp(0.5 - soft_height(body, p) / step, 0.0, 1.0);
        if (part > 0) part *= share_left(borders, p, step);
        if (part == 0) continue;
        const Vector3d from = p - box.center();
        volume += part;
        first += part * from;
        second += part * (from * from.transpose() + step * step / 12 * Matrix3d::Identity());
      }
  if (volume == 0) return {};
  const Vector3d com = first / volume;
  second -= volume * com * com.transpose();
  const double cell = kHandDensity * step * step * step;
  return {cell * volume,
          box.center() + com,
          cell * (second.trace() * Matrix3d::Identity() - second),
          {}};
}

}  // namespace

std::map<std::string, LinkMass> skin_masses(const HandAnatomy& hand,
                                            const std::map<std::string, SoftBody>& bodies) {
  const auto borders = borders_of(hand, bodies);
  std::map<std::string, LinkMass> masses;
  for (const auto& [segment, body] : bodies) {
    const auto found = borders.find(segment);
    masses[segment] =
        integrate(body, found == borders.end() ? std::vector<Border>{} : found->second);
  }
  return masses;
}

Subject with_skin_masses(Subject subject) {
  const HandAnatomy hand = find_anatomy(subject);
  const auto masses = skin_masses(hand, skin_bodies(hand));
  for (Segment& segment : subject.segments) {
    const auto found = masses.find(segment.name);
    if (found == masses.end() || segment.mass > 0 || segment.radius > 0) continue;
    segment.mass = found->second.mass;
    segment.com = found->second.com;
    segment.inertia = found->second.inertia;
  }
  return subject;
}

}  // namespace thenar
