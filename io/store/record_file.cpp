#include "io/store/record_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace coapt {
namespace {

constexpr std::string_view kRecordMagic = "coapt.records/1";  // with a blank, 32 digits: 48 bytes

Error system_problem(const std::string& path, const std::string& problem) {
  return {ErrorCode::InputOutput, "", path + ": " + problem + ": " + std::strerror(errno)};
}

}  // namespace

RecordFile::RecordFile(std::string path, std::string records, std::FILE* file)
    : path_(std::move(path)), records_(std::move(records)), file_(file) {}

Expected<RecordFile> RecordFile::open(const std::string& path, const std::string& id,
                                      std::size_t record_size) {
  const std::string head = std::string(kRecordMagic) + ' ' + id;
  std::string bytes;
  if (std::ifstream in(path, std::ios::binary); in)
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  const bool is_new = bytes.empty();
  if (!is_new && !bytes.starts_with(head))
    return Error{ErrorCode::Unsupported, "",
                 path +
                     " holds records of other valves, options or of another version of coapt; "
                     "remove it or choose another directory"};
  std::string records = is_new ? "" : bytes.substr(head.size());
  records.resize(records.size() / record_size * record_size);
  if (!is_new) {
    std::error_code failed;
    std::filesystem::resize_file(path, head.size() + records.size(), failed);
    if (failed) return Error{ErrorCode::InputOutput, "", path + ": " + failed.message()};
  }
  std::FILE* file = std::fopen(path.c_str(), "ab");
  if (file == nullptr) return system_problem(path, "cannot be written");
  RecordFile opened(path, std::move(records), file);
  if (is_new)
    if (Errors errors = opened.append(head); !errors.empty()) return errors;
  return opened;
}

Errors RecordFile::append(std::string_view records) {
  if (std::fwrite(records.data(), 1, records.size(), file_.get()) != records.size() ||
      std::fflush(file_.get()) != 0)
    return {system_problem(path_, "cannot be written")};
  return {};
}

}  // namespace coapt
