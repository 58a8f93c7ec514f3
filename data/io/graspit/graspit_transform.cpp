#include "data/io/graspit/graspit_transform.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include <pugixml.hpp>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

constexpr double kRotationError = 1e-3;  // Error of a rotation that rounding in a file explains [1]

Mat3<double> quaternion(const XmlFile& file, const pugi::xml_node& node,
                        const std::vector<double>& v) {
  const Eigen::Quaterniond q(v[0], v[1], v[2], v[3]);
  if (std::abs(q.norm() - 1) > kRotationError)
    file.fail(node, fmt::format("wanted a quaternion of length 1, got {:.6g}", q.norm()));
  return q.normalized().toRotationMatrix();
}

Mat3<double> matrix(const XmlFile& file, const pugi::xml_node& node) {
  const std::vector<double> v = file.numbers(node, 9);
  // Off by more than rounding: no rotation.
  const Mat3<double> R = Eigen::Map<const Mat3<double>>(v.data());
  const double error = (R.transpose() * R - Mat3<double>::Identity()).cwiseAbs().maxCoeff();
  if (error > kRotationError || R.determinant() < 0)
    file.fail(node, fmt::format("wanted a rotation in <rotationMatrix>, got one off by {:.3g} and "
                                "of determinant {:.3g}",
                                error, R.determinant()));
  return Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

double number_in(const std::string& word) {
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  return *end == '\0' ? number : NAN;
}

/// Rotation "90 x", "x 90", "90 X" or "90 0 0 1".
Mat3<double> turn(const XmlFile& file, const pugi::xml_node& node) {
  std::istringstream words(file.text(node));
  Vec3<double> axis = Vec3<double>::Zero();
  std::vector<double> numbers;
  // A letter names an axis; everything else is a number.
  for (std::string word; words >> word;) {
    const std::size_t letter = word.size() == 1 ? std::string("xyzXYZ").find(word) : 6;
    if (letter < 6)
      axis(static_cast<int>(letter % 3)) = 1;
    else
      numbers.push_back(number_in(word));
  }
  // Four numbers: an angle and a general axis.
  if (numbers.size() == 4 && axis.isZero()) {
    axis << numbers[1], numbers[2], numbers[3];
    numbers.resize(1);
  }
  if (numbers.size() != 1 || !(axis.norm() > 0) || !std::isfinite(axis.norm() + numbers[0]))
    file.fail(node,
              fmt::format("wanted an angle and one axis in <rotation>, got '{}'", file.text(node)));
  return rotation_about<double>(axis.normalized(), numbers[0] * kDegree);
}

}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): once, for a <transform> inside
Pose<double> graspit_transform(const XmlFile& file, const pugi::xml_node& node,
                               std::vector<std::string>& warnings) {
  // An element that contains the transform.
  if (std::string(node.name()) != "transform" && !node.child("transform").empty())
    return graspit_transform(file, node.child("transform"), warnings);
  Pose<double> X;
  if (std::string(node.name()) != "transform") return X;
  // Steps multiply from left to right.
  for (const pugi::xml_node& step : node.children()) {
    const std::string name = step.name();
    if (step.type() != pugi::node_element) continue;
    if (name == "fullTransform") {
      const std::vector<double> v = file.numbers(step, 7);
      const Vec3<double> place = kGraspitLength * Vec3<double>(v[4], v[5], v[6]);
      X = X * Pose<double>{quaternion(file, step, v), place};
    } else if (name == "translation") {
      X = X * Pose<double>{Mat3<double>::Identity(), kGraspitLength * file.vector3(step)};
    } else if (name == "rotation") {
      X = X * Pose<double>{turn(file, step), Vec3<double>::Zero()};
    } else if (name == "rotationMatrix") {
      X = X * Pose<double>{matrix(file, step), Vec3<double>::Zero()};
    } else {
      warnings.push_back(file.not_understood(step));
    }
  }
  return X;
}

}  // namespace thenar
