#pragma once

/// Postures of a request: one, or a grid of them.

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
  kTyped  // [deg], of slides [mm], as in commands
};

/// Angles of joints, either by name or in the order of the joints; the others are 0.
struct PostureRequest {
  std::map<std::string, double> named;  // joint -> value
  std::vector<double> in_order;         // angles of every joint, in order
  PostureUnit unit = PostureUnit::kSI;  // unit of all values

  [[nodiscard]] bool empty() const { return named.empty() && in_order.empty(); }
};

/// Joint that varies from `from` in steps up to `to`, which is not passed, in the unit of its
/// posture.
struct Vary {
  std::string joint;      // name of a free joint
  double from, to, step;  // first value, largest or smallest value, and difference; not 0
};

/// Postures at which a result is computed.
struct PostureGrid {
  std::vector<int> varied;  // coordinates, the last one varies fastest; empty: none
  std::size_t row = 1;      // number of postures in a row, which differ in the last one only
  std::vector<Eigen::VectorXd> postures;  // all postures, row after row [rad] (coordinates)
  std::vector<std::string> warnings;      // angles outside their limits
};

/// Largest number of postures of one request.
inline constexpr std::size_t kMaxPostures = 1000000;

/// Returns the values of a joint that varies, in its own unit, including the end despite rounding.
/// @param unit  unit in messages: " deg"
/// @throws InputError if steps do not lead from one end to the other, or are more than kMaxPostures
[[nodiscard]] std::vector<double> steps_of(const Vary& vary, const std::string& unit);

/// Returns the numbers in the order of `names`, zero for names that are not given (names).
/// @param kind   word for a name in messages: "muscle"
/// @param field  field of the request that has the names, for the error; empty: none
/// @throws InputError for a name that is not among `names`, with the nearest one and all others.
[[nodiscard]] Eigen::VectorXd in_order(const std::map<std::string, double>& named,
                                       const std::vector<std::string>& names,
                                       const std::string& kind, const std::string& field = "");

/// Returns the coordinates of a skeleton [rad] (coordinates).
/// @throws InputError for an unknown joint or a wrong count.
[[nodiscard]] Eigen::VectorXd posture_of(const Skeleton& skeleton, const PostureRequest& request);

/// Returns the grid of postures over the joints that vary; the other joints are as requested.
/// @throws InputError for an unknown joint, one that varies twice, steps that do not lead to the
/// end, or more than a million postures.
[[nodiscard]] PostureGrid posture_grid(const Skeleton& skeleton, const PostureRequest& request,
                                       const std::vector<Vary>& vary = {});

/// Returns a sentence for each violated limit: "joint 'PIP3' at 120 deg is outside -10 .. 110 deg".
/// @param q  [rad] (coordinates)
[[nodiscard]] std::vector<std::string> limit_warnings(const Skeleton& skeleton,
                                                      const Eigen::VectorXd& q);

/// Returns the angles of the frozen joints by name [rad].
/// @throws InputError for an unknown joint or an angle outside its limits.
[[nodiscard]] std::map<std::string, double> frozen_joints(const Subject& subject,
                                                          const PostureRequest& request);

}  // namespace thenar
