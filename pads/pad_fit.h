#pragma once

/// Constants of a pad from measured presses, with what the data leave open.

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

/// A measured number.
struct PressDatum {
  PressQuantity quantity = PressQuantity::kIndentation;
  int load = 0;             // of the course
  std::optional<int> over;  // the number is a part of the quantity at this load [1]
  double value = 0;         // in SI
  double sd = 0;            // of the measurement, or between subjects; in the same unit
  std::string source;       // citation keys
};

/// A press, and what was measured of it.
struct PressRecord {
  std::string name;
  PressCourse course;
  std::vector<PressDatum> data;
};

/// A constant that moves. Its prior, if any, is normal in its coordinate about the pad's own value.
struct FreeConstant {
  PadConstant constant;
  double lower_factor = 0.01, upper_factor = 100;  // bounds of exp(coordinate), over the pad's own
  std::optional<double> prior_factor = {};         // exp of the prior's sd, > 1 [1]
};

/// Problem of fit_pad(): a pad, its free constants and the records.
struct PadFitProblem {
  PadModel pad;  // where the search begins; its cells are those of the fit
  std::vector<FreeConstant> constants;
  std::vector<PressRecord> records;
};

struct PadFitOptions {
  double tolerance = 1e-6;  // of the search, relative to the cost [1]
  bool check_mesh = true;   // whether the estimate is pressed once more on finer cells
  Progress progress;
};

/// A constant, as the data and its prior leave it.
struct ConstantEstimate {
  double value = 0;         // in SI
  double sd = 0;            // of its coordinate: exp(sd) is a factor; infinite: not determined [1]
  double sd_by_data = 0;    // the same without priors; infinite: the data do not tell [1]
  bool determined = false;  // by the data alone, to a factor of kDetermined at two sds
  bool at_bound = false;
  double mesh_shift = 0;  // of the coordinate, if cells were finer; 0 without a check [1]
};

/// Largest factor by which two sds may change a constant that counts as determined [1].
inline constexpr double kDetermined = 3;

/// A datum and what the pad makes of it.
struct PressPrediction {
  double value = 0;             // in the datum's unit
  std::optional<double> finer;  // on finer cells
};

struct [[nodiscard]] PadFitResult {
  Solution solution;                        // of the search, in coordinates
  PadModel pad;                             // with the estimates
  std::vector<ConstantEstimate> estimates;  // as the problem's constants
  Eigen::MatrixXd correlations;  // of coordinates, priors included (constants, constants)
  std::vector<std::vector<PressPrediction>> predictions;  // (records, data)
  double misfit = 0;                  // sum of squares of (prediction - value) / sd [1]
  int degrees_of_freedom = 0;         // data less constants without a prior
  std::vector<std::string> warnings;  // constants that are not determined, bounds, misfits, meshes
};

/// Least squares of  (prediction - value) / sd  and  (z - z_0) / sd of priors, in coordinates z of
/// coordinate_of(). Slopes are differences to neighbours that press_curves() carries along. sds are
/// those of the inverse of J'J at the estimate: of a normal approximation, with the sds of the data
/// as they are stated. What neither data nor priors decide stays near where the search begins.
/// @throws InputError if there is nothing to fit or to fit it to, a datum or a constant makes no
/// sense, or the pad cannot be pressed where the search begins.
PadFitResult fit_pad(const PadFitProblem& problem, const PadFitOptions& options = {});

/// The press of each record on the pad. @throws InputError as fit_pad() does.
[[nodiscard]] std::vector<PressCurves> press_records(const PadModel& pad,
                                                     const std::vector<PressRecord>& records,
                                                     const Progress& progress = {});

/// Returns the prediction for a datum, in its unit.
/// @param points  of a pad under the loads of its record
[[nodiscard]] double predicted(const PressDatum& datum, const std::vector<PressPoint>& points);

}  // namespace thenar
