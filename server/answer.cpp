#include "server/answer.h"

#include "io/json/result_json.h"

namespace coapt {
namespace {

const char* title(int status) {
  switch (status) {
    case 400:
      return "Bad request";
    case 404:
      return "Not found";
    case 405:
      return "Method not allowed";
    case 411:
      return "Length required";
    case 413:
      return "Content too large";
    case 414:
      return "URI too long";
    case 415:
      return "Unsupported media type";
    case 422:
      return "Unprocessable content";
    default:
      return "Internal error";
  }
}

}  // namespace

Answer problem(int status, const Errors& errors) {
  return {status, {{"status", status}, {"title", title(status)}, {"problems", to_json(errors)}}};
}

}  // namespace coapt
