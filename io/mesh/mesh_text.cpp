#include "io/mesh/mesh_text.h"

#include <charconv>

namespace coapt {

void append_number(std::string& text, double number, std::optional<int> digits) {
  char characters[32];
  char* const end = characters + sizeof characters;
  const auto written =
      digits ? std::to_chars(characters, end, number, std::chars_format::general, *digits)
             : std::to_chars(characters, end, number);
  text.append(characters, written.ptr);
}

void append_points(std::string& text, const Points& points, const char* before,
                   std::optional<int> digits) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += before;
    for (int axis = 0; axis < 3; ++axis) {
      append_number(text, points(i, axis), digits);
      text += axis < 2 ? ' ' : '\n';
    }
  }
}

void append_faces(std::string& text, const Faces& faces, const char* before, int first) {
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    text += before;
    for (int corner = 0; corner < 3; ++corner) {
      text += std::to_string(faces(f, corner) + first);
      text += corner < 2 ? ' ' : '\n';
    }
  }
}

}  // namespace coapt
