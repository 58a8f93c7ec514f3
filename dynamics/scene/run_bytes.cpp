#include "dynamics/scene/run_bytes.h"

#include <cstring>
#include <type_traits>

#include "base/error.h"

namespace thenar {
namespace {

/// Stream that appends values to a string of bytes.
class ByteWriter {
 public:
  template <typename T>
  void pass_value(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void pass_count(std::size_t& value) { pass_value(value); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Stream that reads values from a string of bytes.
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  void pass_value(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    require(bytes_.size() - at_ >= sizeof value, "a run of a scene is cut short at {} bytes",
            bytes_.size());
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  /// Reads a number of entries, each of which has at least one byte.
  void pass_count(std::size_t& value) {
    pass_value(value);
    require(value <= bytes_.size() - at_, "a run of a scene promises {} entries in {} bytes", value,
            bytes_.size() - at_);
  }
  void end() const {
    require(at_ == bytes_.size(), "{} bytes behind the run of a scene", bytes_.size() - at_);
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// Passes the entries of a list by a function.
template <typename Stream, typename List, typename Pass>
void pass_list(Stream& stream, List& list, const Pass& pass) {
  // Size first, so that a reader can allocate the list.
  auto size = static_cast<std::size_t>(list.size());
  stream.pass_count(size);
  list.resize(static_cast<decltype(list.size())>(size));
  for (auto& each : list) pass(stream, each);
}

template <typename Stream, typename List>
void pass_values(Stream& stream, List& list) {
  pass_list(stream, list, [](Stream& to, auto& value) { to.pass_value(value); });
}

// Structured bindings make sure that a new member does not compile until it is passed, too.

template <typename Stream>
void pass_contact(Stream& stream, ContactSample& contact) {
  auto& [a, b, id, point, normal, force, torsion, gap, mode, area, stick] = contact;
  for (int* each : {&a, &b, &id}) stream.pass_value(*each);
  for (Eigen::Vector3d* each : {&point, &normal, &force})
    for (Eigen::Index k = 0; k < 3; ++k) stream.pass_value((*each)[k]);
  for (double* each : {&torsion, &gap, &area, &stick}) stream.pass_value(*each);
  stream.pass_value(mode);
}

template <typename Stream>
void pass_sample(Stream& stream, SceneSample& sample) {
  auto& [t, q, v, z, contacts, energy, w] = sample;
  stream.pass_value(t);
  pass_values(stream, q);
  pass_values(stream, v);
  pass_values(stream, z);
  pass_values(stream, w);
  pass_list(stream, contacts, pass_contact<Stream>);
  auto& [kinetic, weight, springs, of_elements, of_passive] = energy;
  for (double* each : {&kinetic, &weight, &springs, &of_elements, &of_passive})
    stream.pass_value(*each);
}

template <typename Stream>
void pass_cost(Stream& stream, SceneCost& cost) {
  auto& [steps, rejected, substeps, impacts, bursts, unsolved, tunnelling, inaccurate, residual,
         penetration, excess, rest, cpu] = cost;
  for (long* each :
       {&steps, &rejected, &substeps, &impacts, &bursts, &unsolved, &tunnelling, &inaccurate})
    stream.pass_value(*each);
  for (double* each : {&residual, &penetration, &rest, &cpu}) stream.pass_value(*each);
  pass_values(stream, excess);
}

/// Writes or reads a run; both use the same order of its parts.
template <typename Stream>
void pass_run(Stream& stream, SceneRun& run) {
  auto& [status, samples, cost, reason] = run;
  stream.pass_value(status);
  pass_list(stream, samples, pass_sample<Stream>);
  pass_cost(stream, cost);
  pass_values(stream, reason);
}

}  // namespace

std::string bytes_of(const SceneRun& run) {
  SceneRun copy = run;
  ByteWriter writer;
  pass_run(writer, copy);
  return writer.take();
}

SceneRun run_from_bytes(const std::string& bytes) {
  SceneRun run;
  ByteReader reader(bytes);
  pass_run(reader, run);
  reader.end();
  return run;
}

}  // namespace thenar
