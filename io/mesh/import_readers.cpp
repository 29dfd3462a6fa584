// Points and chordae from tables and JSON.
//
// Points: columns x, y, z by name in any order (r, a, s and l, p, s of Slicer's tables, too); without names three columns.
// Chordae in CSV: columns by name (id, papillary, ins_x, ins_y, ins_z, tip_x, tip_y, tip_z, and if
// there is one kind), others are passed over; without names id,leaflet,papillary,ins_x,...,tip_z in
// this order. Chordae in JSON: {"chordae": [{"id", "papillary", "insertion_mm", "tip_mm",
// "kind"}]}.

#include "io/mesh/import_readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

#include "core/valve/problem_list.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/mesh/column_names.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/import_valve.h"
#include "io/mesh/papillary_side.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

const Error kEmpty = {ErrorCode::MissingField, "", "has no rows"};
constexpr Range kCoordinateMm = {-1e5, 1e5};

const std::vector<std::string> kSides = {"AL", "PM", "anterolateral", "posteromedial"};
const std::vector<std::string> kKinds = {"marginal", "strut", "basal"};

Side side_at(std::size_t choice) {
  return choice % 2 == 0 ? Side::Anterolateral : Side::Posteromedial;
}

ChordaKind kind_at(std::size_t choice) {
  constexpr std::array kinds = {ChordaKind::Marginal, ChordaKind::Strut, ChordaKind::Basal};
  return kinds[choice];
}

/// One row of a table: its fields by name of column, and where problems with them are listed.
struct RowReader {
  const CsvTable& table;
  const CsvRow& row;
  std::map<std::string, std::size_t, std::less<>> columns;
  std::string path;
  ProblemList& problems;

  std::string_view field(std::string_view column) const {
    return row.fields[columns.find(column)->second];
  }

  void add(ErrorCode code, std::string_view column, const std::string& message) const {
    problems.add(code, path + '/' + std::string(column),
                 "line " + std::to_string(row.line) + ": " + message);
  }

  /// In the unit of the table, whatever its own column states.
  double coordinate(std::string_view column) const {
    const std::optional<double> number = table.number(field(column));
    const double value = number.value_or(0.0) * in_unit_of_table(columns.find(column)->second);
    if (!number) {
      add(ErrorCode::WrongType, column, "must be a number");
    } else if (!(value >= kCoordinateMm.min && value <= kCoordinateMm.max)) {
      add(ErrorCode::OutOfRange, column, "is " + shown(value) + ", must be from -1e5 to 1e5 mm");
    } else {
      return value;
    }
    return 0.0;
  }

  double in_unit_of_table(std::size_t column) const {
    if (column >= table.units.size() || table.units[column] == table.unit) return 1.0;
    const auto of_table = unit_in_mm(table.unit), of_column = unit_in_mm(table.units[column]);
    return of_table && of_column ? *of_column / *of_table : 1.0;
  }

  /// Anterolateral and a problem if it is neither.
  Side side(std::string_view column) const {
    const std::optional<Side> named = papillary_side(field(column));
    if (!named)
      add(ErrorCode::BadReference, column,
          "must be AL or PM, in any wording (anterolateral, ALPM; posteromedial, PMPM)");
    return named.value_or(Side::Anterolateral);
  }

  /// Index of the field among `names`, 0 and a problem if it is none of them.
  std::size_t choice(std::string_view column, const std::vector<std::string>& names) const {
    std::string word(field(column));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::find(names.begin(), names.end(), word);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string message = "must be one of";
    for (const std::string& name : names) message += ' ' + name;
    add(ErrorCode::BadReference, column, message);
    return 0;
  }
};

/// A reader of row `i`; none, and a problem, if it has too few fields or too many.
std::optional<RowReader> reader(const CsvTable& table, const std::vector<std::string>& names,
                                std::size_t i, const std::string& path, ProblemList& problems) {
  RowReader row{table, table.rows[i], {}, path + '/' + std::to_string(i), problems};
  for (std::size_t column = 0; column < names.size(); ++column) {
    row.columns.try_emplace(names[column], column);
  }
  const std::size_t fields = row.row.fields.size();
  const bool may_go_on = table.names.empty() || table.may_go_on;
  if (fields == names.size() || (fields > names.size() && may_go_on)) return row;
  problems.add(ErrorCode::MissingField, row.path,
               "line " + std::to_string(row.row.line) + ": has " + std::to_string(fields) +
                   " fields, must have " + std::to_string(names.size()));
  return {};
}

/// Of a table whose headings state axes that are neither LPS nor RAS.
std::optional<Error> unknown_axes(const CsvTable& table) {
  if (table.axes.empty() || table.axes == "lps" || table.axes == "ras") return {};
  std::string axes = table.axes;
  for (char& letter : axes)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return Error{ErrorCode::Unsupported, "",
               "has the axes " + axes + " in the names of its columns; must be LPS or RAS"};
}

