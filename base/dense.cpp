#include "base/dense.h"

namespace Eigen {

template class JacobiSVD<MatrixXd>;
template class ColPivHouseholderQR<MatrixXd>;
template class HouseholderQR<MatrixXd>;
template class CompleteOrthogonalDecomposition<MatrixXd>;
template class SelfAdjointEigenSolver<MatrixXd>;
template class SelfAdjointEigenSolver<Matrix3d>;
template class LLT<MatrixXd>;
template class LDLT<MatrixXd>;
template class PartialPivLU<MatrixXd>;
template class FullPivLU<MatrixXd>;

}  // namespace Eigen
