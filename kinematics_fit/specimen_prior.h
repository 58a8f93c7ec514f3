#pragma once

/// Hierarchical prior of a fit: displacements of the population and of each specimen, as functions
/// of standard normal z.

#include <Eigen/Core>

#include "kinematics_fit/fit_coordinates.h"

namespace thenar {

/// Deviation of a specimen from the population in one coordinate, and its derivatives.
struct SpecimenDeviation {
  double u = 0;              // deviation [SI]
  double by_x = 0;           // du/dx [SI]
  double by_population = 0;  // du / d population, nonzero near bounds of the sum [1]
  double by_log_factor = 0;  // du / d log factor [SI]
};

/// Computes the deviation of a specimen.
/// @param population  the population's displacement, within the bounds of the sum [SI]
/// @param x           the specimen's entry of z [1]
/// @param factor      factor on deviation_sd [1]
[[nodiscard]] SpecimenDeviation specimen_deviation(const CoordinateEntries& coordinate,
                                                   double population, double x, double factor = 1);

/// Inverts specimen_deviation(): returns x with specimen_deviation(of, population, x, factor).u =
/// u.
[[nodiscard]] double deviation_entry(const CoordinateEntries& coordinate, double population,
                                     double u, double factor = 1);

/// Displacements of the coordinates of a specimen, or of the population, and their derivatives by
/// the two entries of z in FitCoordinates::entries().
struct CoordinateMotion {
  Eigen::VectorXd u;              // displacements [SI] (coordinates)
  Eigen::VectorXd by_population;  // du / dz[population], 0 without such an entry [SI] (coordinates)
  Eigen::VectorXd by_deviation;   // du / dz[deviation], 0 without such an entry [SI] (coordinates)
};

/// Computes displacements and derivatives.
/// @param z         point of the fit [1] (size)
/// @param specimen  index, or kPopulation
[[nodiscard]] CoordinateMotion coordinate_motion(const FitCoordinates& coordinates,
                                                 const Eigen::VectorXd& z, int specimen);

/// Computes the displacements u of the coordinates of a specimen or kPopulation [SI] (coordinates).
[[nodiscard]] Eigen::VectorXd displacements(const FitCoordinates& coordinates,
                                            const Eigen::VectorXd& z, int specimen);

/// Computes du/dz of a specimen or kPopulation at z, by the entries that move it [SI] (coordinates,
/// FitCoordinates::entries_of_specimen()).
[[nodiscard]] Eigen::MatrixXd displacement_jacobian(const FitCoordinates& coordinates,
                                                    const Eigen::VectorXd& z, int specimen);

/// Returns the variance of an unseen specimen's u about the population's displacements: the
/// variance between specimens, and the part of the population's variance that the data of a single
/// specimen cannot reduce [SI^2] (coordinates).
[[nodiscard]] Eigen::VectorXd unseen_variance(const FitCoordinates& coordinates);

}  // namespace thenar
