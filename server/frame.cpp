#include "server/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/bytes.h"

namespace thenar {
namespace {

constexpr double kStepUnit = 1e-6;  // unit of the step of line points [m]
constexpr int kDefaultStep = 10;    // default step of line points [kStepUnit]
constexpr int kMaxSteps = 32767;    // largest number of steps from the origin, by the range of i16

/// Converts a number of entries. @throws InputError if it exceeds the range of u16
std::uint16_t count_of(std::size_t count, const char* what) {
  require(count <= std::numeric_limits<std::uint16_t>::max(), "{} {} are too many to be shown",
          count, what);
  return static_cast<std::uint16_t>(count);
}

/// Grid to which points of lines are rounded.
struct Grid {
  Eigen::Vector3f origin{0, 0, 0};  // [m]
  int step = kDefaultStep;          // [kStepUnit]
};

/// Computes a grid with its origin in the middle of all points, and the smallest step that reaches
/// all of them.
Grid grid_of(const std::vector<Eigen::Vector3d>& points) {
  Grid grid;
  if (points.empty()) return grid;
  // Centre the grid in the box of the points.
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  grid.origin = box.center().cast<float>();
  // Choose a step that reaches the farthest point.
  const double reach =
      std::max((box.max() - grid.origin.cast<double>()).cwiseAbs().maxCoeff(),
               (box.min() - grid.origin.cast<double>()).cwiseAbs().maxCoeff());  // [m]
  const double wanted = std::ceil(reach / (kMaxSteps * kStepUnit));
  require(wanted <= std::numeric_limits<std::uint16_t>::max(),
          "lines that reach {} m are too long to be shown", reach);
  grid.step = std::max(kDefaultStep, static_cast<int>(wanted));
  return grid;
}

template <typename Vector>
void add_floats(LittleEndianWriter& out, const Vector& values) {
  for (const auto value : values) out.add<float>(value);
}

/// Adds an entry of bodies; -1 becomes 0xffff.
void add_body(LittleEndianWriter& out, int body) {
  out.add<std::uint16_t>(body < 0 ? 0xffff : body);
}

void add_head(LittleEndianWriter& out, const LiveInstant& instant, const Grid& grid) {
  out.add<double>(instant.time);
  out.add<std::uint16_t>(count_of(instant.bodies.size(), "bodies"));
  out.add<std::uint16_t>(count_of(instant.joints.size(), "joints"));
  out.add<std::uint16_t>(count_of(instant.tensions.size(), "lines"));
  out.add<std::uint16_t>(count_of(instant.contacts.size(), "contacts"));
  out.add<std::uint16_t>(count_of(instant.arrows.size(), "arrows"));
  out.add<std::uint16_t>(count_of(instant.line_points.size(), "points of lines"));
  out.add<std::uint16_t>(grid.step == kDefaultStep ? 0 : grid.step);
  out.add<std::uint16_t>(0);
  add_floats(out, grid.origin);
}

}  // namespace

Eigen::Vector4d quaternion_of(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
  return (q.w() < 0 ? -1 : 1) * Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
}

std::string encode_frame(const LiveInstant& instant, std::uint32_t revision,
                         std::uint32_t sequence) {
  const Grid grid = grid_of(instant.line_points);
  LittleEndianWriter out(52 + 28 * instant.bodies.size() + 4 * instant.joints.size() +
                         4 * instant.tensions.size() + 44 * instant.contacts.size() +
                         24 * instant.arrows.size() + 6 * instant.line_points.size());
  // Write the header.
  out.add_text("THF1");
  out.add<std::uint32_t>(revision);
  out.add<std::uint32_t>(sequence);
  out.add<std::uint32_t>(0);
  add_head(out, instant, grid);
  // Write bodies, joints, tensions, contacts and arrows.
  for (const Pose<double>& pose : instant.bodies) {
    add_floats(out, pose.p);
    add_floats(out, quaternion_of(pose.R));
  }
  add_floats(out, instant.joints);
  add_floats(out, instant.tensions);
  for (const LiveContact& contact : instant.contacts) {
    add_body(out, contact.a);
    add_body(out, contact.b);
    add_floats(out, contact.point);
    add_floats(out, contact.normal);
    add_floats(out, contact.force);
    out.add<float>(contact.friction);
  }
  for (const LiveVector& arrow : instant.arrows) {
    add_floats(out, arrow.from);
    add_floats(out, arrow.vector);
  }
  // Write the points of lines, rounded to the grid.
  for (const Eigen::Vector3d& point : instant.line_points)
    for (int i = 0; i < 3; ++i)
      out.add<std::int16_t>(std::lround((point(i) - grid.origin(i)) / (grid.step * kStepUnit)));
  return out.take();
}

OrderedJson frame_json(const LiveShape& shape, const LiveInstant& instant, unsigned long revision) {
  OrderedJson out{{"revision", revision},           {"time", instant.time},
                  {"bodies", OrderedJson::array()}, {"joints", OrderedJson::array()},
                  {"lines", OrderedJson::array()},  {"contacts", OrderedJson::array()},
                  {"arrows", OrderedJson::array()}};
  // Add bodies and joints with their names.
  for (std::size_t i = 0; i < shape.bodies.size(); ++i)
    out["bodies"].push_back({{"name", shape.bodies[i].name},
                             {"position", to_json(instant.bodies[i].p)},
                             {"rotation", to_json(quaternion_of(instant.bodies[i].R))}});
  for (std::size_t i = 0; i < shape.joints.size(); ++i)
    out["joints"].push_back({{"name", shape.joints[i].name}, {"value", instant.joints[i]}});
  // Split the points of all lines into the lines.
  std::size_t point = 0;
  for (std::size_t i = 0; i < shape.lines.size(); ++i) {
    OrderedJson points = OrderedJson::array();
    for (int k = 0; k < shape.lines[i].points; ++k)
      points.push_back(OrderedJson(to_json(instant.line_points[point++])));
    out["lines"].push_back({{"name", shape.lines[i].name},
                            {"tension", number_or_null(instant.tensions[i])},
                            {"points", std::move(points)}});
  }
  // Add contacts and arrows.
  const auto name = [&](int body) {
    return body < 0 ? OrderedJson() : OrderedJson(shape.bodies[body].name);
  };
  for (const LiveContact& contact : instant.contacts)
    out["contacts"].push_back({{"a", name(contact.a)},
                               {"b", name(contact.b)},
                               {"point", to_json(contact.point)},
                               {"normal", to_json(contact.normal)},
                               {"force", to_json(contact.force)},
                               {"friction", contact.friction}});
  for (std::size_t i = 0; i < shape.arrows.size(); ++i)
    out["arrows"].push_back({{"name", shape.arrows[i].name},
                             {"from", to_json(instant.arrows[i].from)},
                             {"vector", to_json(instant.arrows[i].vector)}});
  return out;
}

}  // namespace thenar
