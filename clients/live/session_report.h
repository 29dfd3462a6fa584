// What a session was, for people, as JSON, and period by period.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "clients/live/live_session.h"
#include "io/json/json.h"

namespace coapt {

struct Spread {
  double median = 0.0, p99 = 0.0, largest = 0.0;
};
/// All 0 where there are no values.
Spread spread_of(std::vector<double> values);

/// coapt.live/1.
Json to_json(const SessionResult& session, double rate_hz);

void print_session(std::ostream& out, const SessionResult& session, double rate_hz);

/// CSV: t_ms, late_us, x, y, z (stylus, mm), fx, fy, fz (on the hand, N), holds, spot_x, spot_y, spot_z (mm), energy_mj.
std::string session_csv(const std::vector<SessionRow>& rows);

}  // namespace coapt
