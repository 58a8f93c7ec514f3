// The only fence of Coin.

#include "data/io/foreign_mesh/parsers.h"

#include "base/error.h"

#ifndef THENAR_HAS_COIN

namespace thenar {

TriangleSoup read_inventor_mesh(const std::string& path) {
  throw DataError(path, 1,
                  "VRML and Inventor are read through Coin, which this thenar was built without: "
                  "install libcoin-dev and build again, or turn the file into an OBJ");
}

}  // namespace thenar

#else

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <utility>
#include <vector>

#include <Inventor/SbMatrix.h>
#include <Inventor/SbRotation.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLBox.h>
#include <Inventor/VRMLnodes/SoVRMLCylinder.h>
#include <Inventor/VRMLnodes/SoVRMLSphere.h>
#include <Inventor/VRMLnodes/SoVRMLTransform.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoMatrixTransform.h>
#include <Inventor/nodes/SoRotation.h>
#include <Inventor/nodes/SoRotationXYZ.h>
#include <Inventor/nodes/SoScale.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTransformSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include "data/io/mesh/transformed_primitive.h"

namespace thenar {
namespace {

/// Keeps the first reading error of Coin in a std::string. Missing textures are no error: a surface
/// does not need them.
void keep_first(const SoError* error, void* first) {
  const std::string said = error->getDebugString().getString();
  std::string& kept = *static_cast<std::string*>(first);
  if (kept.empty() && said.find("texture file") == std::string::npos) kept = said;
}

void swallow(const SoError* /*error*/, void* /*data*/) {}

/// Coin says "Coin read error: WHAT\n\tOccurred at line N in FILE".
[[noreturn]] void refuse_file(const std::string& path, const std::string& said) {
  // The line number is somewhere in the message.
  std::smatch found;
  const bool has_line = std::regex_search(said, found, std::regex("line +([0-9]+)"));
  const int line = has_line ? std::stoi(found[1]) : 1;
  std::string what = said.substr(0, said.find('\n'));
  const std::string prefix = "Coin read error: ";
  if (what.rfind(prefix, 0) == 0) what.erase(0, prefix.size());
  throw DataError(path, line, what.empty() ? "is neither VRML nor Inventor" : what);
}

/// Shapes of VRML 2.0 state their vertex order, others inherit it from the scene.
bool is_clockwise(SoCallbackAction& action) {
  const SoNode* shape = action.getCurPathTail();
  const SoField* counterclockwise = shape->getField("ccw");
  if (counterclockwise != nullptr && counterclockwise->isOfType(SoSFBool::getClassTypeId()))
    return static_cast<const SoSFBool*>(counterclockwise)->getValue() == 0;
  return action.getVertexOrdering() == SoShapeHints::CLOCKWISE;
}

/// Stack of transforms in double precision, from the numbers as they were written.
class WrittenPlace {
 public:
  [[nodiscard]] const Eigen::Affine3d& top() const { return open_.back(); }
  void push() { open_.push_back(open_.back()); }
  void pop() {
    if (open_.size() > 1) open_.pop_back();
  }
  void multiply(const Eigen::Affine3d& map) { open_.back() = open_.back() * map; }

