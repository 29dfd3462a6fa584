// A PNG read back, to look at its pixels.
#pragma once

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace coapt {

struct DecodedPng {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  ///< 0xAARRGGBB, row after row; empty if it is no PNG
};

inline DecodedPng decode_png(std::string png) {
  const auto read = [](void* source, unsigned char* bytes, unsigned int length) {
    std::string& rest = *static_cast<std::string*>(source);
    if (rest.size() < length) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(bytes, rest.data(), length);
    rest.erase(0, length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &png);
  DecodedPng decoded{
      cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* row = cairo_image_surface_get_data(surface);
  for (int y = 0; row && y < decoded.height; ++y, row += cairo_image_surface_get_stride(surface)) {
    decoded.pixels.resize(decoded.pixels.size() + static_cast<std::size_t>(decoded.width));
    std::memcpy(&decoded.pixels[decoded.pixels.size() - static_cast<std::size_t>(decoded.width)],
                row, sizeof(std::uint32_t) * static_cast<std::size_t>(decoded.width));
  }
  cairo_surface_destroy(surface);
  return decoded;
}

/// Pixels of the leak's saturated blue, which nothing else has, within columns [first, end).
inline long blue_pixels(const DecodedPng& png, int first, int end) {
  long count = 0;
  for (int y = 0; y < png.height; ++y)
    for (int x = first; x < end; ++x) {
      const std::uint32_t pixel = png.pixels[static_cast<std::size_t>(y * png.width + x)];
      const std::uint32_t red = pixel >> 16 & 0xFFu, blue = pixel & 0xFFu;
      count += blue > 0xC0u && red < 0x40u;
    }
  return count;
}

/// Whether words warn (palette::kWarning).
inline bool warns(const DecodedPng& png) {
  constexpr int kWords = 50, kNear = 6;
  const auto near = [](std::uint32_t part, int value) {
    return std::abs(static_cast<int>(part & 0xFFu) - value) <= kNear;
  };
  return std::count_if(png.pixels.begin(), png.pixels.end(), [&](std::uint32_t pixel) {
           return near(pixel >> 16, 0xBF) && near(pixel >> 8, 0x1C) && near(pixel, 0x1C);
         }) > kWords;
}

}  // namespace coapt
