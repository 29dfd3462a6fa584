// coapt._engine (clients/python/coapt/_engine.pyi): what the package knows of it, and nothing else. The interpreter's lock is
// released while something is closed, compared or answered.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clients/python/engine/arrays.h"
#include "clients/python/engine/fields.h"
#include "clients/python/engine/local_service.h"
#include "clients/python/engine/problems.h"
#include "clients/python/engine/shapes.h"
#include "clients/python/engine/space.h"
#include "core/closure/standing.h"
#include "io/json/valve_json.h"
#include "search/plans/plan_order.h"

namespace py = pybind11;

namespace coapt {
namespace {

using Unlocked = py::call_guard<py::gil_scoped_release>;

/// A service until it is closed; requests that are being answered then are the last.
struct OpenService {
  std::shared_ptr<LocalService> service;
  pid_t process = getpid();

  /// In a forked child it stays as it is: its threads, which it would wait for, are the parent's.
  ~OpenService() {
    if (process != getpid())
      static_cast<void>(new std::shared_ptr<LocalService>(std::move(service)));
  }
  OpenService(const OpenService&) = delete;
  OpenService& operator=(const OpenService&) = delete;
  explicit OpenService(std::shared_ptr<LocalService> open) : service(std::move(open)) {}

  std::shared_ptr<LocalService> get() const {
    if (!service) throw std::runtime_error("this engine has ended");
    return service;
  }
};

/// A stream, part by part.
struct LocalStream {
  Stream stream;
  std::shared_ptr<LocalService> service;  ///< whose store it reads
  bool ended = false;

  /// What comes next, empty if nothing came within a second; none at the end.
  std::optional<std::string> next() {
    if (ended) return std::nullopt;
    std::string part;
    ended = !stream.next([&part](std::string_view text) {
      part += text;
      return true;
    });
    return part;
  }
};

/// Status, headers and body: bytes or a stream.
py::tuple answered(const std::shared_ptr<LocalService>& service, Request request) {
  const Answer answer = [&] {
    const py::gil_scoped_release unlocked;
    return service->answer(std::move(request));
  }();
  if (const auto* stream = std::get_if<Stream>(&answer.body))
    return py::make_tuple(answer.status, answer.headers, LocalStream{*stream, service});
  return py::make_tuple(answer.status, answer.headers, py::bytes(content_bytes(answer)));
}

/// Asks Python's signals at most ten times a second, on the thread that called: Ctrl-C.
class Interrupts {
 public:
  bool operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (came_ || std::this_thread::get_id() != caller_ || now - asked_ < kPause) return came_;
    asked_ = now;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) {
      PyErr_Clear();
      came_ = true;
    }
    return came_;
  }

 private:
  static constexpr std::chrono::milliseconds kPause{100};
  const std::thread::id caller_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();  // the caller's
  std::atomic<bool> came_ = false;
};

/// What an operation of this name answers to a request; `progress` is called with rounds done and, of a fit, the distance left.
/// Ctrl-C ends it with what there is by then.
py::bytes computed(LocalService& service, const std::string& operation, const std::string& request,
                   const py::object& progress) {
  Interrupts interrupts;
  double rms_mm = 0.0;
  std::atomic<bool> interrupted = false;
  Context context{.limits = OperationLimits::unlimited()};
  context.interrupted = &interrupted;
  context.abandoned = [&] {
    if (interrupts()) interrupted = true;
    return false;
  };
  context.distance = [&](double now_mm) { rms_mm = now_mm; };
  context.progress = [&](int done, int) {
    const py::gil_scoped_acquire locked;
    if (!progress.is_none()) progress(done, rms_mm);
  };
  std::string answer;
  {
    const py::gil_scoped_release unlocked;
    answer = service.compute(operation, request, context);
  }
  return py::bytes(answer);
}

py::object known(double number) {
  if (std::isfinite(number)) return py::float_(number);
  return py::none();
}

/// Figures in the order of coapt.closures.Measure.
py::tuple figures_of(const ValveMeasure& measured) {
  const Coaptation& coaptation = measured.coaptation;
  py::tuple figures(10);
  std::size_t i = 0;
  for (const double number :
       {measured.leak.area_mm2, coaptation.height_mean_mm, coaptation.height_min_mm,
        measured.annulus.ap_mm, measured.annulus.al_pm_mm, measured.tenting_height_mm,
        measured.tension_max_n, measured.tension_sum_n, measured.strain_circumferential_max,
        measured.strain_radial_max})
    figures[i++] = known(number);
  return figures;
}

