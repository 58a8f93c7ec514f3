#include "grasp/robot/posed_surfaces.h"

#include "grasp/closing/fingertip_paths.h"

namespace thenar {

std::vector<std::size_t> palm_surfaces(const BallGrasp& grip) {
  const HandLayout& layout = grip.hand().layout();
  // Surfaces without a digit on the outermost link that has any.
  std::vector<std::size_t> palm;
  for (std::size_t s = 0; s < grip.surfaces().size(); ++s) {
    const SampledSurface& surface = grip.surfaces()[s];
    if (!surface.digit.empty()) continue;
    const int depth = joints_to(layout, surface.link);
    if (!palm.empty() && depth > joints_to(layout, grip.surfaces()[palm.front()].link))
      palm.clear();
    if (palm.empty() || surface.link == grip.surfaces()[palm.front()].link) palm.push_back(s);
  }
  return palm;
}

Eigen::Matrix3Xd points_of(const BallGrasp& grip, const std::vector<std::size_t>& surfaces,
                           const std::vector<Pose<double>>& links) {
  std::vector<Eigen::Matrix3Xd> parts;
  for (const std::size_t surface : surfaces) {
    const SampledSurface& points = grip.surfaces()[surface];
    const Pose<double> X = points.link < 0 ? Pose<double>{} : links[points.link];
    parts.emplace_back((X.R * points.p).colwise() + X.p);
  }
  return join_columns(parts);
}

Eigen::Matrix3Xd faces_of(const BallGrasp& grip, const std::vector<std::size_t>& surfaces,
                          const std::vector<Pose<double>>& links) {
  std::vector<Eigen::Matrix3Xd> faces;
  for (const std::size_t s : surfaces) {
    const SampledSurface& surface = grip.surfaces()[s];
    faces.push_back(surface.faces);
    if (surface.link >= 0) faces.back() = links[surface.link].R * surface.faces;
  }
  return join_columns(faces);
}

Eigen::AlignedBox3d box_of(const BallGrasp& grip, const std::vector<std::size_t>& surfaces,
                           const std::vector<Pose<double>>& links, const Eigen::Matrix3d& R) {
  Eigen::AlignedBox3d box;
  for (const std::size_t s : surfaces) {
    const SampledSurface& surface = grip.surfaces()[s];
    for (const auto& p : surface.p.colwise())
      box.extend(R.transpose() * moved_with(links, surface.link, p));
  }
  return box;
}

}  // namespace thenar
