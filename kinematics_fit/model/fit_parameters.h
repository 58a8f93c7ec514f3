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

/// Two hinges and the allowed distance between their axes.
struct AxisPair {
  int first = 0, second = 0;    // indices of the hinges
  double lower = 0, upper = 0;  // [m]
};

/// Prior scale that several parameters share: see PriorScale.
struct ScaledPriors {
  std::string name;
  double likeliest = 0;  // prior median of the factor [1]
  double spread = 0;     // prior sd of the logarithm of the factor; infinite: uniform [1]
  double largest = 0;    // upper bound of the factor [1]
  double factor = 1;     // current factor, included in the sds of its parameters [1]
};

/// Choice of free, fixed and tied parameters. A free parameter p has the value
///   mean_p + ratio_p u,   u = sd z_population + between_sd z_specimen,
/// with standard normal priors of z. Tied parameters share the u of their leader, whose bounds are
/// narrowed so that all parameters stay within their own bounds.
struct FitParameters {
  std::vector<Parameter> all;         // parameters in the order of list_parameters()
  std::vector<std::string> postures;  // names of postures with their own angle errors
  std::vector<int> coordinate;        // coordinate of each parameter; -1: fixed
  std::vector<double> ratio;          // ratio of each parameter to its coordinate [1]
  std::vector<int> leader;            // index of the parameter that leads each coordinate
  std::vector<ScaledPriors> scales;   // groups of parameters, see fit_with_scales()
  std::vector<int> scale;             // index in `scales` of each parameter; -1: none
  double misfit = 0;  // sd of the model error of each force component, independent in every trial,
                      // per newton of tension [1]
  double superposition = 0;  // sd of the additional model error of trials with several loads, per
                             // newton of tension [1]
  double linearity = 0;  // sd by which a muscle's force per newton of tension changes if its load
                         // is e times a fitted one [1]
  std::map<std::string, std::set<double>>
      fitted_tension;  // tensions of every muscle in the fitted trials in which it pulls [N]

  [[nodiscard]] int coordinates() const { return static_cast<int>(leader.size()); }
};

/// Applies the rules of a settings file, then frees all parameters that match `also_free`.
/// @throws InputError if a rule matches no parameter, ties to one that is not free, or frees the
/// length of a bone under a net, or hold/out_of_plane at mean zero, where forces are an even
/// function of it.
[[nodiscard]] FitParameters choose_parameters(const TendonDigit& digit,
                                              const std::vector<std::string>& postures,
                                              const FitSettings& settings,
                                              const std::vector<std::string>& also_free = {});

/// Returns the parameters with other factors on the prior sds of each scale [1] (scales).
[[nodiscard]] FitParameters with_scale_factors(FitParameters parameters,
                                               const std::vector<double>& factors);

/// Returns the parameters with the tensions of each muscle in the trials of these experiments in
/// which it pulls.
[[nodiscard]] FitParameters with_fitted_tensions(FitParameters parameters,
                                                 const std::vector<Experiment>& experiments);

/// Returns the sd of the model error of each force component under these tensions [N]: with T their
/// sum and b the fitted tension of a muscle that is nearest to its tension t by ratio,
///   sd^2 = (misfit T)^2 + (superposition T)^2 + sum over muscles of (linearity t ln(t / b))^2.
/// The second term applies if several muscles pull, the third to muscles that pull in a fitted
/// trial: nothing was learnt about the others that could be nonlinear.
/// @param tension  tendon tension of each muscle [N]
[[nodiscard]] double missed_force_sd(const FitParameters& parameters,
                                     const std::map<std::string, double>& tension);

/// Returns a warning about moment arms, and another about tendon points, if the digit has some
/// (arms of zero do not count) and none of them may move: errors of the tendons' geometry are then
/// absorbed by other parameters.
[[nodiscard]] std::vector<std::string> fixed_geometry_warnings(const FitParameters& parameters);

/// Returns the value of every parameter if only some move and all others are at their mean [SI]
/// (all).
/// @param moving  indices in `all`
/// @param values  values of the moving parameters [SI] (moving)
[[nodiscard]] std::vector<double> values_with(const FitParameters& parameters,
                                              const std::vector<int>& moving,
                                              const Eigen::Ref<const Eigen::VectorXd>& values);

/// Returns the value of every parameter for coordinates u  [SI] (all).
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
