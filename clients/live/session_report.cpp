#include "clients/live/session_report.h"

#include <algorithm>
#include <ostream>
#include <sstream>

#include "core/valve/number_text.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

const char* end_name(SessionEnd end) {
  switch (end) {
    case SessionEnd::Device:
      return "device";
    case SessionEnd::Time:
      return "time";
    case SessionEnd::Interrupt:
      return "interrupt";
    case SessionEnd::Lost:
      return "lost";
  }
  return "";
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"p99", spread.p99}, {"largest", spread.largest}};
}

double steps_per_second(const SessionResult& session) {
  return session.valve_seconds > 0.0 ? static_cast<double>(session.steps) / session.valve_seconds
                                     : 0.0;
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1;
  return {values[last / 2], values[last * 99 / 100], values[last]};
}

Json to_json(const SessionResult& session, double rate_hz) {
  return result_document("coapt.live/1", {{"end", end_name(session.end)},
                                          {"seconds", session.seconds},
                                          {"rate_hz", rate_hz},
                                          {"periods", session.periods},
                                          {"periods_missed", session.missed},
                                          {"late_us", spread_json(spread_of(session.late_us))},
                                          {"real_time_priority", session.real_time.priority},
                                          {"memory_locked", session.real_time.memory_locked},
                                          {"steps", session.steps},
                                          {"steps_per_second", steps_per_second(session)},
                                          {"look_us", spread_json(spread_of(session.look_us))},
                                          {"returns", session.returns},
                                          {"grasps", session.grasps},
                                          {"largest_force_n", session.largest_force_n},
                                          {"energy_mj", session.energy_mj},
                                          {"lowest_energy_mj", session.lowest_energy_mj}});
}

void print_session(std::ostream& out, const SessionResult& session, double rate_hz) {
  const Spread late = spread_of(session.late_us), look = spread_of(session.look_us);
  const auto whole = [](double number) { return with_decimals(number, 0); };
  out << session.periods << " periods of " << shown(1e3 / rate_hz) << " ms in "
      << with_decimals(session.seconds, 1) << " s, " << session.missed << " missed; late by "
      << whole(late.median) << " us (median), " << whole(late.p99) << " us (p99), "
      << whole(late.largest) << " us at most\n"
      << "valve: " << whole(steps_per_second(session)) << " steps a second while it moves; "
      << whole(look.median) << " us (median), " << whole(look.p99)
      << " us (p99) between two places of the spot; went back " << session.returns << " times\n"
      << "hand: " << session.grasps << " grasps, " << with_decimals(session.largest_force_n, 2)
      << " N at most, put in " << with_decimals(session.energy_mj, 2)
      << " mJ; lowest balance of a grasp " << with_decimals(session.lowest_energy_mj, 4) << " mJ\n"
      << "Lateness is that of this machine and of all that runs on it.\n";
}

std::string session_csv(const std::vector<SessionRow>& rows) {
  std::ostringstream csv;
  csv << "t_ms,late_us,x,y,z,fx,fy,fz,holds,spot_x,spot_y,spot_z,energy_mj\n";
  const auto point = [&csv](const Vec3& p) {
    for (const double c : p) csv << ',' << with_decimals(c, 4);
  };
  for (const SessionRow& row : rows) {
    csv << with_decimals(row.time_ms, 3) << ',' << with_decimals(row.late_us, 1);
    point(row.stylus_mm);
    point(row.force_n);
    csv << ',' << (row.holds ? 1 : 0);
    point(row.spot_mm);
    csv << ',' << with_decimals(row.energy_mj, 6) << '\n';
  }
  return std::move(csv).str();
}

}  // namespace coapt
