#include "server/workers.h"

#include <algorithm>
#include <utility>

namespace coapt {
namespace {

int most_with_body(int threads) { return std::max(threads / 2, 1); }

}  // namespace

int Workers::most_of_one_client(int threads) {
  return most_with_body(threads) - most_with_body(threads) / 8;
}

Workers::Workers(int threads)
    : most_with_body_(most_with_body(threads)), most_of_one_(most_of_one_client(threads)) {
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

void Workers::add(bool with_body, const std::string& client, std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({with_body, client, std::move(work)});
    rounds_.came(client);
  }
  changed_.notify_one();
}

int Workers::busy() const {
  const std::lock_guard lock(mutex_);
  return busy_;
}

/// Of those that may run the first of the client whose turn it is.
Workers::Place Workers::next() {
  Place best = waiting_.end();
  for (Place place = waiting_.begin(); place != waiting_.end(); ++place) {
    if (place->with_body &&
        (busy_with_body_ >= most_with_body_ ||
         (bodies_.contains(place->client) && bodies_.at(place->client) >= most_of_one_)))
      continue;
    if (best == waiting_.end() ||
        rounds_.last_turn(place->client) < rounds_.last_turn(best->client))
      best = place;
  }
  return best;
}

void Workers::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    const Place place = next();
    if (place == waiting_.end()) {
      if (ending_ && waiting_.empty()) return;
      changed_.wait(lock);
      continue;
    }
    Waiting begun = std::move(*place);
    waiting_.erase(place);
    rounds_.begins(begun.client);
    ++busy_;
    if (begun.with_body) {
      ++busy_with_body_;
      ++bodies_[begun.client];
    }
    lock.unlock();
    begun.work();
    begun.work = nullptr;
    lock.lock();
    --busy_;
    if (begun.with_body) {
      --busy_with_body_;
      if (--bodies_[begun.client] == 0) bodies_.erase(begun.client);
    }
    rounds_.left(begun.client);
    // This thread looks again itself; those that wait to end must see that a queue may have emptied.
    if (ending_) changed_.notify_all();
  }
}

}  // namespace coapt
