#include "sampling/draws.h"

#include "base/error.h"

namespace thenar {

Eigen::MatrixXd Draws::coordinate(int i) const {
  require(i >= 0 && i < size(), "draws have {} coordinates, there is no number {}", size(), i);
  Eigen::MatrixXd of(draws(), chains());
  for (int chain = 0; chain < chains(); ++chain) {
    require(x[chain].rows() == size() && x[chain].cols() == draws(),
            "chain {} has {} x {} draws, the first {} x {}", chain, x[chain].rows(),
            x[chain].cols(), size(), draws());
    of.col(chain) = x[chain].row(i).transpose();
  }
  return of;
}

}  // namespace thenar
