#include "base/dense.h"

namespace Eigen::internal {

THENAR_DENSE_KERNELS()

}  // namespace Eigen::internal
