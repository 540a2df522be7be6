// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace aneurysm::report
{

/// Of all pages: light or dark as the reader's system is, black on white in print. The colors of
/// curves are those of Okabe and Ito, which color-blind readers can tell apart.
inline constexpr std::string_view page_style = R"css(
:root {
  --page: #ffffff; --text: #1c1f23; --weak: #5b6470; --line: #d5dae0; --shade: #f3f5f7; --link: #0b57a4;
  --good: #0a6b3d; --bad: #b3261e; --warn: #8a5a00;
  --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #a3548a; --c4: #b57b00; --c5: #3a3f45;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171a; --text: #e6e9ec; --weak: #9aa4b0; --line: #363d45; --shade: #1e2328; --link: #79b8f2;
    --good: #5fd08f; --bad: #ff8a80; --warn: #f0b94a;
    --c0: #56b4e9; --c1: #ff8f45; --c2: #2fd0a0; --c3: #e39cc8; --c4: #e69f00; --c5: #c8ced6;
  }
}
body { background: var(--page); color: var(--text); margin: 0 auto; max-width: 76rem; padding: 1rem 1.25rem 4rem;
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 1rem 0 0.5rem; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 0.75rem; padding-top: 0.75rem; border-top: 2px solid var(--line); }
h3 { font-size: 1.12rem; margin: 2rem 0 0.5rem; }
h4 { font-size: 1rem; margin: 2rem 0 0.3rem; border-top: 1px solid var(--line); padding-top: 0.5rem; }
p, ul { max-width: 48rem; margin: 0.4rem 0 0.8rem; }
a { color: var(--link); }
code { font: 0.88em/1.4 ui-monospace, monospace; overflow-wrap: anywhere; }
.weak { color: var(--weak); } .holds { color: var(--good); } .warn { color: var(--warn); }
.fails { color: var(--bad); font-weight: 700; }
.verdict { border: 2px solid currentColor; border-radius: 0.5rem; padding: 0.6rem 1rem; font-size: 1.25rem;
  font-weight: 650; max-width: none; }
.who { font-size: 1rem; font-weight: 500; }
.figures { display: flex; flex-wrap: wrap; gap: 0.75rem; margin: 1rem 0; max-width: none; padding: 0; list-style: none; }
.figures li { background: var(--shade); border-radius: 0.5rem; padding: 0.5rem 1rem; flex: 1 1 11rem; }
.figures b { display: block; font-size: 1.6rem; line-height: 1.3; }
.wide { overflow-x: auto; margin: 0.5rem 0 1rem; }
table { border-collapse: collapse; font-size: 0.86rem; line-height: 1.4; }
th, td { border-bottom: 1px solid var(--line); padding: 0.3rem 0.6rem; text-align: left; vertical-align: top; }
thead th { background: var(--shade); border-bottom: 2px solid var(--line); }
tr.group th { background: var(--shade); font-weight: 600; padding-top: 0.6rem; }
tr.group .weak { font-weight: 400; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.long { min-width: 13rem; }
th.sign { writing-mode: vertical-rl; transform: rotate(180deg); font-weight: 500; padding: 0.4rem 0.1rem; }
td.sign { text-align: center; padding: 0.1rem 0.35rem; white-space: nowrap; }
nav ul { display: flex; flex-wrap: wrap; gap: 0.2rem 1.5rem; padding: 0; list-style: none; }
figure { display: inline-block; margin: 0.5rem 1rem 0.5rem 0; max-width: 33rem; width: 100%; vertical-align: top; }
figure.picture { max-width: none; display: block; margin: 1rem 0; }
figure.picture img { max-width: 100%; height: auto; background: #fff; }
figcaption { font-size: 0.86rem; font-weight: 600; }
svg { width: 100%; height: auto; } svg text { fill: var(--text); font-size: 13px; }
.axis { stroke: var(--text); } .grid { stroke: var(--line); }
.s0 { --c: var(--c0); } .s1 { --c: var(--c1); } .s2 { --c: var(--c2); }
.s3 { --c: var(--c3); } .s4 { --c: var(--c4); } .s5 { --c: var(--c5); }
svg path { stroke: var(--c); fill: none; stroke-width: 1.5; } .curve { stroke-width: 2; }
.curve.s1 { stroke-dasharray: 8 3; } .curve.s2 { stroke-dasharray: 2 3; } .curve.s3 { stroke-dasharray: 8 3 2 3; }
.curve.s4 { stroke-dasharray: 14 4; } .curve.s5 { stroke-dasharray: 4 4; }
@media print {
  :root { --page: #fff; --text: #000; --weak: #444; --line: #bbb; --shade: #f0f0f0; --link: #000; --good: #064;
    --bad: #a00; --warn: #640;
    --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #a3548a; --c4: #b57b00; --c5: #3a3f45; }
  body { font-size: 10pt; max-width: none; padding: 0; } table { font-size: 7.5pt; }
  .wide { overflow: visible; } .long { min-width: 0; } h2 { break-before: page; }
  tr, figure, h3, h4 { break-inside: avoid; } h3, h4 { break-after: avoid; } th, td { overflow-wrap: anywhere; }
}
)css";

} // namespace aneurysm::report