 private:
  std::vector<Eigen::Affine3d> open_{Eigen::Affine3d::Identity()};
};

Eigen::Vector3d written(const SbVec3f& v) {
  return {shortest_decimal(v[0]), shortest_decimal(v[1]), shortest_decimal(v[2])};
}

/// Rotation as a unit quaternion, the only form that Coin keeps.
Eigen::Quaterniond written(const SbRotation& rotation) {
  float x = 0, y = 0, z = 0, w = 1;
  rotation.getValue(x, y, z, w);
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

/// Map T C R SO S SO^-1 C^-1 of SoTransform and SoVRMLTransform.
template <typename Transform>
Eigen::Affine3d map_of(const Transform& node, const SoSFVec3f& scale) {
  const Eigen::Vector3d centre = written(node.center.getValue());
  const Eigen::Quaterniond axes = written(node.scaleOrientation.getValue());
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.translate(written(node.translation.getValue()) + centre);
  map.rotate(written(node.rotation.getValue()) * axes);
  map.scale(written(scale.getValue()));
  map.rotate(axes.inverse());
  return map.translate(-centre);
}

/// Map of a transformation node; the identity for any other node.
Eigen::Affine3d map_of_node(const SoNode& node) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  // One of Coin's kinds of transformations.
  if (const auto* whole = dynamic_cast<const SoTransform*>(&node))
    return map_of(*whole, whole->scaleFactor);
  if (const auto* move = dynamic_cast<const SoTranslation*>(&node))
    map.translate(written(move->translation.getValue()));
  if (const auto* scale = dynamic_cast<const SoScale*>(&node))
    map.scale(written(scale->scaleFactor.getValue()));
  if (const auto* turn = dynamic_cast<const SoRotation*>(&node))
    map.rotate(written(turn->rotation.getValue()));
  if (const auto* turn = dynamic_cast<const SoRotationXYZ*>(&node))
    map.rotate(Eigen::AngleAxisd(shortest_decimal(turn->angle.getValue()),
                                 Eigen::Vector3d::Unit(turn->axis.getValue())));
  // A general matrix, which Coin applies to row vectors.
  if (const auto* matrix = dynamic_cast<const SoMatrixTransform*>(&node)) {
    const SbMatrix& rows = matrix->matrix.getValue();  // p' = p M
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 3; ++k) map.matrix()(k, i) = shortest_decimal(rows[i][k]);
  }
  return map;
}

/// Returns whether Coin's own pose is the same, to its precision: unknown nodes may move things,
/// too.
bool agrees(const Eigen::Affine3d& ours, const SbMatrix& coin, double size) {
  // Relative error of some hundred roundings in single precision [1]
  constexpr double kPoseTolerance = 1e-5;
  Eigen::Matrix4d theirs;
  for (int i = 0; i < 4; ++i)
    // Coin's matrix acts on row vectors.
    for (int k = 0; k < 4; ++k) theirs(k, i) = coin[i][k];
  const Eigen::Matrix3d A = theirs.topLeftCorner<3, 3>();
  const Eigen::Vector3d p = theirs.topRightCorner<3, 1>();
  const double largest = A.cwiseAbs().maxCoeff();
  // An affine map, with equal linear part and translation.
  return theirs.row(3) == Eigen::RowVector4d(0, 0, 0, 1) &&
         (ours.linear() - A).cwiseAbs().maxCoeff() <= kPoseTolerance * largest &&
         (ours.translation() - p).norm() <= kPoseTolerance * (p.norm() + largest * size);
}

/// A whole sphere, box or cylinder at its own pose, where cylinders stand along y.
std::optional<ShapeSpec> primitive_of(const SoNode& node) {
  const auto number = [](const SoSFFloat& field) { return shortest_decimal(field.getValue()); };
  // Our cylinders stand along z.
  ShapeSpec solid;
  const auto along_y = [&](const SoSFFloat& radius, const SoSFFloat& height) {
    solid.kind = ShapeKind::kCylinder;
    solid.size = {number(radius), number(height), 0};
    solid.X_BS.R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    return solid;
  };
  // Each solid exists in Inventor and in VRML 2.0.
  if (const auto* ball = dynamic_cast<const SoSphere*>(&node)) {
    solid.size.x() = number(ball->radius);
  } else if (const auto* ball2 = dynamic_cast<const SoVRMLSphere*>(&node)) {
    solid.size.x() = number(ball2->radius);
  } else if (const auto* box = dynamic_cast<const SoCube*>(&node)) {
    solid.kind = ShapeKind::kBox;
    solid.size = {number(box->width), number(box->height), number(box->depth)};
  } else if (const auto* box2 = dynamic_cast<const SoVRMLBox*>(&node)) {
    solid.kind = ShapeKind::kBox;
    solid.size = written(box2->size.getValue());
  } else if (const auto* rod = dynamic_cast<const SoCylinder*>(&node)) {
    // A cylinder without a part is not a solid.
    if (rod->parts.getValue() != SoCylinder::ALL) return {};
    return along_y(rod->radius, rod->height);
  } else if (const auto* rod2 = dynamic_cast<const SoVRMLCylinder*>(&node)) {
    if (!rod2->top.getValue() || !rod2->bottom.getValue() || !rod2->side.getValue()) return {};
    return along_y(rod2->radius, rod2->height);
  } else {
    return {};
  }
  return solid;
}

/// Collects triangles during the walk through a scene. Few bytes may stand for many triangles, by
/// shapes that Coin divides and by nodes used in many places; 100,000 are always allowed.
struct Collector {
  TriangleSoup soup;
  std::size_t most;
  WrittenPlace place;
  std::optional<ShapeSpec> shape;  // whose triangles come next, if it is exact
  bool is_taken = false;           // whether one of its triangles has come
  bool all_exact = true;           // whether all triangles so far belong to soup.exact
};

Collector& collector(void* data) { return *static_cast<Collector*>(data); }

SoCallbackAction::Response open_place(void* data, SoCallbackAction* /*action*/,
                                      const SoNode* node) {
  collector(data).place.push();
  if (const auto* transform = dynamic_cast<const SoVRMLTransform*>(node))
    collector(data).place.multiply(map_of(*transform, transform->scale));
  return SoCallbackAction::CONTINUE;
}

SoCallbackAction::Response close_place(void* data, SoCallbackAction* /*action*/,
                                       const SoNode* /*node*/) {
  collector(data).place.pop();
  return SoCallbackAction::CONTINUE;
}

SoCallbackAction::Response move_place(void* data, SoCallbackAction* /*action*/,
                                      const SoNode* node) {
  collector(data).place.multiply(map_of_node(*node));
  return SoCallbackAction::CONTINUE;
}

SoCallbackAction::Response begin_shape(void* data, SoCallbackAction* action, const SoNode* node) {
  Collector& found = collector(data);
  found.is_taken = false;
  found.shape = primitive_of(*node);
  if (!found.shape) return SoCallbackAction::CONTINUE;
  // Exact only if our transforms are Coin's, and leave the solid what it is.
  const double size = found.shape->size.maxCoeff();
  const bool placed = agrees(found.place.top(), action->getModelMatrix(), size);
  found.shape = placed ? place_primitive(*found.shape, found.place.top()) : std::nullopt;
  return SoCallbackAction::CONTINUE;
}

/// Counts a shape with its first triangle: lines, points and texts have none.
void take_shape(Collector& found) {
  if (found.is_taken) return;
  found.is_taken = true;
  found.all_exact = found.all_exact && found.shape && found.soup.exact.size() < kMaxExact;
  if (found.all_exact) found.soup.exact.push_back(*found.shape);
}

void append_triangle(void* data, SoCallbackAction* action, const SoPrimitiveVertex* a,
                     const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  take_shape(collector(data));
  auto& soup = collector(data).soup;
  const std::size_t most = collector(data).most;
  if (soup.corners.size() >= 3 * most)
    throw InputError(fmt::format("this file stands for more than {} triangles", most));
  // Corners in the scene, turned over where the order is clockwise or mirrored.
  const SbMatrix& place = action->getModelMatrix();
  std::array<Eigen::Vector3d, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    SbVec3f p;
    place.multVecMatrix(std::array{a, b, c}[k]->getPoint(), p);
    corner[k] = {p[0], p[1], p[2]};
  }
  if (is_clockwise(*action) != (place.det3() < 0)) std::swap(corner[1], corner[2]);
  soup.corners.insert(soup.corners.end(), corner.begin(), corner.end());
}

