// The one fence of Coin.

#include "data/io/foreign_mesh/inventor_mesh.h"

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
#include <regex>
#include <utility>

#include <Inventor/SbMatrix.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/fields/SoSFBool.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoShapeHints.h>

#include "data/io/foreign_mesh/one_folder.h"

namespace thenar {
namespace {

/// The first error of reading that Coin tells, into a std::string. Textures that are not there are
/// none: a surface has no need of them.
void keep_first(const SoError* error, void* first) {
  const std::string said = error->getDebugString().getString();
  std::string& kept = *static_cast<std::string*>(first);
  if (kept.empty() && said.find("texture file") == std::string::npos) kept = said;
}

void swallow(const SoError* /*error*/, void* /*data*/) {}

/// Coin says "Coin read error: WHAT\n\tOccurred at line N in FILE".
[[noreturn]] void fail(const std::string& path, const std::string& said) {
  std::smatch found;
  const bool has_line = std::regex_search(said, found, std::regex("line +([0-9]+)"));
  const int line = has_line ? std::stoi(found[1]) : 1;
  std::string what = said.substr(0, said.find('\n'));
  const std::string prefix = "Coin read error: ";
  if (what.rfind(prefix, 0) == 0) what.erase(0, prefix.size());
  throw DataError(path, line, what.empty() ? "is neither VRML nor Inventor" : what);
}

/// Faces of VRML 2.0 say so themselves, others by what stands before them.
bool is_clockwise(SoCallbackAction& action) {
  const SoNode* shape = action.getCurPathTail();
  const SoField* counterclockwise = shape->getField("ccw");
  if (counterclockwise != nullptr && counterclockwise->isOfType(SoSFBool::getClassTypeId()))
    return !static_cast<const SoSFBool*>(counterclockwise)->getValue();
  return action.getVertexOrdering() == SoShapeHints::CLOCKWISE;
}

/// Triangles as they come. Few bytes may stand for many, by shapes that Coin divides and by nodes
/// used in many places; 100,000 are few enough.
struct Collector {
  TriangleSoup soup;
  std::size_t most;
};

void append_triangle(void* data, SoCallbackAction* action, const SoPrimitiveVertex* a,
                     const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  auto& [soup, most] = *static_cast<Collector*>(data);
  if (soup.corners.size() >= 3 * most)
    throw InputError(fmt::format("this file stands for more than {} triangles", most));
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
  std::string first_error;
  SoDebugError::setHandlerCallback(swallow, nullptr);
  SoReadError::setHandlerCallback(keep_first, &first_error);
  SoInput input;
  input.setBuffer(text.data(), text.size());
  SoSeparator* const graph = SoDB::readAll(&input);
  if (graph == nullptr || !first_error.empty()) fail(path, first_error);
  graph->ref();
  return graph;
}

}  // namespace

TriangleSoup read_inventor_mesh(const std::string& path) {
  const std::string text = read_one(path);
  SoDB::init();
  open_nothing();
  SoSeparator* const graph = read_graph(text, path);
  Collector found{{}, std::min(kMostTriangles, 100'000 + text.size())};
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), append_triangle, &found);
  action.apply(graph);
  return std::move(found.soup);
}

}  // namespace thenar

#endif
