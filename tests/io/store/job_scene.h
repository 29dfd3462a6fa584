// Jobs by number, and what becomes of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

#include "io/store/job_store.h"
#include "tests/io/store/store_scene.h"

namespace coapt {

/// Every byte there is, zero first, no valid UTF-8, then `size` more.
inline std::string all_bytes(std::size_t size = 0) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) bytes.push_back(static_cast<char>(byte));
  return bytes + std::string(size, 'x');
}

inline std::string numbered_id(int i) { return "job-" + std::to_string(i); }

/// Three jobs share a valve.
inline NewJob numbered_job(int i) {
  return {.id = numbered_id(i),
          .kind = i % 2 == 0 ? "plans" : "study",
          .valve = "valve-" + std::to_string(i / 3),
          .request = R"({"seed":)" + std::to_string(i) + "}",
          .idempotency_key = i % 4 == 0 ? "" : "key-" + std::to_string(i)};
}

inline std::string numbered_document(int i) {
  return R"({"valve":)" + std::to_string(i / 3) + "}" + std::string(5'000, ' ');
}

inline JobEnd numbered_end(int i) {
  const std::string number = std::to_string(i);
  return {.state = static_cast<JobState>(2 + i % 3),
          .seconds = i / 8.0,
          .progress = R"({"stage":"ended )" + number + R"("})",
          .summary = "{\"summary\":" + number + "}",
          .result = "{\"result\":" + number + std::string(9'000, ' ') + "}",
          .files = {{"report.html", "text/html; charset=utf-8", "<p>" + number},
                    {"a.png", "image/png", all_bytes(static_cast<std::size_t>(i))}},
          .material = i % 2 == 0 ? "" : all_bytes(3)};
}

inline std::string numbered_event(int event) {
  return "{\"closures\":" + std::to_string(event) + "}";
}

/// The job, which must be there.
inline Job job_of(const JobStore& store, const std::string& id) {
  const Expected<std::optional<Job>> job = store.job(id);
  EXPECT_TRUE(job && *job) << id;
  return job && *job ? **job : Job{};
}

inline void submit(JobStore& store, int i) {
  const auto submitted = store.submit(numbered_job(i), numbered_document(i), 1'000 + i);
  ASSERT_TRUE(submitted) << submitted.errors()[0].message;
  EXPECT_TRUE(submitted->is_new);
}

/// All that finish() keeps of numbered_end(i).
inline void expect_ended(const JobStore& store, int i) {
  const JobEnd end = numbered_end(i);
  const Job job = job_of(store, numbered_id(i));
  EXPECT_EQ(job.state, end.state);
  EXPECT_EQ(job.seconds, end.seconds);
  EXPECT_EQ(job.progress, end.progress);
  EXPECT_EQ(job.summary, end.summary);
  EXPECT_EQ(**store.result(job.id), end.result);
  const auto material = store.material(job.id);
  ASSERT_TRUE(material);
  EXPECT_EQ(material->value_or(""), end.material);
  const auto files = store.files(job.id);
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), end.files.size());
  for (std::size_t f = 0; f < end.files.size(); ++f) {
    const JobFile& wanted = end.files[f];
    EXPECT_EQ((*files)[f].name, wanted.name);
    EXPECT_EQ((*files)[f].type, wanted.type);
    EXPECT_EQ((*files)[f].bytes, std::ssize(wanted.content));
    const auto file = store.file(job.id, wanted.name);
    ASSERT_TRUE(file && *file);
    EXPECT_EQ((*file)->type, wanted.type);
    EXPECT_EQ((*file)->content, wanted.content);
  }
}

/// Those of one kind.
inline std::vector<JobEvent> events_of(const JobStore& store, const std::string& id,
                                       const std::string& kind) {
  const auto all = store.events(id, 0, 10'000);
  EXPECT_TRUE(all);
  std::vector<JobEvent> events;
  if (all)
    std::copy_if(all->begin(), all->end(), std::back_inserter(events),
                 [&](const JobEvent& event) { return event.kind == kind; });
  return events;
}

inline void expect_bad_reference(const Errors& errors) {
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, ErrorCode::BadReference) << errors[0].message;
}

/// A store that is made anew for each test.
class JobStoreTest : public testing::Test {
 protected:
  JobStoreTest() { open(); }

  void open() {
    Expected<JobStore> opened = JobStore::open(path_);
    ASSERT_TRUE(opened) << opened.errors()[0].message;
    kept_ = std::make_unique<JobStore>(*std::move(opened));
  }
  void open_again() {
    kept_.reset();
    open();
  }
  JobStore& store() { return *kept_; }
  Job job(int i) { return job_of(store(), numbered_id(i)); }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("a.db");

 private:
  std::unique_ptr<JobStore> kept_;
};

class JobStoreRun : public JobStoreTest {};

}  // namespace coapt
