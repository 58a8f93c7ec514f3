#pragma once

/// Checks of an HDF5 file before its arrays are read. The library takes memory for whatever a file
/// promises, and follows its links wherever they lead.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace thenar {

/// An HDF5 handle that closes itself; it is never an error value.
class Hdf5Object {
 public:
  using Close = int (*)(std::int64_t);  // herr_t (*)(hid_t)
  /// @param what  the action that made the handle: "open the root"
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

/// Keeps other threads from HDF5 and netCDF, which are built for one, while it lives.
[[nodiscard]] std::unique_lock<std::recursive_mutex> lock_hdf5();

/// Returns the time limit for reading a file of this size: a hundred times what it takes [s of
/// processor]
[[nodiscard]] inline int seconds_to_read(std::size_t bytes) {
  return 1 + static_cast<int>(bytes / (20 * 1000 * 1000));
}

/// Checks every object of a file against the file's size. Groups nest at
/// most 8 deep; arrays have at most 8 dimensions, lie in the file itself, and together with
/// attributes promise no more bytes than the file has. No value is read, and no memory is taken for
/// any.
/// @param bytes  of the file
/// @param path   only names it in messages
/// @returns keys of all datasets: "group/array", in order of their names
/// @throws DataError naming the object that does not fit.
[[nodiscard]] std::vector<std::string> guard_hdf5(std::string& bytes, const std::string& path);

/// Tries `work` in a copy of this process, under limits of processor time and memory, because
/// libraries of file formats crash or loop on damaged files. If it returns, the same work on the
/// same bytes takes the same course in this process.
/// @param path     of the file, for the message
/// @param seconds  of processor time allowed
/// @throws DataError if the copy crashes, takes longer, or needs more than 1 GB in addition to this
/// process; or with the message of the work if it throws, so that it is not tried without limits.
void try_in_fork(const std::string& path, int seconds, const std::function<void()>& work);

}  // namespace thenar
