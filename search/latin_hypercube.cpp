#include "search/latin_hypercube.h"

#include <numeric>
#include <random>
#include <utility>

#include "search/random_share.h"

namespace coapt {

std::vector<std::vector<double>> latin_hypercube(int count, int factors, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto die = [&] { return random_share(engine); };
  std::vector<std::vector<double>> samples(count, std::vector<double>(factors));
  std::vector<int> order(count);
  for (int f = 0; f < factors; ++f) {
    std::iota(order.begin(), order.end(), 0);
    for (int i = count; i > 1; --i)  // std::shuffle differs between standard libraries
      std::swap(order[i - 1], order[static_cast<int>(die() * i)]);
    for (int i = 0; i < count; ++i) samples[i][f] = (order[i] + die()) / count;
  }
  return samples;
}

}  // namespace coapt
