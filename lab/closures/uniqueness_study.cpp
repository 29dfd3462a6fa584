#include "lab/closures/uniqueness_study.h"

#include <sstream>

#include "core/presets/presets.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

/// One scene of each valve in turn, as study_closures() makes them.
struct SceneSet {
  std::string kind;
  std::vector<Valve> valves;
  std::uint64_t seed = 0;
  int count = 0;
};

std::vector<SceneSet> scene_sets(const UniquenessStudyOptions& options) {
  std::vector<SceneSet> sets;
  for (const bool known : {true, false})
    for (const std::string& preset : options.presets)
      if (const Expected<Valve> valve = make_preset(preset))
        sets.push_back({known ? "known" : "new",
                        {*valve},
                        known ? options.seed : options.seed + 1,
                        options.scenes});
  RandomAnatomies random = random_anatomies(options.anatomies, options.seed, options.threads);
  const int drawn = static_cast<int>(random.valves.size());
  if (drawn > 0) sets.push_back({"anatomies", std::move(random.valves), options.seed, drawn});
  return sets;
}

}  // namespace

std::vector<UniquenessPoint> study_uniqueness(const UniquenessStudyOptions& options,
                                              const std::function<void(int, int)>& progress) {
  std::vector<SceneSet> sets = scene_sets(options);
  int scenes = 0;
  for (const SceneSet& set : sets) scenes += set.count;
  const int planned = scenes * static_cast<int>(options.bending_n_mm.size());
  std::vector<UniquenessPoint> points;
  for (const double bending : options.bending_n_mm)
    for (SceneSet& set : sets) {
      for (Valve& valve : set.valves) valve.tissue.bending_n_mm = bending;
      ClosureStudyOptions study;
      study.closure.membrane = options.membrane;
      study.count = set.count;
      study.seed = set.seed;
      study.threads = options.threads;
      const int before = static_cast<int>(points.size());
      const ClosureStudy closed = study_closures(set.valves, study, [&](int done) {
        if (progress) progress(before + done, planned);
      });
      for (int i = 0; i < set.count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        points.push_back({set.kind, set.valves[at % set.valves.size()].name, set.seed, i, bending,
                          closed.scenes[at]});
      }
    }
  return points;
}

std::string uniqueness_csv(const std::vector<UniquenessPoint>& points) {
  std::ostringstream csv;
  csv << "kind,valve,seed,scene,bending_n_mm,status,crossing,attempts,steps,compared,rms_mm,"
         "leak_difference_mm2\n";
  for (const UniquenessPoint& p : points) {
    const SceneOutcome& o = p.outcome;
    csv << p.kind << ',' << p.valve << ',' << p.seed << ',' << p.scene << ',' << p.bending_n_mm
        << ',' << to_string(o.status) << ',' << (o.crossing ? "true" : "false") << ',' << o.attempts
        << ',' << o.steps << ',' << (o.compared ? "true" : "false") << ',';
    if (o.compared)
      csv << o.from_other.rms_mm << ',' << o.from_other.leak_mm2;
    else
      csv << ',';
    csv << '\n';
  }
  return csv.str();
}

}  // namespace coapt
