// Valves in a service's database; each document is kept as it came.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/store/job_store.h"

namespace coapt {

/// What a list says of a stored valve.
struct ValveSummary {
  std::string id, name;  ///< name: of the document; empty if it has none
  int vertices = 0, triangles = 0;
};

struct ValvePage {
  std::vector<ValveSummary> valves;  ///< newest first
  std::int64_t next_before = 0;      ///< 0: there are no more
};

/// Keeps a valve; true if it is new, else the first stays.
Expected<bool> add_valve(JobStore& store, const std::string& id, const std::string& document);
Expected<std::optional<std::string>> stored_valve(const JobStore& store, const std::string& id);
/// @param size from 1 @param before only those stored before that place; 0: all
Expected<ValvePage> stored_valves(const JobStore& store, int size, std::int64_t before);
/// False if there is none. BadReference if a job or a kept plan refers to it.
Expected<bool> remove_valve(JobStore& store, const std::string& id);

/// As part of a change: true if it is new.
bool insert_valve(Transaction& change, const std::string& id, const std::string& document);
/// Of all valves that have no summary yet. What is no valve has an empty one.
void summarise_valves(Transaction& change);

}  // namespace coapt
