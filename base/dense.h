#pragma once

/// Dense decompositions and products that many files use, compiled once (dense.cpp and
/// dense_kernels.cpp) instead of in each of them.
///
/// Release builds read this before every file (cmake/prelude.cmake): a file that decomposes
/// matrices compiles in half the time. No result depends on it.

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

/// Instantiates the decompositions; with the word `extern`, declares that another file does.
#define THENAR_DENSE_DECOMPOSITIONS(EXTERN)                                                    \
  EXTERN template class JacobiSVD<MatrixXd>;                                                   \
  EXTERN template class ColPivHouseholderQR<MatrixXd>;                                         \
  EXTERN template class HouseholderQR<MatrixXd>;                                               \
  EXTERN template class CompleteOrthogonalDecomposition<MatrixXd>;                             \
  EXTERN template class SelfAdjointEigenSolver<MatrixXd>;                                      \
  EXTERN template class SelfAdjointEigenSolver<Matrix3d>;                                      \
  EXTERN template class LLT<MatrixXd>;                                                         \
  EXTERN template class LDLT<MatrixXd>;                                                        \
  EXTERN template class PartialPivLU<MatrixXd>;                                                \
  EXTERN template class FullPivLU<MatrixXd>;                                                   \
  EXTERN template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute( \
      const EigenBase<MatrixXd>&, int);                                                        \
  EXTERN template SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute( \
      const EigenBase<Matrix3d>&, int);                                                        \
  EXTERN template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);           \
  EXTERN template LDLT<MatrixXd>& LDLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);

/// Instantiates the kernels of products and triangular systems. They are internals of Eigen 3.4:
/// with another version the list is empty, and every file compiles its own.
#if EIGEN_VERSION_AT_LEAST(3, 4, 0) && !EIGEN_VERSION_AT_LEAST(3, 4, 90)
#define THENAR_DENSE_KERNELS(EXTERN)                                                               \
  EXTERN template struct gebp_kernel<double, double, Index, blas_data_mapper<double, Index, 0>,    \
                                     gebp_traits<double, double>::mr,                              \
                                     gebp_traits<double, double>::nr>;                             \
  EXTERN template struct general_matrix_matrix_product<Index, double, 0, 0, double, 0, 0, 0, 1>;   \
  EXTERN template struct general_matrix_matrix_product<Index, double, 0, 0, double, 1, 0, 0, 1>;   \
  EXTERN template struct general_matrix_matrix_product<Index, double, 1, 0, double, 0, 0, 0, 1>;   \
  EXTERN template struct general_matrix_matrix_product<Index, double, 1, 0, double, 1, 0, 0, 1>;   \
  EXTERN template struct general_matrix_vector_product<Index, double, MapperOf<0>, 0, false,       \
                                                       double, MapperOf<0>, false>;                \
  EXTERN template struct general_matrix_vector_product<Index, double, MapperOf<0>, 0, false,       \
                                                       double, MapperOf<1>, false>;                \
  EXTERN template struct general_matrix_vector_product<Index, double, MapperOf<1>, 1, false,       \
                                                       double, MapperOf<0>, false>;                \
  EXTERN template struct general_matrix_vector_product<Index, double, MapperOf<1>, 1, false,       \
                                                       double, MapperOf<1>, false, 1>;             \
  EXTERN template struct product_triangular_matrix_matrix<double, Index, Lower, true, 0, false, 0, \
                                                          false, 0, 1>;                            \
  EXTERN template struct product_triangular_matrix_matrix<double, Index, UnitLower, true, 0,       \
                                                          false, 0, false, 0, 1>;                  \
  EXTERN template struct product_triangular_matrix_matrix<double, Index, Upper, true, 1, false, 0, \
                                                          false, 0, 1>;                            \
  EXTERN template struct product_triangular_matrix_matrix<double, Index, UnitUpper, true, 1,       \
                                                          false, 0, false, 0, 1>;                  \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, Lower, false, 0, 0, 1>; \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, 0, 0, \
                                                 1>;                                               \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, 0, 0, 1>; \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, 1, 0, 1>; \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheLeft, UnitUpper, false, 1, 0, \
                                                 1>;                                               \
  EXTERN template struct triangular_solve_matrix<double, Index, OnTheRight, Upper, false, 1, 0,    \
                                                 1>;                                               \
  EXTERN template struct triangular_solve_vector<double, double, Index, OnTheLeft, Lower, false,   \
                                                 0>;                                               \
  EXTERN template struct triangular_solve_vector<double, double, Index, OnTheLeft, UnitLower,      \
                                                 false, 0>;                                        \
  EXTERN template struct triangular_solve_vector<double, double, Index, OnTheLeft, Upper, false,   \
                                                 0>;                                               \
  EXTERN template struct triangular_solve_vector<double, double, Index, OnTheLeft, Upper, false,   \
                                                 1>;                                               \
  EXTERN template struct triangular_solve_vector<double, double, Index, OnTheLeft, UnitUpper,      \
                                                 false, 1>;                                        \
  EXTERN template struct general_matrix_matrix_triangular_product<Index, double, 0, false, double, \
                                                                  1, false, 0, 1, Lower>;          \
  EXTERN template struct triangular_matrix_vector_product<Index, UnitUpper, double, false, double, \
                                                          false, 1>;                               \
  EXTERN template struct selfadjoint_matrix_vector_product<double, Index, 0, Lower, false, false>; \
  EXTERN template ComputationInfo computeFromTridiagonal_impl(VectorXd&, VectorXd&, const Index,   \
                                                              bool, MatrixXd&);                    \
  EXTERN template void tridiagonalization_inplace(MatrixXd&, VectorXd&);                           \
  EXTERN template void make_block_householder_triangular_factor(                                   \
      RowMatrix&, const Block<MatrixXd>&, const Block<const VectorXd, Dynamic, 1>&);               \
  EXTERN template void make_block_householder_triangular_factor(                                   \
      RowMatrix&, const Block<MatrixXd>&, const VectorBlock<const VectorXd>&);                     \
  EXTERN template void apply_block_householder_on_the_left(                                        \
      Block<MatrixXd>&, const Block<MatrixXd>&, const VectorBlock<const VectorXd>&, bool);

