#pragma once

#include <functional>
#include <string>

namespace thenar {

/// Does `work` in a copy of this process first, under limits of processor time and memory, to see
/// whether it comes back: libraries of file formats crash or loop on damaged files. Done again here
/// on the same bytes, the work takes the same course.
/// @param path     of the file, for the message
/// @param seconds  of processor time that it may take
/// @throws DataError if the copy crashed, took longer, or more than 1 GB beyond what we have; with
/// its message if the work threw: what fails under limits is not tried without them.
void try_first(const std::string& path, int seconds, const std::function<void()>& work);

}  // namespace thenar
