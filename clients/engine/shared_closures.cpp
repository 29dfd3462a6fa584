// Structured bindings name every field, so the compiler asks for each that is added.
#include "clients/engine/shared_closures.h"

#include <algorithm>
#include <concepts>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace coapt {
namespace {

template <class T>
constexpr bool kPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends values.
class Writer {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  void put_raw(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  template <class T>
  requires kPlain<T>
  void put(const T& value) { put_raw(&value, sizeof value); }
  void put(const std::string& text) {
    put(text.size());
    put_raw(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(list.size());
    for (const T& one : list) put(one);
  }
  template <class T, std::size_t kSize>
  void put(const std::array<T, kSize>& list) {
    for (const T& one : list) put(one);
  }
  template <class T, int kRows, int kColumns, int kOrder>
  void put(const Eigen::Matrix<T, kRows, kColumns, kOrder>& matrix) {
    put(matrix.rows());
    put_raw(matrix.data(), sizeof(T) * static_cast<std::size_t>(matrix.size()));
  }
  template <class T>
  requires std::is_class_v<T>
  void put(const T& whole) { fields(*this, whole); }

  std::string bytes_;
};

/// Takes them again.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }

 private:
  void take_raw(void* into, std::size_t size) {
    std::memcpy(into, left_.data(), size);
    left_.remove_prefix(size);
  }
  template <class T>
  requires kPlain<T>
  void take(T& value) { take_raw(&value, sizeof value); }
  std::size_t take_size() {
    std::size_t size = 0;
    take(size);
    return size;
  }
  void take(std::string& text) {
    text.resize(take_size());
    take_raw(text.data(), text.size());
  }
  template <class T>
  void take(std::vector<T>& list) {
    list.resize(take_size());
    for (T& one : list) take(one);
  }
  void take(Points& points) {
    Index rows = 0;
    take(rows);
    points.resize(rows, 3);
    take_raw(points.data(), sizeof(double) * static_cast<std::size_t>(points.size()));
  }
  template <class T>
  requires std::is_class_v<T>
  void take(T& whole) { fields(*this, whole); }

  std::string_view left_;
};

template <class T, class Whole>
concept Like = std::same_as<std::remove_const_t<T>, Whole>;

template <class Archive>
void fields(Archive& archive, Like<ExponentialTissue> auto& tissue) {
  auto& [c0, c1, c2] = tissue;
  archive(c0, c1, c2);
}
template <class Archive>
void fields(Archive& archive, Like<NamedLeaflet> auto& leaflet) {
  auto& [name, thickness, tissue] = leaflet;
  archive(name, thickness, tissue);
}
template <class Archive>
void fields(Archive& archive, Like<Landmarks> auto& landmarks) {
  auto& [al_trigone, pm_trigone, saddle, mid, al_commissure, pm_commissure] = landmarks;
  archive(al_trigone, pm_trigone, saddle, mid, al_commissure, pm_commissure);
}
template <class Archive>
void fields(Archive& archive, Like<PapillaryHead> auto& head) {
  auto& [id, side, rest, tip] = head;
  archive(id, side, rest, tip);
}
template <class Archive>
void fields(Archive& archive, Like<Insertion> auto& insertion) {
  auto& [face, weights] = insertion;
  archive(face, weights);
}
template <class Archive>
void fields(Archive& archive, Like<ChordaSegment> auto& segment) {
  auto& [parent, length, diameter, zone, modulus, inserts, insertion, branch_point] = segment;
  archive(parent, length, diameter, zone, modulus, inserts, insertion, branch_point);
}
template <class Archive>
void fields(Archive& archive, Like<Chorda> auto& chorda) {
  auto& [id, kind, head, ruptured, segments] = chorda;
  archive(id, kind, head, ruptured, segments);
}
template <class Archive>
void fields(Archive& archive, Like<Tie> auto& tie) {
  auto& [id, anterior, posterior, length, zone, stiffness] = tie;
  archive(id, anterior, posterior, length, zone, stiffness);
}
template <class Archive>
void fields(Archive& archive, Like<Tissue> auto& tissue) {
  auto& [density, thickness, along_pre, along_post, along_transition, across_pre, across_post,
         across_transition, reference, along, across, bending, chordae] = tissue;
  archive(density, thickness, along_pre, along_post, along_transition, across_pre, across_post,
          across_transition, reference, along, across, bending, chordae);
}
template <class Archive>
void fields(Archive& archive, Like<SystolicMotion> auto& systole) {
  auto& [contraction, approach] = systole;
  archive(contraction, approach);
}
template <class Archive>
void fields(Archive& archive, Like<Valve> auto& valve) {
  auto& [name, provenance, rest, faces, segments, leaflets, face_leaflet, fibre, annulus,
         annulus_mm, landmarks, heads, chordae, ties, tissue, pressure, systole, drawn_chordae,
         fitted, observed, patient] = valve;
  archive(rest, faces, segments, leaflets, face_leaflet, fibre, annulus, annulus_mm, landmarks,
          heads, chordae, ties, tissue, pressure, systole);
}
template <class Archive>
void fields(Archive& archive, Like<ClosureOptions> auto& options) {
  auto& [method, membrane, residual, way, most_steps, contact, speed, damping, samples,
         edge_contact, self_contact, motion, budget] = options;
  archive(method, membrane, residual, way, most_steps, contact, speed, damping, samples,
          edge_contact, self_contact, motion, budget.vertex_steps);
}
template <class Archive>
void fields(Archive& archive, Like<ClosureAttempt> auto& attempt) {
  auto& [how, status, pairs, residual, steps] = attempt;
  archive(how, status, pairs, residual, steps);
}
template <class Archive>
void fields(Archive& archive, Like<ClosureResult> auto& closure) {
  auto& [method, membrane, residual_tolerance, way_tolerance, status, closed, samples, motion,
         tension, tie_tension, branch_points, residual, steps, crossing, pairs, guarded, attempts,
         predicted, unfinished] = closure;
  archive(method, membrane, residual_tolerance, way_tolerance, status, closed, samples, motion,
          tension, tie_tension, branch_points, residual, steps, crossing, pairs, guarded, attempts,
          predicted, unfinished);
}

/// Two lanes, each of words of 64 bits that are multiplied and folded.
ClosureKey hash_of(std::string_view bytes) {
  ClosureKey key = {0x9e3779b97f4a7c15u, bytes.size()};
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    key[0] = (key[0] ^ word) * 0xff51afd7ed558ccdu;
    key[0] ^= key[0] >> 32;
    key[1] = (key[1] + word) * 0xc4ceb9fe1a85ec53u;
    key[1] ^= key[1] >> 29;
  }
  return key;
}

}  // namespace

ClosureKey closure_key(const Valve& valve, const ClosureOptions& options,
                       const ClosureResult* neighbour) {
  Writer writer;
  writer('c', valve, options, neighbour != nullptr);
  if (neighbour != nullptr) writer(*neighbour);
  return hash_of(writer.take());
}

ClosureKey opening_key(const Valve& valve) {
  Writer writer;
  writer('o', valve);
  return hash_of(writer.take());
}

std::string bytes_of(const ClosureResult& closure) {
  Writer writer;
  writer(closure);
  return writer.take();
}

ClosureResult closure_from(std::string_view bytes) {
  ClosureResult closure;
  Reader reader(bytes);
  reader(closure);
  return closure;
}

}  // namespace coapt
