#pragma once

/// One digit of a subject with its tendons: what every question about fingertip forces starts from.

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
  std::string subject;       // a file, or the name of one of subjects/
  std::string subject_text;  // of a subject as its file would have it, in place of a file;
                             // `subject` then is what messages and records call it
  std::string digit;         // empty: the only one that the subject has
  std::string data;          // folder with subjects/ ..; empty: the usual ones
  PostureRequest posture;    // joints not named are at 0
  PostureRequest frozen;     // joints welded there
  std::vector<Vary> vary;    // in the unit of the posture; the last one varies fastest
  std::optional<Path> path;  // of tendons outside of a net; absent: default_path()
  std::optional<Hood> hood;  // absent: the question's own default, or a net where one is named
  std::string net;           // name or file; empty: extensor_hood if the hood is a net
  std::string map;           // a published tip map; empty: the bones, or the first map
  WristMode wrist = WristMode::kWelded;  // joints that digits share: welded, or coordinates too
  PassiveMoments passive = PassiveMoments::kOn;  // whether those of the subject are counted
};

/// The digit, built.
struct DigitCase {
  std::vector<SourceText> sources;  // of the subject, and of a net
  Subject subject;
  std::string digit;
  std::string map;                               // empty: built from bones
  TendonOptions rungs;                           // by which tendons were built
  PassiveMoments passive = PassiveMoments::kOn;  // as asked for: already in `subject`
  std::shared_ptr<const DigitTendons> tendons;   // shared with results; null for a map
  const NetTendons* net = nullptr;               // the same where its hood is a net, else null
  PostureGrid grid;                              // empty for a map
  std::vector<std::string> warnings;             // of limits and of tendons too close to a joint

  [[nodiscard]] const TendonDigit& bones() const { return tendons->digit(); }
};

/// One digit in balance at one posture, with the names that its numbers go by.
struct DigitAtPosture {
  std::string subject;
  std::string digit;
  std::string map;                          // empty: built from bones and tendons
  std::string built;                        // fidelity, or which map, in words
  std::vector<std::string> rows;            // of the balance: joints, or Fx Fy Fz tx ..
  Eigen::VectorXd q;                        // [rad] (joints); empty for a map
  std::optional<Eigen::Matrix3d> tip_axes;  // proximal, dorsal, radial now, in world axes (3, 3)
  TipStatics statics;
  std::vector<StaticsDerivative> slopes;  // by each joint; empty for a map
  double condition;                   // of the tip's Jacobian, in the plane of parallel axes [1]
  std::vector<std::string> warnings;  // of its tendons
  Eigen::Vector3d tip{0, 0, 0};       // where it is, world frame [m] (3); 0 for a map
  std::optional<Eigen::Vector3d> plane_normal = {};  // of flexion, where all axes are parallel (3)
};

/// Reads the subject and builds the digit; a digit without bones is one of the subject's tip maps.
/// @param default_hood  where the request has no hood and no net
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] DigitCase build_digit(const DigitRequest& request, Hood default_hood);

/// Returns the balance of linear tendons at a posture of the case, or of its map.
/// @param q  [rad] (coordinates); empty for a map
/// @throws InputError if tendon paths are not to be trusted there, or if the hood is a net.
[[nodiscard]] DigitAtPosture digit_at(const DigitCase& at, const Eigen::VectorXd& q);

/// The largest tension that a question may state: a tonne hangs on it. No tendon of a hand bears
/// that, so that more is a slip of units.
inline constexpr double kMaxTension = 1e4;  // [N]

/// Returns the tension of each muscle [N] (muscles), zero where it is not named.
/// @throws InputError for an unknown muscle, a negative tension, or one above kMaxTension.
[[nodiscard]] Eigen::VectorXd tensions(const DigitCase& at,
                                       const std::map<std::string, double>& named);

/// Returns a subject by the path of its file or by its name, with its text.
/// @throws InputError with the places looked in and the nearest name; DataError if it is wrong.
[[nodiscard]] SourceText subject_source(const std::string& name_or_path, const std::string& data);

/// Returns the name itself if the subject has such a digit, the only digit if the name is empty.
/// @throws InputError listing the digits there are.
[[nodiscard]] std::string choose_digit(const Subject& subject, const std::string& asked);

/// Returns "FDP", "FDS": muscles whose largest force the subject does not say.
[[nodiscard]] std::vector<std::string> unlimited_muscles(const TipStatics& statics);

/// Returns warnings about moment arms that collapse at this posture, see vanishing_arms(), with
/// remedies.
/// @param linear  tendons of the digit without a net
[[nodiscard]] std::vector<std::string> collapse_warnings(const DigitTendons& linear,
                                                         const Eigen::VectorXd& q);

/// Returns arms of the wrong sign, see reversed_arms(): at how many of the postures, and at the
/// first of them.
/// @param linear  tendons of the digit without a net
[[nodiscard]] std::vector<std::string> reversal_warnings(const DigitTendons& linear,
                                                         const PostureGrid& grid);

/// Returns muscles that are to pull more than the subject says they can.
/// @param t  tension of each muscle [N] (muscles)
[[nodiscard]] std::vector<std::string> overload_warnings(const std::vector<std::string>& muscles,
                                                         const Eigen::VectorXd& max_tension,
                                                         const Eigen::VectorXd& t);

/// Returns "chao_an", "dogadov2017", "extensor_hood", "winslow": nets that the library carries
/// along.
[[nodiscard]] std::vector<std::string> known_nets();

/// Returns the text of a net by one of these names, or by the path of its file; that path is
/// returned with it, or "NAME.toml". @throws InputError listing the names; DataError if the file
/// cannot be read.
[[nodiscard]] SourceText net_source(const std::string& name_or_path);

/// Returns a net by the same. @throws as well DataError if the file is wrong.
[[nodiscard]] NetDescription find_net(const std::string& name_or_path);

/// Returns the net that a hood and a net, absent or empty where not given, mean together: a named
/// net means a hood that is a net; such a hood alone means "extensor_hood". Empty: no net.
/// @throws InputError if a net is named for a hood that is none.
[[nodiscard]] std::string net_meant(const std::optional<Hood>& hood, const std::string& net);

}  // namespace thenar
