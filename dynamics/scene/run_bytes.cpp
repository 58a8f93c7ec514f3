#include "dynamics/scene/run_bytes.h"

#include <cstring>
#include <type_traits>

#include "base/error.h"

namespace thenar {
namespace {

/// Writes what it is given.
class ByteWriter {
 public:
  template <typename T>
  void plain(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void count(std::size_t& value) { plain(value); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads into what it is given.
class ByteReader {
 public:
  explicit ByteReader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  void plain(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    require(bytes_.size() - at_ >= sizeof value, "a run of a scene is cut short at {} bytes",
            bytes_.size());
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  /// Reads a number of entries, each of which has at least one byte.
  void count(std::size_t& value) {
    plain(value);
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

template <typename Stream, typename Vector>
void pass_vector(Stream& stream, Vector& vector) {
  // Size first, so that a reader can make room.
  auto size = static_cast<std::size_t>(vector.size());
  stream.count(size);
  vector.resize(static_cast<Eigen::Index>(size));
  for (Eigen::Index i = 0; i < vector.size(); ++i) stream.plain(vector[i]);
}

// Structs are taken apart by name, so that a member that is added does not compile until it is
// passed.

template <typename Stream>
void pass_contact(Stream& stream, ContactSample& contact) {
  auto& [a, b, id, point, normal, force, torsion, gap, mode, area, stick] = contact;
  for (int* each : {&a, &b, &id}) stream.plain(*each);
  for (Eigen::Vector3d* each : {&point, &normal, &force})
    for (Eigen::Index k = 0; k < 3; ++k) stream.plain((*each)[k]);
  for (double* each : {&torsion, &gap, &area, &stick}) stream.plain(*each);
  stream.plain(mode);
}

template <typename Stream>
void pass_sample(Stream& stream, SceneSample& sample) {
  auto& [t, q, v, z, contacts, energy, w] = sample;
  stream.plain(t);
  pass_vector(stream, q);
  pass_vector(stream, v);
  pass_vector(stream, z);
  pass_vector(stream, w);
  std::size_t touching = contacts.size();
  stream.count(touching);
  contacts.resize(touching);
  for (ContactSample& contact : contacts) pass_contact(stream, contact);
  auto& [kinetic, weight, springs, of_elements, of_passive] = energy;
  for (double* each : {&kinetic, &weight, &springs, &of_elements, &of_passive}) stream.plain(*each);
}

template <typename Stream>
void pass_cost(Stream& stream, SceneCost& cost) {
  auto& [steps, rejected, substeps, impacts, passed, unsolved, leaps, coarse, residual, deepest,
         beyond, asleep, cpu] = cost;
  for (long* each : {&steps, &rejected, &substeps, &impacts, &passed, &unsolved, &leaps, &coarse})
    stream.plain(*each);
  for (double* each : {&residual, &deepest, &asleep, &cpu}) stream.plain(*each);
  pass_vector(stream, beyond);
}

/// Writes or reads a run, its parts in the same order.
template <typename Stream>
void pass_run(Stream& stream, SceneRun& run) {
  // Samples, cost and the message of a failure, each list after its size.
  auto& [status, samples, cost, message] = run;
  stream.plain(status);
  std::size_t instants = samples.size();
  stream.count(instants);
  samples.resize(instants);
  for (SceneSample& sample : samples) pass_sample(stream, sample);
  pass_cost(stream, cost);
  std::size_t letters = message.size();
  stream.count(letters);
  message.resize(letters);
  for (char& letter : message) stream.plain(letter);
}

}  // namespace

std::string bytes_of(const SceneRun& run) {
  SceneRun copy = run;
  ByteWriter writer;
  pass_run(writer, copy);
  return writer.take();
}

SceneRun run_of_bytes(const std::string& bytes) {
  SceneRun run;
  ByteReader reader(bytes);
  pass_run(reader, run);
  reader.end();
  return run;
}

}  // namespace thenar
