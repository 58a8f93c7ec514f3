#pragma once

/// Layouts of result files: the arrays of each format, with their shapes. Files are checked against
/// these layouts when they are read, so that no reader meets an array of another shape.

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/inference_file.h"
#include "data/io/result_file.h"

namespace thenar {

/// Checks a file against the layout of its format; a file of another format has none. read_result()
/// and read_inference() do so with every file.
/// @param path  of the file, for messages
/// @throws DataError "path:1: 'fit/z': wanted 6 numbers (coordinate), got 1 x 6 numbers": for an
/// array that is absent, of another type or shape, or holds numbers that it must not.
void check_layout(const ResultFile& file, const std::string& path);
void check_layout(const InferenceFile& file, const std::string& path);

/// Returns whether a file says that it is of a format that has a layout.
[[nodiscard]] bool has_layout(const ResultFile& file);

/// Returns the numbers of an array of one dimension. @throws InputError if it is absent or has
/// others.
[[nodiscard]] Eigen::VectorXd vector_in(const ResultFile& file, const std::string& key);
/// Returns the lengths of an array of a group. @throws InputError if a dimension of it has none.
[[nodiscard]] std::vector<std::size_t> shape_in(const InferenceGroup& group,
                                                const InferenceArray& array);

}  // namespace thenar