/// Arguments of coapt.closures.Closure: name, status, crossing, residual, steps, seconds, figures, warnings.
py::tuple told(const LocalClosure& made) {
  const auto& [closed, answer] = made;
  const ClosureResult& closure = closed.closure;
  return py::make_tuple(closed.valve.name, to_string(closure.status), closure.crossing,
                        known(closure.residual), closure.steps, answer["seconds"].get<double>(),
                        figures_of(closed.measure),
                        py::tuple(py::cast(answer["warnings"].get<std::vector<std::string>>())));
}

void add_valves(py::module_& module) {
  py::class_<LocalValve>(module, "Valve")
      .def_static("read", &local_valve, py::arg("document"), py::arg("path"), Unlocked())
      .def("write", [](const LocalValve& self) { return write_valve(*self.valve); })
      .def_property_readonly("name", [](const LocalValve& self) { return self.valve->name; })
      .def_property_readonly("counts",
                             [](const LocalValve& self) {
                               return std::pair(self.valve->rest_mm.rows(),
                                                self.valve->faces.rows());
                             })
      .def_property_readonly("vertices_mm",
                             [](const py::object& self) {
                               return view(self.cast<const LocalValve&>().valve->rest_mm, self);
                             })
      .def_property_readonly("faces",
                             [](const py::object& self) {
                               return view(self.cast<const LocalValve&>().valve->faces, self);
                             })
      .def_property_readonly("annulus_mm",
                             [](const py::object& self) {
                               return view(self.cast<const LocalValve&>().valve->annulus_mm, self);
                             })
      .def(
          "with_arrays",
          [](const LocalValve& self, const py::object& vertices_mm, const py::object& faces,
             const py::object& annulus_mm) {
            std::optional<Points> vertices, annulus;
            std::optional<Faces> triangles;
            if (!vertices_mm.is_none()) vertices = points_of(vertices_mm, "/vertices_mm");
            if (!faces.is_none()) triangles = faces_of(faces, "/faces");
            if (!annulus_mm.is_none()) annulus = points_of(annulus_mm, "/annulus_mm");
            return with_arrays(self,
                               {vertices ? &*vertices : nullptr, triangles ? &*triangles : nullptr,
                                annulus ? &*annulus : nullptr});
          },
          py::arg("vertices_mm"), py::arg("faces"), py::arg("annulus_mm"))
      .def(
          "with_material",
          [](const LocalValve& self, const std::string& material) {
            return with_material(self, material);
          },
          py::arg("material"), Unlocked())
      .def("close", &close_locally, py::arg("request"), Unlocked());
  py::class_<LocalClosure>(module, "Closure")
      .def("fields", [](const LocalClosure& self) { return fields_of(self.closed); })
      .def(
          "file",
          [](const LocalClosure& self, const std::string& path, bool open) {
            std::string bytes;
            {
              const py::gil_scoped_release unlocked;
              bytes = file_of(self, path, open);
            }
            return py::bytes(bytes);
          },
          py::arg("path"), py::arg("open"))
      .def("document", &document_of, Unlocked())
      .def("shape", &shape_document, Unlocked())
      .def("told", &told)
      .def_property_readonly(
          "doubt", [](const LocalClosure& self) { return doubt_about(self.closed.closure); })
      .def_property_readonly("closed_mm",
                             [](const py::object& self) {
                               return view(
                                   self.cast<const LocalClosure&>().closed.closure.closed_mm, self);
                             })
      .def_property_readonly("faces", [](const py::object& self) {
        return view(self.cast<const LocalClosure&>().closed.valve.faces, self);
      });
}

void add_shapes(py::module_& module) {
  module.def(
      "read_mesh",
      [](const py::bytes& bytes, const std::string& format) {
        const TriangleMesh mesh = mesh_of_file(std::string_view(bytes), format);
        return py::make_tuple(view(mesh.vertices_mm, py::none()).attr("copy")(),
                              view(mesh.faces, py::none()).attr("copy")());
      },
      py::arg("bytes"), py::arg("format"));
  module.def(
      "write_mesh",
      [](const py::object& vertices_mm, const py::object& faces, const std::string& format,
         const std::string& doubt) {
        return py::bytes(
            file_of(TriangleMesh{points_of(vertices_mm, "/vertices_mm"), faces_of(faces, "/faces")},
                    format, doubt));
      },
      py::arg("vertices_mm"), py::arg("faces"), py::arg("format"), py::arg("doubt"));
  module.def("points_document", [](const py::object& points_mm) {
    const Points points = points_of(points_mm, "/points_mm");
    Json rows = Json::array();
    for (Index i = 0; i < points.rows(); ++i)
      rows.push_back({points(i, 0), points(i, 1), points(i, 2)});
    return rows.dump();
  });
}

