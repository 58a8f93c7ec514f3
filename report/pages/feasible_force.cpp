#include "report/pages/digit_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/units.h"
#include "report/answers/digit_words.h"
#include "report/answers/feasible_force.h"
#include "report/picture/digit_layers.h"

namespace thenar {
namespace {

using Eigen::Index;

/// Largest force along the direction, what limits it, and who pulls.
void add_direction_charts(const FeasibleForceResult& answer, const SweepAxes& axes, Json& charts) {
  // Price and activation of each muscle at the largest load; gaps where there is none.
  const LoadWords words = words_of(answer.request.load);
  std::vector<Curve> prices, activations;
  for (std::size_t m = 0; m < answer.muscles.size(); ++m) {
    const auto i = static_cast<Index>(m);
    prices.push_back(
        curve_over(answer.points, answer.muscles[m], [i](const FeasibleForcePoint& point) {
          const Eigen::VectorXd& price = point.largest->prices.increase;
          return makes_force(point) && price.size() > 0 ? price(i) : kNaN;
        }));
    activations.push_back(
        curve_over(answer.points, answer.muscles[m], [i](const FeasibleForcePoint& point) {
          return makes_force(point) ? point.largest->activation(i) : kNaN;
        }));
  }
  // The load itself first, then what limits it, and who makes it.
  charts.push_back(
      curve_chart(axes,
                  fmt::format("Largest {0} along the direction; a gap where no "
                              "combination of tensions produces a {0} in this direction with every "
                              "joint in equilibrium",
                              words.one),
                  fmt::format("{} along the direction [{}]", words.one, words.unit),
                  {curve_over(answer.points, "largest " + words.one, [](const auto& point) {
                    return makes_force(point) ? point.largest->component : kNaN;
                  })}));
  charts.push_back(curve_chart(
      axes, fmt::format("Limiting muscles: gain in {} per additional newton of F0", words.one),
      fmt::format("{} of {} per N of F0", words.unit, words.one), prices));
  charts.push_back(
      curve_chart(axes, "Activation of each muscle that makes it", "activation [1]", activations));
}

/// Largest load along each axis, and the size of the set.
void add_set_charts(const FeasibleForceResult& answer, const SweepAxes& axes, Json& charts) {
  // Names of the axes come from the first posture that has an answer.
  const auto with_axes = std::find_if(answer.points.begin(), answer.points.end(),
                                      [](const auto& point) { return point.message.empty(); });
  std::vector<Curve> along;
  for (std::size_t k = 0; k < 6; ++k)
    along.push_back(curve_over(answer.points, axis_direction(with_axes->axes, k),
                               [k](const auto& point) { return point.whole->along[k].component; }));
  const LoadWords words = words_of(answer.request.load);
  charts.push_back(curve_chart(
      axes, fmt::format("Largest {} along each axis, its other components 0", words.one),
      fmt::format("{} [{}]", words.one, words.unit), along));
  charts.push_back(curve_chart(
      axes, fmt::format("Volume of all {}", words.many), fmt::format("volume [({})^3]", words.unit),
      {curve_over(answer.points, "volume", [](const auto& point) {
        return point.whole->set.dimension == 3 ? point.whole->set.volume : kNaN;
      })}));
}

/// The largest length of anything to draw [N] or [N m].
double drawn_force(const FeasibleForceResult& answer) {
  double largest = 0;
  for (const FeasibleForcePoint& point : answer.points) {
    if (makes_force(point)) largest = std::max(largest, point.largest->force.norm());
    if (point.whole && point.whole->set.vertices.rows() > 0)
      largest = std::max(largest, point.whole->set.vertices.rowwise().norm().maxCoeff());
  }
  return largest;
}

Json force_scene(const FeasibleForceResult& answer, MeshTable& meshes) {
  // Scale the arrows so that the largest load fits the digit.
  const double scale = arrow_scale(drawn_force(answer));
  const SweepAxes axes = axes_of(answer);
  bool first = true;
  const LoadWords words = words_of(answer.request.load);
  const std::string what = answer.request.direction ? "its largest " + words.one
                                                    : fmt::format("all {} of its tip", words.many);
  return digit_scene(
      answer,
      fmt::format("The digit, and {}: 10 mm represents {:.3g} {}.", what, 10 / scale, words.unit),
      meshes, [&](std::size_t i, const std::string& tint, Json& layers) {
        const FeasibleForcePoint& point = answer.points[i];
        // Draw the largest load, and the convex hull of all loads at the tip.
        if (!point.message.empty()) return;
        if (makes_force(point))
          layers.push_back(arrow_layer("largest " + words.one, "#d55e00", point.tip,
                                       scale * point.largest->force));
        if (!point.whole || point.whole->set.vertices.rows() == 0) return;
        Json hull =
            force_set_layer(answer.tendons->digit(), point.q, point.whole->set, scale, tint);
        if (!axes.single()) hull["name"] = words.many + " at " + title_of(axes, i);
        hull["visible"] = first;
        first = false;
        layers.push_back(hull);
      });
}

std::string question_words(const FeasibleForceResult& answer) {
  // State the question with its axes, its tolerance and the loads of the other kind.
  const LoadWords load = words_of(answer.request.load);
  const std::string axes = answer.points.empty() ? "world" : answer.points.front().axes.name;
  const std::string other = other_words(answer.request.load, answer.request.max_other);
  const std::string beside = other.empty() ? "" : ", " + other;
  if (!answer.request.direction)
    return fmt::format(
        "All static {} of the tip{} with every muscle between 0 and its largest force F0, in {} "
        "axes.",
        load.many, beside, axes);
  std::string words = fmt::format(
      "The largest static {} along ({:.4g}, {:.4g}, {:.4g}) in {} axes{}{}, {}every muscle between "
      "0 "
      "and its largest force F0.",
      load.one, answer.request.direction->x(), answer.request.direction->y(),
      answer.request.direction->z(), axes,
      answer.request.tolerance > 0
          ? fmt::format(", or up to {:.4g} degrees off it", answer.request.tolerance / kDegree)
          : "",
      beside, answer.map.empty() ? "every joint in balance and " : "");
  // Add the limits for a single posture.
  if (answer.single() && !answer.points.empty()) {
    const std::string limits = limit_words(answer, answer.points.front());
    if (!limits.empty()) words += "\n\nIt is " + limits + ".";
  }
  if (const std::string weak = weak_words(answer); !weak.empty()) words += "\n\n" + weak + ".";
  return words;
}

/// The range of the largest loads in the requested direction.
std::string largest_words(const LoadWords& words, const std::vector<double>& largest) {
  if (largest.empty())
    return fmt::format("No {} in the requested direction can be produced.", words.one);
  return fmt::format("The largest {} in the requested direction is {}.", words.one,
                     range_words(largest, words.unit));
}

}  // namespace

Json page_of(const FeasibleForceResult& answer) {
  const LoadWords words = words_of(answer.request.load);
  // The scene, then numbers of a single posture or of the sweep.
  Json blocks = Json::array();
  MeshTable meshes;
  if (const Json scene = force_scene(answer, meshes); !scene.is_null()) blocks.push_back(scene);
  if (answer.single() && answer.points.front().largest)
    blocks.push_back(
        table_block(fmt::format("Muscle tensions at the largest {0}, and the gain in {0} per "
                                "additional newton of F0.",
                                words.one),
                    limit_table(answer, answer.points.front())));
  blocks.push_back(table_block("The answer at every posture.", table_of(answer)));
  Json sections = Json::array({section(
      "forces", answer.request.direction ? "The largest " + words.one : "All " + words.many,
      digit_introduction(answer, question_words(answer)), blocks)});
  // Charts over the posture, if it varies.
  if (!answer.single() && !answer.points.empty()) {
    const SweepAxes axes = axes_of(answer);
    Json charts = Json::array();
    if (answer.request.direction) add_direction_charts(answer, axes, charts);
    if (with_whole(answer)) add_set_charts(answer, axes, charts);
    sections.push_back(section("curves", "Over the posture", "", paired(charts)));
  }
  // Sum up by the range of the largest loads.
  std::vector<double> largest;
  for (const FeasibleForcePoint& point : answer.points)
    if (point.largest && point.largest->status == Status::kSolved)
      largest.push_back(point.largest->component);
  return digit_page(answer, "feasible " + words.many, sections, meshes,
                    answer.request.direction ? largest_words(words, largest)
                                             : "All that muscles can make is drawn below.");
}

}  // namespace thenar
