#include "server/compute.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr std::size_t kMostRemembered = 1024;  // requests that ran out of time

// No client's requests can make others be taken for more than these times what they are.
constexpr double kFastest = 0.25, kSlowest = 4.0;
constexpr double kTelling_s =
    0.01;  // what is expected to take less does not tell how fast the machine is

double seconds_since(Compute::Clock::time_point since) {
  return Seconds(Compute::Clock::now() - since).count();
}

}  // namespace

Compute::Compute(int turns, std::chrono::milliseconds patience, std::chrono::milliseconds longest)
    : turns_(std::max(1, turns)),
      most_long_(std::max(1, turns_ - 1)),
      patience_(patience),
      longest_(longest) {
  slowness_.fill(1.0);
}

Compute::Compute(double longest_s)
    : Compute(static_cast<int>(std::thread::hardware_concurrency()), std::chrono::seconds(20),
              std::chrono::milliseconds(std::llround(1e3 * longest_s))) {}

Compute::Turn::Turn(Compute& compute, TurnAsk ask) : compute_(compute), ask_(std::move(ask)) {
  std::unique_lock<std::mutex> lock(compute_.mutex_);
  if (const double left = compute_.not_again_s(ask_.request); left > 0.0) {
    end_ = End::TooLong;
    retry_after_s_ = static_cast<int>(std::ceil(left));
    return;
  }
  const double wait = compute_.wait_s(ask_);
  retry_after_s_ = static_cast<int>(std::clamp(std::ceil(wait), 1.0, 60.0));
  const bool could_end = compute_.expected_s(ask_) < Seconds(compute_.longest_).count();
  if (wait > Seconds(compute_.patience_).count() || (wait > 0.0 && !could_end)) return;
  std::list<Asked>& queue = compute_.queue(ask_);
  const auto place = queue.insert(queue.end(), {&ask_, Clock::now()});
  compute_.rounds_.came(ask_.client);
  const bool is_mine = compute_.changed_.wait_for(
      lock, compute_.patience_, [&] { return compute_.next(is_long(ask_)) == &*place; });
  queue.erase(place);
  if (is_mine) {
    end_ = End::Running;
    since_ = Clock::now();
    compute_.running_.push_back({&ask_, since_});
    compute_.rounds_.begins(ask_.client);
  } else {
    compute_.rounds_.left(ask_.client);
  }
  compute_.changed_.notify_all();  // the next may be free to go, too
}

Compute::Turn::~Turn() {
  if (end_ != End::Running) return;
  const std::lock_guard<std::mutex> lock(compute_.mutex_);
  compute_.running_.remove_if([this](const Asked& one) { return one.ask == &ask_; });
  compute_.rounds_.left(ask_.client);
  compute_.changed_.notify_all();
}

void Compute::Turn::done() {
  if (ask_.seconds < kTelling_s) return;
  const std::lock_guard<std::mutex> lock(compute_.mutex_);
  compute_.slowness_[compute_.done_++ % compute_.slowness_.size()] =
      std::clamp(seconds_since(since_) / ask_.seconds, kFastest, kSlowest);
}

void Compute::Turn::ran_out() {
  if (ask_.request == 0) return;
  const std::lock_guard<std::mutex> lock(compute_.mutex_);
  if (compute_.ran_out_.size() >= kMostRemembered) compute_.ran_out_.clear();
  compute_.ran_out_[ask_.request] =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(kNotAgain_s));
}

double Compute::not_again_s(std::size_t request) {
  const auto found = ran_out_.find(request);
  if (found == ran_out_.end()) return 0.0;
  const double left = -seconds_since(found->second);
  if (left <= 0.0) ran_out_.erase(found);
  return left;
}

int Compute::running(bool of_long) const {
  return static_cast<int>(std::count_if(running_.begin(), running_.end(), [&](const Asked& one) {
    return is_long(*one.ask) == of_long;
  }));
}

/// The first of the client whose turn it is.
const Compute::Asked* Compute::fair(const std::list<Asked>& queue) const {
  const auto first =
      std::min_element(queue.begin(), queue.end(), [this](const Asked& one, const Asked& other) {
        return rounds_.last_turn(one.ask->client) < rounds_.last_turn(other.ask->client);
      });
  return first == queue.end() ? nullptr : &*first;
}

/// Of those who wait for turns of this cost the one whose turn it is; null if it is nobody's.
const Compute::Asked* Compute::next(bool of_long) const {
  if (std::ssize(running_) >= turns_) return nullptr;
  const Asked* const long_one = running(true) < most_long_ ? fair(longs_) : nullptr;
  const bool is_overdue = long_one && Clock::now() - long_one->since > patience_ / 4;
  if (of_long) return shorts_.empty() || is_overdue ? long_one : nullptr;
  return is_overdue ? nullptr : fair(shorts_);
}

/// The median: one odd request says nothing of the machine.
double Compute::slowness() const {
  std::array<double, 9> sorted = slowness_;
  const auto middle = sorted.begin() + sorted.size() / 2;
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

double Compute::expected_s(const TurnAsk& ask) const { return ask.seconds * slowness(); }

/// Until its turn begins, by what is expected of those before it: of each other client as many as of its own, and one more.
double Compute::wait_s(const TurnAsk& ask) {
  const bool of_long = is_long(ask);
  const int most = of_long ? most_long_ : turns_ - running(true);
  const std::list<Asked>& queue = this->queue(ask);
  if (queue.empty() && running(of_long) < most && std::ssize(running_) < turns_) return 0.0;
  const double longest = Seconds(longest_).count();
  const auto expected = [&](const Asked& one) { return std::min(longest, expected_s(*one.ask)); };
  double sum = 0.0;
  for (const Asked& one : running_) {
    if (is_long(*one.ask) != of_long) continue;
    const double passed = seconds_since(one.since);
    sum += std::max(0.0, std::min(longest, std::max(expected(one), 1.25 * passed)) - passed);
  }
  std::map<std::string, std::ptrdiff_t> waiting;
  for (const Asked& one : queue) ++waiting[one.ask->client];
  const std::ptrdiff_t own = waiting[ask.client];
  std::map<std::string, std::ptrdiff_t> counted;
  for (const Asked& one : queue)
    if (one.ask->client == ask.client || counted[one.ask->client]++ <= own) sum += expected(one);
  return std::max(1e-3, sum / std::max(1, most));
}

}  // namespace coapt
