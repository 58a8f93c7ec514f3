#include <cmath>

#include "base/error.h"
#include "sampling/methods/metropolis.h"

namespace thenar::internal {
namespace {

constexpr std::uint32_t kStretchMoves = 0;
constexpr double kMaxStretch = 2;  // a, the maximum stretch [1] [Goodman2010]

/// Affine-invariant ensemble sampler. Each walker of one half moves along the line through a walker
/// of the other half,
///   x' = y + z (x - y),  density of z ~ 1 / sqrt(z) on 1/a .. a,
/// accepted by z^(n-1) p(x') / p(x). The halves alternate, so that half of the ensemble is
/// evaluated at once. There is no adaptation.
class StretchMove final : public Metropolis {
 public:
  StretchMove(const Eigen::MatrixXd& starts, const SamplerOptions& options)
      : Metropolis(starts, options) {
    require(chains() % 2 == 0 && chains() >= size() + 2,
            "an ensemble in {} dimensions needs an even number of walkers, at least {}, got {}",
            size(), size() + 2, chains());
  }

 private:
  [[nodiscard]] int rounds() const override { return 2; }

  Proposals propose(int round) override {
    const int half = chains() / 2;
    Proposals to{{}, Eigen::MatrixXd(size(), half), Eigen::VectorXd(half)};
    for (int i = 0; i < half; ++i) {
      const int k = round * half + i;
      RandomStream draw = random(k, kStretchMoves);
      const auto y = positions().col((1 - round) * half + draw.index(half));
      // Sample by inversion: the square root of z is uniform on sqrt(1/a) .. sqrt(a).
      const double root = (1 + (kMaxStretch - 1) * draw.uniform()) / std::sqrt(kMaxStretch);
      to.chain.push_back(k);
      to.x.col(i) = y + root * root * (positions().col(k) - y);
      to.log_proposal_ratio[i] = (size() - 1) * 2 * std::log(root);
    }
    return to;
  }
};

}  // namespace

std::unique_ptr<Sampler> stretch_move(const Eigen::MatrixXd& starts,
                                      const SamplerOptions& options) {
  return std::make_unique<StretchMove>(starts, options);
}

}  // namespace thenar::internal
