#pragma once

/// What an HDF5 file may hold before its arrays are read: the library itself takes memory for
/// whatever a file promises, and follows its links wherever they lead.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace thenar {

/// An HDF5 handle that closes itself and refuses to be an error.
class Hdf5Object {
 public:
  using Close = int (*)(std::int64_t);  // herr_t (*)(hid_t)
  /// @param what  was to be done: "open the root"
  /// @throws InputError if the handle is an error.
  Hdf5Object(std::int64_t id, Close close, const std::string& what);
  ~Hdf5Object() { (void)close_(id_); }
  Hdf5Object(const Hdf5Object&) = delete;
  Hdf5Object& operator=(const Hdf5Object&) = delete;
  operator std::int64_t() const { return id_; }  // NOLINT: handles are passed to C all the time

 private:
  std::int64_t id_;
  Close close_;
};

/// How long reading a file of this size may take: a hundred times what it does [s of processor].
[[nodiscard]] inline int seconds_to_read(std::size_t bytes) {
  return 1 + static_cast<int>(bytes / (20 * 1000 * 1000));
}

/// Walks over every object of a file and holds it against the file's size: groups nest at most 8
/// deep; arrays have at most 8 dimensions, lie in the file itself, and together with attributes
/// promise no more bytes than it has. No value is read, no memory is taken for any.
/// @param bytes  of the file
/// @param path   only names it in messages
/// @return keys of all datasets: "group/array", in order of their names
/// @throws DataError naming the object that does not fit.
[[nodiscard]] std::vector<std::string> guard_hdf5(std::string& bytes, const std::string& path);

/// Does `work` in a copy of this process first, under limits of processor time and memory, to see
/// whether it comes back: libraries of file formats crash or loop on damaged files. Done again here
/// on the same bytes, the work takes the same course.
/// @param path     of the file, for the message
/// @param seconds  of processor time that it may take
/// @throws DataError if the copy crashed, took longer, or more than 1 GB beyond what we have; with
/// its message if the work threw: what fails under limits is not tried without them.
void try_in_fork(const std::string& path, int seconds, const std::function<void()>& work);

}  // namespace thenar
