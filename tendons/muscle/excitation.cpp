#include "tendons/muscle/excitation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "base/error.h"

namespace thenar {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\""), last = text.find_last_not_of(" \t\r\"");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(trimmed(cell));
  if (!line.empty() && line.back() == ',') cells.emplace_back();
  return cells;
}

/// Columns of a table by name, and its rows of numbers.
class ExcitationTable {
 public:
  ExcitationTable(const std::string& path, const std::vector<std::string>& muscles, double most)
      : path_(path), muscles_(muscles), most_(most) {}

  void read_header(int line, const std::vector<std::string>& cells) {
    // Time first, then one known muscle a column.
    if (cells.size() < 2 || cells.front() != "time_s")
      throw DataError(path_, line, "wanted a header 'time_s,MUSCLE,...'");
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const auto found = std::find(muscles_.begin(), muscles_.end(), cells[i]);
      if (found == muscles_.end())
        throw DataError(
            path_, line,
            fmt::format("no muscle '{}'; there are {}", cells[i], fmt::join(muscles_, ", ")));
      const auto column = static_cast<Eigen::Index>(found - muscles_.begin());
      if (std::count(columns_.begin(), columns_.end(), column) > 0)
        throw DataError(path_, line, fmt::format("muscle '{}' has two columns", cells[i]));
      columns_.push_back(column);
    }
  }

  void read_row(int line, const std::vector<std::string>& cells) {
    if (cells.size() != columns_.size() + 1)
      throw DataError(path_, line,
                      fmt::format("wanted {} cells, got {}", columns_.size() + 1, cells.size()));
    std::vector<double> row;
    row.reserve(cells.size());
    // Numbers, in rising time and within the range of excitations.
    for (const std::string& cell : cells) row.push_back(number(line, cell));
    if (row.front() < (rows_.empty() ? 0 : rows_.back().front()))
      throw DataError(path_, line, "wanted times from 0 on that never fall");
    for (std::size_t i = 1; i < row.size(); ++i)
      if (row[i] < 0 || row[i] > most_)
        throw DataError(path_, line,
                        most_ == 1 ? fmt::format("wanted an excitation in 0..1, got {}", row[i])
                                   : fmt::format("wanted a tension >= 0, got {}", row[i]));
    rows_.push_back(row);
  }

  [[nodiscard]] bool has_header() const { return !columns_.empty(); }

  [[nodiscard]] Excitation take() const {
    if (rows_.empty()) throw DataError(path_, 1, "wanted a header and at least one row");
    // Columns in the order of the muscles; those without a column stay 0.
    const auto knots = static_cast<Eigen::Index>(rows_.size());
    Excitation result{Eigen::VectorXd(knots),
                      Eigen::MatrixXd::Zero(knots, static_cast<Eigen::Index>(muscles_.size()))};
    for (Eigen::Index k = 0; k < knots; ++k) {
      const std::vector<double>& row = rows_[static_cast<std::size_t>(k)];
      result.time[k] = row.front();
      for (std::size_t i = 0; i < columns_.size(); ++i) result.value(k, columns_[i]) = row[i + 1];
    }
    return result;
  }

 private:
  [[nodiscard]] double number(int line, const std::string& cell) const {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (cell.empty() || *end != 0 || !std::isfinite(value))
      throw DataError(path_, line, fmt::format("wanted a number, got '{}'", cell));
    return value;
  }

  const std::string& path_;
  const std::vector<std::string>& muscles_;
  double most_;
  std::vector<Eigen::Index> columns_;
  std::vector<std::vector<double>> rows_;
};

void check(const Excitation& excitation) {
  const Eigen::VectorXd& t = excitation.time;
  require(t.size() > 0 && t.size() == excitation.value.rows(), "{} knots of excitation, {} values",
          t.size(), excitation.value.rows());
  require(t.allFinite() && std::is_sorted(t.data(), t.data() + t.size()),
          "times of the knots of an excitation must not fall");
  require((excitation.value.array() >= 0 && excitation.value.array() <= 1).all(),
          "excitations must be in 0..1");
}

}  // namespace

Excitation constant_excitation(const Eigen::VectorXd& value) {
  return {Eigen::VectorXd::Zero(1), value.transpose()};
}

std::vector<ExcitationPiece> excitation_pieces(const Excitation& excitation, double seconds) {
  check(excitation);
  std::vector<ExcitationPiece> pieces;
  // A piece of no duration is a jump.
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
  // Knots up to the end; the last piece is cut there.
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
                            const std::vector<std::string>& muscles, double most) {
  ExcitationTable table(path, muscles, most);
  // The first row that is no comment is the header.
  std::istringstream in(text);
  int line = 0;
  for (std::string row; std::getline(in, row);) {
    ++line;
    if (trimmed(row).empty() || trimmed(row).front() == '#') continue;
    table.has_header() ? table.read_row(line, cells_of(row))
                       : table.read_header(line, cells_of(row));
  }
  return table.take();
}

}  // namespace thenar
