#include "api/read_motion.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "api/named/digits.h"
#include "api/simulate.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/result_layout.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

using Eigen::Index;

constexpr double kSameTip = 1e-6;  // Largest distance of a tip from its place in the file [m]
constexpr double kMaxRecordedAngle = 10;  // Largest angle of a joint [rad]
constexpr double kNoPull = 1e-6;          // Largest tension that rounding made negative [N]

// Rungs of the two ladders
constexpr std::array kPathRungs{Path::kConstant, Path::kViaPoint, Path::kFitted, Path::kWrapped};
constexpr std::array kHoodRungs{Hood::kSeparate, Hood::kFractions, Hood::kFloatingNet};

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(", ", from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 2;
  }
  return parts;
}

/// The rung of a ladder that explain() calls so; nothing: none.
template <typename Rungs>
auto rung_called(const Rungs& rungs, std::size_t ladder, const std::string& name)
    -> std::optional<typename Rungs::value_type> {
  for (const auto rung : rungs)
    if (explain(Fidelity(rung))[ladder].rung == name) return rung;
  return {};
}

/// Reader of one file of a motion.
class MotionReader {
 public:
  explicit MotionReader(const std::string& path) : path_(path), file_(read_result(path)) {}

  RecordedDigit read() {
    const std::string format = file_.text_or_none("format");
    if (format != kMotionFormat)
      fail(fmt::format("wanted a motion of a digit ('{}'), got '{}'", kMotionFormat, format));
    try {
      // Build the digit again, since the file keeps its inputs rather than its geometry.
      build();
    } catch (const Error& error) {
      fail(fmt::format("its digit cannot be built again: {}", error.what()));
    }
    // Compare names and tip places: another build of the digit would show a wrong motion.
    compare_names();
    read_instants();
    compare_tips();
    tell_outcome();
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, 1, what); }

  // ---- the digit

  [[nodiscard]] TendonOptions rungs() const {
    TendonOptions rungs;
    std::string path = file_.text_or_none("rungs/path"), hood = file_.text_or_none("rungs/hood");
    const bool named = !path.empty();
    if (!named) {
      // Use the rungs of an older file: a digit with constant arms alone determines them itself.
      const std::vector<std::string> built = parts_of(file_.text_or_none("provenance/fidelity"));
      require(built.size() > kHoodLadder, "it does not say on which rungs");
      path = built[kPathLadder];
      hood = built[kHoodLadder];
    }
    const auto path_rung = rung_called(kPathRungs, kPathLadder, path);
    // Words of the file become rungs; unknown words are of a later version.
    const auto hood_rung = rung_called(kHoodRungs, kHoodLadder, hood);
    require(path_rung && hood_rung, "there are no rungs '{}' and '{}'", path, hood);
    rungs.path = !named && *path_rung == Path::kConstant ? Path::kViaPoint : *path_rung;
    rungs.hood = *hood_rung;
    if (file_.text_or_none("rungs/wrist") == "free") rungs.wrist_mode = WristMode::kFree;
    // Frozen joints are part of the digit, with the angles at which they were frozen.
    if (file_.texts.count("name/frozen") == 0) return rungs;
    const std::vector<std::string>& joints = file_.list("name/frozen");
    const Eigen::MatrixXd angles =
        table("rungs/frozen_angle", static_cast<Index>(joints.size()), 1);
    for (std::size_t i = 0; i < joints.size(); ++i)
      rungs.frozen[joints[i]] = angles(static_cast<Index>(i));
    return rungs;
  }

  void build() {
    const std::string text = file_.text_or_none("inputs/1/text");
    require(!text.empty(), "it does not keep the text of its subject");
    // Older files say nothing of passive moments: none were counted.
    out_.subject = with_passive(
        parse_subject(text, file_.text_or_none("inputs/1/path")),
        file_.text_or_none("rungs/passive") == "on" ? PassiveMoments::kOn : PassiveMoments::kOff);
    out_.digit = choose_digit(out_.subject, file_.text("digit"));
    // Without a net the subject alone builds the digit.
    const TendonOptions options = rungs();
    if (options.hood != Hood::kFloatingNet) {
      out_.tendons = build_digit_tendons(out_.subject, out_.digit, options);
      return;
    }
    // A net is built from the text that the file keeps.
    const std::string net = file_.text_or_none("inputs/2/text");
    require(!net.empty(), "it does not keep the text of its net");
    const NetDescription description = parse_net(net, file_.text_or_none("inputs/2/path"));
    out_.tendons = build_digit_tendons(out_.subject, out_.digit, options, &description);
  }

  void compare_names() const {
    const TendonNames& names = out_.tendons->digit().names;
    const auto compare = [&](const char* key, const std::vector<std::string>& now) {
      const std::vector<std::string>& then = file_.list(key);
      if (then != now)
        fail(fmt::format("'{}': its digit has {} now, in the file {}", key, listed(now),
                         listed(then)));
    };
    try {
      compare("name/joint", names.coordinates);
      compare("name/muscle", names.muscles);
    } catch (const InputError& error) {
      fail(error.what());
    }
  }

  // ---- instants

  [[nodiscard]] Eigen::MatrixXd table(const std::string& key, Index rows, Index columns) const {
    return finite_matrix(file_, path_, key, rows, columns);
  }

  void read_instants() {
    const TendonNames& names = out_.tendons->digit().names;
    const auto joints = static_cast<Index>(names.coordinates.size());
    const auto muscles = static_cast<Index>(names.muscles.size());
    // Time has to rise, and every table has one row for each instant.
    out_.time = vector_in(file_, "time");
    const Index count = out_.time.size();
    for (Index i = 1; i < count; ++i)
      if (!(out_.time[i] > out_.time[i - 1])) fail("'time' does not rise");
    out_.angle = table("angle", count, joints);
    out_.speed = table("speed", count, joints);
    out_.activation = table("activation", count, muscles);
    out_.tension = table("tension", count, muscles);
    out_.energy = table("energy", count, 1);
    out_.work = table("work", count, 1);
    out_.dissipated = table("lost", count, 1);
    // Refuse values that no digit has, which a damaged file may hold.
    if ((out_.angle.array().abs() > kMaxRecordedAngle).any())
      fail(fmt::format("'angle': wanted up to {} rad", kMaxRecordedAngle));
    if ((out_.tension.array() < -kNoPull).any() || (out_.tension.array() > kMaxTension).any())
      fail(fmt::format("'tension': wanted 0 to {} N", kMaxTension));
    out_.tension = out_.tension.cwiseMax(0);
  }

  /// Holds the tip against that of the file.
  void compare_tips() const {
    const TendonModel<double>& model = out_.tendons->digit().model;
    const Eigen::MatrixXd tip = table("tip", out_.time.size(), 3);
    for (Index i = 0; i < out_.time.size(); ++i) {
      const Eigen::VectorXd q = out_.angle.row(i);
      const Eigen::Vector3d now = moved(pose_tree(model.tree, q), model.tip_link, model.tip);
      if (!((now - tip.row(i).transpose()).norm() <= kSameTip))
        fail(
            fmt::format("at {} s the tip of its digit is {:.3g} mm from where it was: it is not "
                        "the digit of the motion, as where joints were frozen",
                        out_.time[i], 1e3 * (now - tip.row(i).transpose()).norm()));
    }
  }

  void tell_outcome() {
    const std::string status = file_.text_or_none("status"),
                      trouble = file_.text_or_none("trouble");
    if (status != "done") out_.warnings.push_back(fmt::format("the motion ended so: {}", status));
    if (!trouble.empty()) out_.warnings.push_back(trouble);
  }

  const std::string& path_;
  ResultFile file_;
  RecordedDigit out_;
};

}  // namespace

RecordedDigit read_motion(const std::string& path) { return MotionReader(path).read(); }

}  // namespace thenar
