#pragma once

/// Step 3b: arms of muscles through the hood [m], and torques of all trials of a posture [N m].

#include "kinematics_fit/kernel/arms.h"

namespace thenar::kernel {
namespace {

/// Shifts a fraction c by u on the logit scale. The derivative of the result f by u is f (1 - f).
inline V shifted(double c, const V& u) {
  const V odds = c * exponential(u);
  return odds / ((1.0 - c) + odds);
}

/// Arms, at one coordinate, of the strands to which the hood distributes a share: the central slip,
/// and the lateral bands with the terminal slip.
struct HoodStrandArms {
  V central, lateral;
};

/// Returns the arms of the strands of a share at coordinate j.
inline HoodStrandArms hood_strand_arms(const Program& program, const ShareStep& share, const V* arm,
                                       int j) {
  const int n = program.coordinates;
  const HoodSteps& hood = program.hood;
  return {arm[hood.central_slip * n + j], share.radial * arm[hood.radial_band * n + j] +
                                              (1 - share.radial) * arm[hood.ulnar_band * n + j] +
                                              arm[hood.terminal_slip * n + j]};
}

/// Computes row = arms of the pulled strand + h (c central + (1 - c) lateral).
inline void set_rows(const Program& program, const DigitParameters& digit, PosedDigit& posed) {
  const int n = program.coordinates;
  for (int m = 0; m < program.pulls_strand.size(); ++m)
    for (int j = 0; j < n; ++j) posed.row[m * n + j] = posed.arm[program.pulls_strand[m] * n + j];
  const V bent = angle_at(program.knuckle, posed) - program.hood_angle;
  for (int b = 0; b < program.shares.size(); ++b) {
    // Compute the fractions in this posture: parameters and flexion of the knuckle shift their
    // logits.
    const ShareStep& share = program.shares[b];
    posed.into[b] = shifted(share.into, digit.number[share.into_shift]);
    posed.central[b] = shifted(
        share.central, digit.number[share.central_shift] + digit.number[share.slope] * bent);
    // Add the arms through the hood, weighted by the fractions.
    for (int j = 0; j < n; ++j) {
      const HoodStrandArms strands = hood_strand_arms(program, share, posed.arm, j);
      posed.row[share.muscle * n + j] +=
          posed.into[b] *
          (posed.central[b] * strands.central + (1.0 - posed.central[b]) * strands.lateral);
    }
  }
}

/// Adjoint of set_rows().
inline void adjoint_rows(const Program& program, const DigitParameters& digit,
                         const PosedDigit& posed, PosedDigit& adjoint,
                         DigitParameters& adjoint_digit) {
  // Add the strands that the muscles pull.
  const int n = program.coordinates;
  for (int m = 0; m < program.pulls_strand.size(); ++m)
    for (int j = 0; j < n; ++j)
      adjoint.arm[program.pulls_strand[m] * n + j] += adjoint.row[m * n + j];
  const V bent = angle_at(program.knuckle, posed) - program.hood_angle;
  const HoodSteps& hood = program.hood;
  for (int b = 0; b < program.shares.size(); ++b) {
    const ShareStep& share = program.shares[b];
    // Add adjoints of the hood's strands, and compute the sums that give the adjoints of both
    // fractions.
    const V h = posed.into[b], c = posed.central[b];
    V by_central = V{}, by_lateral = V{};
    for (int j = 0; j < n; ++j) {
      const V push = adjoint.row[share.muscle * n + j];
      const HoodStrandArms strands = hood_strand_arms(program, share, posed.arm, j);
      by_central += push * strands.central;
      by_lateral += push * strands.lateral;
      const V central = h * c * push, lateral = h * (1.0 - c) * push;
      adjoint.arm[hood.central_slip * n + j] += central;
      adjoint.arm[hood.radial_band * n + j] += share.radial * lateral;
      adjoint.arm[hood.ulnar_band * n + j] += (1 - share.radial) * lateral;
      adjoint.arm[hood.terminal_slip * n + j] += lateral;
    }
    // Pass adjoints from the fractions to their logits, and to shifts, slope and knuckle.
    const V h_bar = c * by_central + (1.0 - c) * by_lateral;
    const V c_bar = h * (by_central - by_lateral);
    adjoint_digit.number[share.into_shift] += h_bar * h * (1.0 - h);
    const V logit_bar = c_bar * c * (1.0 - c);
    adjoint_digit.number[share.central_shift] += logit_bar;
    adjoint_digit.number[share.slope] += logit_bar * bent;
    if (program.knuckle.coordinate >= 0)
      adjoint.angle[program.knuckle.coordinate] +=
          logit_bar * digit.number[share.slope] * program.knuckle.ratio;
  }
}

/// Computes torque = sum over muscles of  gain tension row.
inline void set_torques(const Program& program, int k, const DigitParameters& digit,
                        PosedDigit& posed) {
  const int n = program.coordinates;
  const PostureStep& posture = program.postures[k];
  clear(posed.torque, (posture.last_trial - posture.first_trial) * n);
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    // Sum over the muscles that pull in the trial.
    V* torque = posed.torque + (i - posture.first_trial) * n;
    for (int t = program.trial_steps[i].first; t < program.trial_steps[i].last; ++t) {
      const TensionStep& pull = program.pulls[t];
      const V tension = pull.tension * digit.number[program.gain + pull.muscle];
      for (int j = 0; j < n; ++j) torque[j] += tension * posed.row[pull.muscle * n + j];
    }
  }
}

/// Adjoint of set_torques().
inline void adjoint_torques(const Program& program, int k, const DigitParameters& digit,
                            const PosedDigit& posed, PosedDigit& adjoint,
                            DigitParameters& adjoint_digit) {
  const int n = program.coordinates;
  const PostureStep& posture = program.postures[k];
  for (int i = posture.first_trial; i < posture.last_trial; ++i) {
    // Pass adjoints from torques to arms, and to the gains.
    const V* push = adjoint.torque + (i - posture.first_trial) * n;
    for (int t = program.trial_steps[i].first; t < program.trial_steps[i].last; ++t) {
      const TensionStep& pull = program.pulls[t];
      const V tension = pull.tension * digit.number[program.gain + pull.muscle];
      V along = V{};
      for (int j = 0; j < n; ++j) {
        adjoint.row[pull.muscle * n + j] += tension * push[j];
        along += posed.row[pull.muscle * n + j] * push[j];
      }
      adjoint_digit.number[program.gain + pull.muscle] += pull.tension * along;
    }
  }
}

}  // namespace
}  // namespace thenar::kernel
