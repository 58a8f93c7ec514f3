#include "geometry/rounded_shape.h"

#include <cmath>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

class RoundedShape final : public Shape {
 public:
  RoundedShape(std::shared_ptr<const Shape> core, double radius)
      : core_(std::move(core)), radius_(radius) {}

  [[nodiscard]] double distance(const Eigen::Vector3d& p) const override {
    return core_->distance(p) - radius_;
  }
  [[nodiscard]] NearestSurface nearest(const Eigen::Vector3d& p) const override {
    // Move the plane through the core's nearest point out by the radius; it still supports.
    NearestSurface near = core_->nearest(p);
    near.distance -= radius_;
    return near;
  }
  [[nodiscard]] Eigen::AlignedBox3d bounds() const override {
    const Eigen::AlignedBox3d box = core_->bounds();
    const Eigen::Vector3d more = Eigen::Vector3d::Constant(radius_);
    return {box.min() - more, box.max() + more};
  }
  [[nodiscard]] double accuracy() const override { return core_->accuracy(); }

 private:
  std::shared_ptr<const Shape> core_;
  double radius_;
};

}  // namespace

std::shared_ptr<const Shape> build_rounded(std::shared_ptr<const Shape> core, double radius) {
  require(core != nullptr, "a rounded solid needs a core");
  require(radius >= 0 && std::isfinite(radius), "wanted a radius of at least 0 m, got {}", radius);
  return std::make_shared<RoundedShape>(std::move(core), radius);
}

}  // namespace thenar
