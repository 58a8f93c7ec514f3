#include "studies/thumb/thumb_types.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"
#include "base/parallel_for.h"
#include "base/random_stream.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kDrawnAxesStream = 231;  // Purpose of the random stream of drawn axes
constexpr int kBatchDraws = 500;                 // Draws between two reports of progress

/// Half a turn about z, on the right of a pose.
Pose<double> half_turned(const Pose<double>& pose) {
  Pose<double> out = pose;
  out.R.col(0) *= -1;
  out.R.col(1) *= -1;
  return out;
}

/// Angle in -pi .. pi.
double within_half_turn(double angle) { return std::remainder(angle, 2 * kPi); }

/// Member of a list by its name, as every list of a subject has them.
template <typename Items>
const typename Items::value_type& named_item(const Items& items, const std::string& name,
                                             const char* what) {
  const auto* found = find_named(items, name);
  require(found != nullptr, "the mean thumb needs a {} '{}'", what, name);
  return *found;
}

int axis_number(const std::vector<AxisVariability>& axes, const std::string& joint) {
  const int place = place_in(transformed(axes, &AxisVariability::joint), joint);
  require(place >= 0, "the types of thumbs need an [[axis]] of joint '{}'", joint);
  return place;
}

/// Direction of the digit at its tip, reference posture.
Vector3d direction_of(const Pose<double>& tip, DigitDirection direction) {
  switch (direction) {
    case DigitDirection::kDistal:
      return -tip.R.col(0);
    case DigitDirection::kDorsal:
      return tip.R.col(1);
    case DigitDirection::kRadial:
      return tip.R.col(2);
  }
  return Vector3d::Zero();
}

/// One draw, reduced to what is counted.
struct ThumbDraw {
  ThumbType type;
  std::vector<DhRow> rows;
  std::vector<std::array<bool, 3>> normals;  // of successive axes: distal, dorsal, radial
};

ThumbDraw measure_thumb(const MeanThumb& mean, const std::vector<AxisLine>& axes) {
  // Axes become Denavit-Hartenberg rows with normals that point outwards, so that types can be
  // compared.
  ThumbDraw draw{
      classify_thumb(mean, axes), with_normals_outwards(dh_from_axes(axes, mean.tip)).rows, {}};
  for (std::size_t i = 0; i + 1 < axes.size(); ++i) {
    // Which way the common normal points, in all three directions.
    std::array<bool, 3> toward{};
    for (std::size_t k = 0; k < 3; ++k)
      toward[k] = normal_component(axes[i], axes[i + 1],
                                   direction_of(mean.tip, static_cast<DigitDirection>(k))) > 0;
    draw.normals.push_back(toward);
  }
  return draw;
}

double sd_of(const std::vector<double>& deviations) {
  double sum = 0;
  for (const double deviation : deviations) sum += deviation * deviation;
  return std::sqrt(sum / std::max(1.0, static_cast<double>(deviations.size()) - 1));
}

struct MeanAndSd {
  double mean, sd;
};

MeanAndSd of_lengths(std::vector<double> values) {
  double mean = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (double& value : values) value -= mean;
  return {mean, sd_of(values)};
}

MeanAndSd of_angles(std::vector<double> values) {
  std::complex<double> sum = 0;
  for (const double value : values) sum += std::polar(1.0, value);
  const double mean = std::arg(sum);
  for (double& value : values) value = within_half_turn(value - mean);
  return {mean, sd_of(values)};
}

/// Statistics of row i over the draws of one type.
DhStatistics row_statistics(const std::vector<const ThumbDraw*>& draws, std::size_t i) {
  // Angles need circular means, lengths do not.
  const auto collect = [&](double DhRow::*member) {
    return transformed(draws, [&](const ThumbDraw* draw) { return draw->rows[i].*member; });
  };
  DhStatistics out;
  for (double DhRow::*angle : {&DhRow::theta, &DhRow::alpha}) {
    const MeanAndSd found = of_angles(collect(angle));
    out.mean.*angle = found.mean;
    out.sd.*angle = found.sd;
  }
  for (double DhRow::*length : {&DhRow::d, &DhRow::a}) {
    const MeanAndSd found = of_lengths(collect(length));
    out.mean.*length = found.mean;
    out.sd.*length = found.sd;
  }
  return out;
}

