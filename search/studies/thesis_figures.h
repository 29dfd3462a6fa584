// What the thesis gives in numbers (4.3): facts to compare with and to calibrate to.
#pragma once

#include <array>

namespace coapt::thesis {

/// Figure 4.5: orifice at 10, 20, 30 % anteroposterior dilation, mm2 (6.7, + 25.3, + 54.9).
inline constexpr std::array<double, 3> kDilation_percent = {10.0, 20.0, 30.0};
inline constexpr std::array<double, 3> kDilated_mm2 = {6.7, 32.0, 86.9};

/// Table 4.1, mm2: rows anterolateral, posteromedial, both; columns T, P, A, T + P, T + A, P + A,
/// all.
inline constexpr std::array<std::array<double, 7>, 3> kDisplaced_mm2 = {
    {{1.2, 0.5, 20.2, 4.1, 40.8, 29.6, 66.6},
     {2.6, 6.6, 41.1, 17.5, 67.6, 60.6, 88.6},
     {14.6, 4.0, 97.7, 26.0, 186.5, 106.6, 191.7}}};

/// Table 4.2, percent: rows as above; columns U1, U2, U3.
inline constexpr std::array<std::array<double, 3>, 3> kRingRatio_percent = {
    {{54.5, 27.3, 13.0}, {75.4, 52.8, 32.4}, {81.9, 64.1, 47.3}}};

/// Shares of the configurations where both exceeds the sum of singles: all, from 1 mm, from 2 mm
/// along each axis; and the mean increase.
inline constexpr double kSynergyShare = 0.81, kSynergyFrom1mm = 0.92, kSynergyFrom2mm = 1.0;
inline constexpr double kSynergyIncrease = 0.37;

inline constexpr int kConfigurations = 3723;
inline constexpr double kHours = 10.0;

}  // namespace coapt::thesis
