// The one fence of Coin.

#include "data/io/mesh/inventor_mesh.h"

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

#include <array>
#include <mutex>
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

namespace thenar {
namespace {

/// Keeps what Coin would print while it reads.
class Silence {
 public:
  Silence()
      : debug_(SoDebugError::getHandlerCallback()),
        debug_data_(SoDebugError::getHandlerData()),
        read_(SoReadError::getHandlerCallback()),
        read_data_(SoReadError::getHandlerData()) {
    SoDebugError::setHandlerCallback(swallow, nullptr);
    SoReadError::setHandlerCallback(keep, this);
  }
  ~Silence() {
    SoDebugError::setHandlerCallback(debug_, debug_data_);
    SoReadError::setHandlerCallback(read_, read_data_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  static void swallow(const SoError* /*error*/, void* /*data*/) {}
  static void keep(const SoError* error, void* data) {
    std::string& first = static_cast<Silence*>(data)->first_;
    if (first.empty()) first = error->getDebugString().getString();
  }

  SoErrorCB* debug_;
  void* debug_data_;
  SoErrorCB* read_;
  void* read_data_;
  std::string first_;
};

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

void append_triangle(void* soup, SoCallbackAction* action, const SoPrimitiveVertex* a,
                     const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  const SbMatrix& place = action->getModelMatrix();
  std::array<Eigen::Vector3d, 3> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    SbVec3f p;
    place.multVecMatrix(std::array{a, b, c}[k]->getPoint(), p);
    corner[k] = {p[0], p[1], p[2]};
  }
  if (is_clockwise(*action) != (place.det3() < 0)) std::swap(corner[1], corner[2]);
  auto& corners = static_cast<TriangleSoup*>(soup)->corners;
  corners.insert(corners.end(), corner.begin(), corner.end());
}

SoSeparator* read_graph(const std::string& path) {
  const Silence silence;
  SoInput input;
  SoSeparator* graph = nullptr;
  if (input.openFile(path.c_str(), TRUE)) graph = SoDB::readAll(&input);
  if (graph != nullptr) graph->ref();
  if (graph == nullptr || !silence.first().empty()) {
    if (graph != nullptr) graph->unref();
    fail(path, silence.first());
  }
  return graph;
}

}  // namespace

TriangleSoup read_inventor_mesh(const std::string& path) {
  static std::mutex one_at_a_time;  // Coin's error handlers and node types are global
  const std::lock_guard lock(one_at_a_time);
  if (!SoDB::isInitialized()) SoDB::init();

  SoSeparator* graph = read_graph(path);
  TriangleSoup soup;
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), append_triangle, &soup);
  action.apply(graph);
  graph->unref();
  return soup;
}

}  // namespace thenar

#endif
