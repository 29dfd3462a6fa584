// The valve that moves, as WebAssembly sees it: one at a time. What makes no sense (no valve yet, no such hook, vertex or cable,
// a place that is not a number, a pressure out of range) is left alone: false.
#include <cstdint>

#include "clients/engine/buffers.h"
#include "clients/engine/live.h"

namespace {

coapt::LiveEngine live;

bool is_hook(int hook) { return live.valve() && hook >= 0 && hook < coapt::kHooks; }
bool holds(int hook) { return is_hook(hook) && live.valve()->hook(hook).has_value(); }

}  // namespace

extern "C" {

/// LiveEngine::start() and change() of coapt_body(); return the status, and what they say is coapt_answer_bytes().
[[clang::export_name("coapt_live_start")]] int coapt_live_start() {
  auto& [path, body, given] = coapt::buffers();
  given = live.start(body);
  return given.status;
}
[[clang::export_name("coapt_live_change")]] int coapt_live_change() {
  auto& [path, body, given] = coapt::buffers();
  given = live.valve() ? live.change(body) : live.start(body);
  return given.status;
}

[[clang::export_name("coapt_live_pressure")]] bool coapt_live_pressure(double mmhg) {
  const auto [lowest, highest] = coapt::kLivePressures_mmhg;
  if (!live.valve() || !(mmhg >= lowest && mmhg <= highest)) return false;
  live.valve()->set_pressure(mmhg);
  return true;
}

[[clang::export_name("coapt_live_grab")]] bool coapt_live_grab(int hook, int vertex) {
  if (!is_hook(hook) || vertex < 0 || vertex >= live.vertices()) return false;
  live.valve()->grab(hook, vertex);
  return true;
}
[[clang::export_name("coapt_live_grab_cable")]] bool coapt_live_grab_cable(int hook, int cable,
                                                                           double share) {
  if (!is_hook(hook) || cable < 0 || cable >= live.cables() || !(share >= 0.0 && share <= 1.0))
    return false;
  live.valve()->grab_cable(hook, cable, share);
  return true;
}
[[clang::export_name("coapt_live_move")]] bool coapt_live_move(int hook, double x_mm, double y_mm,
                                                               double z_mm) {
  const coapt::Vec3 hand_mm(x_mm, y_mm, z_mm);
  if (!holds(hook) || !hand_mm.allFinite()) return false;
  live.valve()->move_to(hook, hand_mm);
  return true;
}
[[clang::export_name("coapt_live_pull")]] bool coapt_live_pull(int hook, double x_n, double y_n,
                                                               double z_n) {
  const coapt::Vec3 force_n(x_n, y_n, z_n);
  if (!holds(hook) || !force_n.allFinite()) return false;
  live.valve()->pull_with(hook, force_n);
  return true;
}
[[clang::export_name("coapt_live_release")]] bool coapt_live_release(int hook) {
  if (!is_hook(hook)) return false;
  live.valve()->release(hook);
  return true;
}

/// So many steps, at least.
[[clang::export_name("coapt_live_advance")]] bool coapt_live_advance(int steps) {
  if (!live.valve()) return false;
  live.valve()->advance(steps);
  return true;
}
[[clang::export_name("coapt_live_at_rest")]] bool coapt_live_at_rest() {
  return !live.valve() || live.valve()->at_rest();
}

/// LiveEngine::take_picture(), and how many numbers that is; 0 before a start.
[[clang::export_name("coapt_live_picture")]] std::uint32_t coapt_live_picture() {
  return live.valve() ? static_cast<std::uint32_t>(live.take_picture().size()) : 0;
}
[[clang::export_name("coapt_live_picture_at")]] const float* coapt_live_picture_at() {
  return live.picture().data();
}
/// The vertices, unrounded: x, y, z each, mm. @pre started.
[[clang::export_name("coapt_live_vertices_mm")]] const double* coapt_live_vertices_mm() {
  return live.valve()->vertices_mm().data();
}
[[clang::export_name("coapt_live_vertices")]] int coapt_live_vertices() { return live.vertices(); }
}