SoSeparator* read_graph(const std::string& text, const std::string& path) {
  // Silence warnings, and keep the first error.
  std::string first_error;
  SoDebugError::setHandlerCallback(swallow, nullptr);
  SoReadError::setHandlerCallback(keep_first, &first_error);
  SoInput input;
  input.setBuffer(text.data(), text.size());
  SoSeparator* const graph = SoDB::readAll(&input);
  if (graph == nullptr || !first_error.empty()) refuse_file(path, first_error);
  graph->ref();
  return graph;
}

}  // namespace

TriangleSoup read_inventor_mesh(const std::string& path) {
  const std::string text = read_permitted_file(path);
  SoDB::init();
  forbid_opening_files();
  // Walk the scene with our stack of transforms.
  SoSeparator* const graph = read_graph(text, path);
  Collector found{{}, std::min(kMaxTriangles, 100'000 + text.size()), {}, {}};
  SoCallbackAction action;
  // Groups open and close a place; transformations move it.
  for (const SoType& group : {SoSeparator::getClassTypeId(), SoTransformSeparator::getClassTypeId(),
                              SoVRMLTransform::getClassTypeId()}) {
    action.addPreCallback(group, open_place, &found);
    action.addPostCallback(group, close_place, &found);
  }
  action.addPreCallback(SoTransformation::getClassTypeId(), move_place, &found);
  // Shapes, and the triangles into which Coin divides them.
  action.addPreCallback(SoShape::getClassTypeId(), begin_shape, &found);
  action.addTriangleCallback(SoShape::getClassTypeId(), append_triangle, &found);
  action.apply(graph);
  if (!found.all_exact) found.soup.exact.clear();
  return std::move(found.soup);
}

}  // namespace thenar

#endif
