#pragma once

/// Measured forces, a digit and its free parameters, as a least-squares problem.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "kinematics_fit/force_jacobian.h"

namespace thenar {

/// How a coordinate of a specimen follows from z:
///   u = p + deviation_sd d,   p = population_sd z[population],   d from z[deviation + specimen *
/// deviations] = x. Without bounds of the sum d = x; with them d = Z(x; l, h), the map of
/// BoundedNormal with l = (lower - p) / deviation_sd and h = (upper - p) / deviation_sd, so that
/// every specimen keeps the bounds of its parameter. An entry of -1 adds nothing.
struct CoordinateEntries {
  int population = -1;       // entry of z
  double population_sd = 0;  // [SI]
  int deviation = -1;        // entry of z for specimen 0
  double deviation_sd = 0;   // [SI]
  double lower =
      -std::numeric_limits<double>::infinity();            // of the sum u, where both entries exist
  double upper = std::numeric_limits<double>::infinity();  // [SI]
};

/// Coordinates of one specimen, or of the population, and their slopes; entries() says which
/// entries of z they hang on.
struct CoordinateMotion {
  Eigen::VectorXd u;              // [SI] (coordinates)
  Eigen::VectorXd by_population;  // du / dz[population], 0 without one [SI] (coordinates)
  Eigen::VectorXd by_deviation;   // du / dz[deviation], 0 without one [SI] (coordinates)
};

/// What a specimen adds to a coordinate of the population.
struct SpecimenDeviation {
  double u;              // [SI]
  double by_x;           // du/dx [SI]
  double by_population;  // du / d population, where bounds of the sum are near [1]
  double by_log_factor;  // du / d log factor [SI]
};

/// @param population  the population's displacement, within the bounds of the sum [SI]
/// @param x           the specimen's entry of z [1]
/// @param factor      on deviation_sd [1]
[[nodiscard]] SpecimenDeviation specimen_deviation(const CoordinateEntries& of, double population,
                                                   double x, double factor = 1);

/// x with specimen_deviation(of, population, x, factor).u = u.
[[nodiscard]] double deviation_entry(const CoordinateEntries& of, double population, double u,
                                     double factor = 1);

/// The problem  min 1/2 |r(z)|^2  over whitened coordinates z, all N(0, 1) beforehand.
///
/// z holds the population's coordinates, then each specimen's deviations from it. One specimen
/// alone cannot tell its deviation from the population's, so there z holds only their sum, whose
/// prior variances add; the most probable share of the population is sd^2 / (sd^2 + between^2).
/// Bounds of a parameter hold for the population and for every specimen: as bounds of z where one
/// entry alone moves a coordinate, and by the map of CoordinateEntries where two do. Tilts of axes
/// are bounded for the population alone.
/// Data residuals are (predicted - measured) / sd; with a robust scale c each trial's r is shrunk
/// so that |r|^2 becomes c^2 log(1 + |r|^2 / c^2) (Cauchy's loss).
class FitProblem {
 public:
  /// @param robust_scale    c, in noise sds; 0: plain squares [1]
  /// @param axis_distances  what constraints() asks of every specimen
  /// @throws InputError if an experiment does not fit the digit, a posture is singular, nothing is
  /// free, or an axis distance names a joint the digit has not.
  FitProblem(TendonDigit digit, FitParameters parameters, std::vector<Experiment> experiments,
             double robust_scale = 0, std::vector<AxisDistance> axis_distances = {});

  [[nodiscard]] int size() const { return static_cast<int>(lower_.size()); }
  [[nodiscard]] const Eigen::VectorXd& lower() const { return lower_; }  // of z (size)
  [[nodiscard]] const Eigen::VectorXd& upper() const { return upper_; }  // of z (size)
  [[nodiscard]] Residuals evaluate(const Eigen::VectorXd& z, WithJacobian want) const;
  [[nodiscard]] int data_rows() const;  // residuals that are data; the rest are priors

  /// Forces of experiment `e` [N] (3, trials); with kYes also their Jacobian by z.
  struct Prediction {
    Eigen::Matrix3Xd force;  // [N] (3, trials)
    Eigen::MatrixXd J;       // [N] (3 trials, size)
  };
  [[nodiscard]] Prediction predict(const Eigen::VectorXd& z, int e, WithJacobian want) const;

