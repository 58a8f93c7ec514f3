#pragma once

/// Hands of meshes with faults, as exporters and scanners leave them, as URDF with STL and OBJ.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "geometry/mesh_from_distance.h"
#include "geometry/mesh_parts.h"
#include "geometry/primitives.h"
#include "geometry/tessellate.h"
#include "tests/geometry/random_points.h"

namespace thenar {

// Sound surfaces of some centimetres.

/// Squares of a tube about a curve, with a cap at each end.
/// @param curve  its axis by a share of its length  @param radius  by that share
template <typename Curve, typename Radius>
[[nodiscard]] TriangleMesh swept_tube(const Curve& curve, const Radius& radius, int rings = 12,
                                      int sides = 10) {
  TriangleMesh tube{Eigen::Matrix3Xd(3, rings * sides + 2), Eigen::Matrix3Xi(3, 2 * rings * sides)};
  const int first = rings * sides, last = first + 1;
  Eigen::Index count = 0;
  for (int i = 0; i < rings; ++i) {
    const double s = static_cast<double>(i) / (rings - 1);
    const Eigen::Vector3d along = (curve(s + 1e-4) - curve(s - 1e-4)).normalized();
    const Eigen::Vector3d u = along.cross(Eigen::Vector3d(0.1, 1, 0.2)).normalized();
    for (int j = 0; j < sides; ++j) {
      const double angle = 2 * kPi * j / sides;
      tube.vertices.col(i * sides + j) =
          curve(s) + radius(s) * (std::cos(angle) * u + std::sin(angle) * along.cross(u));
      const int a = i * sides + j, b = i * sides + (j + 1) % sides;
      if (i == 0) tube.triangles.col(count++) << first, b, a;
      if (i + 1 == rings) tube.triangles.col(count++) << last, a, b;
      if (i + 1 == rings) continue;
      tube.triangles.col(count++) << a, b, b + sides;
      tube.triangles.col(count++) << a, b + sides, a + sides;
    }
  }
  tube.vertices.col(first) = curve(0);
  tube.vertices.col(last) = curve(1);
  return tube;
}

/// A box whose faces are grids.
[[nodiscard]] inline TriangleMesh grid_box(const Eigen::Vector3d& edges) {
  return mesh_from_distance(*build_box(edges), edges.minCoeff() / 4);
}

/// One of seven kinds of bodies.
[[nodiscard]] inline TriangleMesh made_up_body(std::mt19937& rng) {
  const double size = 0.012 + 0.01 * uniform(rng);  // [m]
  const double bend = 2 + 2 * uniform(rng);         // [rad]
  switch (rng() % 7) {
    case 0:
      return grid_box(size * Eigen::Vector3d(1, 1.3, 2));
    case 1:  // a ball, drawn out
      return surface_of_revolution({{0, -size},
                                    {0.5 * size, -0.8 * size},
                                    {0.7 * size, 0},
                                    {0.5 * size, 0.8 * size},
                                    {0, size}},
                                   14);
    case 2:  // a cup
      return surface_of_revolution({{0, -size},
                                    {0.6 * size, -size},
                                    {0.7 * size, size},
                                    {0.5 * size, size},
                                    {0.4 * size, -0.8 * size},
                                    {0, -0.8 * size}},
                                   16);
    case 3:  // a banana
      return swept_tube(
          [=](double s) {
            return Eigen::Vector3d(size * std::cos(bend * s), size * std::sin(bend * s), 0);
          },
          [=](double s) { return size * (0.15 + 0.2 * std::sin(kPi * s)); });
    case 4:  // a hollow ball
    {
      TriangleMesh cavity =
          surface_of_revolution({{0, -0.6 * size}, {0.6 * size, 0}, {0, 0.6 * size}}, 9);
      cavity.triangles.row(0).swap(cavity.triangles.row(1));
      return joined({grid_box(Eigen::Vector3d::Constant(1.6 * size)), cavity});
    }
    case 5:  // a plain box
      return box_mesh(size * Eigen::Vector3d(1.5, 0.8, 1));
    default:  // a waist
      return surface_of_revolution(
          {{0, -size}, {0.6 * size, -size}, {0.2 * size, 0}, {0.6 * size, size}, {0, size}}, 12);
  }
}

// Faults.

[[nodiscard]] inline TriangleMesh without_triangles(const TriangleMesh& mesh,
                                                    const std::vector<bool>& gone) {
  TriangleMesh left{mesh.vertices, Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (!gone[static_cast<std::size_t>(t)]) left.triangles.col(count++) = mesh.triangles.col(t);
  left.triangles.conservativeResize(3, count);
  return count < 4 ? mesh : left;
}

/// Without the triangles around a corner, within a share of the extent.
[[nodiscard]] inline TriangleMesh with_hole(const TriangleMesh& mesh, double share,
                                            std::mt19937& rng) {
  const Eigen::Vector3d centre = mesh.vertices.col(rng() % mesh.vertices.cols());
  const double extent =
      (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).norm();
  std::vector<bool> gone(static_cast<std::size_t>(mesh.triangles.cols()), false);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      if ((mesh.vertices.col(mesh.triangles(k, t)) - centre).norm() <= share * extent)
        gone[static_cast<std::size_t>(t)] = true;
  return without_triangles(mesh, gone);
}

/// Corners moved at random: the surface goes through itself.
[[nodiscard]] inline TriangleMesh crumpled_mesh(TriangleMesh mesh, double by, std::mt19937& rng) {
  for (auto p : mesh.vertices.colwise()) p += by * random_in_cube(rng);
  return mesh;
}

/// A closed needle of some 1e-18 m^3.
[[nodiscard]] inline TriangleMesh needle(std::mt19937& rng) {
  TriangleMesh out{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  const Eigen::Vector3d from = 0.01 * random_in_cube(rng), way = 0.02 * random_direction(rng);
  out.vertices << from, from + way, from + 0.4 * way + 2e-8 * random_in_cube(rng),
      from + 0.6 * way + 2e-8 * random_in_cube(rng);
  out.triangles << 0, 0, 1, 2, 2, 1, 2, 0, 1, 3, 3, 3;
  return out;
}

/// A square that hangs on nothing.
[[nodiscard]] inline TriangleMesh sheet(std::mt19937& rng) {
  TriangleMesh out{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
  const Eigen::Vector3d at = 0.02 * random_in_cube(rng), u = 0.01 * random_direction(rng);
  const Eigen::Vector3d v = 0.01 * random_direction(rng);
  out.vertices << at, at + u, at + u + v, at + v;
  out.triangles << 0, 0, 1, 2, 2, 3;
  return out;
}

/// A triangle that hangs on an edge of the surface.
[[nodiscard]] inline TriangleMesh with_fin(TriangleMesh mesh, std::mt19937& rng) {
  const auto t = static_cast<Eigen::Index>(rng() % mesh.triangles.cols());
  const Eigen::Index corner = mesh.vertices.cols(), last = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, corner + 1);
  mesh.vertices.col(corner) = 0.02 * random_in_cube(rng);
  mesh.triangles.conservativeResize(3, last + 1);
  mesh.triangles.col(last) << mesh.triangles(0, t), mesh.triangles(1, t), static_cast<int>(corner);
  return mesh;
}

/// Triangles cut at the middle of an edge, or near its end, which their neighbours keep whole.
[[nodiscard]] inline TriangleMesh with_corners_on_edges(TriangleMesh mesh, double share,
                                                        std::mt19937& rng) {
  for (int i = 0; i < 3; ++i) {
    const auto t = static_cast<Eigen::Index>(rng() % mesh.triangles.cols());
    const int a = mesh.triangles(0, t), b = mesh.triangles(1, t), c = mesh.triangles(2, t);
    const auto middle = static_cast<int>(mesh.vertices.cols());
    mesh.vertices.conservativeResize(3, middle + 1);
    mesh.vertices.col(middle) = share * mesh.vertices.col(a) + (1 - share) * mesh.vertices.col(b);
    mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
    mesh.triangles.col(t) << a, middle, c;
    mesh.triangles.rightCols(1) << middle, b, c;
  }
  return mesh;
}

/// A corner all but at its neighbour, so that the triangles between them have no area.
[[nodiscard]] inline TriangleMesh with_short_edge(TriangleMesh mesh, std::mt19937& rng) {
  const auto t = static_cast<Eigen::Index>(rng() % mesh.triangles.cols());
  mesh.vertices.col(mesh.triangles(1, t)) =
      mesh.vertices.col(mesh.triangles(0, t)) + 1e-15 * random_in_cube(rng);
  return mesh;
}

/// Every triangle with corners of its own, up to `off` from where they were [m].
[[nodiscard]] inline TriangleMesh loose_triangles(const TriangleMesh& mesh, double off,
                                                  std::mt19937& rng) {
  TriangleMesh out{Eigen::Matrix3Xd(3, mesh.triangles.size()),
                   Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    out.vertices.col(i) = mesh.vertices.col(mesh.triangles(i)) + off * random_in_cube(rng);
    out.triangles(i) = static_cast<int>(i);
  }
  return out;
}

/// Without every tenth triangle.
[[nodiscard]] inline TriangleMesh with_many_holes(const TriangleMesh& mesh, std::mt19937& rng) {
  std::vector<bool> gone(static_cast<std::size_t>(mesh.triangles.cols()));
  for (auto&& each : gone) each = rng() % 10 == 0;
  return without_triangles(mesh, gone);
}

/// Three boxes on each other with the walls between them, whose corners are one.
[[nodiscard]] inline TriangleMesh stacked_boxes(std::mt19937& rng) {
  const Eigen::Vector3d edges(0.01, 0.02, 0.008);
  std::vector<TriangleMesh> boxes;
  for (int i = 0; i < 3; ++i) {
    boxes.push_back(box_mesh(edges));
    boxes.back().vertices.row(2).array() += 0.008 * i;
  }
  return loose_triangles(joined(boxes), 0, rng);
}

/// One of eighteen faults, or none.
[[nodiscard]] inline TriangleMesh with_fault(TriangleMesh mesh, std::mt19937& rng) {
  const auto some = static_cast<Eigen::Index>(rng() % mesh.triangles.cols());
  switch (rng() % 20) {
    case 0:  // holes, small and large
      return with_hole(mesh, 0.05, rng);
    case 1:
      return with_hole(with_hole(mesh, 0.15, rng), 0.1, rng);
    case 2:
      return with_hole(mesh, 0.35, rng);
    case 3:  // self crossings
      return crumpled_mesh(mesh, 0.002, rng);
    case 4:
      return with_hole(crumpled_mesh(mesh, 0.004, rng), 0.1, rng);
    case 5: {  // through another body
      TriangleMesh other = made_up_body(rng);
      other.vertices.colwise() += 0.01 * random_in_cube(rng);
      return joined({mesh, other});
    }
    case 6:  // slivers
      return joined({mesh, needle(rng), needle(rng)});
    case 7:
      return with_corners_on_edges(mesh, 1e-7, rng);
    case 8:
      return with_corners_on_edges(mesh, 0.4, rng);
    case 9:  // there twice
      mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
      mesh.triangles.rightCols(1) = mesh.triangles.col(some);
      return mesh;
    case 10:  // turned
      std::swap(mesh.triangles(0, some), mesh.triangles(1, some));
      return mesh;
    case 11:
      mesh.triangles.row(0).swap(mesh.triangles.row(1));
      return mesh;
    case 12:
      return joined({with_fin(mesh, rng), sheet(rng)});
    case 13:
      return with_short_edge(mesh, rng);
    case 14:
      return with_many_holes(mesh, rng);
    case 15:
      return loose_triangles(mesh, 1e-9, rng);
    case 16:
      return loose_triangles(with_hole(mesh, 0.1, rng), 1e-7, rng);
    case 17:
      return stacked_boxes(rng);
    case 18:
      return with_many_holes(crumpled_mesh(mesh, 0.01, rng), rng);
    default:
      return mesh;
  }
}

/// A file of some bodies with faults, in STL or OBJ.
/// @returns the number of bodies
inline int write_made_up_mesh(const std::string& path, std::mt19937& rng) {
  const int bodies = 1 + static_cast<int>(rng() % 3);
  std::vector<TriangleMesh> all;
  for (int i = 0; i < bodies; ++i) {
    TriangleMesh body = with_fault(made_up_body(rng), rng);
    const Eigen::Matrix3d R = random_rotation(rng);
    body.vertices = (R * body.vertices).colwise() + 0.012 * random_in_cube(rng);
    all.push_back(std::move(body));
  }
  write_mesh(path, joined(all));
  return bodies;
}

/// A palm and three fingers of two links each. @returns the number of bodies in its meshes
inline int write_made_up_mesh_hand(const std::string& folder, unsigned seed) {
  std::mt19937 rng(seed);
  std::filesystem::create_directories(folder);
  std::ofstream urdf(folder + "/hand.urdf");
  urdf << "<robot name='made_up'>\n";
  int bodies = 0;
  const auto link = [&](const std::string& name) {
    const std::string file = name + (rng() % 2 == 0 ? ".stl" : ".obj");
    bodies += write_made_up_mesh(folder + "/" + file, rng);
    urdf << "<link name='" << name
         << "'><inertial><mass value='.1'/><inertia ixx='1e-4' iyy='1e-4' izz='1e-4' ixy='0' "
            "ixz='0' iyz='0'/></inertial><collision><geometry><mesh filename='"
         << file << "'/></geometry></collision></link>\n";
  };
  const auto joint = [&](const std::string& parent, const std::string& child,
                         const Eigen::Vector3d& p, const Eigen::Vector3d& axis) {
    urdf << fmt::format(
        "<joint name='{}_j' type='revolute'><parent link='{}'/><child link='{}'/>"
        "<origin xyz='{} {} {}'/><axis xyz='{} {} {}'/><limit lower='0' upper='1.5' effort='2' "
        "velocity='1'/></joint>\n",
        child, parent, child, p.x(), p.y(), p.z(), axis.x(), axis.y(), axis.z());
  };
  link("palm");
  const std::vector<std::string> names{"thumb", "index", "ring"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double way = 2 * kPi * static_cast<double>(i) / 3;
    const Eigen::Vector3d out(std::cos(way), std::sin(way), 0), axis(out.y(), -out.x(), 0);
    link(names[i] + "_1");
    link(names[i] + "_2");
    joint("palm", names[i] + "_1", 0.05 * out + Eigen::Vector3d(0, 0, 0.03), axis);
    joint(names[i] + "_1", names[i] + "_2", {0, 0, 0.05}, axis);
  }
  urdf << "</robot>\n";
  return bodies;
}

}  // namespace thenar
