#pragma once
// Read before every source of a tree with faults (mutants.py): the environment says which fault is there, if any.

#include <cstdlib>

inline bool coapt_mutant(int number) {
  static const int chosen = [] {
    const char* text = std::getenv("COAPT_MUTANT");
    return text ? std::atoi(text) : 0;
  }();
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
