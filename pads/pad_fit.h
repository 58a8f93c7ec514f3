#pragma once

/// Fit of a pad's constants to measured presses, with the uncertainty that the data leave.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/progress.h"
#include "pads/pad_constants.h"
#include "pads/press_curve.h"
#include "solvers/least_squares.h"

namespace thenar {

enum class PressQuantity { kIndentation, kForce, kArea };  // [m], [N], [m^2]
inline constexpr std::array kPressQuantityNames{
    EnumName{PressQuantity::kIndentation, "indentation"}, EnumName{PressQuantity::kForce, "force"},
    EnumName{PressQuantity::kArea, "area"}};
[[nodiscard]] inline std::string name_of(PressQuantity quantity) {
  return name_in(kPressQuantityNames, quantity);
}

/// A measured value.
struct PressDatum {
  PressQuantity quantity = PressQuantity::kIndentation;
  int load = 0;             // index of the load in the course
  std::optional<int> over;  // load whose quantity divides this one: the value is a ratio [1]
  double value = 0;         // value [SI unit]
  double sd = 0;            // standard deviation of the measurement or between subjects [same unit]
  std::string source;       // citation keys
};

/// A press and its measurements.
struct PressRecord {
  std::string name;
  PressCourse course;
  std::vector<PressDatum> data;
};

/// A constant to fit. Its prior, if any, is normal in its coordinate about the pad's own value.
struct FreeConstant {
  PadConstant constant;
  // Bounds of exp(coordinate) over that of the pad's own value [1]
  double lower_factor = 0.01, upper_factor = 100;
  std::optional<double> prior_factor = {};  // exp of the prior's sd, > 1 [1]
};

/// Problem of fit_pad(): a pad, its free constants and the records.
struct PadFitProblem {
  PadModel pad;  // start of the search, with the cells of the fit
  std::vector<FreeConstant> constants;
  std::vector<PressRecord> records;
};

struct PadFitOptions {
  double tolerance = 1e-6;  // tolerance of the search relative to the cost [1]
  bool check_mesh = true;   // presses the estimate once more on finer cells
  Progress progress;
};

/// Estimate of a constant from the data and its prior.
struct ConstantEstimate {
  double value = 0;         // value [SI unit]
  double sd = 0;            // sd of the coordinate, a factor exp(sd); infinite: undetermined [1]
  double sd_by_data = 0;    // sd without priors; infinite: the data do not determine it [1]
  bool determined = false;  // the data alone determine it, to a factor of kDetermined at two sds
  bool at_bound = false;    // the estimate lies at a bound of the search
  double mesh_shift = 0;    // shift of the coordinate on finer cells; 0 without a check [1]
};

/// Largest factor exp(2 sd) of a constant that counts as determined [1].
inline constexpr double kDetermined = 3;

/// Prediction of the pad for a datum, in the datum's unit.
struct PressPrediction {
  double value = 0;             // prediction on the cells of the fit
  std::optional<double> finer;  // prediction on finer cells
};

struct [[nodiscard]] PadFitResult {
  Solution solution;                        // solution of the search, in coordinates
  PadModel pad;                             // pad with the estimates
  std::vector<ConstantEstimate> estimates;  // in the order of the problem's constants
  Eigen::MatrixXd correlations;  // correlations of coordinates with priors (constants, constants)
  std::vector<std::vector<PressPrediction>> predictions;  // (records, data)
  double misfit = 0;                  // sum of squares of (prediction - value) / sd [1]
  int degrees_of_freedom = 0;         // number of data less constants without a prior
  std::vector<std::string> warnings;  // undetermined constants, bounds, misfits, coarse meshes
};

/// Fits constants by least squares of  (prediction - value) / sd  and, for priors,  (z - z_0) / sd,
/// in coordinates z of coordinate_of(). Derivatives are differences to neighbours in
/// press_curves(). sds come from the inverse of J'J at the estimate: a normal approximation with
/// the stated sds of the data. Combinations that neither data nor priors determine stay near the
/// start of the search.
/// @throws InputError if there are no constants or no data, a datum or a constant makes no sense,
/// or the pad cannot be pressed at the start of the search.
PadFitResult fit_pad(const PadFitProblem& problem, const PadFitOptions& options = {});

/// Presses the pad by the course of each record. @throws InputError as fit_pad() does.
[[nodiscard]] std::vector<PressCurves> press_records(const PadModel& pad,
                                                     const std::vector<PressRecord>& records,
                                                     const Progress& progress = {});

/// Returns the prediction for a datum, in its unit.
/// @param points  results of the pad under the loads of the datum's record
[[nodiscard]] double predicted(const PressDatum& datum, const std::vector<PressPoint>& points);

}  // namespace thenar
