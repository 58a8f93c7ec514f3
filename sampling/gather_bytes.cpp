#include "sampling/gather_bytes.h"

namespace thenar::internal {

// Each rank sends its length and then its bytes, eight in each number. Numbers are only copied.
std::vector<std::string> gather_bytes(const Ranks& ranks, const std::string& mine) {
  if (ranks.size() == 1) return {mine};
  const auto words = [](std::size_t bytes) {
    return static_cast<Eigen::Index>((bytes + sizeof(double) - 1) / sizeof(double));
  };
  Eigen::VectorXd sent = Eigen::VectorXd::Zero(1 + words(mine.size()));
  sent[0] = static_cast<double>(mine.size());
  mine.copy(reinterpret_cast<char*>(sent.data() + 1), mine.size());

  const Eigen::VectorXd all = ranks.all_gather(sent);
  std::vector<std::string> parts;
  for (Eigen::Index at = 0; at < all.size();) {
    const auto size = static_cast<std::size_t>(all[at]);
    parts.emplace_back(reinterpret_cast<const char*>(all.data() + at + 1), size);
    at += 1 + words(size);
  }
  return parts;
}

}  // namespace thenar::internal
