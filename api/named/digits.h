#pragma once

/// One digit of a subject with its tendons, from which every question about fingertip forces
/// starts.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/posture.h"
#include "base/fidelity.h"
#include "base/provenance.h"
#include "data/io/net_description.h"
#include "data/io/subject.h"
#include "tendons/digit_tendons.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/net/net_tendons.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Options that select a digit, its posture and its model rungs.
struct DigitRequest {
  std::string subject;       // a file, or the name of one of subjects/; required
  std::string subject_text;  // text of a subject file, instead of a file;
                             // `subject` is then its name in messages and records
  std::string digit;         // empty: the only one that the subject has
  std::string data;          // folder with subjects/ ..; empty: the usual ones
  PostureRequest posture;    // joints not named are at 0
  PostureRequest frozen;     // joints welded there
  std::vector<Vary> vary;    // in the unit of the posture; the last one varies fastest
  std::optional<Path> path;  // tendon paths outside of a net; absent: default_path()
  std::optional<Hood> hood;  // absent: the question's own default, or a net where one is named
  std::string net;           // name or file; empty: extensor_hood if the hood is a net
  std::string map;           // a published tip map; empty: the bones, or the first map
  WristMode wrist = WristMode::kWelded;  // joints that digits share: welded, or coordinates too
  PassiveMoments passive = PassiveMoments::kOn;  // whether the subject's passive moments act
};

/// Digit built from a request.
struct DigitCase {
  std::vector<SourceText> sources;               // texts of the subject and of a net
  Subject subject;                               // subject, with passive moments as requested
  std::string digit;                             // name of the digit
  std::string map;                               // empty: built from bones
  TendonOptions rungs;                           // options by which the tendons were built
  PassiveMoments passive = PassiveMoments::kOn;  // requested setting, already applied to `subject`
  std::shared_ptr<const DigitTendons> tendons;   // shared with results; null for a map
  const NetTendons* net = nullptr;    // tendons as a net where the hood is one, else null
  PostureGrid grid;                   // empty for a map
  std::vector<std::string> warnings;  // about limits and about tendons too close to a joint

  [[nodiscard]] const TendonDigit& bones() const { return tendons->digit(); }
};

/// Static balance of one digit at one posture, with the names of its rows and columns.
struct DigitAtPosture {
  std::string subject;                      // name of the subject
  std::string digit;                        // name of the digit
  std::string map;                          // empty: built from bones and tendons
  std::string built;                        // fidelity, or which map, in words
  std::vector<std::string> rows;            // rows of the balance: joints, or Fx Fy Fz tx ..
  Eigen::VectorXd q;                        // [rad] (joints); empty for a map
  std::optional<Eigen::Matrix3d> tip_axes;  // proximal, dorsal, radial, world frame (3, 3)
  TipStatics statics;                       // balance J' f + W' m = R' t + tau_0
  std::vector<StaticsDerivative> slopes;    // derivatives by each joint; empty for a map
  double condition;                         // condition number of the tip's Jacobian [1]
  std::vector<std::string> warnings;        // warnings about its tendons
  Eigen::Vector3d tip{0, 0, 0};             // position of the tip, world frame [m] (3); 0 for a map
  std::optional<Eigen::Vector3d> plane_normal = {};  // unit, where all axes are parallel (3)
};

/// Reads the subject and builds the digit; a digit without bones is one of the subject's tip maps.
/// @param default_hood  used where the request has no hood and no net
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] DigitCase build_digit(const DigitRequest& request, Hood default_hood);

/// Returns the static balance of linear tendons at a posture of the case, or of its map.
/// @param q  [rad] (coordinates); empty for a map
/// @throws InputError if tendon paths are not reliable there, or if the hood is a net.
[[nodiscard]] DigitAtPosture digit_at(const DigitCase& at, const Eigen::VectorXd& q);

/// Largest tension of a request [N]: the weight of a tonne. No tendon of a hand carries more, so a
/// larger value is a mistake in units.
inline constexpr double kMaxTension = 1e4;

/// Returns the tension of each muscle [N] (muscles), zero for muscles that are not named.
/// @throws InputError for an unknown muscle, a negative tension, or one above kMaxTension.
[[nodiscard]] Eigen::VectorXd tensions(const DigitCase& at,
                                       const std::map<std::string, double>& named);

/// Returns the path and text of a subject given by the path of its file or by its name.
/// @param field  field of the request, which errors name
/// @throws InputError listing the searched folders and the nearest name; DataError if it is wrong.
[[nodiscard]] SourceText subject_source(const std::string& name_or_path, const std::string& data,
                                        const char* field = "subject");

/// Returns the name itself if the subject has such a digit, the only digit if the name is empty.
/// @throws InputError listing the subject's digits.
[[nodiscard]] std::string choose_digit(const Subject& subject, const std::string& asked);

/// Returns the muscles whose largest force the subject does not state: "FDP", "FDS".
[[nodiscard]] std::vector<std::string> unlimited_muscles(const TipStatics& statics);

/// Returns warnings about moment arms that collapse at this posture, see vanishing_arms(), with
/// remedies.
/// @param linear  tendons of the digit without a net
[[nodiscard]] std::vector<std::string> collapse_warnings(const DigitTendons& linear,
                                                         const Eigen::VectorXd& q);

/// Returns warnings about arms of the wrong sign, see reversed_arms(): the number of postures, and
/// the first of them.
/// @param linear  tendons of the digit without a net
[[nodiscard]] std::vector<std::string> reversal_warnings(const DigitTendons& linear,
                                                         const PostureGrid& grid);

/// Returns warnings about muscles whose tension exceeds the subject's limit.
/// @param t  tension of each muscle [N] (muscles)
[[nodiscard]] std::vector<std::string> overload_warnings(const std::vector<std::string>& muscles,
                                                         const Eigen::VectorXd& max_tension,
                                                         const Eigen::VectorXd& t);

/// Returns the names of the built-in nets: "chao_an", "dogadov2017", "extensor_hood", "winslow".
[[nodiscard]] std::vector<std::string> known_nets();

/// Returns the text of a net given by one of these names or by the path of its file, with that path
/// or "built-in NAME.toml". @throws InputError listing the names; DataError if the file cannot be
/// read.
[[nodiscard]] SourceText net_source(const std::string& name_or_path);

/// Returns the net itself. @throws as net_source(); DataError also if the content is wrong.
[[nodiscard]] NetDescription find_net(const std::string& name_or_path);

/// Returns the name of the net that a requested hood and a requested net select together: the named
/// net, or "extensor_hood" for a hood that is a net without a name; empty: no net.
/// @throws InputError if a net is named for a hood of another kind.
[[nodiscard]] std::string requested_net(const std::optional<Hood>& hood, const std::string& net);

}  // namespace thenar
