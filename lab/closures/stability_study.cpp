#include "lab/closures/stability_study.h"

#include <mutex>

#include "core/closure/relaxation.h"
#include "core/closure/thesis.h"
#include "lab/closures/stability_level.h"
#include "search/parallel.h"

namespace coapt {
namespace {

// Ten times what the thesis's method and five times what `fast` need for the nominal scenes.
constexpr int kThesisSteps = 10000, kFastSteps = 3000;
constexpr int kThesisTriangles = 2600;  // 5,200 take a minute
constexpr double kFastWay_mm = 0.04;    // as the defaults: 0.02 mm at 0.005

ClosureRun close_by_thesis(const ClosureModel& model, const AttemptSettings& attempt) {
  ThesisSettings settings;
  settings.residual_tolerance = kStabilityResidual;
  settings.max_steps = kThesisSteps;
  settings.step = attempt.step;
  settings.contact = attempt.contact;
  return run_thesis(model, settings);
}

/// `step` is the length of a step squared: the mass falls with it.
ClosureRun close_by_relaxation(const ClosureModel& model, const AttemptSettings& attempt,
                               RelaxationSettings settings) {
  settings.residual_tolerance = kStabilityResidual;
  settings.way_tolerance_mm = kFastWay_mm;
  settings.max_steps = kFastSteps;
  settings.mass_share /= attempt.step;
  settings.contact = attempt.contact;
  return relax<float>(model, settings);
}

struct Task {
  std::string scene;
  Difficulty axis;
  double level;
  bool nominal;
  bool again;  // the nominal level of an axis that is not the first: taken from the first
};

std::vector<Task> tasks_of(const StabilityStudyOptions& options) {
  std::vector<Task> tasks;
  for (const std::string& scene : options.scenes)
    for (const DifficultyAxis& axis : options.axes)
      for (const double level : axis.levels) {
        const bool nominal = level == axis.nominal;
        tasks.push_back({scene, axis.of, level, nominal, nominal && axis.of != options.axes[0].of});
      }
  return tasks;
}

/// One cell a method that goes so far, in their order.
std::vector<StabilityCell> close_level(const Task& task,
                                       const std::vector<StabilityMethod>& methods) {
  const StabilityScene scene = make_stability_scene(task.scene, task.axis, task.level);
  const StabilityLevel springs(scene, Membrane::Springs), continuum(scene, Membrane::Continuum);
  std::vector<StabilityCell> cells;
  const auto triangles = static_cast<int>(scene.valve.faces.rows());
  for (const StabilityMethod& method : methods)
    if (method.most_triangles == 0 || triangles <= method.most_triangles)
      cells.push_back((method.membrane == Membrane::Springs ? springs : continuum).close(method));
  cells.push_back(continuum.close_with_ladder());
  return cells;
}

}  // namespace

std::vector<StabilityCell> study_stability(const StabilityStudyOptions& options,
                                           const std::vector<StabilityMethod>& comparators,
                                           const std::function<void(int, int)>& progress) {
  std::vector<StabilityMethod> methods = {
      {"thesis", close_by_thesis, kThesisTriangles, Membrane::Springs}};
  methods.insert(methods.end(), comparators.begin(), comparators.end());
  const auto add = [&methods](const char* name, Membrane membrane,
                              const RelaxationSettings& settings) {
    methods.push_back({name,
                       [settings](const ClosureModel& model, const AttemptSettings& attempt) {
                         return close_by_relaxation(model, attempt, settings);
                       },
                       0, membrane});
  };
  RelaxationSettings unguarded;
  unguarded.guards = false;
  add("fast (springs)", Membrane::Springs, {});
  add("unguarded", Membrane::Continuum, unguarded);
  add("fast", Membrane::Continuum, {});
  add("preconditioned", Membrane::Continuum, preconditioned({}));
  const std::vector<Task> tasks = tasks_of(options);
  std::vector<std::vector<StabilityCell>> levels(tasks.size());
  std::mutex mutex;
  int done = 0;
  for_each_index(static_cast<int>(tasks.size()), options.threads, [&](int i) {
    const auto t = static_cast<std::size_t>(i);
    if (!tasks[t].again) levels[t] = close_level(tasks[t], methods);
    const std::lock_guard<std::mutex> lock(mutex);
    if (progress) progress(++done, static_cast<int>(tasks.size()));
  });
  std::vector<StabilityCell> cells;
  const std::vector<StabilityCell>* nominal = nullptr;
  for (std::size_t first = 0, last = 0; first < tasks.size(); first = last) {
    while (last < tasks.size() && tasks[last].scene == tasks[first].scene &&
           tasks[last].axis == tasks[first].axis) {
      if (tasks[last].nominal && !tasks[last].again) nominal = &levels[last];
      ++last;
    }
    std::vector<std::string> names;
    for (const StabilityMethod& method : methods) names.push_back(method.name);
    names.push_back(kLadderName);
    for (const std::string& name : names)
      for (std::size_t t = first; t < last; ++t) {
        // The ladder has no step to vary.
        if (name == kLadderName && tasks[t].axis == Difficulty::Step && !tasks[t].nominal) continue;
        for (StabilityCell cell : tasks[t].again ? *nominal : levels[t]) {
          if (cell.method != name) continue;
          cell.scene = tasks[t].scene;
          cell.axis = tasks[t].axis;
          cell.level = tasks[t].level;
          cell.nominal = tasks[t].nominal;
          cells.push_back(cell);
        }
      }
  }
  return cells;
}

const char* to_string(StabilityOutcome outcome) {
  switch (outcome) {
    case StabilityOutcome::Settles:
      return "settles";
    case StabilityOutcome::OtherEquilibrium:
      return "other_equilibrium";
    case StabilityOutcome::Crosses:
      return "crosses";
    case StabilityOutcome::Stalls:
      return "stalls";
    case StabilityOutcome::BlowsUp:
      return "blows_up";
  }
  return "";
}

}  // namespace coapt
