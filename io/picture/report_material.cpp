#include "io/picture/report_material.h"

#include <charconv>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/picture/html.h"

namespace coapt {
namespace {

constexpr std::int32_t kVersion = 2;

// In a page no other text can begin with it: names and words that users give are escaped.
constexpr std::string_view kPlace = "<picture ";

std::string place_mark(const ReportPicture& picture) {
  return std::string(kPlace) + std::to_string(static_cast<int>(picture.view)) + ' ' +
         std::to_string(picture.plan) + '>';
}

/// Numbers as this machine has them in memory, texts after their length.
class MaterialWriter {
 public:
  template <class Number>
  void add(Number number) {
    static_assert(std::is_arithmetic_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void add(std::string_view text) {
    add(text.size());
    bytes_.append(text);
  }
  void add(const double* numbers, std::size_t count) {
    add(std::string_view(reinterpret_cast<const char*>(numbers), count * sizeof(double)));
  }
  void add(const Points& points) { add(points.data(), static_cast<std::size_t>(points.size())); }
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what a MaterialWriter wrote; after what cannot be, everything is empty.
class MaterialReader {
 public:
  explicit MaterialReader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    Number value = 0;
    if (const std::string_view bytes = taken(sizeof value); !bytes.empty())
      std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  std::string_view text() { return taken(number<std::size_t>()); }
  std::vector<double> numbers() {
    const std::string_view bytes = text();
    std::vector<double> values(bytes.size() / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
    return values;
  }
  Points points() {
    const std::vector<double> values = numbers();
    return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
  }
  /// How many there are of something that takes a byte or more.
  std::size_t count() {
    const auto read = number<std::size_t>();
    if (read > rest_.size()) is_sound_ = false;
    return is_sound_ ? read : 0;
  }
  bool is_sound() const { return is_sound_; }

 private:
  std::string_view taken(std::size_t size) {
    if (size > rest_.size()) is_sound_ = false;
    if (!is_sound_) return {};
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  std::string_view rest_;
  bool is_sound_ = true;
};

Errors no_material() {
  return {Error{ErrorCode::Unsupported, "", "the reports of this search cannot be made any more"}};
}

std::string closed_bytes(const ClosedValve& closed) {
  const ClosureResult& closure = closed.closure;
  MaterialWriter writer;
  writer.add(std::string_view(to_json(closed.plan).dump()));
  writer.add(static_cast<std::int32_t>(closure.membrane));
  writer.add(closure.residual_tolerance);
  writer.add(closure.way_tolerance_mm);
  writer.add(static_cast<std::int32_t>(closure.status));
  writer.add(closure.residual);
  writer.add(static_cast<std::int32_t>(closure.crossing ? 1 : 0));
  writer.add(static_cast<std::int32_t>(closure.crossing_pairs));
  writer.add(closure.closed_mm);
  writer.add(closure.branch_points_mm.size());
  for (const Points& points : closure.branch_points_mm) writer.add(points);
  writer.add(closure.tension_n.size());
  for (const std::vector<double>& tensions : closure.tension_n)
    writer.add(tensions.data(), tensions.size());
  return std::move(writer).take();
}

/// Measured anew, to the same bits.
Expected<ClosedValve> closed_of(std::string_view bytes, const Valve& before) {
  MaterialReader reader(bytes);
  const Expected<RepairPlan> plan = read_plan(reader.text());
  if (!plan) return no_material();
  const bool is_repaired = !plan->steps.empty();
  const Expected<Valve> valve = is_repaired ? apply_plan(before, *plan) : before;
  if (!valve) return no_material();
  ClosureResult closure;
  closure.membrane = static_cast<Membrane>(reader.number<std::int32_t>());
  closure.residual_tolerance = reader.number<double>();
  closure.way_tolerance_mm = reader.number<double>();
  closure.status = static_cast<ClosureStatus>(reader.number<std::int32_t>());
  closure.residual = reader.number<double>();
  closure.crossing = reader.number<std::int32_t>() != 0;
  closure.crossing_pairs = reader.number<std::int32_t>();
  closure.closed_mm = reader.points();
  closure.samples_mm = {closure.closed_mm};
  for (std::size_t i = reader.count(); i > 0; --i)
    closure.branch_points_mm.push_back(reader.points());
  for (std::size_t i = reader.count(); i > 0; --i) closure.tension_n.push_back(reader.numbers());
  if (!reader.is_sound() || closure.closed_mm.rows() != valve->rest_mm.rows() ||
      closure.branch_points_mm.size() != valve->chordae.size() ||
      closure.tension_n.size() != valve->chordae.size())
    return no_material();
  for (std::size_t i = 0; i < valve->chordae.size(); ++i)
    if (closure.tension_n[i].size() != valve->chordae[i].segments.size() ||
        closure.branch_points_mm[i].rows() != std::ssize(valve->chordae[i].segments))
      return no_material();
  ClosedValve closed{*valve, std::move(closure), {}};
  closed.measure = measure(closed.valve, closed.closure);
  return is_repaired ? with_repair(std::move(closed), before, *plan) : closed;
}

/// Parts of the material where they lie.
struct MaterialParts {
  std::vector<std::string_view> pages, after;
  std::string_view before;
};

Expected<MaterialParts> parts_of(std::string_view material) {
  MaterialReader reader(material);
  MaterialParts parts;
  if (reader.number<std::int32_t>() != kVersion) return no_material();
  for (std::size_t i = reader.count(); i > 0; --i) parts.pages.push_back(reader.text());
  parts.before = reader.text();
  for (std::size_t i = reader.count(); i > 0; --i) parts.after.push_back(reader.text());
  if (!reader.is_sound()) return no_material();
  return parts;
}

}  // namespace

ReportMaterial report_material(const SearchResult& result, const SearchRequest& request) {
  PlanPictures pictures = pictures_of(result);
  ReportMaterial material{{}, std::move(pictures.before), std::move(pictures.after)};
  PlanReport report{material.before, material.after, result, request, 0, today(), place_mark};
  material.pages.push_back(plan_report_html(report));
  for (const RankedPlan& plan : result.plans) {
    report.about = plan.rank;
    material.pages.push_back(plan_report_html(report));
  }
  return material;
}

std::string write_report_material(const ReportMaterial& material) {
  MaterialWriter writer;
  writer.add(kVersion);
  writer.add(material.pages.size());
  for (const std::string& page : material.pages) writer.add(std::string_view(page));
  writer.add(std::string_view(closed_bytes(material.before)));
  writer.add(material.after.size());
  for (const ClosedValve& closed : material.after)
    writer.add(std::string_view(closed_bytes(closed)));
  return std::move(writer).take();
}

Expected<std::size_t> report_pages(std::string_view material) {
  const Expected<MaterialParts> parts = parts_of(material);
  if (!parts) return parts.errors();
  return parts->pages.size();
}

Expected<std::string> report_page(std::string_view material, std::size_t page, const Valve& valve) {
  const Expected<MaterialParts> parts = parts_of(material);
  if (!parts || page >= parts->pages.size()) return no_material();
  const Expected<ClosedValve> before = closed_of(parts->before, valve);
  if (!before) return before.errors();
  std::vector<ClosedValve> after(parts->after.size());
  std::vector<bool> is_read(after.size());
  bool is_sound = true;
  std::string html =
      with_pictures(std::string(parts->pages[page]), [&](const ReportPicture& picture) {
        const std::size_t plan = picture.plan;
        if (picture.view != ReportPicture::View::Before &&
            !(plan < after.size() && is_read[plan])) {
          Expected<ClosedValve> closed =
              plan < after.size() ? closed_of(parts->after[plan], valve) : no_material();
          is_sound = is_sound && closed;
          if (!closed) return std::string();
          after[plan] = *std::move(closed);
          is_read[plan] = true;
        }
        return drawn(picture, *before, after);
      });
  if (!is_sound) return no_material();
  return html;
}

Expected<PlanPictures> closed_shapes(std::string_view material, const Valve& valve,
                                     const std::vector<RepairPlan>& plans) {
  const auto objection = [](const std::string& what) {
    return Error{ErrorCode::Unsupported, "", what};
  };
  const Expected<MaterialParts> parts = parts_of(material);
  if (!parts) return objection("the material of the reports cannot be read");
  if (parts->after.size() != plans.size() || parts->pages.size() != plans.size() + 1)
    return objection("the reports are of another number of plans");
  for (const std::string_view page : parts->pages)
    if (!page.starts_with(kPageOpening)) return objection("a report is no page of coapt");
  Expected<ClosedValve> before = closed_of(parts->before, valve);
  if (!before || !before->plan.steps.empty())
    return objection("the closed shape before the repair does not fit the valve");
  PlanPictures shapes{*std::move(before), {}};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    Expected<ClosedValve> closed = closed_of(parts->after[i], valve);
    if (!closed || to_json(closed->plan) != to_json(plans[i]))
      return objection("the closed shape of plan " + std::to_string(i + 1) + " is of another plan");
    shapes.after.push_back(*std::move(closed));
  }
  return shapes;
}

std::string with_pictures(const std::string& page,
                          const std::function<std::string(const ReportPicture&)>& picture) {
  std::string filled;
  std::size_t done = 0;
  for (std::size_t at = page.find(kPlace); at != page.npos; at = page.find(kPlace, done)) {
    const std::size_t end = page.find('>', at);
    int view = 0;
    ReportPicture asked;
    const char* const last = page.data() + end;
    const auto [next, error] = std::from_chars(page.data() + at + kPlace.size(), last, view);
    if (error == std::errc() && next < last) std::from_chars(next + 1, last, asked.plan);
    asked.view = static_cast<ReportPicture::View>(view);
    filled.append(page, done, at - done).append(picture(asked));
    done = end + 1;
  }
  return filled.append(page, done);
}

}  // namespace coapt
