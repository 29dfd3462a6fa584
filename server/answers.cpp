#include "server/answers.h"

#include <sstream>

namespace coapt {

std::string without_folders(const std::string& message) {
  std::istringstream words(message);
  std::string clean;
  for (std::string word; std::getline(words, word, ' ');) {
    if (word.starts_with('/')) word.erase(0, word.rfind('/') + 1);
    clean += (clean.empty() ? "" : " ") + word;
  }
  return clean;
}

Answer store_problem(const Errors& told) {
  Errors errors = told;
  for (Error& error : errors) error.message = without_folders(error.message);
  switch (errors.front().code) {
    case ErrorCode::Busy:
      return problem(503, errors);
    case ErrorCode::NoSpace:
      return problem(507, errors);
    default:
      return problem(500, errors);
  }
}

Answer retry_later(int status, const std::string& why, int seconds) {
  Answer answer = problem(status, ErrorCode::Busy, why);
  if (seconds > 0) answer.headers.emplace_back("Retry-After", std::to_string(seconds));
  return answer;
}

Answer not_found(const std::string& what) {
  return problem(404, ErrorCode::BadReference, "there is no such " + what);
}

}  // namespace coapt