Expected<std::vector<ImportedChorda>> read_chordae_csv(std::string_view text) {
  const Expected<CsvTable> table = read_csv(text, {"papillary"});
  if (!table) return table.errors();
  if (const auto axes = unknown_axes(*table)) return *axes;
  const std::vector<std::string> needed = {"papillary", "ins_x", "ins_y", "ins_z",
                                           "tip_x",     "tip_y", "tip_z"};
  std::vector<std::string> names = table->names;
  if (names.empty()) {
    names = needed;
    for (const char* first : {"leaflet", "id"}) names.insert(names.begin(), first);
  }
  const auto has = [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  ProblemList problems;
  for (const std::string& name : needed) {
    if (has(name)) continue;
    problems.add(ErrorCode::MissingField, "/chordae", "has no column " + name);
  }
  if (!problems.empty()) return std::move(problems).take();
  if (table->rows.empty()) return kEmpty;
  std::vector<ImportedChorda> chordae;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto row = reader(*table, names, i, "/chordae", problems);
    if (!row) continue;
    ImportedChorda chorda;
    chorda.id = has("id") ? std::string(row->field("id")) : std::to_string(i + 1);
    chorda.side = row->side("papillary");
    if (has("kind")) chorda.kind = kind_at(row->choice("kind", kKinds));
    chorda.insertion_mm = {row->coordinate("ins_x"), row->coordinate("ins_y"),
                           row->coordinate("ins_z")};
    chorda.tip_mm = {row->coordinate("tip_x"), row->coordinate("tip_y"), row->coordinate("tip_z")};
    chordae.push_back(chorda);
  }
  if (!problems.empty()) return std::move(problems).take();
  return chordae;
}

Vec3 read_position(const JsonPlace& place) {
  const Vec3 position = read_vector(place);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(position[axis] < kCoordinateMm.min || position[axis] > kCoordinateMm.max)) continue;
    add_problem(place, ErrorCode::OutOfRange,
                "is " + shown(position[axis]) + ", must be from -1e5 to 1e5 mm");
  }
  return position;
}

ImportedChorda read_chorda(const JsonPlace& place) {
  ImportedChorda chorda;
  const auto side = [](const JsonPlace& at) {
    return side_at(read_choice(at, kSides).value_or(0));
  };
  const auto kind = [](const JsonPlace& at) {
    return kind_at(read_choice(at, kKinds).value_or(0));
  };
  read_fields(place, {{"id", into(chorda.id, read_string)},
                      {"papillary", into(chorda.side, side)},
                      {"insertion_mm", into(chorda.insertion_mm, read_position)},
                      {"tip_mm", into(chorda.tip_mm, read_position)},
                      {"kind", into(chorda.kind, kind), false}});
  return chorda;
}

Expected<std::vector<ImportedChorda>> read_chordae_json(std::string_view text) {
  const Expected<Json> document = parse_json(text);
  if (!document) return document.errors();
  ProblemList problems;
  std::vector<ImportedChorda> chordae;
  const auto list = [](const JsonPlace& place) { return read_list(place, read_chorda); };
  read_fields(JsonPlace{*document, problems}, {{"chordae", into(chordae, list)}});
  if (!problems.empty()) return std::move(problems).take();
  return chordae;
}

}  // namespace

namespace {

/// Names of the coordinates, as the columns of a table call them; "x", "y" and "z" of one without names.
Expected<std::vector<std::string>> point_columns(const CsvTable& table, std::size_t before) {
  if (const auto axes = unknown_axes(table)) return *axes;
  if (table.names.empty()) {
    std::size_t fields = table.rows.empty() ? 3 + before : table.rows[0].fields.size();
    while (fields > 3 + before && table.rows[0].fields[fields - 1].empty()) --fields;
    if (fields <= 3 + before) return std::vector<std::string>{"x", "y", "z"};
    return Error{ErrorCode::MissingField, "",
                 "line " + std::to_string(table.rows[0].line) + ": has " + std::to_string(fields) +
                     " columns without names, must have " + std::to_string(3 + before) +
                     ", or names in its first line, x, y and z among them"};
  }
  const bool of_tips = table.has("tip_x") && table.has("tip_y") && table.has("tip_z");
  if (of_tips && before > 0 && !table.has("x") && !table.has("ins_x"))
    return std::vector<std::string>{"tip_x", "tip_y", "tip_z"};
  for (const char* names : {"xyz", "ras", "lps"})
    if (table.has(std::string(1, names[0])) && table.has(std::string(1, names[1])) &&
        table.has(std::string(1, names[2])))
      return std::vector<std::string>{{names[0]}, {names[1]}, {names[2]}};
  return Error{ErrorCode::MissingField, "", "has names of columns, but not all of x, y and z"};
}

/// All names of a table, or `otherwise`, by place.
std::vector<std::string> names_or(const CsvTable& table,
                                  const std::vector<std::string>& otherwise) {
  return table.names.empty() ? otherwise : table.names;
}

}  // namespace

