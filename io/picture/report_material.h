// What the reports on a search are made of: their words and charts, and the closed shapes that their pictures draw. A
// thirtieth of the reports, because pictures are most of these; kept in their place, and made into the same bytes when
// a report is asked for. No closure is made again, nor is the search.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/valve.h"
#include "io/picture/report.h"

namespace coapt {

struct ReportMaterial {
  /// HTML with places for pictures: on all plans first, then about each of them, by rank.
  std::vector<std::string> pages;
  ClosedValve before;
  std::vector<ClosedValve> after;  ///< of the plans, by rank
};

/// @pre the search kept its closures
ReportMaterial report_material(const SearchResult& result, const SearchRequest& request);

/// Every bit that a picture depends on, for those below; for the machine that wrote it.
std::string write_report_material(const ReportMaterial& material);

/// How many pages there are, and the report that page `page` becomes: what plan_report_html() gave.
/// @param valve that was searched: the material does not hold it.
/// Unsupported if bytes and valve do not belong together, or this version's repairs give another mesh.
Expected<std::size_t> report_pages(std::string_view material);
Expected<std::string> report_page(std::string_view material, std::size_t page, const Valve& valve);

/// The closed shapes in material of unknown origin. Errors (one, a sentence without its full stop): a number of plans or a plan that is
/// another, closed shapes that do not fit the valve, a page that may run scripts.
Expected<PlanPictures> closed_shapes(std::string_view material, const Valve& valve,
                                     const std::vector<RepairPlan>& plans);

/// The page with what `picture` gives in its places.
std::string with_pictures(const std::string& page,
                          const std::function<std::string(const ReportPicture&)>& picture);

}  // namespace coapt
