#include "dynamics/compliant/surface_pairs.h"

#include <map>

#include "base/error.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/stepping/meeting_pairs.h"

namespace thenar {
namespace {

/// Planner of the surface pairs of one scene.
class PairPlanner {
 public:
  PairPlanner(const MovingScene& scene, const TreeModel& model)
      : scene_(scene), model_(model), motion_(model) {
    motion_.set_position(scene.q);
  }

  std::vector<SimbodyPair> plan() {
    std::vector<SimbodyPair> out;
    for (const auto& [a, b] : pairs_that_may_meet(scene_, model_)) {
      check_parts(a);
      check_parts(b);
      for (std::size_t i = 0; i < solid(a).parts.size(); ++i)
        for (std::size_t j = 0; j < solid(b).parts.size(); ++j)
          out.push_back(pair(surface(a, i), surface(b, j)));
    }
    return out;
  }

 private:
  [[nodiscard]] const MechanismBody& body(int i) const { return scene_.mechanism.bodies[i]; }
  [[nodiscard]] const Solid& solid(int i) const { return *body(i).solid; }
  [[nodiscard]] const ShapeSpec& spec(const SimbodySurface& of) const {
    return solid(of.body).parts[of.part].spec;
  }
  [[nodiscard]] std::string description(const SimbodySurface& of) const {
    return fmt::format("'{}' ({})", body(of.body).name, name_of(spec(of).kind));
  }

  void check_parts(int i) const {
    require(!solid(i).parts.empty(), "what '{}' is made of is not known: Simbody cannot touch it",
            body(i).name);
  }

  /// Returns the surface of a part in Simbody's terms; a box is a brick.
  [[nodiscard]] SimbodySurface surface(int i, std::size_t part) const {
    SimbodySurface out;
    out.body = i;
    out.part = part;
    const ShapeSpec& shape = spec(out);
    out.X_BS = shape.X_BS;
    out.size = shape.size;
    static const std::map<ShapeKind, SurfaceKind> kinds{
        {ShapeKind::kSphere, SurfaceKind::kBall},
        {ShapeKind::kEllipsoid, SurfaceKind::kEllipsoid},
        {ShapeKind::kBox, SurfaceKind::kBrick},
        {ShapeKind::kMesh, SurfaceKind::kMesh}};
    const auto found = kinds.find(shape.kind);
    require(found != kinds.end(),
            "Simbody has no contacts of {}: wanted spheres, ellipsoids, boxes or meshes",
            description(out));
    out.kind = found->second;
    if (shape.kind == ShapeKind::kBox) out.size *= 0.5;
    return out;
  }

  /// Returns the pair of two surfaces, with one box of a pair replaced by a half space.
  [[nodiscard]] SimbodyPair pair(SimbodySurface a, SimbodySurface b) const {
    const bool is_brick_a = a.kind == SurfaceKind::kBrick,
               is_brick_b = b.kind == SurfaceKind::kBrick;
    if (is_brick_a && (!is_brick_b || becomes_half_space(a, b))) {
      replace_by_half_space(a, b);
    } else if (is_brick_b) {
      replace_by_half_space(b, a);
    }
    // Refuse ellipsoids with meshes.
    const auto are = [&](SurfaceKind one, SurfaceKind other) {
      return (a.kind == one && b.kind == other) || (a.kind == other && b.kind == one);
    };
    require(!are(SurfaceKind::kEllipsoid, SurfaceKind::kMesh),
            "Simbody has no contact of {} with {}", description(a), description(b));
    return {a, b};
  }

  /// Returns true if the first of two boxes becomes the half space: a fixed box, else the box with
  /// the larger facing side.
  [[nodiscard]] bool becomes_half_space(const SimbodySurface& a, const SimbodySurface& b) const {
    const auto is_fixed = [&](const SimbodySurface& of) { return model_.bodies[of.body].link < 0; };
    if (is_fixed(a) != is_fixed(b)) return is_fixed(a);
    const auto face_area = [&](const SimbodySurface& box, const SimbodySurface& other) {
      const int k = facing_axis(box, other);
      return box.size[(k + 1) % 3] * box.size[(k + 2) % 3];  // a quarter of it
    };
    return face_area(a, b) >= face_area(b, a);
  }

  /// Returns the centre of the other part in the frame of a box at the start [m].
  [[nodiscard]] Eigen::Vector3d centre_seen_from(const SimbodySurface& box,
                                                 const SimbodySurface& other) const {
    Eigen::Vector3d centre = other.X_BS.p;
    if (other.kind == SurfaceKind::kMesh)
      centre = other.X_BS * solid(other.body).parts[other.part].shape->bounds().center();
    const Pose<double> X_WS = motion_.pose(box.body) * box.X_BS;
    return X_WS.inverse() * (motion_.pose(other.body) * centre);
  }

  /// Returns the axis of a box whose face is turned most towards the other part.
  [[nodiscard]] int facing_axis(const SimbodySurface& box, const SimbodySurface& other) const {
    const Eigen::Vector3d beyond = centre_seen_from(box, other).cwiseAbs() - box.size;
    int axis = 0;
    beyond.maxCoeff(&axis);
    return axis;
  }

  /// Replaces a box by the half space of its face towards the other part.
  void replace_by_half_space(SimbodySurface& box, const SimbodySurface& other) const {
    // Frame of the face, with z out of the box.
    const int k = facing_axis(box, other), x = (k + 1) % 3, y = (k + 2) % 3;
    const double sign = centre_seen_from(box, other)[k] < 0 ? -1 : 1;
    Pose<double> X_SF;
    X_SF.R.setZero();
    X_SF.R(x, 0) = 1;
    X_SF.R(y, 1) = sign;
    X_SF.R(k, 2) = sign;
    X_SF.p = sign * box.size[k] * Eigen::Vector3d::Unit(k);
    box.extent = {box.size[x], box.size[y]};
    box.X_BS = box.X_BS * X_SF;
    box.kind = SurfaceKind::kHalfSpace;
  }

  const MovingScene& scene_;
  const TreeModel& model_;
  TreeMotion<double> motion_;
};

}  // namespace

std::vector<SimbodyPair> plan_simbody_pairs(const MovingScene& scene, const TreeModel& model) {
  return PairPlanner(scene, model).plan();
}

std::vector<std::vector<int>> separating_cliques(std::size_t pairs) {
  std::vector<std::vector<int>> out(2 * pairs);
  for (std::size_t k = 0; k < pairs; ++k) {
    for (const std::size_t side : {0, 1}) {
      std::vector<int>& cliques = out[2 * k + side];
      cliques.push_back(static_cast<int>(side));
      for (std::size_t bit = 0; (std::size_t{1} << bit) < pairs; ++bit) {
        const std::size_t first_side = (k >> bit) & 1;  // side of the pair in clique 2 + 2 bit
        cliques.push_back(static_cast<int>(2 + 2 * bit + (first_side == side ? 0 : 1)));
      }
    }
  }
  return out;
}

}  // namespace thenar