/// Instantiates sequences of Householder reflections.
#define THENAR_DENSE_REFLECTIONS(EXTERN)                                                       \
  EXTERN template void MatrixBase<Block<MatrixXd>>::applyHouseholderOnTheLeft(                 \
      const Block<const MatrixXd, Dynamic, 1>&, const double&, double*);                       \
  EXTERN template void MatrixBase<Block<MatrixXd>>::applyHouseholderOnTheRight(                \
      const Block<const MatrixXd, Dynamic, 1>&, const double&, double*);                       \
  EXTERN template void HouseholderSequence<MatrixXd, VectorXd, OnTheLeft>::evalTo(             \
      MatrixXd&, VectorXd&) const;                                                             \
  EXTERN template void HouseholderSequence<MatrixXd, VectorXd, OnTheLeft>::applyThisOnTheLeft( \
      MatrixXd&, VectorXd&, bool) const;                                                       \
  EXTERN template void HouseholderSequence<MatrixXd, VectorXd, OnTheLeft>::applyThisOnTheLeft( \
      VectorXd&, Matrix<double, 1, 1, RowMajor>&, bool) const;                                 \
  EXTERN template void MatrixBase<Block<VectorXd>>::applyHouseholderOnTheLeft(                 \
      const Block<const MatrixXd, Dynamic, 1>&, const double&, double*);

/// Instantiates solutions for right-hand sides that are stored vectors and matrices.
#define THENAR_DENSE_SOLUTIONS(EXTERN)                                                          \
  EXTERN template void LDLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&, VectorXd&) \
      const;                                                                                    \
  EXTERN template void LDLT<MatrixXd>::_solve_impl_transposed<true>(const MatrixXd&, MatrixXd&) \
      const;                                                                                    \
  EXTERN template void LLT<MatrixXd>::_solve_impl_transposed<true>(const VectorXd&, VectorXd&)  \
      const;                                                                                    \
  EXTERN template void LLT<MatrixXd>::_solve_impl_transposed<true>(const MatrixXd&, MatrixXd&)  \
      const;                                                                                    \
  EXTERN template void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const VectorXd&,  \
                                                                              VectorXd&) const; \
  EXTERN template void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const MatrixXd&,  \
                                                                              MatrixXd&) const; \
  EXTERN template void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&)   \
      const;                                                                                    \
  EXTERN template void SVDBase<JacobiSVD<MatrixXd>>::_solve_impl(const VectorXd&, VectorXd&)    \
      const;                                                                                    \
  EXTERN template void SVDBase<JacobiSVD<MatrixXd>>::_solve_impl(const VectorXd&, Vector3d&) const;
#else
#define THENAR_DENSE_KERNELS(EXTERN)
#define THENAR_DENSE_REFLECTIONS(EXTERN)
#define THENAR_DENSE_SOLUTIONS(EXTERN)
#endif

namespace Eigen {

THENAR_DENSE_DECOMPOSITIONS(extern)
THENAR_DENSE_SOLUTIONS(extern)
THENAR_DENSE_REFLECTIONS(extern)

namespace internal {

template <int Order>
using MapperOf = const_blas_data_mapper<double, Index, Order>;
using RowMatrix = Matrix<double, Dynamic, Dynamic, RowMajor>;

THENAR_DENSE_KERNELS(extern)

}  // namespace internal

}  // namespace Eigen
