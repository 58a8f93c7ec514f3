#pragma once

/// Postures that a question asks about: one, or a grid of them.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "hand/skeleton.h"

namespace thenar {

/// Units of the numbers of a posture.
enum class PostureUnit {
  kSI,    // [rad], of slides [m]
  kTyped  // as people type them: [deg], of slides [mm]
};

/// Angles of joints, by name or in the order of the joints: one of both. The rest is 0.
struct PostureRequest {
  std::map<std::string, double> named;  // joint -> value
  std::vector<double> in_order;         // of every joint
  PostureUnit unit = PostureUnit::kSI;

  [[nodiscard]] bool empty() const { return named.empty() && in_order.empty(); }
};

/// One joint that varies from `from` in steps; `to` is met or not passed. In the unit of the
/// posture that it goes with.
struct Vary {
  std::string joint;
  double from, to, step;
};

/// Postures that a question is asked at.
struct PostureGrid {
  std::vector<int> varied;                // coordinates, the last one varies fastest; empty: none
  std::size_t row = 1;                    // postures that differ in the last one only
  std::vector<Eigen::VectorXd> postures;  // all, row after row [rad] (coordinates)
  std::vector<std::string> warnings;      // of angles outside their limits
};

/// Most postures of one question.
inline constexpr std::size_t kMaxPostures = 1000000;

/// Returns the values of one that varies, in its own unit: the end is met where rounding alone
/// would miss it.
/// @param unit  how messages call the unit: " deg"
/// @throws InputError if steps do not lead from one end to the other, or are more than kMaxPostures
[[nodiscard]] std::vector<double> steps_of(const Vary& vary, const std::string& unit);

/// Returns numbers in the order of `names`, zero where not given (names).
/// @param kind  how messages call a name: "muscle"
/// @throws InputError for a name that is not among `names`, with the nearest one and all others.
[[nodiscard]] Eigen::VectorXd in_order(const std::map<std::string, double>& named,
                                       const std::vector<std::string>& names,
                                       const std::string& kind);

/// Returns coordinates of a skeleton [rad] (coordinates).
/// @throws InputError for an unknown joint or a wrong count.
[[nodiscard]] Eigen::VectorXd posture_of(const Skeleton& skeleton, const PostureRequest& request);

/// Returns the posture and all that differ from it in the joints that vary; `varied` joints
/// override it.
/// @throws InputError for an unknown joint, one that varies twice, steps that do not lead to the
/// end, or more than a million postures.
[[nodiscard]] PostureGrid posture_grid(const Skeleton& skeleton, const PostureRequest& request,
                                       const std::vector<Vary>& vary = {});

/// Returns "joint 'PIP3' at 120 deg is outside -10 .. 110 deg", a sentence for each.
/// @param q  [rad] (coordinates)
[[nodiscard]] std::vector<std::string> limit_warnings(const Skeleton& skeleton,
                                                      const Eigen::VectorXd& q);

/// Returns angles at which joints are frozen, by name [rad].
/// @throws InputError for an unknown joint or an angle outside its limits.
[[nodiscard]] std::map<std::string, double> frozen_joints(const Subject& subject,
                                                          const PostureRequest& request);

}  // namespace thenar
