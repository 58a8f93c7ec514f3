#include "geometry/shape_union.h"

#include <algorithm>
#include <limits>
#include <utility>

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
    // Compute box and accuracy of the union.
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
  /// Skips parts whose box is farther than the best distance so far.
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

}  // namespace thenar
