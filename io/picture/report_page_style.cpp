#include "io/picture/report_page_style.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "io/json/version.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

// Three columns on a wide screen, two on a narrow one and on paper, one on a telephone.
constexpr std::string_view kFirstPage = R"(
main{max-width:1240px;padding-top:1.2rem}
h1{font-size:1.6rem}
.lead{margin:.1rem 0 .4rem;font-size:.95rem;line-height:1.4}
.notice{margin:.4rem 0;padding:.25rem .8rem;font-size:.95rem}
.first{display:grid;font-size:.92rem;line-height:1.42;grid-template-rows:auto auto auto 1fr;gap:.2rem 1.1rem;grid-template-columns:repeat(2,minmax(0,1fr));
grid-template-areas:"verdict verdict" "atrial atrial" "cut operation" "cut care" "key key" "others others"}
.first>.robust,.first>.least-bad{grid-area:verdict;margin:.3rem 0;padding:.4rem .9rem;
font-size:1rem}
.operation{grid-area:operation}.atrial{grid-area:atrial}.cut{grid-area:cut}.key{grid-area:key}
.care{grid-area:care}.others{grid-area:others}
.first h2,.first h3{margin:.3rem 0 .2rem;font-size:1.02rem}
.first figure{margin:.3rem 0}
.first .plan{padding-left:1.3rem;font-weight:400;font-size:inherit;margin:.2rem 0}
.plan span{color:var(--muted)}.plan li{margin-bottom:.3rem}
.first dl{grid-template-columns:repeat(4,minmax(0,1fr));gap:.5rem;margin:.3rem 0}
.first dl div{padding:.35rem .6rem}.first dd{font-size:1.08rem}.first dd small{font-size:.76rem}
.first .small{margin:.2rem 0}.first ul{margin:.2rem 0}
.first .dense td,.first .dense th{padding:.25rem .36rem;text-align:left}
.this td,.this th{background:var(--good-paper)}
tbody th{font-size:inherit;color:inherit;text-align:left}
.first .badge{display:inline-block;margin:0 0 0 .2rem}#ranked .badge{margin-left:0}
a{color:var(--accent)}
.fold h3{margin-top:.8rem}
summary h3{display:inline;margin:0}
@media (min-width:1100px){.first{grid-template-columns:repeat(3,minmax(0,1fr));
grid-template-areas:"verdict verdict verdict" "atrial atrial cut" "operation key key" "care key key"
"others others others"}}
@media (max-width:640px){.first{display:block}.first dl{grid-template-columns:repeat(2,minmax(0,1fr))}}
)";

// Tables and figures stay whole; a table longer than a sheet breaks between rows under its head.
constexpr std::string_view kPrint = R"(
@media print{
:root{--paper:#fff;--card:#fff;--ink:#000;--muted:#3d4650;--line:#b9c0c8;--accent:#1b3f96;
--warn:#8a2b0b;--warn-paper:#fff;--good:#004d39;--good-paper:#fff;color-scheme:light}
html{font-size:11.6px}
body{font-size:1rem;line-height:1.27}
.first dl div{padding:.2rem .5rem}.first dl{gap:.35rem}
.first>.robust,.first>.least-bad,.notice{margin:.25rem 0}
.first figure{margin:.2rem 0}.atrial img{width:auto;max-width:100%;max-height:44mm}.cut img{width:auto;max-width:100%;max-height:40mm}.first .plan li{margin-bottom:.2rem}
.first dl{grid-template-columns:repeat(5,minmax(0,1fr))}
.first:has(.plan>li:nth-child(3)){grid-template-areas:"verdict verdict" "atrial atrial" "cut operation" "care operation" "key key" "others others"}
main{padding:0;max-width:none}
h1{font-size:1.3rem}
.contents{display:none}
.notice,.robust,.least-bad{border:1.5px solid currentColor;border-radius:4px}
h2{margin:1.4rem 0 .4rem}
figure{margin:.5rem 0}
figure,dl,pre,.care,.operation,li,tr{break-inside:avoid}
table{break-inside:auto}thead{display:table-header-group}
table.whole{break-inside:avoid}
h2,h3,h4,summary{break-after:avoid}
.scroll{overflow:visible;border-radius:0}
details{border:0;padding:0;margin:0}
summary{list-style:none}
.fold>summary{display:none}
.plan-evidence{margin-top:.9rem}
img,.chart{border-radius:0}
.chart{padding:.2rem}
.this td,.this th{font-weight:700}
a{color:inherit;text-decoration:none}
.dense{font-size:.86rem}.first .dense td,.first .dense th,.dense td,.dense th{padding:.15rem .25rem}
#evidence table,#search table{font-size:.84rem}
#evidence :is(td,th),#search :is(td,th){padding:.15rem .4rem}
.narrow{max-width:135mm}
.dense .words{min-width:11rem}
.chart .coapt-panels .tick,.chart .coapt-panels .small{font-size:13px;opacity:1}
.chart .coapt-panels .note{opacity:1}
.chart .coapt-panels text{fill:#000}.chart .coapt-panels [class*=" on"]{fill:currentColor}
}
)";

/// A quoted CSS string that ends neither itself nor the style sheet.
std::string css_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : printable(text)) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool plain = byte >= 0x80 || byte == ' ' || byte == '.' || byte == '-' || byte == '_' ||
                       (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= 'a' && byte <= 'z');
    if (plain) {
      quoted += letter;
      continue;
    }
    std::array<char, 8> escaped;
    std::snprintf(escaped.data(), escaped.size(), "\\%x ", byte);
    quoted += escaped.data();
  }
  return quoted + '"';
}

std::string margin_box(const char* place, const std::string& content) {
  return std::string("@") + place + "{content:" + content +
         ";font:8pt system-ui,\"DejaVu Sans\",sans-serif;color:#3d4650}\n";
}

}  // namespace

std::string report_page_style(const std::string& valve_name, const std::string& date) {
  return std::string(kFirstPage) + std::string(kPrint) + "@page{margin:12mm 12mm 11mm;\n" +
         margin_box("top-left", css_string(valve_name)) +
         margin_box("top-right", css_string((date.empty() ? "" : date + ", ") + "coapt " +
                                            std::string(version()))) +
         margin_box("bottom-left", css_string(kResearchNotice)) +
         margin_box("bottom-right", "\"page \" counter(page) \" of \" counter(pages)") + "}\n";
}

}  // namespace coapt