ThumbTypeShare share_of(const std::vector<ThumbDraw>& draws, const ThumbType& type) {
  std::vector<const ThumbDraw*> members;
  for (const ThumbDraw& draw : draws)
    if (draw.type.index() == type.index()) members.push_back(&draw);
  // Parameters of a type that was drawn.
  ThumbTypeShare out{type, static_cast<int>(members.size()), {}};
  for (std::size_t i = 0; !members.empty() && i < members.front()->rows.size(); ++i)
    out.rows.push_back(row_statistics(members, i));
  return out;
}

std::vector<NormalShares> normal_shares(const MeanThumb& mean,
                                        const std::vector<ThumbDraw>& draws) {
  std::vector<NormalShares> out;
  for (std::size_t i = 0; i + 1 < mean.axes.size(); ++i) {
    NormalShares shares{mean.spread[i].joint, mean.spread[i + 1].joint, {}};
    for (std::size_t k = 0; k < 3; ++k)
      shares.toward[k] = static_cast<double>(std::count_if(
                             draws.begin(), draws.end(),
                             [&](const ThumbDraw& draw) { return draw.normals[i][k]; })) /
                         static_cast<double>(draws.size());
    out.push_back(shares);
  }
  return out;
}

/// Closed form of the order at the MCP joint for places along the bone alone.
double flexion_distal_by_places(const MeanThumb& mean) {
  const auto f = static_cast<std::size_t>(mean.mcp_flexion);
  const auto a = static_cast<std::size_t>(mean.mcp_abduction);
  const double ahead = mean.along[f].dot(mean.axes[f].point - mean.axes[a].point);
  const double sd = std::hypot(mean.spread[f].along_sd, mean.spread[a].along_sd);
  if (sd == 0) return ahead > 0 ? 1 : 0;
  return 0.5 * std::erfc(-ahead / (sd * std::sqrt(2.0)));
}

}  // namespace

DhChain with_normals_outwards(const DhChain& chain) {
  DhChain out = chain;
  // A negative a is the same chain with the normal the other way round.
  const std::size_t n = out.rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    DhRow& row = out.rows[i];
    if (row.a >= 0) continue;
    // The frame behind this row turns by half a turn about its z; what follows turns back.
    row.a = -row.a;
    row.alpha = -row.alpha;
    if (i + 1 < n)
      out.rows[i + 1].theta = within_half_turn(out.rows[i + 1].theta - kPi);
    else
      out.tool = half_turned(Pose<double>{}) * out.tool;
    // Row 1 has theta in the base.
    if (i == 0)
      out.base = half_turned(out.base);
    else
      row.theta = within_half_turn(row.theta + kPi);
  }
  return out;
}

MeanThumb mean_thumb(const DigitVariability& variability, const Subject& subject) {
  MeanThumb mean;
  mean.spread = variability.axes;
  for (const AxisVariability& spread : mean.spread) {
    // The axis, its place moved along its bone.
    const JointAxis& joint = named_item(subject.joints, spread.joint, "joint");
    const JointAxis& beside = named_item(subject.joints, spread.beside, "joint");
    const Segment& bone = named_item(subject.segments, spread.bone, "segment");
    const Vector3d along = (bone.distal - bone.proximal).normalized();
    require(along.allFinite() && along.norm() > 0.5, "bone '{}' of the mean thumb has no length",
            spread.bone);
    mean.along.push_back(along);
    mean.axes.push_back({beside.point + spread.along * along, joint.direction.normalized()});
  }
  // Where the thumb ends.
  const Digit& thumb = named_item(subject.digits, "thumb", "digit");
  mean.tip.R << thumb.proximal, thumb.dorsal, thumb.radial;
  mean.tip.p = thumb.tip;
  // Find the axes on which the criteria are decided.
  mean.mcp_flexion = axis_number(mean.spread, "MCP1_FE");
  mean.mcp_abduction = axis_number(mean.spread, "MCP1_AA");
  mean.first = axis_number(mean.spread, variability.second.first);
  mean.second = axis_number(mean.spread, variability.second.second);
  mean.toward = variability.second.toward;
  return mean;
}

std::vector<AxisLine> draw_thumb(const MeanThumb& mean, unsigned seed, int number) {
  RandomStream random(seed, static_cast<std::uint32_t>(number), 0, kDrawnAxesStream);
  std::vector<AxisLine> axes = mean.axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const AxisVariability& spread = mean.spread[i];
    const Vector3d d = axes[i].direction, across = d.cross(mean.along[i]).normalized();
    // Shifted along its bone and across, square to both.
    axes[i].point += spread.along_sd * random.normal() * mean.along[i] +
                     spread.across_sd * random.normal() * across;
    // Tilted in two directions.
    const Tangents e = tangents(d);
    axes[i].direction = (d + std::tan(spread.tilt_sd * random.normal()) * e.e1 +
                         std::tan(spread.tilt_sd * random.normal()) * e.e2)
                            .normalized();
  }
  return axes;
}

