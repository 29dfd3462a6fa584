#include "io/json/subject.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "io/json/json.h"
#include "io/json/valve_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

constexpr std::uint64_t kPrime = 0x13b;  // of FNV: the prime is 2^88 + 0x13b
constexpr std::uint64_t kHalf = 0xffffffff;

Json values_of(const ClosureOptions& options) {
  // Names all fields, so that this does not compile when there is one more.
  const auto& [method, membrane, residual_tolerance, way_tolerance_mm, max_steps,
               contact_pressure_mpa, speed, damping_per_ms, samples, edge_contact, self_contact,
               motion, budget] = options;  // motion moves nothing; what is unfinished is not kept
  return Json::array({to_string(method), to_string(membrane), residual_tolerance, way_tolerance_mm,
                      max_steps, contact_pressure_mpa, speed, damping_per_ms, samples, edge_contact,
                      static_cast<int>(self_contact)});
}

std::string text_of(const Valve& valve, const ClosureOptions& options) {
  Valve nameless = valve;
  nameless.name.clear();
  nameless.provenance.clear();
  nameless.observed.clear();  // weighs closures, changes none
  std::string text = write_valve(nameless) + values_of(options).dump() + '\n';
  return text + std::string(version()) + ' ' + std::to_string(kClosureRevision);
}

}  // namespace

std::string subject_of(const Valve& valve, const ClosureOptions& options) {
  return fnv1a_128(text_of(valve, options));
}

std::string plan_subject_of(const Valve& valve, const ClosureOptions& options) {
  return fnv1a_128(text_of(valve, options) + " plans " + std::to_string(kPlanRevision));
}

std::string closures_revision() {
  return std::string(version()) + " closures " + std::to_string(kClosureRevision) + " plans " +
         std::to_string(kPlanRevision);
}

std::string fnv1a_128(std::string_view bytes) {
  std::uint64_t high = 0x6c62272e07bb0142, low = 0x62b821756295c58d;
  for (const char byte : bytes) {
    low ^= static_cast<unsigned char>(byte);
    const std::uint64_t lower = (low & kHalf) * kPrime;
    const std::uint64_t upper = (low >> 32) * kPrime + (lower >> 32);
    high = high * kPrime + (upper >> 32) + (low << 24);
    low = (upper << 32) | (lower & kHalf);
  }
  std::array<char, 33> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                static_cast<unsigned long long>(high), static_cast<unsigned long long>(low));
  return digits.data();
}

}  // namespace coapt