  /// Axis distances of every specimen in turn, scaled as axis_constraints() does; empty if none.
  [[nodiscard]] ConstraintValues constraints(const Eigen::VectorXd& z) const;
  [[nodiscard]] Eigen::VectorXd constraint_lower() const;  // (axis distances x specimens) [1]

  /// What to know of the experiments before trusting the fit; see experiment_warnings().
  [[nodiscard]] std::vector<std::string> warnings() const;

  /// Coordinates of a specimen (-1: the population) and their slopes.
  [[nodiscard]] CoordinateMotion motion(const Eigen::VectorXd& z, int specimen) const;

  /// Displacements u of the parameters of a specimen (-1: the population)  [SI] (coordinates).
  [[nodiscard]] Eigen::VectorXd displacements(const Eigen::VectorXd& z, int specimen) const;

  /// du/dz of a specimen (-1: the population) at z, (coordinates, size) [SI].
  [[nodiscard]] Eigen::MatrixXd displacement_jacobian(const Eigen::VectorXd& z, int specimen) const;

  /// Entries of z on which a specimen hangs (-1: the population): all other columns of its
  /// displacement_jacobian() are zero.
  [[nodiscard]] std::vector<int> entries_of_specimen(int specimen) const;

  /// Entries of z behind coordinate c, and how many entries the population and each specimen have.
  [[nodiscard]] const CoordinateEntries& entries(int c) const { return entries_.at(c); }
  [[nodiscard]] int population_entries() const { return population_size_; }
  [[nodiscard]] int deviations() const { return deviation_size_; }

  /// Data residuals of experiment `e` (3 trials); with kYes also their Jacobian by what they hang
  /// on alone: the population's entries of z, then the deviations of its specimen
  /// (3 trials, population_entries() + deviations()).
  [[nodiscard]] Residuals data_residuals(const Eigen::VectorXd& z, int e, WithJacobian want) const;

  /// Variance of an unseen specimen's u about displacements(z, -1) that no data can lessen, and
  /// of what one specimen alone cannot say of the population [SI^2] (coordinates).
  [[nodiscard]] Eigen::VectorXd unseen_variance() const;

  /// Name of every entry of z: the leading parameter, with "specimen: " before deviations.
  [[nodiscard]] std::vector<std::string> names() const;

  [[nodiscard]] const TendonDigit& digit() const { return digit_; }
  [[nodiscard]] const FitParameters& parameters() const { return parameters_; }
  [[nodiscard]] const std::vector<Experiment>& experiments() const { return experiments_; }
  [[nodiscard]] const std::vector<ExperimentPlan>& plans() const { return plans_; }
  [[nodiscard]] const std::vector<std::string>& specimens() const { return specimens_; }
  [[nodiscard]] int specimen_of(int e) const { return specimen_of_.at(e); }  // index there
  [[nodiscard]] double robust_scale() const { return robust_scale_; }
  [[nodiscard]] const std::vector<AxisDistance>& axis_distances() const { return axis_distances_; }

 private:
  void find_axes();
  void list_entries();
  void bound_coordinates();

  TendonDigit digit_;
  FitParameters parameters_;
  std::vector<Experiment> experiments_;
  std::vector<ExperimentPlan> plans_;
  std::vector<std::string> specimens_;
  std::vector<int> specimen_of_;            // of each experiment
  std::vector<CoordinateEntries> entries_;  // (coordinates)
  Eigen::VectorXd population_share_;        // of what moves a coordinate [1] (coordinates)
  int population_size_ = 0, deviation_size_ = 0;
  Eigen::VectorXd lower_, upper_;
  double robust_scale_;
  std::vector<AxisDistance> axis_distances_;
  std::vector<AxisPair> axis_pairs_;
};

/// The problem without the trials of one fold; empty experiments are dropped.
/// @param keep  keep(experiment, trial)
[[nodiscard]] FitProblem subset(const FitProblem& problem,
                                const std::function<bool(const Experiment&, const Trial&)>& keep);

/// The least-squares problem of a fit, for solve(); refers to `problem`, which must outlive it.
[[nodiscard]] LeastSquares least_squares(const FitProblem& problem);
LeastSquares least_squares(const FitProblem&& problem) = delete;

}  // namespace thenar
