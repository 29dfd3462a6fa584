#pragma once
// Precompiled for every source of a tree with faults (mutants.py): the environment says which fault is there, if any.

#include <array>
#include <atomic>
#include <cstdlib>

/// Which faults' places the program came to, by number (reached.cpp).
inline std::array<std::atomic<bool>, 128> coapt_reached{};

inline bool coapt_mutant(int number) {
  static const int chosen = [] {
    const char* text = std::getenv("COAPT_MUTANT");
    return text ? std::atoi(text) : 0;
  }();
  std::atomic<bool>& reached = coapt_reached[static_cast<std::size_t>(number)];
  if (!reached.load(std::memory_order_relaxed)) reached.store(true, std::memory_order_relaxed);
  return number == chosen;
}

template <typename T>
T coapt_negated(int number, T value) {
  if (coapt_mutant(number)) return -value;
  return value;
}

template <typename T>
T coapt_one_less(int number, T value) {
  if (coapt_mutant(number)) return value - T(1);
  return value;
}
