#pragma once

/// Numbers of many points, eight points beside each other.

#include <vector>

namespace thenar::internal {

inline constexpr int kBlock = 8;  // points of a block: a register of the widest unit

/// Row i of points 8 b .. 8 b + 7 is contiguous. Points beyond the last fill up the last block.
class LaneRows {
 public:
  LaneRows() = default;
  LaneRows(long rows, long points)
      : rows_(rows),
        blocks_((points + kBlock - 1) / kBlock),
        numbers_(static_cast<std::size_t>(rows * blocks_ * kBlock)) {}

  [[nodiscard]] long rows() const { return rows_; }
  [[nodiscard]] long blocks() const { return blocks_; }
  [[nodiscard]] double* row(long block, long i) {
    return numbers_.data() + (block * rows_ + i) * kBlock;
  }
  [[nodiscard]] const double* row(long block, long i) const {
    return numbers_.data() + (block * rows_ + i) * kBlock;
  }
  [[nodiscard]] double& operator()(long i, long point) {
    return row(point / kBlock, i)[point % kBlock];
  }
  [[nodiscard]] double operator()(long i, long point) const {
    return row(point / kBlock, i)[point % kBlock];
  }

 private:
  long rows_ = 0, blocks_ = 0;
  std::vector<double> numbers_;
};

}  // namespace thenar::internal
