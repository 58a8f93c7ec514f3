#include "tests/hand/fast_kinematics.h"

#include <cmath>

#include "base/error.h"
#include "base/simd.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // inlined functions have no calling convention

namespace thenar {
namespace {

using internal::Double4;
using internal::Double4Sse;
using internal::load;
using internal::store;
using Column = std::array<double, 4>;

/// x, y and z of the base, and its origin.
alignas(32) constexpr std::array<Column, 4> kUnit{
    {{{1, 0, 0, 0}}, {{0, 1, 0, 0}}, {{0, 0, 1, 0}}, {{0, 0, 0, 0}}}};

Column column(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z(), 0}; }

/// R v, with R given by columns and v read number by number.
template <typename V>
THENAR_INLINE V times(const V& x, const V& y, const V& z, const double* v) {
  return x * v[0] + y * v[1] + z * v[2];
}

}  // namespace

/// Sine and cosine of every hinge, padded to whole groups of four.
struct FastKinematics::Angles {
  alignas(32) std::array<double, kMaxFastHinges> angle, sine, cosine;
};

FastKinematics::FastKinematics(const Skeleton& skeleton, InstructionSet simd)
    : coordinates_(skeleton.coordinates()),
      avx2_(simd != InstructionSet::kBaseline && __builtin_cpu_supports("avx2")) {
  require(skeleton.tree.size() <= kMaxFastHinges, "at most {} hinges here, the skeleton has {}",
          kMaxFastHinges, skeleton.tree.size());
  require(skeleton.tips.size() <= kMaxFastTips, "at most {} tips here, the skeleton has {}",
          kMaxFastTips, skeleton.tips.size());
  require(simd != InstructionSet::kAvx2 || avx2_, "this processor has no AVX2");
  for (const Hinge<double>& hinge : skeleton.tree) {
    turns_.push_back({column(hinge.direction), column(hinge.point), hinge.parent});
    drives_.push_back({hinge.coordinate, hinge.ratio, hinge.offset});
  }
  for (const SkeletonTip& tip : skeleton.tips) {
    const int first = static_cast<int>(movers_.size());
    for_each_hinge_to_base(skeleton.tree, tip.link, [&](int i) {
      movers_.push_back({i, skeleton.tree[i].coordinate, skeleton.tree[i].ratio});
    });
    tips_.push_back({column(tip.p), tip.link, first, static_cast<int>(movers_.size())});
  }
}

/// Everything, in the instructions of whoever this is inlined into.
template <typename V>
THENAR_INLINE void FastKinematics::run(Angles& a, FastHandPose& hand) const {
  const std::size_t hinges = turns_.size();
  for (std::size_t i = 0; i < hinges; i += 4) {
    const auto sc = internal::sin_cos(load<Double4>(&a.angle[i]));
    store(&a.sine[i], sc.sine);
    store(&a.cosine[i], sc.cosine);
  }

  // Link by link:  R = R_parent (cos I + (1 - cos) d d' + sin [d]);  the axis stays where it is.
  alignas(32) std::array<Column, kMaxFastHinges> axis, point;
  const V kX = load<V>(kUnit[0].data()), kY = load<V>(kUnit[1].data()),
          kZ = load<V>(kUnit[2].data()), kOrigin = load<V>(kUnit[3].data());
  for (std::size_t i = 0; i < hinges; ++i) {
    const Turn& turn = turns_[i];
    V x = kX, y = kY, z = kZ, p = kOrigin;
    if (turn.parent >= 0) {
      const auto& X = hand.X_[turn.parent];
      x = load<V>(X[0].data()), y = load<V>(X[1].data()), z = load<V>(X[2].data()),
      p = load<V>(X[3].data());
    }
    const double* d = turn.direction.data();
    const V along = times(x, y, z, d), here = times(x, y, z, turn.point.data()) + p;
    store(axis[i].data(), along);
    store(point[i].data(), here);

    const double s = a.sine[i], c = a.cosine[i];
    const V u = (1 - c) * along;
    const V Rx = c * x + u * d[0] + s * (y * d[2] - z * d[1]);
    const V Ry = c * y + u * d[1] + s * (z * d[0] - x * d[2]);
    const V Rz = c * z + u * d[2] + s * (x * d[1] - y * d[0]);
    auto& X = hand.X_[i];
    store(X[0].data(), Rx), store(X[1].data(), Ry), store(X[2].data(), Rz);
    store(X[3].data(), here - times(Rx, Ry, Rz, turn.point.data()));
  }

  // Tip by tip: a column  ratio * axis x (p - point)  for every hinge that moves it.
  for (std::size_t k = 0; k < tips_.size(); ++k) {
    const Tip& tip = tips_[k];
    V p = load<V>(tip.p.data());
    if (tip.link >= 0) {
      const auto& X = hand.X_[tip.link];
      p = times(load<V>(X[0].data()), load<V>(X[1].data()), load<V>(X[2].data()), tip.p.data()) +
          load<V>(X[3].data());
    }
    store(hand.tip_[k].data(), p);
    auto& J = hand.J_[k];
    for (int c = 0; c < coordinates_; ++c) store(J[c].data(), kOrigin);
    for (int m = tip.first; m < tip.last; ++m) {
      const Mover& mover = movers_[m];
      double* column = J[mover.coordinate].data();
      const V arm = p - load<V>(point[mover.hinge].data());
      store(column, load<V>(column) +
                        mover.ratio * internal::cross(load<V>(axis[mover.hinge].data()), arm));
    }
  }
}

void FastKinematics::run_baseline(Angles& angles, FastHandPose& hand) const {
  run<Double4Sse>(angles, hand);
}

__attribute__((target("avx2"))) void FastKinematics::run_avx2(Angles& angles,
                                                              FastHandPose& hand) const {
  run<Double4>(angles, hand);
}

FastHandPose FastKinematics::pose(const Eigen::Ref<const Eigen::VectorXd>& q) const {
  require(q.size() == coordinates_, "the skeleton has {} coordinates, q has {}", coordinates_,
          q.size());
  Angles angles;
  std::size_t i = 0;
  for (; i < drives_.size(); ++i) {
    const double angle = drives_[i].ratio * q[drives_[i].coordinate] + drives_[i].offset;
    // Whole turns taken off a huge angle; NaN stays.
    angles.angle[i] = std::abs(angle) < internal::kSinCosBound
                          ? angle
                          : std::atan2(std::sin(angle), std::cos(angle));
  }
  for (; i % 4 != 0; ++i) angles.angle[i] = 0;

  FastHandPose hand;
  hand.coordinates_ = coordinates_;
  if (avx2_)
    run_avx2(angles, hand);
  else
    run_baseline(angles, hand);
  return hand;
}

}  // namespace thenar
