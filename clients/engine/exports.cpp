// The engine as WebAssembly sees it: bytes in, bytes out. One call at a time; what an answer points to lasts until the next one.
#include <cstdint>
#include <string>

#include "clients/engine/engine.h"

namespace {

std::string path, body;
coapt::EngineAnswer given;

}  // namespace

extern "C" {

/// Room for a request's path and body, UTF-8, to be written to before coapt_answer().
[[clang::export_name("coapt_path")]] char* coapt_path(std::uint32_t size) {
  path.resize(size);
  return path.data();
}
[[clang::export_name("coapt_body")]] char* coapt_body(std::uint32_t size) {
  body.resize(size);
  return body.data();
}

/// Answers; returns the status.
[[clang::export_name("coapt_answer")]] int coapt_answer() {
  given = coapt::answer(path, body);
  return given.status;
}
[[clang::export_name("coapt_answer_bytes")]] const char* coapt_answer_bytes() {
  return given.body.data();
}
[[clang::export_name("coapt_answer_size")]] std::uint32_t coapt_answer_size() {
  return static_cast<std::uint32_t>(given.body.size());
}

/// What was closed: x, y, z of each vertex, mm.
[[clang::export_name("coapt_closed_mm")]] const double* coapt_closed_mm() {
  return given.closed_mm.data();
}
[[clang::export_name("coapt_closed_vertices")]] std::uint32_t coapt_closed_vertices() {
  return static_cast<std::uint32_t>(given.closed_mm.rows());
}
}