Expected<Points> read_points_csv(std::string_view text) {
  const Expected<CsvTable> table = read_csv(text, {"x"});
  if (!table) return table.errors();
  if (table->rows.empty()) return kEmpty;
  const Expected<std::vector<std::string>> axes = point_columns(*table, 0);
  if (!axes) return axes.errors();
  ProblemList problems;
  Points points(std::ssize(table->rows), 3);
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto row = reader(*table, names_or(*table, *axes), i, "/points", problems);
    if (!row) continue;
    points.row(static_cast<Eigen::Index>(i)) << row->coordinate((*axes)[0]),
        row->coordinate((*axes)[1]), row->coordinate((*axes)[2]);
  }
  if (!problems.empty()) return std::move(problems).take();
  return points;
}

std::optional<LengthUnit> stated_unit(std::string_view table,
                                      std::initializer_list<std::string_view> columns) {
  const Expected<CsvTable> read = read_csv(table, columns);
  return read ? unit_named(read->unit) : std::nullopt;
}

Expected<std::vector<ImportedTip>> read_tips_csv(std::string_view text) {
  const Expected<CsvTable> table = read_csv(text, {"papillary", "label", "name"});
  if (!table) return table.errors();
  if (table->rows.empty()) return kEmpty;
  const Expected<std::vector<std::string>> axes = point_columns(*table, 1);
  if (!axes) return axes.errors();
  std::string side = "papillary";
  for (const char* column : {"label", "name"})
    if (!table->has(side) && table->has(column)) side = column;
  if (!table->names.empty() && !table->has(side))
    return Error{ErrorCode::MissingField, "", "has no column papillary, label or name"};
  ProblemList problems;
  std::vector<ImportedTip> tips;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const auto row = reader(*table, names_or(*table, {side, (*axes)[0], (*axes)[1], (*axes)[2]}), i,
                            "/tips", problems);
    if (!row) continue;
    tips.push_back(
        {row->side(side),
         {row->coordinate((*axes)[0]), row->coordinate((*axes)[1]), row->coordinate((*axes)[2])}});
  }
  if (!problems.empty()) return std::move(problems).take();
  return tips;
}

Expected<std::vector<LabelledPoint>> read_labelled_points_csv(std::string_view text) {
  const Expected<CsvTable> table = read_csv(text, {"label", "name"});
  if (!table) return table.errors();
  if (table->rows.empty()) return kEmpty;
  const Expected<std::vector<std::string>> axes = point_columns(*table, 1);
  if (!axes) return axes.errors();
  const std::string label = table->has("name") && !table->has("label") ? "name" : "label";
  if (!table->names.empty() && !table->has(label))
    return Error{ErrorCode::MissingField, "", "has no column label"};
  const auto names = names_or(*table, {label, (*axes)[0], (*axes)[1], (*axes)[2]});
  ProblemList problems;
  std::vector<LabelledPoint> points;
  for (std::size_t i = 0; i < table->rows.size(); ++i)
    if (const auto row = reader(*table, names, i, "/points", problems))
      points.push_back({std::string(row->field(label)),
                        {row->coordinate((*axes)[0]), row->coordinate((*axes)[1]),
                         row->coordinate((*axes)[2])}});
  if (!problems.empty()) return std::move(problems).take();
  return points;
}

LeftOver unused_columns(const CsvTable& table, std::initializer_list<std::string_view> used) {
  LeftOver unused;
  const bool points = std::find(used.begin(), used.end(), "x") != used.end();
  unused.of = table.names.size();
  for (const std::string& name : table.names) {
    const bool axis = points && name.size() == 1 &&
                      std::string_view("xyzraslp").find(name[0]) != std::string_view::npos;
    if (!name.empty() && !axis && std::find(used.begin(), used.end(), name) == used.end())
      unused.names.push_back(name);
  }
  return unused;
}

Expected<std::vector<ImportedChorda>> read_chordae(std::string_view text, std::string_view format) {
  if (is_table_format(format)) return read_chordae_csv(text);
  if (format == "json") return read_chordae_json(text);
  return Error{
      ErrorCode::Unsupported, "",
      "has the chordae format '" + std::string(format.substr(0, 20)) + "', must be csv or json"};
}

}  // namespace coapt
