#pragma once

/// Exact serialisation of numbers: a sampler restored from its bytes continues as if never
/// interrupted.

#include <cstdint>
#include <string>

#include <Eigen/Core>

namespace thenar {

/// Appends numbers to a string of bytes (little endian, as in memory).
class StateWriter {
 public:
  void write(double value);
  void write(std::int64_t value);
  void write(const Eigen::Ref<const Eigen::MatrixXd>& matrix);  // shape and entries
  void write_bytes(const std::string& bytes);                   // length and bytes

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads numbers in the order in which a StateWriter wrote them.
class StateReader {
 public:
  explicit StateReader(std::string bytes) : bytes_(std::move(bytes)) {}

  /// Return the next item. @throws InputError if the bytes end too early.
  [[nodiscard]] double number();
  [[nodiscard]] std::int64_t integer();
  [[nodiscard]] Eigen::MatrixXd matrix();
  [[nodiscard]] std::string bytes();
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  void copy_next(void* to, std::size_t size);

  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace thenar
