#include "report/pages/tendons.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/tendon_solve.h"
#include "report/pages/digit_page.h"
#include "report/picture/digit_layers.h"
#include "report/picture/net_layers.h"
#include "report/picture/skin_layer.h"
#include "report/provenance.h"
#include "report/words.h"
#include "tendons/name_conventions.h"

namespace thenar {
namespace {

const TendonNames& names_of(const TendonSweepResult& sweep) { return sweep.loaded.bones().names; }

std::string coordinate_name(const TendonSweepResult& sweep, int coordinate) {
  return nth(names_of(sweep).coordinates, coordinate);
}

/// "PIP3 = 30" of the coordinates given [deg].
std::string angles(const TendonSweepResult& sweep, const DigitPoint& point,
                   const std::vector<int>& coordinates) {
  return each_in_words(coordinates, [&](int c) {
    return fmt::format("{} = {:.4g}\u00b0", coordinate_name(sweep, c), point.q[c] / kDegree);
  });
}

/// All coordinates that are not zero.
std::string posture(const TendonSweepResult& sweep, const DigitPoint& point) {
  std::vector<int> bent;
  for (int c = 0; c < point.q.size(); ++c)
    if (point.q[c] != 0) bent.push_back(c);
  return bent.empty() ? "straight" : angles(sweep, point, bent);
}

/// Returns a title that distinguishes a point from the others.
std::string title(const TendonSweepResult& sweep, const DigitPoint& point) {
  return sweep.points.size() > 1 ? angles(sweep, point, sweep.loaded.grid.varied)
                                 : posture(sweep, point);
}

/// One line for every row of the sweep, its name that of the row if there are several; null is a
/// gap.
template <typename Value>
void add_series(const TendonSweepResult& sweep, const std::string& name, const Value& value,
                Json& series) {
  const int along = sweep.loaded.grid.varied.back();
  const std::vector<int> others(sweep.loaded.grid.varied.begin(),
                                sweep.loaded.grid.varied.end() - 1);
  // Each row of the sweep is a line over the coordinate that varies fastest.
  for (std::size_t begin = 0; begin < sweep.points.size(); begin += sweep.loaded.grid.row) {
    const std::size_t end = std::min(begin + sweep.loaded.grid.row, sweep.points.size());
    Json x = Json::array(), y = Json::array();
    for (std::size_t i = begin; i < end; ++i) {
      x.push_back(sweep.points[i].q[along] / kDegree);
      y.push_back(value(sweep.points[i]));
    }
    const std::string row = angles(sweep, sweep.points[begin], others);
    const char* between = name.empty() || row.empty() ? "" : ", ";
    const std::string of = fmt::format("{}{}{}", name, between, row);
    series.push_back(curve_json(of.empty() ? "net" : of, x, y));
  }
}

Json chart(const TendonSweepResult& sweep, const std::string& caption, const std::string& y_label,
           Json series) {
  return lines_block(caption, coordinate_name(sweep, sweep.loaded.grid.varied.back()) + " [deg]",
                     y_label, std::move(series));
}

/// The next of 1, 2, 3, 5, 10 times a power of ten.
double round_up(double value) {
  if (value <= 0) return 1;
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1., 1.5, 2., 3., 5., 7., 10.})
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

/// A scene of the net at a posture.
struct NetPicture {
  const TendonSweepResult& sweep;
  const NetTendons& net;
  std::optional<Subject> subject;  // subject whose skin is drawn
  double highest;                  // tension of the scale [N]
};

Json picture_of(const NetPicture& picture, const DigitPoint& point, MeshTable& meshes) {
  const auto& [sweep, net, subject, highest] = picture;
  const TreeState<double> state = pose_tree(net.digit().model.tree, point.q);
  // Draw bones and surfaces, then bands, muscles and skin.
  Json layers = Json::array({finger_layer(net, state), surface_layer(net, state)});
  layers = joined(std::move(layers), band_layers(net, state, point.rest));
  layers.push_back(muscle_layer(net, state, sweep.loaded.t));
  if (subject) add_skin({*subject, net.digit(), state}, meshes, layers);
  // Look from the back and the radial side of the palm.
  const FingerBone& palm = net.net().frame.bone(BoneRole::kMetacarpal);
  Eigen::Matrix3d directions;
  directions << palm.along, palm.dorsal, palm.radial;
  const Eigen::Vector3d view = 0.75 * palm.dorsal + palm.radial - 0.2 * palm.along;
  return with(
      digit_scene_block(title(sweep, point) + (point.snapped ? "; the net has just snapped" : "") +
                            (point.pull.warning.empty() ? "" : "; " + point.pull.warning),
                        directions, layers),
      {{"view", numbers3(view)},
       {"link", "net"},
       {"color_scale",
        {{"label", "tension [N]"}, {"low", 0}, {"high", highest}, {"dashed", "slack"}}}});
}

/// Returns the positive sense of a coordinate. Joints of ab-adduction are named "MCP3_AA".
std::string positive_sense(const std::string& coordinate) {
  return ends_with(coordinate, "_AA") ? "abduction towards radial" : "flexion";
}

Json arm_charts(const TendonSweepResult& sweep) {
  // Arms of muscles that pull; those of a net depend on the tensions.
  Json charts = Json::array();
  const std::vector<std::string>& muscles = names_of(sweep).muscles;
  for (int c = 0; c < sweep.points.front().q.size(); ++c) {
    Json series = Json::array();
    for (Eigen::Index m = 0; m < sweep.loaded.t.size(); ++m) {
      if (sweep.loaded.t[m] == 0) continue;
      add_series(
          sweep, nth(muscles, m), [&](const DigitPoint& point) { return 1e3 * point.pull.R(m, c); },
          series);
    }
    const std::string name = coordinate_name(sweep, c);
    charts.push_back(chart(sweep, "Moment arms about " + name,
                           fmt::format("arm, {} positive [mm]", positive_sense(name)), series));
  }
  return charts;
}

Json tip_chart(const TendonSweepResult& sweep) {
  const char* const names[] = {"proximal", "dorsal", "radial"};
  Json series = Json::array();
  for (int k = 0; k < 3; ++k)
    add_series(
        sweep, names[k],
        [&](const DigitPoint& point) -> Json {
          if (point.tip.singular()) return nullptr;
          return force_in_tip_axes(sweep.loaded, point)[k];
        },
        series);
  return chart(
      sweep, "Force of the pinned tip on the world, along its own axes; none at singular postures",
      "force [N]", series);
}

/// A tension, or 0 below what a search for rest leaves [N].
double above_rounding(double tension) { return tension < 1e-6 ? 0 : tension; }

/// Bands by posture.
Json band_table(const TendonSweepResult& sweep, const Net& net,
                const std::vector<std::size_t>& shown) {
  std::vector<BlockColumn> columns{"band", "from", "to"};
  for (const std::size_t i : shown) columns.push_back({title(sweep, sweep.points[i]), "N", 3});
  Json rows = Json::array();
  for (std::size_t k = 0; k < net.bands.size(); ++k) {
    const NetBand& band = net.bands[k];
    Json row = Json::array({band.name, nth(net.nodes, band.a).name, nth(net.nodes, band.b).name});
    for (const std::size_t i : shown)
      row.push_back(above_rounding(sweep.points[i].rest.tension[static_cast<Eigen::Index>(k)]));
    rows.push_back(row);
  }
  return with(table_block("Tension of every band; 0 is slack.", columns, rows), {{"search", true}});
}

/// Returns a line about postures where the sweep is not to be trusted; empty if there are none.
std::string trouble_line(const TendonSweepResult& sweep) {
  const auto troubled = [](const DigitPoint& point) { return !point.pull.warning.empty(); };
  const auto first = std::find_if(sweep.points.begin(), sweep.points.end(), troubled);
  if (first == sweep.points.end()) return "";
  return fmt::format("{} of {} postures, first {}: {}.",
                     std::count_if(first, sweep.points.end(), troubled), sweep.points.size(),
                     title(sweep, *first), first->pull.warning);
}

Json net_section(const TendonSweepResult& sweep, const NetTendons& net, MeshTable& meshes) {
  Json blocks = net_scenes(sweep, 4, meshes);
  if (sweep.loaded.grid.row > 1) blocks = joined(std::move(blocks), slip_charts(sweep));
  blocks.push_back(band_table(sweep, net.net().net, drawn_rows(sweep.points.size(), 4)));
  return section(
      "net", "The net at rest",
      "Bands are coloured by their tension; slack ones are dashed. Surfaces on which the "
      "net slides are translucent. Every net was brought to its posture from the "
      "neighbouring one, so that it lies where a finger moved this way would have it. "
      "First posture: " +
          posture(sweep, sweep.points.front()) + ".",
      blocks);
}

Json sections_of(const TendonSweepResult& sweep, MeshTable& meshes) {
  // Doubts first, then the net, slips, arms and the force of the tip.
  Json sections = Json::array();
  const std::string warning = trouble_line(sweep);
  if (!warning.empty())
    sections.push_back(
        section("trouble", "Not to be trusted", "", Json::array({text_block(warning)})));
  const NetTendons* net = sweep.loaded.net();
  if (net != nullptr) sections.push_back(net_section(sweep, *net, meshes));
  if (sweep.loaded.grid.row < 2) return sections;
  if (net == nullptr && sweep.loaded.bones().model.hood)
    sections.push_back(section("slips", "Slips of the hood", "", slip_charts(sweep)));
  sections.push_back(section(
      "arms", "Moment arms",
      net == nullptr ? ""
                     : "Of a net, an arm is the change of joint torque with a muscle's tension at "
                       "these tensions: it depends on what the others pull. Muscles that do not "
                       "pull are left out.",
      arm_charts(sweep)));
  sections.push_back(section("tip", "Tip force", "", Json::array({tip_chart(sweep)})));
  return sections;
}

}  // namespace

