#include "api/scenes/read_scene_run.h"

#include <cmath>
#include <filesystem>

#include "api/named/data_folders.h"
#include "api/named/worlds.h"
#include "api/scenes/write_scene_run.h"
#include "base/error.h"
#include "base/outside_path.h"
#include "base/progress_parts.h"
#include "base/rung_names.h"
#include "data/io/result_layout.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

using Eigen::Index;

constexpr double kSamePlace = 1e-6;   // largest difference of a body's place from the file [m]
constexpr double kUnitLength = 1e-6;  // largest deviation of a quaternion's length from 1 [1]

/// Reader of one file of a scene run.
class RunReader {
 public:
  RunReader(const std::string& path, const std::string& data)
      : path_(path), data_(data), file_(read_result(path)) {}

  RecordedScene read() {
    const std::string format = file_.text_or_none("format");
    if (format != kSceneRunFormat)
      fail(fmt::format("wanted a run of a scene ('{}'), got '{}'", kSceneRunFormat, format));
    if (file_.texts.count("varied") > 0)
      fail("it holds several runs, with numbers that vary: wanted one run");
    out_.name = file_.text("scene");
    rebuild();
    read_instants();
    read_contacts();
    read_muscles();
    read_quality();
    compare_places();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, 1, what); }

  Eigen::MatrixXd table(const std::string& key, Index rows, Index columns) const {
    return finite_matrix(file_, path_, key, rows, columns);
  }

  // ---- the scene

  /// A path that the file states, which may be one of another machine.
  [[nodiscard]] std::string recorded_path(const char* key) const {
    return outside_path(file_.text_or_none(key), OutsideUse::kRead);
  }

  /// Returns possible original folders of the scene.
  [[nodiscard]] std::vector<std::string> folders(const std::string& scene) const {
    std::vector<std::string> out;
    const fs::path from = recorded_path("provenance/folder");
    out.push_back((from / scene).lexically_normal().parent_path().string());
    for (const std::string& place : data_folders(data_))
      out.push_back((fs::path(place) / "scenes").string());
    out.push_back(fs::path(path_).parent_path().string());
    return out;
  }

  /// Rung of tendon paths of human hands that the scene leaves open. Older files name none: their
  /// tendons ran straight.
  [[nodiscard]] std::optional<Path> path_asked() const {
    const std::string name = file_.text_or_none("rungs/path");
    if (name.empty()) return Path::kViaPoint;
    if (name == kSubjectsPaths) return {};
    return path_named(name);
  }

  void rebuild() {
    // The scene may have moved since: look where it was, then where the data are.
    const std::string scene = recorded_path("inputs/1/path");
    const std::string text = file_.text_or_none("inputs/1/text");
    if (text.empty()) fail("it does not keep the text of its scene");
    std::string first;
    for (const std::string& folder : folders(scene)) {
      std::error_code none;
      if (!fs::is_directory(folder.empty() ? "." : folder, none)) continue;
      // Runs on pins have fewer coordinates than the scene states.
      for (const bool on_pins : {false, true}) {
        try {
          if (build_from(text, (fs::path(folder) / fs::path(scene).filename()).string(), on_pins))
            return;
          if (first.empty()) first = "its bodies are not those of its scene";
        } catch (const Stopped&) {
          throw;
        } catch (const Error& error) {
          if (first.empty()) first = error.what();
        }
      }
    }
    fail(fmt::format("its scene cannot be built again: {}", first.empty() ? "no folder" : first));
  }

  /// @return whether the bodies are those of the file
  bool build_from(const std::string& text, const std::string& scene, bool on_pins) {
    // Compliances become pins if the run was made so.
    SceneSpec spec =
        parse_scene(text, scene, data_for(fs::path(scene).parent_path().string(), data_));
    if (on_pins && spec.compliances.empty()) return false;
    if (on_pins) spec.compliances.clear();
    // Rungs of pads change no body; this one needs no file but the scene's.
    for (ScenePadSpec& pad : spec.pads) pad.rung = "hard-point";
    out_.path = path_asked();
    BuiltScene built = build_scene(spec, hands_of_scene(spec, data_, spec.files, out_.path));
    // The same bodies in the same order, or it is another scene.
    const std::vector<std::string>& names = file_.list("name/body");
    const std::vector<MechanismBody>& bodies = built.scene.mechanism.bodies;
    if (names.size() != bodies.size()) return false;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] != bodies[i].name) return false;
    out_.warnings = built.warnings;
    out_.camera = spec.camera;
    out_.built = std::move(built);
    return true;
  }

  // ---- instants

  void read_instants() {
    const MovingScene& scene = out_.built.scene;
    // One row for each instant; all tables have as many.
    const Eigen::VectorXd time = vector_in(file_, "time");
    const Index count = time.size();
    // A scene without positions has no columns of them in the file.
    const Eigen::MatrixXd q =
        scene.q.size() > 0 ? table("position", count, scene.q.size()) : Eigen::MatrixXd(count, 0);
    const Eigen::MatrixXd v =
        scene.v.size() > 0 ? table("speed", count, scene.v.size()) : Eigen::MatrixXd(count, 0);
    const Eigen::MatrixXd energy = table("energy", count, 3);
    for (Index i = 0; i < count; ++i) {
      SceneSample sample;
      sample.t = time(i);
      if (i > 0 && !(sample.t > out_.samples.back().t)) fail("'time' does not rise");
      sample.q = q.row(i);
      sample.v = v.row(i);
      sample.energy.kinetic = energy(i, 0);
      sample.energy.weight = energy(i, 1);
      sample.energy.springs = energy(i, 2);
      check_quaternions(sample.q);
      out_.samples.push_back(std::move(sample));
    }
  }

  void check_quaternions(const Eigen::VectorXd& q) const {
    const Mechanism& mechanism = out_.built.scene.mechanism;
    const MechanismLayout layout = layout_of(mechanism);
    for (const int i : layout.quaternion_joints)
      if (std::abs(q.segment<4>(layout.first_q[i]).norm() - 1) > kUnitLength)
        fail(fmt::format("'position': the rotation of '{}' has not length 1",
                         mechanism.bodies[i].name));
  }

  void read_contacts() {
    if (file_.arrays.count("contact_instant") == 0) return;
    // Read the contacts of all instants from one table, with the index of their instants.
    const Index count = vector_in(file_, "contact_instant").size();
    const auto column = [&](const char* key) { return table(key, count, 1); };
    const auto vectors = [&](const char* key) { return table(key, count, 3); };
    const Eigen::MatrixXd instant = column("contact_instant"), a = column("contact_body_a"),
                          b = column("contact_body_b"), id = column("contact_id"),
                          mode = column("contact_mode"), gap = column("contact_gap"),
                          torsion = column("contact_torsion"), point = vectors("contact_point"),
                          normal = vectors("contact_normal"), force = vectors("contact_force"),
                          area = column("contact_area"), stick = column("contact_stick");
    const auto bodies = static_cast<double>(out_.built.scene.mechanism.bodies.size());
    // Indices of a file are checked before they are used as such.
    const auto index = [&](double value, double below, const char* what) {
      if (!(value >= 0 && value < below && value == std::floor(value)))
        fail(fmt::format("'{}': wanted whole numbers from 0 and below {}, got {}", what, below,
                         value));
      return static_cast<std::size_t>(value);
    };
    // Put each contact to the instant that it belongs to.
    for (Index k = 0; k < count; ++k) {
      ContactSample contact;
      contact.a = static_cast<int>(index(a(k), bodies, "contact_body_a"));
      contact.b = static_cast<int>(index(b(k), bodies, "contact_body_b"));
      contact.id = static_cast<int>(std::min(std::max(id(k), -1e9), 1e9));
      contact.point = point.row(k);
      contact.normal = normal.row(k);
      contact.force = force.row(k);
      contact.torsion = torsion(k);
      contact.gap = gap(k);
      contact.mode =
          kContactModeNames[index(mode(k), kContactModeNames.size(), "contact_mode")].value;
      contact.area = area(k);
      contact.stick = stick(k);
      const auto samples = static_cast<double>(out_.samples.size());
      out_.samples[index(instant(k), samples, "contact_instant")].contacts.push_back(contact);
    }
  }

  void read_muscles() {
    if (file_.texts.count("name/muscle") == 0 || file_.arrays.count("tension") == 0) return;
    out_.muscles = file_.list("name/muscle");
    out_.tension = table("tension", static_cast<Index>(out_.samples.size()),
                         static_cast<Index>(out_.muscles.size()));
  }

  void read_quality() {
    // Numbers that older files lack are taken for zero.
    const auto number = [&](const char* key) {
      return file_.arrays.count(key) > 0 ? file_.number(key) : 0;
    };
    const auto count = [&](const char* key) {
      return static_cast<long>(std::min(std::max(number(key), 0.0), 1e15));
    };
    out_.steps = count("steps");
    out_.unsolved = count("unsolved");
    out_.worst_residual = number("worst_residual");
    out_.deepest = number("deepest");
    // Energy balances only where the method keeps account of it.
    if (file_.arrays.count("energy_turned_over") > 0) {
      out_.balance.emplace();
      out_.balance->error = number("energy_error");
      out_.balance->turned_over = number("energy_turned_over");
    }
    read_limits();
    const std::string status = file_.text_or_none("status");
    if (status != "done") out_.warnings.push_back(fmt::format("the run ended so: {}", status));
  }

  void read_limits() {
    if (file_.arrays.count("limit_beyond") == 0) return;
    const std::vector<std::string> names = file_.list("name/limit");
    const auto count = static_cast<Index>(names.size());
    const Eigen::MatrixXd beyond = table("limit_beyond", count, 1);
    const Eigen::MatrixXd slides = table("limit_slides", count, 1);
    for (Index i = 0; i < count; ++i)
      out_.limits.push_back({names[static_cast<std::size_t>(i)], slides(i) > 0, beyond(i)});
  }

  /// Holds places of bodies against those of the file.
  void compare_places() const {
    const Mechanism& mechanism = out_.built.scene.mechanism;
    const std::size_t bodies = mechanism.bodies.size();
    const std::vector<double>& places = file_.arrays.at("body_position").values;
    // Pose the first and the last instant, and compare with the places in the file.
    const TreeModel model = tree_model(mechanism);
    TreeMotion<double> motion(model);
    for (const std::size_t i : {std::size_t{0}, out_.samples.size() - 1}) {
      motion.set_position(out_.samples[i].q);
      for (std::size_t b = 0; b < bodies; ++b) {
        const Eigen::Map<const Eigen::Vector3d> there(places.data() + 3 * (i * bodies + b));
        if (!((motion.pose(static_cast<int>(b)).p - there).norm() <= kSamePlace))
          fail(
              fmt::format("'{}' is elsewhere now: what the scene is built from has changed since "
                          "the run was made",
                          mechanism.bodies[b].name));
      }
    }
  }

  const std::string& path_;
  const std::string& data_;
  ResultFile file_;
  RecordedScene out_;
};

}  // namespace

RecordedScene read_scene_run(const std::string& path, const std::string& data) {
  return RunReader(path, data).read();
}

}  // namespace thenar
