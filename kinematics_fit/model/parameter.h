#pragma once

/// Named parameters of a digit that a fit may move, with default priors.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Kind of a parameter: the quantity that it changes. Points move along the digit's proximal,
/// dorsal and radial directions.
enum class ParameterKind {
  kAxisDirection,  // axis/<joint>/direction/<1|2>: tilt along a tangent of the sphere [rad]
  kAxisPoint,      // axis/<joint>/point/<1|2|along>: shift of the axis                 [m]
  kPathPoint,      // path/<strand>/<k>/<proximal|dorsal|radial>                        [m]
  kArm,            // arm/<strand>/<joint>: constant moment arm                         [m]
  kHoodEntry,      // hood/<muscle>/into: shift of the fraction's logit                 [1]
  kHoodCentral,    // hood/<muscle>/central: shift of the fraction's logit              [1]
  kHoodSlope,      // hood/<muscle>/slope: of the logit of `central`, by MCP flexion    [1/rad]
  kFriction,       // friction/<strand>: Euler's belt coefficient in the sheath         [1]
  kLength,         // length/<joint>: of the bone distal to the joint                   [m]
  kTip,            // tip/<proximal|dorsal|radial>                                      [m]
  kSensorTilt,     // sensor/<proximal|dorsal|radial>: of the load cell                 [rad]
  kAngle,          // angle/<joint>: error of all postures                              [rad]
  kPostureAngle,   // angle/<joint>/<posture>: error of one posture                     [rad]
  kOutOfPlane,     // hold/out_of_plane: length by which out-of-plane moments are divided [m]
  kGain,           // gain/<muscle>: tension at the digit per stated tension            [1]
  kTipForce,       // force/<muscle>/<proximal|dorsal|radial>: of the tip per stated
                   // tension, beyond what the geometry makes                           [1]
  kPostureForce,   // force/<muscle>/<proximal|dorsal|radial>/<posture>: the same in
                   // one posture alone                                                 [1]
  kNetStiffness,   // net/<band>/stiffness, net/stiffness of all: log of a factor on EA [1]
  kNetSlack,       // net/<band>/slack: log of a factor on the slack length             [1]
  kNetPlace,       // net/<node>/<proximal|dorsal|radial>: of an insertion or exit      [m]
  kNetRadius,      // net/<surface>/radius: of a bone that bands bend over              [m]
  kNetEntry,       // net/<muscle>/into: shift of the logit of its share in the net     [1]
  kNetCentral,     // net/<muscle>/central: of that, what goes to the first of its two
                   // pulls: shift of the logit                                         [1]
  kNetSlope        // net/<muscle>/slope: of the logit of `central`, by MCP flexion     [1/rad]
};
inline constexpr std::array kParameterKindNames{
    EnumName{ParameterKind::kAxisDirection, "axis/direction"},
    EnumName{ParameterKind::kAxisPoint, "axis/point"},
    EnumName{ParameterKind::kPathPoint, "path"},
    EnumName{ParameterKind::kArm, "arm"},
    EnumName{ParameterKind::kHoodEntry, "hood/into"},
    EnumName{ParameterKind::kHoodCentral, "hood/central"},
    EnumName{ParameterKind::kHoodSlope, "hood/slope"},
    EnumName{ParameterKind::kFriction, "friction"},
    EnumName{ParameterKind::kLength, "length"},
    EnumName{ParameterKind::kTip, "tip"},
    EnumName{ParameterKind::kSensorTilt, "sensor"},
    EnumName{ParameterKind::kAngle, "angle"},
    EnumName{ParameterKind::kPostureAngle, "angle/posture"},
    EnumName{ParameterKind::kOutOfPlane, "hold/out_of_plane"},
    EnumName{ParameterKind::kGain, "gain"},
    EnumName{ParameterKind::kTipForce, "force"},
    EnumName{ParameterKind::kPostureForce, "force/posture"},
    EnumName{ParameterKind::kNetStiffness, "net/stiffness"},
    EnumName{ParameterKind::kNetSlack, "net/slack"},
    EnumName{ParameterKind::kNetPlace, "net/place"},
    EnumName{ParameterKind::kNetRadius, "net/radius"},
    EnumName{ParameterKind::kNetEntry, "net/into"},
    EnumName{ParameterKind::kNetCentral, "net/central"},
    EnumName{ParameterKind::kNetSlope, "net/slope"}};
[[nodiscard]] inline std::string name_of(ParameterKind kind) {
  return name_in(kParameterKindNames, kind);
}

/// Named parameter; before the fit its value is `mean`.
struct Parameter {
  std::string name;
  ParameterKind kind;
  int item = 0;       // hinge, strand or muscle, depending on `kind`
  int point = 0;      // point of the path, or posture, depending on `kind`
  int component = 0;  // component of a direction, point or coordinate
  double mean = 0;    // prior mean: the subject's value of arms, gains, friction; otherwise 0 [SI]
  double sd = 0;      // prior sd of the population mean [SI]
  double between_sd = 0;  // prior sd between specimens [SI]
  double lower = 0;       // lower bound [SI]
  double upper = 0;       // upper bound [SI]
};

/// Returns the unit in which users read and write the parameter: "mm", "deg", "1" or "1/rad".
[[nodiscard]] std::string display_unit(const Parameter& parameter);

/// Returns display units per SI unit: 1000 for lengths, 180/pi for angles.
[[nodiscard]] double display_scale(const Parameter& parameter);

/// Lists every parameter of a digit, with default priors. Constant arms, gains and friction are
/// values with the subject's as mean; all others are shifts from the subject, with mean 0.
/// Insertions and exits of a net that are points of a tendon's path move with that path and have no
/// parameter.
/// @param postures  names of the postures with their own angle errors
[[nodiscard]] std::vector<Parameter> list_parameters(const TendonDigit& digit,
                                                     const std::vector<std::string>& postures = {});

/// Returns whether a name matches a glob pattern with `*` (any characters, or none) and `?`.
[[nodiscard]] bool matches_glob(const std::string& glob, const std::string& name);

}  // namespace thenar
