// The fixed parts of the grading report: style, controls and script. Plain HTML, CSS and JavaScript, no
// library.
#pragma once

namespace raytracer {

constexpr const char* reportStyle = R"css(
:root { color-scheme: light dark; --ink: #1b1d21; --soft: #666c77; --paper: #f4f5f7; --card: #fff; --line: #d8dbe0;
  --good: #1a7f45; --near: #8a6100; --bad: #b3261e; --accent: #2457c5; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8ec; --soft: #9aa1ad; --paper: #14161a; --card: #1e2127;
  --line: #343943; --good: #58c98a; --near: #e5b94e; --bad: #ff8a80; --accent: #8ab0ff; } }
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
.page { position: sticky; top: 0; z-index: 1; padding: .7rem 1.2rem; background: var(--card);
  border-bottom: 1px solid var(--line); display: flex; flex-wrap: wrap; gap: .2rem 1.5rem; align-items: baseline; }
h1 { font-size: 1.1rem; margin: 0; } .summary { margin: 0; color: var(--soft); } .summary b { color: var(--ink); }
.controls { margin-left: auto; display: flex; flex-wrap: wrap; gap: .4rem 1rem; align-items: center; }
.controls input[type=search], select { font: inherit; padding: .15rem .4rem; }
main { padding: 0 1.2rem 3rem; max-width: 110rem; margin: auto; }
h2 { font-size: 1rem; margin: 1.6rem 0 .6rem; color: var(--soft); text-transform: capitalize; }
article { background: var(--card); border: 1px solid var(--line); border-left: .35rem solid var(--good);
  border-radius: .4rem; padding: .7rem .9rem; margin: 0 0 .8rem; display: grid; gap: .5rem 1.2rem;
  grid-template-columns: minmax(0, 3fr) minmax(13rem, 1fr); content-visibility: auto; contain-intrinsic-height: 18rem; }
article.near { border-left-color: var(--near); } article.off { border-left-color: var(--bad); }
article > header { grid-column: 1 / -1; display: flex; gap: 1rem; align-items: baseline; }
h3 { font-size: 1rem; margin: 0; overflow-wrap: anywhere; }
article output { font-weight: 700; font-size: 1.3rem; margin-left: auto; color: var(--good); }
article.near output { color: var(--near); } article.off output { color: var(--bad); }
.pictures { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: .6rem; align-items: start; }
.picture { border: 0; padding: 0; background: none; font: inherit; font-size: .85rem; color: var(--soft);
  text-align: center; border-radius: .2rem; }
button.picture { cursor: zoom-in; }
.picture span { display: block; position: relative; width: fit-content; margin: auto; line-height: 0; }
.picture img { max-width: 100%; max-height: 24rem; min-height: 1rem; background: #000; }
.picture i { position: absolute; width: 1.1rem; height: 1.1rem; margin: -.55rem; border: 2px solid #fff;
  border-radius: 50%; opacity: .75; }
.picture .none { width: 100%; aspect-ratio: 1; max-height: 12rem; border: 1px dashed var(--line); display: grid;
  place-items: center; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
dl { margin: 0; display: grid; grid-template-columns: auto 1fr; gap: 0 .8rem; align-content: start;
  font-variant-numeric: tabular-nums; }
dt { color: var(--soft); } dd { margin: 0; text-align: right; }
.message, pre { grid-column: 1 / -1; margin: 0; color: var(--bad); overflow-wrap: anywhere; }
pre { color: var(--soft); white-space: pre-wrap; max-height: 12rem; overflow: auto; border-left: 3px solid var(--line);
  padding-left: .6rem; font-size: .8rem; }
[hidden] { display: none !important; }
.empty { color: var(--soft); text-align: center; padding: 3rem; }
@media (max-width: 50rem) { article { grid-template-columns: 1fr; } .page { position: static; } }
dialog { border: 0; padding: 0; width: 100vw; height: 100vh; max-width: none; max-height: none; background: #24262b;
  color: #e6e8ec; overflow: hidden; }
dialog[open] { display: grid; grid-template-rows: auto 1fr auto; }
dialog p { margin: 0; padding: .5rem 1rem; display: flex; gap: 1.5rem; flex-wrap: wrap; align-items: baseline; }
#kind { font-weight: 700; padding: 0 .6rem; border-radius: .3rem; color: #14161a; min-width: 6.5rem;
  text-align: center; }
#kind.reference { background: #ffd479; } #kind.ours { background: #8fd0ff; } #kind.difference { background: #ff9db0; }
#values { font-variant-numeric: tabular-nums; margin-left: auto; white-space: pre; }
#stage { position: relative; overflow: hidden; cursor: crosshair; touch-action: none; background: #3a3d44; }
#stage img { position: absolute; left: 0; top: 0; transform-origin: 0 0; image-rendering: pixelated; max-width: none;
  visibility: hidden; }
#stage img.shown { visibility: visible; }
#mark { position: absolute; pointer-events: none; border: 2px solid #fff; outline: 2px solid #000; border-radius: 3px; }
kbd { border: 1px solid #777; border-radius: .25rem; padding: 0 .35rem; font: inherit; font-size: .85em; }
.keys { color: #b6bcc7; font-size: .85rem; gap: 1.1rem; }
)css";

constexpr const char* reportControls = R"html(<div class="controls">
<label>sort by <select id="sort"><option value="worst">worst first</option><option value="best">best first</option>
<option value="name">name</option></select></label>
<label><input type="checkbox" id="grouped" checked> in groups</label>
<label><input type="checkbox" id="offOnly"> only what is off</label>
<input type="search" id="filter" placeholder="name contains …" aria-label="show only names that contain">
</div>
)html";

constexpr const char* reportViewer = R"html(<dialog id="viewer" aria-label="pictures, large">
<p><b id="title"></b><span id="score"></span><span id="kind"></span><span id="values"></span></p>
<div id="stage"></div>
<p class="keys"><span><kbd>click</kbd> <kbd>space</kbd> swap</span><span><kbd>B</kbd> blink</span>
<span><kbd>D</kbd> difference</span><span><kbd>Z</kbd> worst pixel / all</span>
<span><kbd>wheel</kbd> <kbd>+</kbd> <kbd>-</kbd> zoom</span><span><kbd>drag</kbd> move</span>
<span><kbd>←</kbd> <kbd>→</kbd> other picture</span><span><kbd>Esc</kbd> close</span></p>
</dialog>
)html";

constexpr const char* reportScript = R"js(
"use strict";
const $ = id => document.getElementById(id);
const main = document.querySelector("main"), cards = [...document.querySelectorAll("article")];

// The list: sorted, grouped, filtered.
const worse = (a, b) => a.dataset.score - b.dataset.score || b.dataset.error - a.dataset.error || byName(a, b);
const byName = (a, b) => a.dataset.name < b.dataset.name ? -1 : a.dataset.name > b.dataset.name ? 1 : 0;
const orders = { worst: worse, best: (a, b) => worse(b, a), name: byName };

function section(title, members) {
  const part = document.createElement("section");
  if (title) part.append(Object.assign(document.createElement("h2"), { textContent: title }));
  part.append(...members);
  return part;
}
function arrange() {
  cards.sort(orders[$("sort").value]);
  const wanted = $("filter").value.toLowerCase();
  for (const card of cards)
    card.hidden = !card.dataset.name.toLowerCase().includes(wanted) ||
      ($("offOnly").checked && card.className === "same");
  const groups = new Map();
  for (const card of cards) {
    const group = $("grouped").checked ? card.dataset.group : "";
    groups.set(group, [...(groups.get(group) || []), card]);
  }
  main.replaceChildren(...[...groups].map(([title, members]) => section(title, members)));
  for (const part of main.children) part.hidden = [...part.querySelectorAll("article")].every(card => card.hidden);
  if (visible().length === 0)
    main.append(Object.assign(document.createElement("p"), { className: "empty", textContent: "Nothing to show." }));
}
const visible = () => [...main.querySelectorAll("article")].filter(card => !card.hidden);
for (const id of ["sort", "grouped", "offOnly", "filter"]) $(id).addEventListener("input", arrange);

// The viewer: one picture at a time, all in the same place.
const viewer = $("viewer"), stage = $("stage"), mark = Object.assign(document.createElement("div"), { id: "mark" });
let card = null, pictures = {}, kind = "", pixels = {}, blinking = 0;
let scale = 1, left = 0, top_ = 0;  // screen pixels: of a picture's pixel, and where its corner is

const size = () => { const p = Object.values(pictures)[0]; return [p.naturalWidth, p.naturalHeight]; };
const worst = () => (card.dataset.worst || "").split(",").map(Number);
function draw() {
  for (const [name, picture] of Object.entries(pictures)) {
    picture.className = name === kind ? "shown" : "";
    picture.style.transform = `translate(${left}px, ${top_}px) scale(${scale})`;
  }
  mark.hidden = !card.dataset.worst || card.dataset.error === "0";
  const [x, y] = worst(), box = Math.max(scale, 12), shift = (scale - box) / 2;
  Object.assign(mark.style, { left: `${left + x * scale + shift - 2}px`, top: `${top_ + y * scale + shift - 2}px`,
    width: `${box + 4}px`, height: `${box + 4}px` });
  $("kind").textContent = $("kind").className = kind;
}
function lookAt(x, y, newScale) {
  scale = newScale;
  left = Math.round(stage.clientWidth / 2 - x * scale);
  top_ = Math.round(stage.clientHeight / 2 - y * scale);
}
function fit() {
  const [w, h] = size(), exact = Math.min(stage.clientWidth / w, stage.clientHeight / h);
  return exact >= 1 ? Math.floor(exact) : exact;
}
const showAll = () => lookAt(size()[0] / 2, size()[1] / 2, fit());
const closeUp = () => Math.max(8, 2 * fit(), Math.floor(Math.min(stage.clientWidth, stage.clientHeight) / 48));
function showWorst() {
  if (!card.dataset.worst || card.dataset.error === "0") return showAll();
  const [x, y] = worst();
  lookAt(x + 0.5, y + 0.5, closeUp());
}
function zoomBy(factor, x = stage.clientWidth / 2, y = stage.clientHeight / 2) {
  const next = Math.min(256, Math.max(0.1, scale * factor));
  left = x - (x - left) * next / scale;
  top_ = y - (y - top_) * next / scale;
  scale = next;
}
function readPixels(picture) {
  const [w, h] = size(), canvas = Object.assign(document.createElement("canvas"), { width: w, height: h });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.drawImage(picture, 0, 0);
  return context.getImageData(0, 0, w, h).data;
}
function valueOf(name, x, y) {
  if (!pictures[name]) return "";
  pixels[name] ||= readPixels(pictures[name]);
  const at = 4 * (y * size()[0] + x);
  return `${name} ${[...pixels[name].slice(at, at + 3)].join(" ")}`;
}
function tell(x, y) {
  const [w, h] = size(), inside = x >= 0 && y >= 0 && x < w && y < h;
  $("values").textContent = inside ? `(${x}, ${y})   ${valueOf("reference", x, y)}   ${valueOf("ours", x, y)}` : "";
}
async function open_(newCard, newKind) {
  card = newCard;
  pixels = {};
  pictures = {};
  for (const button of card.querySelectorAll("button.picture")) {
    const picture = new Image();
    picture.src = button.querySelector("img").src;
    picture.alt = button.dataset.kind;
    pictures[button.dataset.kind] = picture;
  }
  const named = pictures[newKind] ? newKind : Object.keys(pictures)[0];
  await Promise.all(Object.values(pictures).map(picture => picture.decode().catch(() => 0)));
  stage.replaceChildren(...Object.values(pictures), mark);
  kind = named;
  $("title").textContent = card.dataset.name;
  $("score").textContent = "score " + card.dataset.score;
  if (!viewer.open) viewer.showModal();
  showWorst();
  draw();
  if (card.dataset.worst) tell(...worst());
  else $("values").textContent = "";
}
function show(name) {
  if (pictures[name]) kind = name;
  draw();
}
const swap = () => show(kind === "ours" ? "reference" : pictures.ours ? "ours" : "reference");
function blink(on) {
  clearInterval(blinking);
  blinking = on ? setInterval(swap, 500) : 0;
}
function step(by) {
  const list = visible().filter(other => other.querySelector("button.picture"));
  const next = list[list.indexOf(card) + by];
  if (next) open_(next, kind);
}
main.addEventListener("click", event => {
  const button = event.target.closest("button.picture");
  if (button) open_(button.closest("article"), button.dataset.kind);
});
function leave() {
  viewer.close();
  blink(false);
  const button = card.querySelector(`button[data-kind="${kind}"]`);
  card.scrollIntoView({ block: "nearest" });
  if (button) button.focus();
}
viewer.addEventListener("close", leave);  // by other means than the key
const keys = {
  " ": swap, Enter: swap, b: () => blink(!blinking), "1": () => show("reference"), "2": () => show("ours"),
  "3": () => show("difference"), d: () => show(kind === "difference" ? "ours" : "difference"),
  z: () => scale === closeUp() ? showAll() : showWorst(), "+": () => zoomBy(2), "=": () => zoomBy(2),
  "-": () => zoomBy(0.5), ArrowRight: () => step(1), ArrowLeft: () => step(-1), n: () => step(1), p: () => step(-1),
  Escape: leave,
};
viewer.addEventListener("keydown", event => {
  const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  action();
  draw();
});
let grip = null;
stage.addEventListener("pointerdown", event => {
  grip = { x: event.clientX, y: event.clientY, left, top_, moved: false };
  stage.setPointerCapture(event.pointerId);
});
stage.addEventListener("pointermove", event => {
  const corner = stage.getBoundingClientRect();
  const toPixel = position => Math.floor(position / scale);
  tell(toPixel(event.clientX - corner.left - left), toPixel(event.clientY - corner.top - top_));
  if (!grip) return;
  const dx = event.clientX - grip.x, dy = event.clientY - grip.y;
  grip.moved ||= Math.hypot(dx, dy) > 4;
  if (grip.moved) [left, top_] = [grip.left + dx, grip.top_ + dy];
  draw();
});
stage.addEventListener("pointerup", () => {
  if (grip && !grip.moved) swap();
  grip = null;
});
stage.addEventListener("wheel", event => {
  event.preventDefault();
  const corner = stage.getBoundingClientRect();
  zoomBy(event.deltaY < 0 ? 1.25 : 0.8, event.clientX - corner.left, event.clientY - corner.top);
  draw();
}, { passive: false });
addEventListener("resize", () => { if (viewer.open) { showWorst(); draw(); } });
)js";

}  // namespace raytracer