double normal_component(const AxisLine& first, const AxisLine& second, const Vector3d& toward) {
  return axis_offset({-1, 0, 1, 0, first.direction, first.point},
                     {-1, 0, 1, 0, second.direction, second.point}, toward)
      .beyond;
}

ThumbType classify_thumb(const MeanThumb& mean, const std::vector<AxisLine>& axes) {
  require(axes.size() == mean.axes.size(), "{} axes of a thumb with {}", axes.size(),
          mean.axes.size());
  const auto axis = [&](int i) { return axes[static_cast<std::size_t>(i)]; };
  const Vector3d& along = mean.along[static_cast<std::size_t>(mean.mcp_flexion)];
  return {normal_component(axis(mean.mcp_flexion), axis(mean.mcp_abduction), along) < 0,
          normal_component(axis(mean.first), axis(mean.second),
                           direction_of(mean.tip, mean.toward)) > 0};
}

std::vector<AxisLine> thumb_axes(const MeanThumb& mean, const TendonModel<double>& model,
                                 const std::vector<std::string>& hinges) {
  std::vector<AxisLine> axes;
  for (const AxisVariability& spread : mean.spread) {
    const auto found = std::find(hinges.begin(), hinges.end(), spread.joint);
    require(found != hinges.end(), "the types of thumbs need a hinge '{}'", spread.joint);
    const Hinge<double>& hinge = model.tree[static_cast<std::size_t>(found - hinges.begin())];
    axes.push_back({hinge.point, hinge.direction});
  }
  return axes;
}

ThumbTypesInputs thumb_types_inputs(const std::string& data) {
  const auto read = [&](const std::string& file) {
    const std::string path = data + "/" + file;
    return SourceText{path, read_text_file(path)};
  };
  ThumbTypesInputs inputs;
  inputs.variability = read("studies/thumb_axes_variability.toml");
  const DigitVariability variability =
      parse_variability(inputs.variability.text, inputs.variability.path);
  inputs.subject = read("subjects/" + variability.mean_subject + ".toml");
  return inputs;
}

ThumbTypes study_thumb_types(const ThumbTypesInputs& inputs, const ThumbTypesSettings& settings) {
  require(settings.draws > 0, "wanted one draw or more, got {}", settings.draws);
  ThumbTypes out;
  out.inputs = inputs;
  out.variability = parse_variability(inputs.variability.text, inputs.variability.path);
  const MeanThumb mean =
      mean_thumb(out.variability, parse_subject(inputs.subject.text, inputs.subject.path));

  // Draw in batches, each thumb in a place of its own.
  std::vector<ThumbDraw> draws;
  while (static_cast<int>(draws.size()) < settings.draws && !settings.progress.stop()) {
    const int done = static_cast<int>(draws.size());
    settings.progress(static_cast<double>(done) / settings.draws, "draws of thumbs");
    draws.resize(static_cast<std::size_t>(std::min(done + kBatchDraws, settings.draws)));
    parallel_for(draws.size() - static_cast<std::size_t>(done), [&](std::size_t i) {
      const int number = done + static_cast<int>(i);
      draws[static_cast<std::size_t>(number)] =
          measure_thumb(mean, draw_thumb(mean, settings.seed, number));
    });
  }
  out.draws = static_cast<int>(draws.size());
  out.complete = out.draws == settings.draws;
  out.flexion_distal_by_places = flexion_distal_by_places(mean);
  if (draws.empty()) return out;

  // Count types and the ways of normals.
  for (const bool flexion_distal : {true, false})
    for (const bool toward : {false, true}) {
      const ThumbType type{flexion_distal, toward};
      ThumbTypeShare& share = out.types[static_cast<std::size_t>(type.index())];
      share = share_of(draws, type);
      if (flexion_distal) out.flexion_distal += share.count;
    }
  out.normals = normal_shares(mean, draws);
  return out;
}

std::string describe_type(const ThumbType& type, DigitDirection toward) {
  constexpr std::array<const char*, 3> kAgainst{"proximal", "palmar", "ulnar"};
  return fmt::format("MCP {} axis distal, normal {}", type.flexion_distal ? "flexion" : "abduction",
                     type.toward ? name_of(toward) : kAgainst[static_cast<std::size_t>(toward)]);
}

}  // namespace thenar
