// What `coapt valve calibrate` is asked, coapt.calibration/1, and what it found.
//
//   {"schema": "coapt.calibration/1",
//    "dimensions": {"ap_mm": 26, "strut_slack": 0.9, ...},       of the healthy valve, names of dimension_table()
//    "valves": {"normal": {"kind": "healthy"},                    all from the healthy one
//               "functional": {"kind": "functional", "remodelling": {"ap_dilation_percent": 18, ...}}},
//    "unknowns": [{"at": ["/dimensions/ap_mm"], "low": 25, "high": 33}, ...],
//    "targets": [{"valve": "normal", "quantity": "leak", "low": 0, "high": 1, "scale": 0.5, "weight": 2}, ...]}
//
// An unknown names numbers of this document by JSON pointers; the first one's value is where it starts, and all take its value. A
// target's band is the published range of its quantity if it says no other, its scale a quarter of the band.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json/json.h"
#include "search/studies/valve_calibration.h"

namespace coapt {

struct CalibrationFile {
  Json document;
  CalibrationProblem problem;
};

/// Every problem is listed, with its pointer and what is accepted.
Expected<CalibrationFile> read_calibration(std::string_view text);

/// The document with its unknowns at `values`.
Json with_values(Json document, const std::vector<double>& values);

/// One of the valves as coapt.dimensions/1.
std::string calibrated_dimensions(const CalibrationValves& valves, int valve);

}  // namespace coapt
