#include "data/io/world/body_toml.h"

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/toml_text.h"

namespace thenar::internal {
namespace {

constexpr double kMaxMesh = 10;            // largest object without a stated scale [m]
constexpr double kInertiaRounding = 1e-6;  // Relative error allowed for moments of inertia [1]

Eigen::Matrix3d read_inertia(TomlTable& table) {
  std::vector<double> v = table.numbers(Dimension::kInertia, "inertia");  // xx yy zz xy xz yz
  if (v.size() != 3 && v.size() != 6)
    table.fail(
        fmt::format("wanted 3 (xx yy zz) or 6 (and xy xz yz) moments of inertia, got {}", v.size()),
        "inertia");
  v.resize(6);
  Eigen::Matrix3d I;
  I << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  // No body has a principal moment above the sum of the others.
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(I).eigenvalues();
  if (moments(0) < -kInertiaRounding * moments(2) ||
      moments(2) > (1 + kInertiaRounding) * (moments(0) + moments(1)))
    table.fail(fmt::format("no body has the principal moments of inertia {:.6g}, {:.6g}, {:.6g}",
                           moments(0), moments(1), moments(2)),
               "inertia");
  return I;
}

void read_mass_keys(TomlTable& table, BodySpec& body) {
  body.density = table.number_or(Dimension::kDensity, "density", 0, Range::kPositive);
  if (!table.has(Dimension::kMass, "mass")) return;
  // Full inertia, or a mass spread evenly.
  const double mass = table.number(Dimension::kMass, "mass", Range::kPositive);
  if (table.has(Dimension::kInertia, "inertia"))
    body.mass = BodyMass{mass, table.vector(Dimension::kLength, "com"), read_inertia(table)};
  else
    body.uniform_mass = mass;
  if (body.density > 0) table.fail("give 'mass' or 'density', not both", "density");
}

std::string mass_lines(const BodySpec& body) {
  if (!body.mass && body.uniform_mass > 0)
    return "mass_kg = " + toml_number(body.uniform_mass) + "\n";
  // A stated tensor, or what the shapes give.
  if (!body.mass)
    return body.density > 0 ? "density_kg_m3 = " + toml_number(body.density) + "\n" : "";
  const Eigen::Matrix3d& I = body.mass->inertia;
  require(I == I.transpose(), "the inertia of body '{}' is not symmetric", body.name);
  return fmt::format(
      "mass_kg = {}\ncom_m = {}\ninertia_kg_m2 = {}\n", toml_number(body.mass->mass),
      toml_list(body.mass->com),
      toml_list(std::vector<double>{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}));
}

/// Reads a shape; a mesh without a stated scale must have a plausible size in metres.
ShapeSpec read_sized_shape(TomlTable& table, const std::string& path) {
  const bool scaled = table.has("scale");
  ShapeSpec shape = read_shape_table(table, path);
  if (scaled || shape.mesh_file.empty() || shape.mesh.empty()) return shape;
  const Eigen::Matrix3Xd& v = shape.mesh.vertices;
  const double across = (v.rowwise().maxCoeff() - v.rowwise().minCoeff()).maxCoeff();
  if (across > kMaxMesh)
    table.fail(
        fmt::format("the mesh is {:.4g} m across: are its numbers millimetres? scale = 0.001;"
                    " if it is as large as that, scale = 1",
                    across),
        "file");
  return shape;
}

}  // namespace

BodySpec read_body_keys(TomlTable& table, const std::string& path) {
  BodySpec body;
  body.name = table.text("name");
  body.description = table.text_or("description", "");
  if (table.has("source")) body.source = table.source();
  body.material = table.text_or("material", "");
  read_mass_keys(table, body);
  read_each(table, "shape", body.shapes, read_sized_shape, path);
  if (body.shapes.empty()) table.fail(fmt::format("body '{}' needs a shape: [[shape]]", body.name));
  return body;
}

std::string text_line(const std::string& key, const std::string& value) {
  return value.empty() ? "" : fmt::format("{} = {}\n", key, toml_quoted(value));
}

std::string source_line(const std::string& source) {
  return source.empty() ? "" : "source = " + toml_keys(source) + "\n";
}

std::string sources_table(const std::vector<std::string>& sources, const OwnSources& own) {
  // Add keys that neither the file nor the bibliography explains.
  OwnSources all = own;
  const std::vector<std::string>& known = known_sources();
  for (const std::string& source : sources)
    for (const std::string& key : keys_in(source))
      if (!contains(known, key)) all.emplace(key, "As the file says that it was read from");
  std::string text;
  for (const auto& [key, reference] : all)
    text += fmt::format("{} = {}\n", toml_quoted(key), toml_quoted(reference));
  return text.empty() ? "" : "\n[sources]\n" + text;
}

std::string body_lines(const BodySpec& body, const std::string& prefix) {
  std::string text = text_line("description", body.description) + source_line(body.source) +
                     text_line("material", body.material) + mass_lines(body);
  for (const ShapeSpec& shape : body.shapes)
    text += fmt::format("\n[[{}shape]]\n{}\n", prefix, fmt::join(toml_of(shape), "\n"));
  return text;
}

}  // namespace thenar::internal
