#include "geometry/smooth_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostParts = 64;

/// What equal distances of `parts` shapes lose in the blend, per blend.
double largest_fillet(std::size_t parts) {
  double loss = 0;
  for (std::size_t i = 1; i < parts; ++i) loss += (1 - loss) * (1 - loss) / 4;
  return loss;
}

class SmoothUnion final : public Shape {
 public:
  SmoothUnion(std::vector<std::shared_ptr<const Shape>> parts, double blend)
      : parts_(std::move(parts)), blend_(blend) {
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

  double distance(const Vector3d& p) const override {
    const Near near = find_near(p);
    double value = near.parts[0].distance;
    for (std::size_t i = 1; i < near.count; ++i) {
      const double overlap = blend_ - (near.parts[i].distance - value);
      if (overlap <= 0) break;
      value -= overlap * overlap / (4 * blend_);
    }
    return value;
  }

  NearestSurface nearest(const Vector3d& p) const override {
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

  Eigen::AlignedBox3d bounds() const override { return whole_; }
  double accuracy() const override { return accuracy_; }

 private:
  struct Part {
    double distance;  // [m]
    std::size_t index;
    bool operator<(const Part& other) const { return distance < other.distance; }
  };
  /// Parts that may count, the nearest first.
  struct Near {
    std::array<Part, kMostParts> parts;
    std::size_t count = 0;
  };

  Near find_near(const Vector3d& p) const {
    Near near;
    double least = std::numeric_limits<double>::infinity();
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
  require(!parts.empty() && parts.size() <= kMostParts,
          "a smooth union takes 1 to {} parts, got {}", kMostParts, parts.size());
  require(blend > 0 && std::isfinite(blend), "a blend must be positive and finite, got {} m",
          blend);
  return std::make_shared<SmoothUnion>(std::move(parts), blend);
}

}  // namespace thenar
