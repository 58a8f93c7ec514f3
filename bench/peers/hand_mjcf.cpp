#include "bench/peers/hand_mjcf.h"

#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar::bench {
namespace {

using Eigen::Vector3d;

std::string three(const Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

/// Text inside each body and in the list of tendons.
class Writer {
 public:
  Writer(const Tree<double>& tree, const PathSet& set)
      : tree_(tree), set_(set), inside_(tree.size() + 1) {
    for (std::size_t i = 0; i < set.surfaces.size(); ++i) add_surface(i);
    for (const WrappedPath& path : set.paths) add_path(path);
  }

  std::string text() {
    return fmt::format(
        "<mujoco><compiler angle=\"radian\"/><worldbody>{}</worldbody><tendon>{}</tendon></mujoco>",
        body(-1), tendons_);
  }

 private:
  std::string& inside(int link) { return inside_[static_cast<std::size_t>(link + 1)]; }

  void add_site(const std::string& name, int link, const Vector3d& p) {
    inside(link) += fmt::format("<site name=\"{}\" pos=\"{}\"/>", name, three(p));
  }

  void add_surface(std::size_t i) {
    const BoneSurface& surface = set_.surfaces[i];
    const bool ball = surface.shape == SurfaceShape::kSphere;
    require(ball || surface.shape == SurfaceShape::kCylinder,
            "MuJoCo wraps round spheres and cylinders only, not round '{}'", surface.name);
    const Eigen::Quaterniond turn(surface.X.R);
    inside(surface.link) += fmt::format(
        "<geom name=\"{}\" type=\"{}\" size=\"{}\" pos=\"{}\" quat=\"{:.17g} {:.17g} {:.17g} "
        "{:.17g}\" contype=\"0\" conaffinity=\"0\"/>",
        surface.name, ball ? "sphere" : "cylinder",
        ball ? fmt::format("{:.17g}", surface.size[0])
             : fmt::format("{:.17g} 0.01", surface.size[0]),
        three(surface.X.p), turn.w(), turn.x(), turn.y(), turn.z());
  }

  void add_path(const WrappedPath& path) {
    tendons_ += fmt::format("<spatial name=\"{}\">", path.name);
    for (std::size_t k = 0; k < path.points.size(); ++k) {
      const std::string point = fmt::format("{}_{}", path.name, k);
      add_site(point, path.points[k].link, path.points[k].p);
      tendons_ += fmt::format("<site site=\"{}\"/>", point);
      if (k + 1 == path.points.size() || path.bends[k].empty()) continue;
      require(path.bends[k].size() == 1, "MuJoCo wraps one surface between two points, '{}' has {}",
              path.name, path.bends[k].size());
      const PathWrap& bend = path.bends[k][0];
      const BoneSurface& surface = set_.surfaces[static_cast<std::size_t>(bend.surface)];
      add_site(point + "_side", surface.link, surface.X * bend.side_S);
      // Without a side site both go over a ball the shorter way.
      tendons_ +=
          surface.shape == SurfaceShape::kSphere
              ? fmt::format("<geom geom=\"{}\"/>", surface.name)
              : fmt::format("<geom geom=\"{}\" sidesite=\"{}_side\"/>", surface.name, point);
    }
    tendons_ += "</spatial>";
  }

  /// A link and all that hangs on it.
  std::string body(int link) {
    std::string text = inside(link);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (tree_[i].parent != link) continue;
      text += fmt::format(
          "<body name=\"link{0}\"><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>"
          "<joint name=\"hinge{0}\" type=\"hinge\" axis=\"{1}\" pos=\"{2}\"/>{3}</body>",
          i, three(tree_[i].direction), three(tree_[i].point), body(static_cast<int>(i)));
    }
    return text;
  }

  const Tree<double>& tree_;
  const PathSet& set_;
  std::vector<std::string> inside_;  // the base first
  std::string tendons_;
};

}  // namespace

std::string hand_mjcf(const Tree<double>& tree, const PathSet& set) {
  return Writer(tree, set).text();
}

}  // namespace thenar::bench
