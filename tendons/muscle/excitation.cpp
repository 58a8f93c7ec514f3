#include "tendons/muscle/excitation.h"

#include <algorithm>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/time_table.h"

namespace thenar {
namespace {

/// Checks shapes, times and values.
void check_excitation(const Excitation& excitation) {
  const Eigen::VectorXd& t = excitation.time;
  require(t.size() > 0 && t.size() == excitation.value.rows(), "{} knots of excitation, {} values",
          t.size(), excitation.value.rows());
  require(t.allFinite() && std::is_sorted(t.data(), t.data() + t.size()),
          "times of the knots of an excitation must not fall");
  for (Eigen::Index m = 0; m < excitation.value.cols(); ++m)
    for (const double value : excitation.value.col(m))
      require(value >= 0 && value <= 1,
              "wanted excitations from 0 to 1, got {} of muscle number {}", value, m + 1);
}

}  // namespace

Eigen::VectorXd ExcitationPiece::value_at(double time) const {
  return first + (last - first) * ((time - begin) / (end - begin));
}

Excitation constant_excitation(const Eigen::VectorXd& value) {
  return {Eigen::VectorXd::Zero(1), value.transpose()};
}

std::vector<ExcitationPiece> excitation_pieces(const Excitation& excitation, double seconds) {
  check_excitation(excitation);
  std::vector<ExcitationPiece> pieces;
  // Define how to add a piece; one of zero duration is a jump.
  double begin = 0;
  Eigen::VectorXd first = excitation.value.row(0);
  const auto add = [&](double end, const Eigen::VectorXd& last) {
    if (end > begin) {
      const bool jumps = !pieces.empty() && pieces.back().last != first;
      pieces.push_back({begin, end, first, last, jumps});
      begin = end;
    }
    first = last;
  };
  // Add pieces up to the end, where the last one is cut.
  for (Eigen::Index k = 0; k < excitation.time.size() && begin < seconds; ++k) {
    const Eigen::VectorXd value = excitation.value.row(k);
    const double time = excitation.time[k];
    if (time <= seconds) {
      add(time, value);
    } else {
      const Eigen::VectorXd cut = first + (value - first) * ((seconds - begin) / (time - begin));
      add(seconds, cut);
    }
  }
  add(seconds, first);
  return pieces;
}

Excitation parse_excitation(const std::string& text, const std::string& path,
                            const std::vector<std::string>& muscles, double max_value) {
  const TimeTable table = parse_time_table(text, path, "muscle", &muscles);
  Excitation result{table.time, Eigen::MatrixXd::Zero(table.time.size(),
                                                      static_cast<Eigen::Index>(muscles.size()))};
  // Copy the columns in the order of the muscles; those without a column stay 0.
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Eigen::VectorXd column = table.value.col(static_cast<Eigen::Index>(i));
    for (Eigen::Index k = 0; k < column.size(); ++k)
      if (column[k] < 0 || column[k] > max_value)
        throw DataError(path, table.lines[k],
                        max_value == 1
                            ? fmt::format("wanted an excitation in 0..1, got {}", column[k])
                            : fmt::format("wanted a tension >= 0, got {}", column[k]));
    result.value.col(place_in(muscles, table.columns[i])) = column;
  }
  return result;
}

}  // namespace thenar
