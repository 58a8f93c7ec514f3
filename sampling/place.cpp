#include "sampling/place.h"

namespace thenar::internal {

void put_place(const Place& place, std::vector<double>& to) {
  const auto put = [&](const auto& numbers) {
    to.insert(to.end(), numbers.data(), numbers.data() + numbers.size());
  };
  put(place.x);
  put(place.at.log_prior);
  put(place.at.log_likelihood);
  put(place.at.prior_gradient);
  put(place.at.likelihood_gradient);
}

Place take_place(const double*& from, Eigen::Index size, WithGradient gradient) {
  const auto take = [&](Eigen::Index count) {
    const Eigen::VectorXd numbers = Eigen::Map<const Eigen::VectorXd>(from, count);
    from += count;
    return numbers;
  };
  Place place;
  place.x = take(size);
  place.at.log_prior = take(1);
  place.at.log_likelihood = take(1);
  if (gradient == WithGradient::kNo) return place;
  place.at.prior_gradient = take(size);
  place.at.likelihood_gradient = take(size);
  return place;
}

}  // namespace thenar::internal
