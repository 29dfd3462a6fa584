// What coapt design ring leaves: files beside the ring's, and a summary.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "io/json/ring_design_json.h"
#include "search/rings/design_ring.h"

namespace coapt {

/// Files beside `ring.json`: the solid (.stl), picture (.svg), dimensions (.csv) and page (.html), in this order.
std::vector<std::string> ring_files(const std::string& ring_file);

/// Writes the ring and the files beside it. Returns an exit code.
int write_ring_files(const std::string& ring_file, double printed_size_mm,
                     const RingDesignResult& result, const RingDesignSource& source);

void print_ring_design(std::ostream& out, const RingDesignResult& result,
                       const RingDesignSource& source);

}  // namespace coapt
