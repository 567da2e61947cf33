// The fixed parts of the trade-off's charts and page: style and script. Plain SVG, HTML, CSS, JavaScript; no
// library.
#pragma once

namespace raytracer {

constexpr const char* chartColors = R"css(
:root { color-scheme: light dark; --ink: #1b1d21; --soft: #5f6672; --paper: #f4f5f7; --card: #fff; --line: #dfe2e7;
  --dots: #a9afba; --front: #2457c5; --plain: #c2410c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8ec; --soft: #a3aab6; --paper: #14161a; --card: #1e2127;
  --line: #343943; --dots: #6b7280; --front: #8ab0ff; --plain: #ff9d66; } }
)css";

constexpr const char* chartStyle = R"css(
.grid { stroke: var(--line); fill: none; } .tick, .label, .title, .letter { font: 11px system-ui, sans-serif; fill: var(--soft); }
.title { font-size: 14px; font-weight: 600; fill: var(--ink); }
.floor { stroke: var(--soft); stroke-dasharray: 2 4; fill: none; }
.line { stroke: var(--front); stroke-width: 1.5; fill: none; }
.other { fill: var(--dots); } .front { fill: var(--front); } .plain { fill: var(--card); stroke: var(--plain); stroke-width: 2.5; }
.letter { font-weight: 700; fill: var(--ink); }
)css";

constexpr const char* pageStyle = R"css(
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
main, .head { max-width: 80rem; margin: auto; padding: 0 1.2rem; }
.head { padding-top: 1.4rem; } h1 { font-size: 1.5rem; margin: 0; } .head p { max-width: 50rem; color: var(--soft); margin: .5rem 0; }
nav { display: flex; flex-wrap: wrap; gap: .2rem 1rem; margin: .8rem 0; } a { color: var(--front); }
.key { display: inline-block; width: .8em; height: .8em; border-radius: 50%; background: var(--dots); }
.key.front { background: var(--front); } .key.plain { background: none; border: 2.5px solid var(--plain); }
section { background: var(--card); border: 1px solid var(--line); border-radius: .5rem; padding: .8rem 1.1rem 1.1rem; margin: 0 0 1.2rem; }
h2 { font-size: 1.2rem; margin: 0 0 .3rem; } h3 { font-size: .95rem; margin: 1.1rem 0 .3rem; color: var(--soft); }
.about { margin: 0 0 .8rem; color: var(--soft); max-width: 60rem; }
.both { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 1.2rem; align-items: start; }
@media (max-width: 60rem) { .both { grid-template-columns: minmax(0, 1fr); } main, .head { padding: 0 .6rem; } section { padding: .7rem; } }
.chart { width: 100%; height: auto; display: block; overflow: visible; } circle { cursor: pointer; } circle:hover { stroke: var(--ink); stroke-width: 2; }
.scroll { overflow: auto; max-height: 27rem; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .85rem; }
th { position: sticky; top: 0; background: var(--card); text-align: right; font-weight: 600; color: var(--soft); }
th, td { padding: .12rem .6rem .12rem 0; text-align: right; white-space: nowrap; } th:last-child, td:last-child { text-align: left; }
td { border-top: 1px solid var(--line); vertical-align: top; } td:last-child { white-space: normal; min-width: 11rem; padding-right: 0; }
@media (max-width: 40rem) { tr > :nth-child(4), tr > :nth-child(5) { display: none; } }  /* PSNR and maximum */
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1rem; }
figure { margin: 0; } figure div { display: grid; grid-template-columns: 1fr 1fr; gap: 2px; background: #000; line-height: 0; }
figure img { width: 100%; image-rendering: pixelated; } figcaption { font-size: .82rem; color: var(--soft); margin-top: .25rem; }
figcaption b { color: var(--ink); } code { font: .95em ui-monospace, monospace; white-space: nowrap; }
.swap { cursor: pointer; }
#tip { position: fixed; z-index: 2; max-width: min(24rem, 90vw); pointer-events: none; background: var(--ink); color: var(--card);
  padding: .35rem .6rem; border-radius: .3rem; font-size: .82rem; white-space: pre-line; visibility: hidden; }
)css";

constexpr const char* pageScript = R"js(
"use strict";
const tip = document.getElementById("tip");
for (const title of document.querySelectorAll("svg title")) {  // the browser's own tip comes late and not at all to a finger
  title.parentNode.dataset.tip = title.textContent;
  title.remove();
}
function place(x, y) {
  const box = tip.getBoundingClientRect(), right = x + 14 + box.width > innerWidth, low = y + 14 + box.height > innerHeight;
  tip.style.left = `${Math.max(4, right ? x - 14 - box.width : x + 14)}px`;
  tip.style.top = `${Math.max(4, low ? y - 14 - box.height : y + 14)}px`;
}
function hover(event) {
  const text = event.target.closest("[data-tip]")?.dataset.tip;
  tip.style.visibility = text ? "visible" : "hidden";
  if (!text) return;
  tip.textContent = text;
  place(event.clientX, event.clientY);
}
document.addEventListener("pointermove", hover);
document.addEventListener("pointerdown", hover);

// A picture turns into the reference while it is pressed.
for (const picture of document.querySelectorAll("img.swap")) {
  const own = picture.src, truth = picture.closest("section").querySelector("img.reference").src;
  picture.addEventListener("pointerdown", () => picture.src = truth);
  for (const end of ["pointerup", "pointerleave", "pointercancel"]) picture.addEventListener(end, () => picture.src = own);
  picture.draggable = false;
}
)js";

}  // namespace raytracer
