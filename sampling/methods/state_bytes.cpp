#include "sampling/methods/state_bytes.h"

#include <cstring>

#include "base/error.h"

namespace thenar {

void StateWriter::write(double value) {
  bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void StateWriter::write(std::int64_t value) {
  bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void StateWriter::write(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  write(std::int64_t{matrix.rows()});
  write(std::int64_t{matrix.cols()});
  const auto column = static_cast<std::size_t>(matrix.rows()) * sizeof(double);
  for (Eigen::Index k = 0; k < matrix.cols(); ++k)
    bytes_.append(reinterpret_cast<const char*>(matrix.col(k).data()), column);
}

void StateWriter::write_bytes(const std::string& bytes) {
  write(static_cast<std::int64_t>(bytes.size()));
  bytes_ += bytes;
}

double StateReader::number() {
  double value;
  copy_next(&value, sizeof value);
  return value;
}

std::int64_t StateReader::integer() {
  std::int64_t value;
  copy_next(&value, sizeof value);
  return value;
}

Eigen::MatrixXd StateReader::matrix() {
  // Check the shape before allocating memory, in case it is damaged.
  const std::int64_t rows = integer(), columns = integer();
  const auto left = static_cast<std::int64_t>((bytes_.size() - at_) / sizeof(double));
  require(rows >= 0 && columns >= 0 && (rows == 0 || columns <= left / rows),
          "saved state: a matrix of {} x {} in {} numbers", rows, columns, left);
  Eigen::MatrixXd matrix(rows, columns);
  copy_next(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double));
  return matrix;
}

std::string StateReader::bytes() {
  const std::int64_t size = integer();
  require(size >= 0 && static_cast<std::size_t>(size) <= bytes_.size() - at_,
          "saved state: a part of {} bytes, {} are left", size, bytes_.size() - at_);
  std::string part(static_cast<std::size_t>(size), '\0');
  copy_next(part.data(), part.size());
  return part;
}

void StateReader::copy_next(void* to, std::size_t size) {
  require(size <= bytes_.size() - at_, "saved state: wanted {} bytes, {} are left", size,
          bytes_.size() - at_);
  if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
  at_ += size;
}

}  // namespace thenar
