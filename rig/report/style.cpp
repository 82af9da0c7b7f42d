#include "rig/report/style.h"

namespace foverig::report {

const char* const kStyle = R"css(
:root { color-scheme: light dark; --paper: #fff; --panel: #f6f7f9; --ink: #1c2330; --soft: #5b6575;
  --rule: #dde1e7; --good: #2f7d4f; --late: #c77d0a; --dropped: #c0392b; --budget: #b3261e;
  --s0: #3b6fb6; --s1: #e08a1e; --s2: #3f9a5f; --s3: #c94f4f; --s4: #7b5ea7; --s5: #2a9aa8;
  --s6: #b5892e; --s7: #d0679d; --s8: #7a8a3a; --s9: #8b919b; --on-bar: #fff; }
@media (prefers-color-scheme: dark) { :root { --paper: #14171c; --panel: #1c2027; --ink: #e4e7ec;
  --soft: #9aa4b2; --rule: #323943; --good: #52b57b; --late: #e8a53a; --dropped: #ef6b5e;
  --budget: #ff8a80; --s0: #6c9ee0; --s1: #f0a64b; --s2: #63bd84; --s3: #e57c7c; --s4: #a58bd0;
  --s5: #58c2cf; --s6: #d6b05c; --s7: #e894bf; --s8: #a6b763; --s9: #838b97; --on-bar: #14171c; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 28px 20px 60px; }
h1 { font-size: 25px; line-height: 1.25; margin: 0 0 4px; }
h2 { font-size: 18px; margin: 0 0 4px; }
h3 { font-size: 15px; margin: 18px 0 8px; }
section { margin-top: 36px; border-top: 1px solid var(--rule); padding-top: 18px; }
.note, .identity { color: var(--soft); margin: 0 0 14px; }
.note { max-width: 90ch; } .identity { font-size: 13px; }
.verdict { font-size: 16px; margin: 14px 0; padding: 12px 16px; background: var(--panel);
  border-left: 4px solid var(--good); border-radius: 4px; }
.verdict.bad { border-color: var(--dropped); }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(235px, 1fr)); gap: 10px; }
.tile { background: var(--panel); border-radius: 6px; padding: 10px 14px; }
.tile b { display: block; font-size: 22px; line-height: 1.3; font-variant-numeric: tabular-nums; }
.tile span, .tile small { color: var(--soft); font-size: 12.5px; display: block; }
.scroll { overflow-x: auto; }
svg { display: block; width: 100%; min-width: 620px; height: auto; }
svg text { font-size: 12px; fill: var(--ink); }
svg .axis { fill: var(--soft); } svg .axis-strong { font-weight: 600; font-size: 13px; }
svg .on-bar { fill: var(--on-bar); font-weight: 600; }
svg .budget-text { fill: var(--budget); font-weight: 600; paint-order: stroke;
  stroke: var(--paper); stroke-width: 4px; }
.grid { stroke: var(--rule); stroke-width: 1; }
.governed { fill: none; stroke: var(--s0); stroke-width: 2; }
.budget { stroke: var(--budget); stroke-width: 1.5; stroke-dasharray: 6 4; }
.good { fill: var(--good); background: var(--good); } .late { fill: var(--late);
  background: var(--late); }
.dropped { fill: var(--dropped); background: var(--dropped); }
.s0 { fill: var(--s0); background: var(--s0); } .s1 { fill: var(--s1); background: var(--s1); }
.s2 { fill: var(--s2); background: var(--s2); } .s3 { fill: var(--s3); background: var(--s3); }
.s4 { fill: var(--s4); background: var(--s4); } .s5 { fill: var(--s5); background: var(--s5); }
.s6 { fill: var(--s6); background: var(--s6); } .s7 { fill: var(--s7); background: var(--s7); }
.s8 { fill: var(--s8); background: var(--s8); } .s9 { fill: var(--s9); background: var(--s9); }
.legend { display: flex; flex-wrap: wrap; gap: 4px 20px; font-size: 13px; color: var(--soft);
  margin: 8px 0 14px; }
.legend i, .key { display: inline-block; width: 11px; height: 11px; border-radius: 2px;
  margin-right: 6px; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; margin: 8px 0; }
th, td { text-align: left; padding: 5px 12px 5px 0; border-bottom: 1px solid var(--rule);
  vertical-align: top; }
th { color: var(--soft); font-weight: 600; white-space: nowrap; }
th.n, td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap;
  padding-right: 16px; }
tr.off td { color: var(--soft); }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 12.5px; }
pre { background: var(--panel); padding: 12px; border-radius: 6px; overflow-x: auto; }
.gallery { display: flex; flex-wrap: wrap; gap: 14px; align-items: flex-start;
  margin-bottom: 14px; }
figure { margin: 0; } figure.eye { flex: 1 1 calc(20% - 12px); min-width: 190px; max-width: 50%; }
figure.wide { flex: 1 1 100%; } figure img { width: 100%; height: auto; border-radius: 4px;
  display: block; }
figure.magnified img { image-rendering: pixelated; }
.stack { position: relative; } .stack .over { position: absolute; inset: 0; opacity: 0; }
.flicker:checked ~ .gallery .over { animation: in-turns 1s steps(1) infinite; }
@keyframes in-turns { 50% { opacity: 1; } }
.lens { display: none; position: absolute; overflow: hidden; pointer-events: none; z-index: 1;
  border: 2px solid var(--paper); border-radius: 50%; box-shadow: 0 1px 6px #0008; }
.lens img, .lens .over { position: absolute; max-width: none; border-radius: 0; inset: auto;
  image-rendering: pixelated; }
figcaption { font-size: 12.5px; color: var(--soft); margin-top: 4px; }
figcaption code { font-size: 11.5px; overflow-wrap: anywhere; }
details summary { cursor: pointer; font-weight: 600; }
.live { display: none; } .enlivened .live { display: block; }
.uplot .u-axis .u-label { color: var(--soft); } .u-legend { font-size: 13px; }
@media screen { .enlivened > .scroll { display: none; } }
@media print { h2, h2 + p { break-after: avoid; } .legend { break-before: avoid; }
  svg, tr, img, p { break-inside: avoid; } .scroll { overflow: visible; } table { font-size: 70%; }
  #frame-strip, .enlivened .live { display: none; } }
)css";

}  // namespace foverig::report
