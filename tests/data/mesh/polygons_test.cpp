// Tests for data/io/mesh/polygons.cpp: triangles of a polygon cover its area once.

#include "data/io/mesh/polygons.h"

#include <gmock/gmock.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Twice the sum of the triangles' areas along z; overlaps would count twice, holes would be
/// missing.
double twice_area(const TriangleSoup& soup) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < soup.corners.size(); i += 3) {
    const Eigen::Vector3d n =
        (soup.corners[i + 1] - soup.corners[i]).cross(soup.corners[i + 2] - soup.corners[i]);
    EXPECT_GE(n.z(), 0);
    sum += n.z();
  }
  return sum;
}

Polygons one_face(const std::vector<Eigen::Vector3d>& corners) {
  Polygons polygons;
  polygons.vertices = corners;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) polygons.corners.push_back(i);
  polygons.sizes = {static_cast<int>(corners.size())};
  polygons.lines = {7};
  return polygons;
}

TEST(Polygons, ConvexOnesBecomeFans) {
  const TriangleSoup soup = triangulate_polygons(
      one_face({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}), "f.obj");
  EXPECT_EQ(soup.corners.size(), 9U);
  EXPECT_EQ(twice_area(soup), 2 * 5);
}

// A square of 3 with a notch of 1 x 2 from the right: area 9 - 2.
TEST(Polygons, ReflexCornersAreCutAround) {
  const TriangleSoup soup = triangulate_polygons(
      one_face(
          {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}}),
      "f.obj");
  EXPECT_EQ(soup.corners.size(), 18U);
  EXPECT_DOUBLE_EQ(twice_area(soup), 2 * 7);
}

TEST(Polygons, NameTheLineOfAMissingCorner) {
  Polygons polygons = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  polygons.corners[2] = 3;
  EXPECT_THAT(message_of<DataError>([&] { (void)triangulate_polygons(polygons, "f.obj"); }),
              HasSubstr("f.obj:7: a face has corner 3, and there are 3 vertices"));
}

TEST(Obj, CountsCornersFromBothEnds) {
  const Polygons found = parse_obj(
      "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1/1 2//1 -1/1/1\nusemtl red\n", "f.obj");
  EXPECT_THAT(found.corners, ElementsAre(0, 1, 2));
  EXPECT_THAT(found.lines, ElementsAre(6));
  EXPECT_THROW((void)parse_obj("v 0 0 0\nf -2 1 1\n", "f.obj"), DataError);
}

TEST(Off, TakesCountsOnItsFirstOrSecondLine) {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* head : {"OFF\n3 1 0\n", "OFF 3 1 0\n"}) {
    const Polygons found = parse_off(head + body, "f.off");
    EXPECT_EQ(found.vertices.size(), 3U);
    EXPECT_THAT(found.corners, ElementsAre(0, 1, 2));
  }
  EXPECT_THAT(message_of<DataError>([] { (void)parse_off("OFF\n1000000 1 0\n0 0 0\n", "f.off"); }),
              HasSubstr("more than"));
}

}  // namespace
}  // namespace thenar
