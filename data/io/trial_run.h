#pragma once

#include <functional>
#include <string>

namespace thenar {

/// Does `work` in a copy of this process first, under limits of processor time and memory, to see
/// whether it comes back: libraries of file formats crash or loop on damaged files. What is thrown
/// counts as coming back. Done again here on the same bytes, the work takes the same course.
/// @param path  of the file, for the message
/// @throws DataError if the copy crashed, took more than 10 s of processor time or 1 GB more.
void try_first(const std::string& path, const std::function<void()>& work);

}  // namespace thenar
