#include "io/picture/svg.h"

#include "io/picture/text.h"

namespace coapt {

std::string text_at(double x, double y, const std::string& attributes, const std::string& text) {
  return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" " + attributes + ">" +
         escape_html(text) + "</text>\n";
}

std::string line_at(const char* style, double x1, double y1, double x2, double y2) {
  return "<line class=\"" + std::string(style) + "\" x1=\"" + fixed(x1, 1) + "\" y1=\"" +
         fixed(y1, 1) + "\" x2=\"" + fixed(x2, 1) + "\" y2=\"" + fixed(y2, 1) + "\"/>\n";
}

}  // namespace coapt
