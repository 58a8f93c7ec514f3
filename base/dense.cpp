#include "base/dense.h"

namespace Eigen {

THENAR_DENSE_DECOMPOSITIONS()
THENAR_DENSE_SOLUTIONS()
THENAR_DENSE_REFLECTIONS()

}  // namespace Eigen
