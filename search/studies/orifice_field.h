// The orifice as a function of where displaced tips lie: closed there, or looked up between nodes
// of the 1 mm grid of displacements (trilinear; thesis 4.2.3 looks up in its computed
// displacements).
//
// Asking is cheap and never closes anything: what is not known is noted, and closed by the next
// close_wanted(), all of it side by side.
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "search/studies/orifice_table.h"

namespace coapt {

enum class Protocol {
  LookupClamped,   ///< looked up; positions outside 0 to 6 mm are taken as at the grid's border
  LookupExtended,  ///< looked up, the grid going on to wherever positions are
  Closed,          ///< every position closed
  Optimum          ///< the same, and each anchor at its own robust best suture length
};
inline constexpr std::array<Protocol, 4> kProtocols = {
    Protocol::LookupClamped, Protocol::LookupExtended, Protocol::Closed, Protocol::Optimum};
const char* to_string(Protocol protocol);  ///< "lookup-clamped", "lookup-extended", ...

class OrificeField {
 public:
  OrificeField(OrificeTable& table, Protocol protocol) : table_(table), protocol_(protocol) {}

  /// mm2 at a position (transverse, posterior, apical displacement of the tips, mm), if known.
  std::optional<double> at(Displaced displaced, const Vec3& position_mm);
  /// Whether LookupClamped clamps it.
  static bool outside_grid(const Vec3& position_mm);
  bool anything_wanted() const { return !wanted_.empty(); }
  void close_wanted();

 private:
  std::optional<double> closed(Displaced displaced, const Vec3& position_mm);
  std::optional<double> looked_up(Displaced displaced, const Vec3& position_mm);

  OrificeTable& table_;
  Protocol protocol_;
  std::vector<Configuration> wanted_;
  std::unordered_set<ConfigurationKey, ConfigurationKeyHash> wanted_keys_;
};

}  // namespace coapt
