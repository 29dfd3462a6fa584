#include "server/workers.h"

#include <algorithm>
#include <utility>

namespace coapt {

Workers::Workers(int threads) : most_with_body_(std::max(threads / 2, 1)) {
  try {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { serve(); });
  } catch (...) {  // no more threads can be had
    end();
    throw;
  }
}

Workers::~Workers() { end(); }

void Workers::end() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::add(bool with_body, std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    (with_body ? with_body_ : plain_).push_back({++added_, std::move(work)});
  }
  changed_.notify_one();
}

int Workers::busy() const {
  const std::lock_guard lock(mutex_);
  return busy_;
}

std::deque<Workers::Waiting>* Workers::next_queue() {
  const bool body = !with_body_.empty() && busy_with_body_ < most_with_body_;
  if (body && (plain_.empty() || with_body_.front().number < plain_.front().number))
    return &with_body_;
  return plain_.empty() ? nullptr : &plain_;
}

void Workers::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    std::deque<Waiting>* queue = next_queue();
    if (queue == nullptr) {
      if (ending_ && with_body_.empty()) return;
      changed_.wait(lock);
      continue;
    }
    const int body = queue == &with_body_ ? 1 : 0;
    std::function<void()> work = std::move(queue->front().work);
    queue->pop_front();
    ++busy_;
    busy_with_body_ += body;
    lock.unlock();
    work();
    work = nullptr;
    lock.lock();
    --busy_;
    busy_with_body_ -= body;
    // This thread looks again itself; those that wait to end must see that a queue may have emptied.
    if (ending_) changed_.notify_all();
  }
}

}  // namespace coapt
