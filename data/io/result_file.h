#pragma once

/// Result files (HDF5): named arrays with units and labelled dimensions, texts, groups by "a/b".
/// The only fence of the HDF5 library.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// An array of a file, row-major.
struct ResultArray {
  std::vector<double> values;       // row-major (product of shape)
  std::vector<std::size_t> shape;   // lengths of at most 3 dimensions
  std::string unit;                 // "N", "1"
  std::vector<std::string> labels;  // name of each dimension: {"trial", "component"}
};

/// Content of one result file. Keys are paths: "fit/z".
struct ResultFile {
  std::map<std::string, ResultArray> arrays;
  std::map<std::string, std::vector<std::string>> texts;  // lists of texts; one entry: a scalar

  /// Adds an array, a number, a text or a list of texts. @param labels  name of each dimension
  void add(const std::string& key, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
           const std::string& unit, const std::vector<std::string>& labels);
  void add(const std::string& key, double value, const std::string& unit);
  void add(const std::string& key, const std::string& text);
  void add(const std::string& key, std::vector<std::string> list);

  /// Return values by key. @throws InputError naming the key if it is absent or has another shape.
  [[nodiscard]] Eigen::MatrixXd matrix(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] const std::string& text(const std::string& key) const;
  [[nodiscard]] std::string text_or_none(const std::string& key) const;  // "" if it is absent
  [[nodiscard]] const std::vector<std::string>& list(const std::string& key) const;
};

/// Writes to `path + ".tmp"` and renames it when it is complete, so that no half-written file is
/// left. Dimensions become HDF5 dimension scales, as xarray expects; the file ends with a checksum.
/// @throws InputError if the file cannot be written.
void write_result(const ResultFile& file, const std::string& path);

/// Reads a file. @throws DataError if it is missing, not ours, damaged, or promises more than it
/// has.
[[nodiscard]] ResultFile read_result(const std::string& path);

/// Returns a matrix of finite numbers with so many rows and columns. @param path  of the file, for
/// messages
/// @throws DataError `path:1: ..` if it is absent, of another shape, or has other numbers.
[[nodiscard]] Eigen::MatrixXd finite_matrix(const ResultFile& file, const std::string& path,
                                            const std::string& key, Eigen::Index rows,
                                            Eigen::Index columns);

}  // namespace thenar
