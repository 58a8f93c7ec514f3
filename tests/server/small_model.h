#pragma once

/// A tetrahedron that slides up and down, with a line, an arrow and a contact: a model that tests
/// of the server can move, undo and play.

#include <memory>
#include <string>

#include "base/error.h"
#include "live/live_abilities.h"
#include "live/live_picture.h"
#include "server/method.h"
#include "server/session.h"

namespace thenar {

/// Corners at the origin and at 1, 2, 3 [m] on the axes.
inline std::shared_ptr<const TriangleMesh> tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3;
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

class SmallModel final : public LiveModel, public LiveEdits, public LiveClock {
 public:
  SmallModel() {
    LiveBody body;
    body.name = "box";
    body.owner = "box";
    body.mesh = tetrahedron();
    LiveBody hidden;
    hidden.name = "frame";
    shape_.bodies = {body, hidden};
    LiveJoint joint;
    joint.name = "lift";
    joint.body = 0;
    joint.slides = true;
    joint.upper = 0.5;
    shape_.joints = {joint};
    LiveLine line;
    line.name = "FDP";
    line.points = 2;
    shape_.lines = {line};
    shape_.arrows = {{"push", LiveArrowKind::kMoment}};
    shape_.clouds = {{"axes", 0, {{0, 0, 0}, {1, 2, 3}}}};
  }

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  [[nodiscard]] LiveInstant instant() const override {
    LiveInstant now;
    now.time = t_;
    now.bodies.resize(2);
    now.bodies[0].p.z() = height_;
    now.bodies[0].R = rotation_about<double>({0, 0, 1}, 1.0);
    now.joints = {height_};
    now.line_points = {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3 + height_}};
    now.tensions = {12.5};
    now.arrows = {{{1, 2, 3}, {4, 5, 6}}};
    LiveContact contact;
    contact.a = 0;
    contact.force = {0, 0, 7};
    contact.friction = 0.4;
    now.contacts = {contact};
    return now;
  }
  [[nodiscard]] unsigned long shape_changes() const override { return shape_changes_; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

  [[nodiscard]] LiveEditState edit_state() const override {
    LiveEditState state;
    state.name = "small";
    state.unsaved = height_ != 0;
    if (height_ != 0) state.undo = "lift";
    return state;
  }
  std::string undo() override {
    require(height_ != 0, "nothing to undo");
    lift(0);
    return "lift";
  }
  std::string redo() override { throw InputError("nothing to redo"); }

  [[nodiscard]] LiveTime live_time() const override {
    LiveTime time;
    time.t = t_;
    time.step = 1e-3;
    time.playing = playing;
    return time;
  }

  void pause() override { playing = false; }

  void lift(double height) {
    height_ = height;
    ++changes_;
  }
  void step(long steps) {
    t_ += 1e-3 * static_cast<double>(steps);
    ++changes_;
  }
  void rename(const std::string& name) {
    shape_.bodies[0].name = name;
    ++shape_changes_;
    ++changes_;
  }

  bool playing = false;

 private:
  LiveShape shape_;
  double height_ = 0, t_ = 0;  // [m], [s]
  unsigned long shape_changes_ = 0, changes_ = 0;
};

/// small.open {playing}, small.lift {height}, small.wait {}, motion.step, motion.pause.
inline MethodTable small_table() {
  MethodTable table;
  const auto model = [](Session& session) -> SmallModel& {
    return session.model<SmallModel>(LiveMode::kMotion);
  };
  table.add({"small.open", "Opens.",
             object_schema({{"playing", flag_schema(), "At once.", false, false}}), "nothing", "{}",
             [](Session& session, const Json& params, const Progress&) -> OrderedJson {
               auto opened = std::make_shared<SmallModel>();
               opened->playing = params["playing"].get<bool>();
               session.open(LiveMode::kMotion, opened);
               return OrderedJson::object();
             }});
  table.add({"small.lift", "Lifts.",
             object_schema({{"height", number_schema("m", 0, 0.5), "How high.", true, nullptr}}),
             "height [m]", R"({"height": 0.1})",
             [model](Session& session, const Json& params, const Progress&) -> OrderedJson {
               model(session).lift(params["height"].get<double>());
               return {{"height", params["height"]}};
             }});
  table.add({"small.wait", "Waits until it is asked to stop.", object_schema({}), "asked", "{}",
             [](Session&, const Json&, const Progress& progress) -> OrderedJson {
               long asked = 1;
               while (!progress.stop()) {
                 progress(0.5, "waiting");
                 ++asked;
               }
               return {{"asked", asked}};
             }});
  table.add({"motion.step", "Steps.",
             object_schema({{"steps", integer_schema(1, 1000), "How many.", false, 1},
                            {"want", list_schema(text_schema(), 0, 4), "What."}}),
             "nothing", "{}",
             [model](Session& session, const Json& params, const Progress&) -> OrderedJson {
               model(session).step(params["steps"].get<long>());
               return OrderedJson::object();
             }});
  table.add({"motion.pause", "Pauses.", object_schema({}), "nothing", "{}",
             [model](Session& session, const Json&, const Progress&) -> OrderedJson {
               model(session).playing = false;
               return OrderedJson::object();
             }});
  return table;
}

}  // namespace thenar
