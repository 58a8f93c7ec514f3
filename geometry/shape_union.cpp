#include "geometry/shape_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

class Placed final : public Shape {
 public:
  Placed(std::shared_ptr<const Shape> shape, const Pose<double>& X_BS)
      : shape_(std::move(shape)), R_BS_(X_BS.R), R_SB_(X_BS.R.transpose()), p_BS_(X_BS.p) {}
  [[nodiscard]] double distance(const Vector3d& p) const override {
    return shape_->distance(R_SB_ * (p - p_BS_));
  }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    NearestSurface found = shape_->nearest(R_SB_ * (p - p_BS_));
    found.normal = R_BS_ * found.normal;
    return found;
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    const Eigen::AlignedBox3d box = shape_->bounds();
    const Vector3d centre = R_BS_ * box.center() + p_BS_;
    const Vector3d half = R_BS_.cwiseAbs() * (box.sizes() / 2);
    return {centre - half, centre + half};
  }
  [[nodiscard]] double accuracy() const override { return shape_->accuracy(); }

 private:
  std::shared_ptr<const Shape> shape_;
  Eigen::Matrix3d R_BS_, R_SB_;
  Vector3d p_BS_;
};

class Union final : public Shape {
 public:
  explicit Union(std::vector<std::shared_ptr<const Shape>> parts) : parts_(std::move(parts)) {
    // Box and accuracy of the whole.
    for (const auto& part : parts_) {
      boxes_.push_back(part->bounds());
      whole_.extend(boxes_.back());
      accuracy_ = std::max(accuracy_, part->accuracy());
    }
  }
  [[nodiscard]] double distance(const Vector3d& p) const override { return find(p).distance; }
  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    NearestSurface found = parts_[find(p).part]->nearest(p);
    found.supports = false;  // but one of the parts
    return found;
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return whole_; }
  [[nodiscard]] double accuracy() const override { return accuracy_; }

 private:
  struct Least {
    double distance;  // [m]
    std::size_t part;
  };
  /// A part whose box is farther than the best so far is not asked.
  [[nodiscard]] Least find(const Vector3d& p) const {
    Least least{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double box = boxes_[i].squaredExteriorDistance(p);
      if (box > 0 && (least.distance <= 0 || box >= least.distance * least.distance)) continue;
      const double distance = parts_[i]->distance(p);
      if (distance < least.distance) least = {distance, i};
    }
    return least;
  }

  std::vector<std::shared_ptr<const Shape>> parts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  Eigen::AlignedBox3d whole_;
  double accuracy_ = 0;
};

}  // namespace

std::shared_ptr<const Shape> place(std::shared_ptr<const Shape> shape, const Pose<double>& X_BS) {
  if (X_BS.R.isIdentity(0) && X_BS.p.isZero(0)) return shape;
  return std::make_shared<Placed>(std::move(shape), X_BS);
}

std::shared_ptr<const Shape> join(std::vector<std::shared_ptr<const Shape>> parts) {
  if (parts.size() == 1) return parts.front();
  return std::make_shared<Union>(std::move(parts));
}

namespace {

constexpr std::size_t kMaxParts = 64;  // Most parts of a smooth union

/// Returns the most by which the blend reduces equal distances of `parts` shapes, over the blend
/// [1].
double largest_fillet(std::size_t parts) {
  double loss = 0;
  for (std::size_t i = 1; i < parts; ++i) loss += (1 - loss) * (1 - loss) / 4;
  return loss;
}

class SmoothUnion final : public Shape {
 public:
  SmoothUnion(std::vector<std::shared_ptr<const Shape>> parts, double blend)
      : parts_(std::move(parts)), blend_(blend) {
    // The fillet grows the box and limits the accuracy.
    fillet_ = blend * largest_fillet(parts_.size());
    double of_parts = 0;
    for (const auto& part : parts_) {
      boxes_.push_back(part->bounds());
      whole_.extend(boxes_.back());
      of_parts = std::max(of_parts, part->accuracy());
    }
    whole_ = {whole_.min().array() - fillet_, whole_.max().array() + fillet_};
    accuracy_ = fillet_ + of_parts;
  }

  [[nodiscard]] double distance(const Vector3d& p) const override {
    // Nearest part first; each overlap takes the blend's parabola off.
    const Near near = find_near(p);
    double value = near.parts[0].distance;
    for (std::size_t i = 1; i < near.count; ++i) {
      const double overlap = blend_ - (near.parts[i].distance - value);
      if (overlap <= 0) break;
      value -= overlap * overlap / (4 * blend_);
    }
    return value;
  }

  [[nodiscard]] NearestSurface nearest(const Vector3d& p) const override {
    // The same for the normal, by the blend's weights.
    const Near near = find_near(p);
    NearestSurface blended = parts_[near.parts[0].index]->nearest(p);
    blended.supports = false;  // but one of the parts
    for (std::size_t i = 1; i < near.count; ++i) {
      const double overlap = blend_ - (near.parts[i].distance - blended.distance);
      if (overlap <= 0) break;
      const double weight = overlap / (2 * blend_);
      blended.distance -= overlap * overlap / (4 * blend_);
      blended.normal += weight * (parts_[near.parts[i].index]->nearest(p).normal - blended.normal);
    }
    // Opposite normals may cancel out, on a ridge inside.
    const double norm = blended.normal.norm();
    blended.normal = norm > 1e-9 ? Vector3d(blended.normal / norm)
                                 : parts_[near.parts[0].index]->nearest(p).normal;
    return blended;
  }

  [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return whole_; }
  [[nodiscard]] double accuracy() const override { return accuracy_; }

 private:
  struct Part {
    double distance;  // [m]
    std::size_t index;
    bool operator<(const Part& other) const { return distance < other.distance; }
  };
  /// Parts that may count, the nearest first.
  struct Near {
    std::array<Part, kMaxParts> parts;
    std::size_t count = 0;
  };

  [[nodiscard]] Near find_near(const Vector3d& p) const {
    Near near;
    double least = std::numeric_limits<double>::infinity();
    // Parts within the blend of the nearest one, by their boxes first.
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double reach = std::max(least + blend_, 0.0);
      if (boxes_[i].squaredExteriorDistance(p) > reach * reach) continue;
      const double distance = parts_[i]->distance(p);
      if (distance > least + blend_) continue;
      least = std::min(least, distance);
      near.parts[near.count++] = {distance, i};
    }
    std::sort(near.parts.begin(), near.parts.begin() + near.count);
    return near;
  }

  std::vector<std::shared_ptr<const Shape>> parts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  Eigen::AlignedBox3d whole_;
  double blend_, fillet_, accuracy_ = 0;  // [m]
};

}  // namespace

std::shared_ptr<const Shape> build_smooth_union(std::vector<std::shared_ptr<const Shape>> parts,
                                                double blend) {
  require(!parts.empty() && parts.size() <= kMaxParts, "a smooth union takes 1 to {} parts, got {}",
          kMaxParts, parts.size());
  require(blend > 0 && std::isfinite(blend), "a blend must be positive and finite, got {} m",
          blend);
  return std::make_shared<SmoothUnion>(std::move(parts), blend);
}

}  // namespace thenar
