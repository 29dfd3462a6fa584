#include "io/store/stored_valves.h"

#include <sqlite3.h>

#include "io/store/list_page.h"

namespace coapt {

void summarise_valves(Transaction& change) {
  change.run(R"(INSERT INTO valve_summaries
SELECT number, coalesce(json_extract(document, '$.name'), ''),
  coalesce(json_array_length(document, '$.vertices_mm'), 0), coalesce(json_array_length(document, '$.faces'), 0)
FROM (SELECT number, iif(json_valid(CAST(document AS TEXT)), CAST(document AS TEXT), '{}') AS document FROM valves
  WHERE NOT EXISTS (SELECT 1 FROM valve_summaries WHERE valve = number)))");
}

bool insert_valve(Transaction& change, const std::string& id, const std::string& document) {
  // Not INSERT OR IGNORE, which would pass over every constraint and not only over the key's.
  change.run("INSERT INTO valves (id, document) VALUES (?, ?) ON CONFLICT DO NOTHING",
             {id, Blob{document}});
  const bool is_new = change.changed() == 1;
  if (is_new) summarise_valves(change);
  return is_new;
}

Expected<bool> add_valve(JobStore& store, const std::string& id, const std::string& document) {
  Transaction change = store.writing("a valve cannot be kept");
  const bool is_new = insert_valve(change, id, document);
  return change.end_with(is_new);
}

Expected<std::optional<std::string>> stored_valve(const JobStore& store, const std::string& id) {
  return bytes_of(store.reading(), "SELECT document FROM valves WHERE id = ?", {id});
}

Expected<ValvePage> stored_valves(const JobStore& store, int size, std::int64_t before) {
  ValvePage page;
  Transaction reads = store.reading();
  page.next_before = read_page(
      reads,
      "SELECT number, id, name, vertices, triangles FROM valves JOIN valve_summaries ON "
      "valve = number WHERE number < ?",
      {upper_end(before)}, size, [&page](const Statement& row) {
        page.valves.push_back({bytes_at(row, 1), bytes_at(row, 2), sqlite3_column_int(row.get(), 3),
                               sqlite3_column_int(row.get(), 4)});
      });
  return reads.end_with(std::move(page));
}

Expected<bool> remove_valve(JobStore& store, const std::string& id) {
  Transaction change = store.writing("a valve cannot be removed");
  change.run("SELECT 1 FROM jobs WHERE valve = ? LIMIT 1", {id}, [&change](const Statement&) {
    change.refuse(ErrorCode::BadReference, "jobs refer to the valve: remove them first");
  });
  change.run("SELECT 1 FROM kept_plans WHERE valve = ? LIMIT 1", {id}, [&change](const Statement&) {
    change.refuse(ErrorCode::BadReference, "kept plans refer to the valve: remove them first");
  });
  change.run("DELETE FROM valves WHERE id = ?", {id});
  const bool was_there = change.changed() == 1;
  return change.end_with(was_there);
}

}  // namespace coapt
