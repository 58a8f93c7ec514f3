#include "sampling/run/chain_stream.h"

#include <vector>

#include "base/error.h"
#include "base/provenance.h"
#include "sampling/methods/state_bytes.h"

namespace thenar::internal {
namespace {

constexpr std::int64_t kDigestBytes = 16;  // size of a digest [bytes]
// Size of the header of a block: rows, columns and digest [bytes]
constexpr std::int64_t kHeadBytes = 2 * sizeof(std::int64_t) + kDigestBytes;

std::string digest(const std::string& numbers) { return sha256(numbers).substr(0, kDigestBytes); }

}  // namespace

void ChainStream::append(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  require(columns.rows() == rows_, "'{}' has {} rows, got {}", file_.path(), rows_, columns.rows());
  if (columns.cols() == 0) return;
  const Eigen::MatrixXd block = columns;  // contiguous
  const std::string numbers(reinterpret_cast<const char*>(block.data()),
                            static_cast<std::size_t>(block.size()) * sizeof(double));
  // Write shape, digest and numbers.
  StateWriter head;
  head.write(std::int64_t{block.rows()});
  head.write(std::int64_t{block.cols()});
  file_.append(head.bytes() + digest(numbers) + numbers);
}

Eigen::MatrixXd ChainStream::read_block(std::int64_t& at) const {
  // Read the header of the block.
  const std::int64_t left = file_.size() - at;
  require(left >= kHeadBytes, "'{}' ends too early, at byte {}", file_.path(), at);
  const std::string head = file_.read(at, kHeadBytes);
  StateReader reader(head);
  const std::int64_t rows = reader.integer(), columns = reader.integer();
  const std::int64_t room = (left - kHeadBytes) / std::int64_t{sizeof(double)};
  require(rows == rows_ && columns > 0 && columns <= room / rows,
          "'{}' is damaged at byte {}: a block of {} x {} in {} numbers", file_.path(), at, rows,
          columns, room);
  // Read the numbers, and check their digest.
  Eigen::MatrixXd block(rows, columns);
  const std::string numbers =
      file_.read(at + kHeadBytes, block.size() * std::int64_t{sizeof(double)});
  require(digest(numbers) == head.substr(head.size() - kDigestBytes),
          "'{}' is damaged between bytes {} and {}", file_.path(), at,
          at + kHeadBytes + static_cast<std::int64_t>(numbers.size()));
  numbers.copy(reinterpret_cast<char*>(block.data()), numbers.size());
  at += kHeadBytes + static_cast<std::int64_t>(numbers.size());
  return block;
}

void ChainStream::resume(long columns) {
  // Skip whole blocks up to the column, and truncate the rest.
  std::int64_t at = 0;
  long found = 0;
  while (found < columns) found += read_block(at).cols();
  require(found == columns, "'{}' has no block that ends with column {}", file_.path(), columns);
  file_.truncate(at);
}

Eigen::MatrixXd ChainStream::read() const {
  // Read and concatenate all blocks.
  std::vector<Eigen::MatrixXd> blocks;
  Eigen::Index columns = 0;
  for (std::int64_t at = 0; at < file_.size(); columns += blocks.back().cols())
    blocks.push_back(read_block(at));
  Eigen::MatrixXd all(rows_, columns);
  columns = 0;
  for (const Eigen::MatrixXd& block : blocks) {
    all.middleCols(columns, block.cols()) = block;
    columns += block.cols();
  }
  return all;
}

}  // namespace thenar::internal
