// The engine as WebAssembly sees it: bytes in, bytes out. One call at a time; what an answer points to lasts until the next one.
#include <cstdint>

#include "clients/engine/buffers.h"

extern "C" {

/// Room for a request's path and body, UTF-8, to be written to before coapt_answer().
[[clang::export_name("coapt_path")]] char* coapt_path(std::uint32_t size) {
  coapt::buffers().path.resize(size);
  return coapt::buffers().path.data();
}
[[clang::export_name("coapt_body")]] char* coapt_body(std::uint32_t size) {
  coapt::buffers().body.resize(size);
  return coapt::buffers().body.data();
}

/// Answers; returns the status.
[[clang::export_name("coapt_answer")]] int coapt_answer() {
  auto& [path, body, given] = coapt::buffers();
  given = coapt::answer(path, body);
  return given.status;
}
[[clang::export_name("coapt_answer_bytes")]] const char* coapt_answer_bytes() {
  return coapt::buffers().given.body.data();
}
[[clang::export_name("coapt_answer_size")]] std::uint32_t coapt_answer_size() {
  return static_cast<std::uint32_t>(coapt::buffers().given.body.size());
}

/// What was closed: x, y, z of each vertex, mm.
[[clang::export_name("coapt_closed_mm")]] const double* coapt_closed_mm() {
  return coapt::buffers().given.closed_mm.data();
}
[[clang::export_name("coapt_closed_vertices")]] std::uint32_t coapt_closed_vertices() {
  return static_cast<std::uint32_t>(coapt::buffers().given.closed_mm.rows());
}
}
