#pragma once

#include <string_view>

namespace coapt {

/// The plan report's style sheet: one column for reading, light and dark, prints on A4.
inline constexpr std::string_view kReportStyle = R"(
:root{--paper:#fbfaf8;--card:#fff;--ink:#1d2732;--muted:#647080;--line:#dfe3e8;--accent:#2456c8;
--warn:#a3340f;--warn-paper:#fdf1ea;color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--paper:#14181d;--card:#1c2229;--ink:#e4e9ef;--muted:#98a4b3;
--line:#323b46;--accent:#86aaff;--warn:#ffab84;--warn-paper:#33231b}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,"Segoe UI","Helvetica Neue","DejaVu Sans",sans-serif}
main{max-width:1060px;margin:0 auto;padding:2.4rem 1.4rem 4rem}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 .3rem;letter-spacing:-.01em;overflow-wrap:anywhere}
h2{font-size:1.2rem;margin:2.6rem 0 .7rem}
p,ul,ol{margin:.4rem 0 .8rem}
.lead,.small,figcaption,dt{color:var(--muted)}
.small,figcaption{font-size:.87rem}
.notice{border-left:4px solid var(--warn);background:var(--warn-paper);color:var(--warn);
padding:.55rem .9rem;margin:1.2rem 0;border-radius:0 6px 6px 0;font-weight:600}
.warning{color:var(--warn)}
dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(165px,1fr));gap:.8rem;margin:1rem 0}
dl div{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:.7rem .9rem}
dt{font-size:.82rem}dd{margin:.1rem 0 0;font-size:1.28rem;font-weight:600;line-height:1.3}
dd small{display:block;font-size:.8rem;font-weight:400;color:var(--muted)}
.plan{font-size:1.08rem;font-weight:600;padding-left:1.2rem}
figure{margin:1rem 0}
img,.chart{width:100%;height:auto;display:block;border:1px solid var(--line);border-radius:10px}
.chart{background:var(--card);padding:.8rem}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:10px;background:var(--card)}
table{border-collapse:collapse;width:100%;font-size:.92rem}
th,td{padding:.5rem .65rem;text-align:right;vertical-align:top;border-bottom:1px solid var(--line);
font-variant-numeric:tabular-nums}
tbody tr:last-child td{border-bottom:0}
th{font-weight:600;font-size:.8rem;color:var(--muted);vertical-align:bottom}
.words{text-align:left;min-width:15rem}.words ul{margin:0;padding-left:1rem}
pre{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:.8rem 1rem;
white-space:pre-wrap;overflow-wrap:anywhere;font:.88rem/1.5 ui-monospace,"DejaVu Sans Mono",monospace}
@media print{body{background:#fff}main{max-width:none;padding:0}h2,figure,tr{break-inside:avoid}}
)";

}  // namespace coapt
