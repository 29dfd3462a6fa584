// A coapt-server, asked over HTTP (server/openapi.json). cpp-httplib's client stands behind this file alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/valve/types.h"
#include "io/json/json.h"

namespace coapt {

struct Service {
  std::string url;    ///< "https://coapt.example.org/lab", "http://127.0.0.1:8080"
  std::string token;  ///< empty: none
};

/// The answer to a GET. What the service refuses is all its problems, with pointers into the request; InputOutput, if
/// it cannot be reached or does not work; Busy, if it has no time after several tries (its Retry-After is kept).
Expected<std::string> get(const Service& service, const std::string& path);

/// The same, as JSON. Its names and strings are printable(), but for members "text" and "base64", which hold whole files; the name
/// of a file (beside one of these or "bytes") is without folders.
Expected<Json> get_json(const Service& service, const std::string& path);

struct ServiceAnswer {
  std::string bytes, type;  ///< "image/png"
  bool is_saved = false;    ///< a file that has a name
};
/// What answers a POST, as it is: a page, a file.
Expected<ServiceAnswer> post(const Service& service, const std::string& path, const Json& body);

/// The JSON that answers a POST, as get_json() has it; sent again if the answer gets lost. @param key Idempotency-Key; may be empty
Expected<Json> post_json(const Service& service, const std::string& path, const Json& body,
                         const std::string& key = "");

/// What happened to a job: one of a state and a progress (Progress of openapi.json).
struct ServiceEvent {
  std::string state;
  Json progress;
};

/// Tells every event of a job until it has ended. A stream that breaks off is taken up after the last event, also when
/// the service was started again in between. Errors: the job is not there, or the service stays away for a minute.
Errors follow_job(const Service& service, const std::string& job_path,
                  const std::function<void(const ServiceEvent&)>& tell);

}  // namespace coapt
