#include "server/access.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>

#include "server/content_id.h"
#include "server/page.h"

namespace coapt {
namespace {

constexpr std::size_t kTokenLengthMin = 16, kTokenLengthMax = 4096;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// The name in "name:port", "[::1]:port"; empty if it is neither.
std::string host_name(std::string_view host) {
  const std::size_t from = host.starts_with('[') ? host.find(']') : 0;
  const std::size_t colon = host.find(':', std::min(from, host.size()));
  const std::string_view port = colon == host.npos ? "" : host.substr(colon + 1);
  const bool valid =
      std::all_of(port.begin(), port.end(), [](char c) { return c >= '0' && c <= '9'; });
  return valid ? lower(host.substr(0, colon)) : "";
}

bool is_this_server(const Access& access, const std::string& host) {
  const std::string name = host_name(host);
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]") return true;
  return std::any_of(access.hosts.begin(), access.hosts.end(),
                     [&](const std::string& allowed) { return lower(allowed) == name; });
}

// Touches every character of `given`, whatever is wrong where.
bool same(const std::string& token, std::string_view given) {
  unsigned different = token.size() == given.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    different |= static_cast<unsigned char>(token[i % token.size()] ^ given[i]);
  }
  return different == 0;
}

bool has_token(const std::string& token, const Request& request) {
  const auto header = request.headers.find("authorization");
  if (header == request.headers.end()) return false;
  std::string_view given = header->second;
  constexpr std::string_view kScheme = "bearer ";
  if (lower(given.substr(0, kScheme.size())) != kScheme) return false;
  given.remove_prefix(kScheme.size());
  given.remove_prefix(std::min(given.find_first_not_of(' '), given.size()));
  return same(token, given);
}

Error unfit(const std::string& path, ErrorCode code, const std::string& why) {
  return {code, "", "token file " + path + ": " + why};
}

Expected<std::string> first_line(int file, const std::string& path) {
  std::string text(2 * kTokenLengthMax, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t got = read(file, text.data() + size, text.size() - size);
    if (got < 0) return unfit(path, ErrorCode::InputOutput, "cannot be read");
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  text.resize(std::min(size, text.find('\n')));
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), is_blank));
  const bool visible =
      std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (!visible || text.size() < kTokenLengthMin || text.size() > kTokenLengthMax) {
    return unfit(path, ErrorCode::OutOfRange,
                 "its first line must be 16 to 4,096 visible ASCII characters");
  }
  return text;
}

}  // namespace

Expected<std::string> read_token(const std::string& path) {
  // Without O_NONBLOCK a named pipe would hang the start.
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return unfit(path, ErrorCode::InputOutput, "cannot be opened");
  struct stat status = {};
  Expected<std::string> token = unfit(path, ErrorCode::InputOutput, "is not a regular file");
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
    const bool group_is_root = status.st_gid == 0;
    const mode_t others =
        S_IRWXO | S_IWGRP | S_IXGRP | (group_is_root ? mode_t{0} : mode_t{S_IRGRP});
    if ((status.st_mode & others) != 0) {
      token = unfit(path, ErrorCode::InputOutput, "is accessible to other users; run chmod 600");
    } else if (status.st_uid != geteuid() && status.st_uid != 0) {
      token = unfit(path, ErrorCode::InputOutput, "belongs to another user");
    } else {
      token = first_line(file, path);
    }
  }
  close(file);
  return token;
}

Expected<std::string> kept_token(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0 && errno == EEXIST) return read_token(path);
  if (file < 0) return unfit(path, ErrorCode::InputOutput, "cannot be made");
  const std::string token = random_id(), line = token + '\n';
  const bool is_written = write(file, line.data(), line.size()) == std::ssize(line);
  close(file);
  if (is_written) return token;
  unlink(path.c_str());
  return unfit(path, ErrorCode::NoSpace, "cannot be written");
}

std::optional<Answer> refuse(const Access& access, const Request& request) {
  if (request.path == "/healthz/live") return std::nullopt;
  const std::string host = header(request, "host");
  if (access.token.empty() && !is_this_server(access, host)) {
    return problem(421, ErrorCode::Unsupported,
                   "the Host header does not name this server; see --allow-host");
  }
  // Whatever watches the service needs no token to ask whether it is well.
  const bool is_open = is_page_path(request.path) || request.path == "/healthz/ready";
  if (!access.token.empty() && !is_open && !has_token(access.token, request)) {
    Answer answer = problem(401, ErrorCode::MissingField, "a bearer token is required");
    answer.headers.emplace_back("WWW-Authenticate", "Bearer");
    return answer;
  }
  if (request.headers.contains("origin")) {
    const std::string origin = lower(header(request, "origin"));
    const std::string own = lower(host);
    if (access.origins.contains(origin)) return std::nullopt;
    if (own.empty() || (origin != "http://" + own && origin != "https://" + own)) {
      return problem(403, ErrorCode::Unsupported,
                     "requests from pages of another origin are refused");
    }
  }
  return std::nullopt;
}

bool is_loopback(const std::string& host) {
  in_addr four{};
  in6_addr six{};
  if (host == "localhost") return true;
  if (inet_pton(AF_INET, host.c_str(), &four) == 1) return (ntohl(four.s_addr) >> 24) == 127;
  return inet_pton(AF_INET6, host.c_str(), &six) == 1 && IN6_IS_ADDR_LOOPBACK(&six);
}

}  // namespace coapt
