#pragma once

/// Types of thumbs: draws of joint axes, classified by the relative position of the axes.

#include <array>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/provenance.h"
#include "data/io/axis_variability.h"
#include "data/io/dh.h"
#include "data/io/subject.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Returns a chain with every common normal pointing from its axis to the next one, so that
/// a >= 0: where a < 0, x of the frame is turned by half a turn about the next axis,
///   theta_i + pi, -a_i, -alpha_i, theta_(i+1) - pi  (the base and the tool turn at the ends).
/// In this convention a normal that changes its direction changes two thetas by half a turn.
[[nodiscard]] DhChain with_normals_outwards(const DhChain& chain);

/// A thumb by its two criteria.
struct ThumbType {
  bool flexion_distal;  // MCP flexion axis distal of the MCP abduction axis
  bool toward;          // the common normal of the second question points its way

  [[nodiscard]] int index() const { return (flexion_distal ? 0 : 2) + (toward ? 1 : 0); }  // 0..3
};

/// The mean thumb, ready to be varied.
struct MeanThumb {
  std::vector<AxisLine> axes;          // axes of DigitVariability::axes, before any draw
  std::vector<Eigen::Vector3d> along;  // direction of each axis' bone, distal; unit (3)
  std::vector<AxisVariability> spread;
  Pose<double> tip;                          // axes proximal, dorsal, radial in columns
  int mcp_flexion = -1, mcp_abduction = -1;  // MCP1_FE and MCP1_AA, in `axes`
  int first = -1, second = -1;               // axes of the second question
  DigitDirection toward = DigitDirection::kRadial;
};

/// @throws InputError if the subject lacks a digit "thumb", a joint, or a bone that is named.
[[nodiscard]] MeanThumb mean_thumb(const DigitVariability& variability, const Subject& subject);

/// Returns axes of thumb `number`: a function of (seed, number) alone.
[[nodiscard]] std::vector<AxisLine> draw_thumb(const MeanThumb& mean, unsigned seed, int number);

/// Returns a component of the common normal from one axis to another.
/// @param toward  unit (3)
/// @returns [m]
[[nodiscard]] double normal_component(const AxisLine& first, const AxisLine& second,
                                      const Eigen::Vector3d& toward);

/// Returns the type of a thumb. Order at the MCP joint: the common normal from the flexion to the
/// abduction axis has a component along the metacarpal; the flexion axis is distal if it points
/// proximally.
[[nodiscard]] ThumbType classify_thumb(const MeanThumb& mean, const std::vector<AxisLine>& axes);

/// Mean and sd of the Denavit-Hartenberg parameters of one axis; of angles the mean direction
///   arg(sum e^(i angle))  and the sd of the differences from it, each within half a turn.
struct DhStatistics {
  DhRow mean, sd;  // theta, alpha [rad]; d, a [m]
};

/// Returns axes of a digit's model in its reference posture, in the order of `mean.spread`.
/// @param hinges  names of the model's hinges
/// @throws InputError if one of the axes is missing.
[[nodiscard]] std::vector<AxisLine> thumb_axes(const MeanThumb& mean,
                                               const TendonModel<double>& model,
                                               const std::vector<std::string>& hinges);

/// Number of draws of one type.
struct ThumbTypeShare {
  ThumbType type;
  int count = 0;
  std::vector<DhStatistics> rows;  // by with_normals_outwards(); empty without draws
};

/// Share of the draws in which the common normal of two successive axes points distally, dorsally
/// and radially.
struct NormalShares {
  std::string first, second;     // joints
  std::array<double, 3> toward;  // [1]
};

struct ThumbTypesInputs {
  SourceText variability, subject;
};

/// Reads files of a folder with studies/ and subjects/. @throws InputError if a file cannot be
/// read.
[[nodiscard]] ThumbTypesInputs thumb_types_inputs(const std::string& data);

struct ThumbTypesSettings {
  int draws = 3550;  // number of draws that [SantosValeroCuevas2006] needed [1]
  unsigned seed = 1;
  Progress progress;
};

struct ThumbTypes {
  ThumbTypesInputs inputs;
  DigitVariability variability;
  int draws = 0;  // done
  bool complete = false;
  std::array<ThumbTypeShare, 4> types;  // shares by ThumbType::index()
  int flexion_distal = 0;               // draws whose MCP flexion axis is the distal one
  /// Probability that the flexion axis is distal if axes were neither tilted nor shifted across:
  ///   Phi((m_FE - m_AA) / sqrt(s_FE^2 + s_AA^2))  [1]
  double flexion_distal_by_places = 0;
  std::vector<NormalShares> normals;
};

/// Published share of thumbs whose MCP flexion axis is distal. Source: [SantosValeroCuevas2006].
inline constexpr double kPublishedFlexionDistal = 0.652;

/// Draws thumbs and classifies them. The same settings give bitwise equal results for any number of
/// threads.
/// @throws InputError unless draws > 0.
[[nodiscard]] ThumbTypes study_thumb_types(const ThumbTypesInputs& inputs,
                                           const ThumbTypesSettings& settings);

/// Returns "MCP flexion axis distal, normal ulnar": of types by their index.
[[nodiscard]] std::string describe_type(const ThumbType& type, DigitDirection toward);

}  // namespace thenar