Json net_scenes(const TendonSweepResult& sweep, std::size_t most, MeshTable& meshes) {
  const NetTendons* net = sweep.loaded.net();
  if (net == nullptr) return Json::array();
  const std::vector<std::size_t> shown = drawn_rows(sweep.points.size(), most);
  // All pictures have one scale of tensions.
  double highest = 0;
  for (const std::size_t i : shown)
    highest = std::max(highest, sweep.points[i].rest.tension.maxCoeff());
  NetPicture picture{sweep, *net, {}, round_up(highest)};
  if (const std::vector<SourceText>& sources = sweep.loaded.sources; !sources.empty())
    picture.subject = parse_subject(sources.front().text, sources.front().path);
  return paired(list_of_each(
      shown, [&](std::size_t i) { return picture_of(picture, sweep.points[i], meshes); }));
}

Json slip_charts(const TendonSweepResult& sweep) {
  // The ratio of terminal to central slip is published, and undefined while the central slip is
  // slack.
  Json ratio = Json::array(), slips = Json::array();
  add_series(
      sweep, "",
      [](const DigitPoint& point) {
        const SlipTension& s = point.pull.slips;
        return s.central > 1e-3 * (s.central + s.terminal) ? Json(s.terminal / s.central) : Json();
      },
      ratio);
  const std::pair<const char*, double SlipTension::*> kSlips[] = {
      {"central", &SlipTension::central},
      {"terminal", &SlipTension::terminal},
      {"radial", &SlipTension::radial},
      {"ulnar", &SlipTension::ulnar}};
  for (const auto& [name, slip] : kSlips)
    add_series(
        sweep, name, [&, s = slip](const DigitPoint& point) { return point.pull.slips.*s; }, slips);
  return Json::array({row_block(
      Json::array({chart(sweep, "Tension of the terminal slip per that of the central one",
                         "terminal / central [1]", ratio),
                   chart(sweep, "Tension of the slips", "tension [N]", slips)}))});
}

Json page_of(const TendonSweepResult& sweep) {
  const LoadedDigit& loaded = sweep.loaded;
  Json provenance = provenance_json(loaded.sources, loaded.bones().fidelity);
  provenance["tensions"] = tensions_in_words(loaded) + " N";
  if (loaded.net() != nullptr) provenance["net"] = loaded.net()->net().net.name;
  MeshTable meshes;
  Json sections = sections_of(sweep, meshes);
  return {{"title", fmt::format("Tendons of the {} of {}", loaded.digit, loaded.subject)},
          {"subtitle", fmt::format("under {} N", tensions_in_words(loaded))},
          {"provenance", provenance},
          {"sections", std::move(sections)},
          {"meshes", meshes.json()}};
}

Json page_of(const TendonSolveResult& solution) {
  return page_of(
      TendonSweepResult{solution.request, solution.outcome, solution.loaded, {solution.point}});
}

}  // namespace thenar
