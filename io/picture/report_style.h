#pragma once

#include <string_view>

namespace coapt {

/// The plan report's style sheet: one column for reading, light and dark, prints on A4.
inline constexpr std::string_view kReportStyle = R"(
:root{--paper:#fbfaf8;--card:#fff;--ink:#1d2732;--muted:#647080;--line:#dfe3e8;--accent:#2456c8;
--warn:#a3340f;--warn-paper:#fdf1ea;--good:#00694d;--good-paper:#e6f4ee;color-scheme:light dark}
@media screen and (prefers-color-scheme:dark){:root{--paper:#14181d;--card:#1c2229;--ink:#e4e9ef;--muted:#98a4b3;
--line:#323b46;--accent:#86aaff;--warn:#ffab84;--warn-paper:#33231b;--good:#3fd3a2;--good-paper:#16302a}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,"Segoe UI","Helvetica Neue","DejaVu Sans",sans-serif}
main{max-width:1060px;margin:0 auto;padding:2.4rem 1.4rem 4rem}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 .3rem;letter-spacing:-.01em;overflow-wrap:anywhere}
h2{font-size:1.2rem;margin:2.6rem 0 .7rem}
h3{font-size:1rem;margin:1.6rem 0 .5rem}
p,ul,ol{margin:.4rem 0 .8rem}
.lead,.small,figcaption,dt{color:var(--muted)}
.small,figcaption{font-size:.87rem}
.notice{border-left:4px solid var(--warn);background:var(--warn-paper);color:var(--warn);
padding:.55rem .9rem;margin:1.2rem 0;border-radius:0 6px 6px 0;font-weight:600}
.warning{color:var(--warn)}
.verdict{font-size:1.3rem;font-weight:600;margin:1.2rem 0}
.robust,.least-bad{padding:.7rem 1rem;border-radius:10px;font-size:1.05rem}
.robust{color:var(--good);background:var(--good-paper)}
.least-bad{color:var(--warn);background:var(--warn-paper)}
dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(215px,1fr));gap:.8rem;margin:1rem 0}
dl div{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:.7rem .9rem}
dt{font-size:.82rem}dd{margin:.1rem 0 0;font-size:1.28rem;font-weight:600;line-height:1.3}
dd small{display:block;font-size:.8rem;font-weight:400;color:var(--muted)}
ul.warning{padding-left:1.2rem}.plan{font-size:1.08rem;font-weight:600;padding-left:1.2rem}
figure{margin:1rem 0}
img,.chart{width:100%;height:auto;display:block;border:1px solid var(--line);border-radius:10px}
.chart{background:var(--card);padding:.8rem}
.narrow{max-width:800px}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:10px;background:var(--card)}
table{border-collapse:collapse;width:100%;font-size:.92rem}
th,td{padding:.5rem .65rem;text-align:right;vertical-align:top;border-bottom:1px solid var(--line);
font-variant-numeric:tabular-nums}
tbody tr:last-child td{border-bottom:0}
th{font-weight:600;font-size:.8rem;color:var(--muted);vertical-align:bottom}
.text{text-align:left}
.dense{font-size:.84rem}.dense th,.dense td{padding:.5rem .36rem;white-space:nowrap}
.dense .words{min-width:12rem;white-space:normal}
.dense .group{text-align:center;border-bottom:0;padding-bottom:0}
tr.has-more td{border-bottom:0}tr.more td{padding-top:0}
.badge{display:block;width:max-content;margin:.2rem 0 0 auto;padding:0 .4rem;border-radius:6px;
font-size:.72rem;font-weight:600;background:var(--good-paper);color:var(--good)}
.badge.plain{background:none;color:var(--accent);border:1px solid var(--accent)}
.verdict-of{font-weight:600;white-space:nowrap}
.pass{color:var(--good)}.warn,.reject{color:var(--warn)}.not_assessed{color:var(--muted)}
.reject{text-transform:uppercase;letter-spacing:.03em}
.pair{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:1.2rem;align-items:start}
@media (max-width:760px){.pair{grid-template-columns:minmax(0,1fr)}}
details{border:1px solid var(--line);border-radius:10px;padding:.2rem 1rem .9rem;margin:.8rem 0}
details:not([open]){padding-bottom:.2rem}
summary{cursor:pointer;padding:.5rem 0;font-weight:600}summary small{font-weight:400;
color:var(--muted);font-size:.87rem}
.facts th,.facts td{text-align:left}.facts th{white-space:nowrap;width:1%;vertical-align:top}
.facts td{overflow-wrap:anywhere}.mono{font:.88rem/1.5 ui-monospace,"DejaVu Sans Mono",monospace}
.words{text-align:left;min-width:15rem}.words ul{margin:0;padding-left:1rem}
pre{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:.8rem 1rem;
white-space:pre-wrap;overflow-wrap:anywhere;font:.88rem/1.5 ui-monospace,"DejaVu Sans Mono",monospace}
@media print{body{background:#fff}main{max-width:none;padding:0}h2,figure,tr{break-inside:avoid}
details::details-content{content-visibility:visible;display:block;block-size:auto}}
)";

}  // namespace coapt
