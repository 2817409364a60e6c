#pragma once

namespace ew::reports {

/// Text on its ground has a contrast of 4.5 and more in both themes (WCAG 2.1, AA). On paper it is always light.
inline constexpr const char* kPageStyle = R"(
:root { color-scheme: light dark; --back: #f6f7f8; --panel: #ffffff; --text: #1d2329; --soft: #525c66; --line: #d5dae0; --own: #a34700; --reference: #0b5d8f;
  --good: #1a6b3c; --bad: #b3261e; --caution: #7a5200; --link: #0b5d8f; }
@media screen and (prefers-color-scheme: dark) { :root { --back: #14171a; --panel: #1c2024; --text: #e6e9ec; --soft: #a6b0ba; --line: #373e45;
  --own: #ff9d52; --reference: #6cc0f5; --good: #74d49c; --bad: #ff9c91; --caution: #e6b155; --link: #6cc0f5; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--text); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
main { max-width: 920px; margin: 0 auto; padding: 24px 16px 48px; }
h1 { font-size: 26px; line-height: 1.25; margin: 16px 0 4px; } h2 { font-size: 20px; margin: 32px 0 8px; padding-top: 8px; border-top: 1px solid var(--line); }
h3 { font-size: 17px; margin: 24px 0 8px; } h4 { font-size: 16px; margin: 16px 0 4px; }
p { margin: 8px 0; max-width: 75ch; } .subtitle, .soft { color: var(--soft); } a { color: var(--link); }
.simulation { border: 1px solid var(--caution); border-radius: 6px; padding: 6px 12px; color: var(--caution); font-weight: 600; display: inline-block; }
.good { color: var(--good); } .bad { color: var(--bad); } .caution { color: var(--caution); } p.good, p.bad, p.caution { font-weight: 600; }
dl { display: grid; grid-template-columns: minmax(9em, max-content) 1fr; gap: 4px 24px; margin: 8px 0; } dt { color: var(--soft); } dd { margin: 0; min-width: 0; }
ul { list-style: none; padding: 0; margin: 8px 0; } li { padding-left: 1.6em; text-indent: -1.6em; max-width: 75ch; } .sign { display: inline-block; width: 1.6em; text-indent: 0; }
.wide { overflow-x: auto; } .wide:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
table { border-collapse: collapse; width: 100%; background: var(--panel); border: 1px solid var(--line); font-size: 14px; font-variant-numeric: tabular-nums; margin: 8px 0; }
caption { text-align: left; color: var(--soft); padding: 4px 0; } th, td { border-top: 1px solid var(--line); padding: 4px 10px; text-align: left; vertical-align: top; font-weight: 400; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; } .number { text-align: right; } td.number { white-space: nowrap; }
figure { margin: 16px 0; } figcaption { color: var(--soft); font-size: 14px; } .plot svg { display: block; width: 100%; min-width: 330px; max-width: 540px; height: auto; }
.plot figcaption { color: var(--text); font-weight: 600; font-size: 15px; margin-bottom: 4px; }
.small { display: inline-block; width: 48%; margin: 8px 1% 8px 0; vertical-align: top; } @media screen and (max-width: 760px) { .small { display: block; width: 100%; } }
figure img { display: block; max-width: 100%; max-height: 480px; background: #000000; border-radius: 4px; }
@media (max-width: 520px) { dl { grid-template-columns: 1fr; gap: 0; } dd { margin-bottom: 8px; } }
@page { size: A4; margin: 16mm 14mm; }
@media print { body { background: none; font-size: 10pt; } main { max-width: none; padding: 0; } h1 { font-size: 18pt; } h2 { font-size: 14pt; } h3 { font-size: 12pt; }
  h2, h3, h4, caption, figcaption { break-after: avoid; } tr, figure, li, dl > *, .simulation { break-inside: avoid; } thead { display: table-header-group; break-after: avoid; } tbody tr:nth-child(-n+2) { break-before: avoid; } .wide { overflow: visible; }
  table { font-size: 8.5pt; } th, td { padding: 2px 6px; } .plot svg { min-width: 0; max-width: 105mm; } figure img { max-height: 90mm; } nav { display: none; } a { color: inherit; text-decoration: none; } }
)";

}  // namespace ew::reports
