#pragma once

/// Free, fixed and tied parameters of a digit, and the coordinates of a fit that move them.

#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "data/io/fit_settings.h"
#include "kinematics_fit/model/parameter.h"

namespace thenar {

/// Two hinges and the wanted distance between their axes.
struct AxisPair {
  int first, second;    // hinges
  double lower, upper;  // [m]
};

/// Prior scale that several parameters share: see PriorScale.
struct ScaledPriors {
  std::string name;
  double likeliest;   // factor beforehand [1]
  double spread;      // sd of the logarithm of the factor about it; infinite: all alike [1]
  double largest;     // bound of the factor [1]
  double factor = 1;  // in force, in the sds of its parameters [1]
};

/// A choice of free, fixed and tied parameters. A free parameter p has the value
///   mean_p + ratio_p u,   u = sd z_population + between_sd z_specimen,
/// with standard normal z beforehand. Tied parameters share the u of their leader, whose bounds are
/// narrowed so that all parameters stay within their own bounds.
struct FitParameters {
  std::vector<Parameter> all;         // in the order of list_parameters()
  std::vector<std::string> postures;  // whose angles may be in error one by one
  std::vector<int> coordinate;        // of each parameter; -1: fixed
  std::vector<double> ratio;          // of each parameter to its coordinate [1]
  std::vector<int> leader;            // parameter that owns each coordinate
  std::vector<ScaledPriors> scales;   // groups of parameters, see fit_with_scales()
  std::vector<int> scale;             // of each parameter, in `scales`; -1: none
  double misfit = 0;                  // sd of what the model misses of each component of a force,
                                      // in every trial anew, per newton of tension [1]
  double superposition = 0;           // the same of trials under several loads alone [1]
  double linearity = 0;               // sd by which the force of a muscle per newton of tension
                                      // changes where its load is e times a fitted one [1]
  std::map<std::string, std::set<double>> fitted_tension;  // of every muscle that pulls in a fitted
                                                           // trial [N]

  [[nodiscard]] int coordinates() const { return static_cast<int>(leader.size()); }
};

/// Applies the rules of a settings file, then frees everything that matches `also_free`.
/// @throws InputError if a rule matches no parameter, ties to one that is not free, or frees
/// hold/out_of_plane at mean zero, where forces are even in it, or the length of a bone under a
/// net.
[[nodiscard]] FitParameters choose_parameters(const TendonDigit& digit,
                                              const std::vector<std::string>& postures,
                                              const FitSettings& settings,
                                              const std::vector<std::string>& also_free = {});

/// Returns the parameters with other factors on the prior sds of each scale [1] (scales).
[[nodiscard]] FitParameters with_scale_factors(FitParameters parameters,
                                               const std::vector<double>& factors);

/// Returns the parameters with the tensions that each muscle has in trials of these experiments in
/// which it pulls.
[[nodiscard]] FitParameters with_fitted_tensions(FitParameters parameters,
                                                 const std::vector<Experiment>& experiments);

/// Sd of each component of a force by what the model misses under these tensions [N]: with T their
/// sum and b the fitted tension of a muscle that is nearest to its tension t by ratio,
///   sd^2 = (misfit T)^2 + (superposition T)^2 + sum over muscles of (linearity t ln(t / b))^2,
/// the second where several muscles pull, the third of muscles that pull in a fitted trial: of
/// others nothing was learnt that could be out of proportion.
/// @param tension  muscle -> tendon tension [N]
[[nodiscard]] double missed_force_sd(const FitParameters& parameters,
                                     const std::map<std::string, double>& tension);

/// A warning for moment arms, and another for points of tendons, where the digit has some (arms of
/// zero do not count) and none of them may move: what the tendons' geometry gets wrong then goes
/// into parameters that may.
[[nodiscard]] std::vector<std::string> fixed_geometry_warnings(const FitParameters& parameters);

/// Value of every parameter where only some move: those as given, all others at their mean [SI]
/// (all).
/// @param moving  indices in `all`
/// @param values  of them [SI] (moving)
[[nodiscard]] std::vector<double> values_with(const FitParameters& parameters,
                                              const std::vector<int>& moving,
                                              const Eigen::Ref<const Eigen::VectorXd>& values);

/// Value of every parameter for coordinates u  [SI] (all).
template <typename T, typename U>
[[nodiscard]] std::vector<T> parameter_values(const FitParameters& parameters, const U& u) {
  std::vector<T> values;
  values.reserve(parameters.all.size());
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    T value(parameters.all[p].mean);
    if (parameters.coordinate[p] >= 0)
      value += T(parameters.ratio[p]) * u[parameters.coordinate[p]];
    values.push_back(value);
  }
  return values;
}

}  // namespace thenar
