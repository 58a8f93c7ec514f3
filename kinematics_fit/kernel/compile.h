#pragma once

/// Compilation of a digit, its parameters and an experiment to a Program.

#include "kinematics_fit/kernel/program.h"
#include "kinematics_fit/model/predict_forces.h"

namespace thenar::kernel {

/// Indices of the numbers of a SpecimenModel in one row of numbers. Every parameter changes these
/// numbers linearly.
struct Layout {
  explicit Layout(const TendonModel<double>& model, int posture_count);

  int hinges, coordinates, postures, muscles;
  std::vector<int> first_node;  // index of the first path node of each strand
  // Index of the first number of each kind.
  int directions, points, nodes, arms, frictions, shares, tip, tilt, angle_errors, posture_errors,
      out_of_plane, gains, unexplained, posture_unexplained, size;

  [[nodiscard]] int direction(int hinge) const { return directions + 3 * hinge; }
  [[nodiscard]] int point(int hinge) const { return points + 3 * hinge; }
  [[nodiscard]] int node(int strand, int k) const { return nodes + 3 * (first_node[strand] + k); }
  [[nodiscard]] int into(int share) const { return shares + 3 * share; }
  [[nodiscard]] int central(int share) const { return shares + 3 * share + 1; }
  [[nodiscard]] int slope(int share) const { return shares + 3 * share + 2; }
  [[nodiscard]] int posture_error(int posture) const {
    return posture_errors + coordinates * posture;
  }
  [[nodiscard]] int posture_force(int posture, int muscle) const {
    return posture_unexplained + 3 * (muscles * posture + muscle);
  }
};

/// Returns the numbers of a digit with all parameters at their means; axis directions are not
/// normalised, and hood fractions are shifts of their logits.
[[nodiscard]] std::vector<double> initial_parameters(const TendonDigit& digit,
                                                     const FitParameters& parameters,
                                                     const Layout& layout);

/// Returns the numbers that each coordinate changes, with their weights, by applying
/// set_parameter() to a digit of zeros.
[[nodiscard]] std::vector<LinearTerm> parameter_terms(const TendonDigit& digit,
                                                      const FitParameters& parameters,
                                                      const Layout& layout);

/// Fills a program; parameters without a coordinate become constants.
void compile(const TendonDigit& digit, const FitParameters& parameters, const ExperimentPlan& plan,
             Program& program);

}  // namespace thenar::kernel