PlanMerits merits_from(const py::dict& told) {
  PlanMerits merits;
  const auto take = [&told](const char* name, auto& value) {
    value = told[name].cast<std::decay_t<decltype(value)>>();
  };
  take("trusted", merits.trusted);
  take("varied", merits.varied);
  take("fails_often", merits.fails_often);
  take("rejected", merits.rejected);
  take("stenotic", merits.stenotic);
  take("acceptable_probability", merits.acceptable_probability);
  take("closes_finely", merits.closes_finely);
  take("avoidable_warnings", merits.avoidable_warnings);
  take("durability_mm", merits.durability_mm);
  take("gradient_mmhg", merits.gradient_mmhg);
  take("steps", merits.steps);
  take("muscles", merits.muscles);
  take("free_anchors", merits.free_anchors);
  take("resections", merits.resections);
  take("sizes_below", merits.sizes_below);
  take("leak_mm2", merits.leak_mm2);
  take("cost", merits.cost);
  return merits;
}

void add_spaces(py::module_& module) {
  py::class_<LocalSpace>(module, "Space")
      .def(py::init(&space_of), py::arg("valve"), py::arg("search"), py::arg("indicated"),
           Unlocked())
      .def("document", [](const LocalSpace& self) { return space_document(self); })
      .def("plan", &plan_at, py::arg("branch"), py::arg("at"))
      .def("place", &place_at, py::arg("branch"), py::arg("at"), Unlocked());
  module.def(
      "guess",
      [](const std::vector<std::vector<double>>& places, const std::vector<double>& values,
         double usual_sd, const std::vector<std::vector<double>>& at) {
        const Guesses told = guess(places, values, usual_sd, at);
        return py::make_tuple(told.mean, told.sd);
      },
      py::arg("places"), py::arg("values"), py::arg("usual_sd"), py::arg("at"));
  module.def(
      "order",
      [](const std::vector<py::dict>& plans, bool by_price, double acceptable,
         double same_durability_mm, double same_gradient_mmhg, double enough_durability_mm) {
        std::vector<PlanMerits> merits;
        for (const py::dict& plan : plans) merits.push_back(merits_from(plan));
        std::vector<std::pair<int, int>> places;
        for (const PlanPlace& place :
             order_of(merits, by_price,
                      {acceptable, same_durability_mm, same_gradient_mmhg, enough_durability_mm}))
          places.emplace_back(place.index, place.of_class);
        return places;
      },
      py::arg("plans"), py::arg("by_price"), py::arg("acceptable"), py::arg("same_durability_mm"),
      py::arg("same_gradient_mmhg"), py::arg("enough_durability_mm"));
}

void add_service(py::module_& module) {
  py::class_<LocalStream>(module, "Stream").def("next", [](LocalStream& self) -> py::object {
    const std::optional<std::string> part = [&self] {
      const py::gil_scoped_release unlocked;
      return self.next();
    }();
    if (!part) return py::none();
    return py::bytes(*part);
  });
  py::class_<OpenService>(module, "Service")
      .def(
          py::init([](const std::string& database, int threads) {
            return std::make_unique<OpenService>(std::make_shared<LocalService>(database, threads));
          }),
          py::arg("database"), py::arg("threads"))
      .def(
          "named",
          [](const OpenService& self, const std::string& name) { return self.get()->named(name); },
          py::arg("name"), Unlocked())
      .def(
          "compute",
          [](const OpenService& self, const std::string& operation, const std::string& request,
             const py::object& progress) {
            const std::shared_ptr<LocalService> service = self.get();
            return computed(*service, operation, request, progress);
          },
          py::arg("operation"), py::arg("request"), py::arg("progress"))
      .def(
          "request",
          [](const OpenService& self, std::string method, std::string path,
             std::map<std::string, std::string> query, std::map<std::string, std::string> headers,
             const py::bytes& body) {
            return answered(self.get(), {std::move(method),
                                         std::move(path),
                                         std::move(query),
                                         std::move(headers),
                                         std::string(body),
                                         {}});
          },
          py::arg("method"), py::arg("path"), py::arg("query"), py::arg("headers"), py::arg("body"))
      .def(
          "close", [](OpenService& self) { self.service.reset(); }, Unlocked());
}

}  // namespace
}  // namespace coapt

PYBIND11_MODULE(_engine, module) {
  py::register_exception<coapt::Problems>(module, "Problems");
  coapt::add_valves(module);
  coapt::add_shapes(module);
  coapt::add_spaces(module);
  coapt::add_service(module);
}
