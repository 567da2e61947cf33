"use strict";
const $ = id => document.getElementById(id);
const main = document.querySelector("main");
let cards = [...document.querySelectorAll("article")];

// The list: sorted, grouped, filtered.
const worse = (a, b) =>
  a.dataset.score - b.dataset.score || b.dataset.error - a.dataset.error || byName(a, b);
const byName = (a, b) => a.dataset.name < b.dataset.name ? -1 : a.dataset.name > b.dataset.name ? 1 : 0;
const orders = { worst: worse, best: (a, b) => worse(b, a), name: byName };

function section(title, members) {
  const part = document.createElement("section");
  if (title && members.length > 1) part.append(Object.assign(document.createElement("h2"), { textContent: title }));
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
  for (const part of main.children)
    part.hidden = [...part.querySelectorAll("article")].every(card => card.hidden);
  if (visible().length === 0)
    main.append(Object.assign(document.createElement("p"),
      { className: "empty", textContent: "Nothing to show." }));
}
const visible = () => [...main.querySelectorAll("article")].filter(card => !card.hidden);
for (const id of ["sort", "grouped", "offOnly", "filter"]) $(id).addEventListener("input", arrange);

// The viewer shows one picture at a time, all in the same place.
const viewer = $("viewer"), stage = $("stage");
const mark = Object.assign(document.createElement("div"), { id: "mark" });
let card = null, pictures = {}, kind = "", pixels = {}, blinking = 0;
let scale = 1, left = 0, top_ = 0;  // screen pixels: size of a picture's pixel, place of its corner

const size = () => { const p = Object.values(pictures)[0]; return [p.naturalWidth, p.naturalHeight]; };
const worst = () => (card.dataset.worst || "").split(",").map(Number);
function draw() {
  for (const [name, picture] of Object.entries(pictures)) {
    picture.className = name === kind ? "shown" : "";
    picture.style.transform = `translate(${left}px, ${top_}px) scale(${scale})`;
  }
  mark.hidden = !card.dataset.worst || card.dataset.error === "0";
  const [x, y] = worst(), box = Math.max(scale, 12), shift = (scale - box) / 2;
  Object.assign(mark.style, { left: `${left + x * scale + shift - 2}px`, width: `${box + 4}px`,
    top: `${top_ + y * scale + shift - 2}px`, height: `${box + 4}px` });
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
const closeUp = () =>
  Math.max(8, 2 * fit(), Math.floor(Math.min(stage.clientWidth, stage.clientHeight) / 48));
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
  try {
    pixels[name] ||= readPixels(pictures[name]);
  } catch { return ""; }  // browsers forbid a page on a disk to read pictures beside it
  const at = 4 * (y * size()[0] + x);
  return `${name} ${[...pixels[name].slice(at, at + 3)].join(" ")}`;
}
function tell(x, y) {
  const [w, h] = size(), inside = x >= 0 && y >= 0 && x < w && y < h;
  const values = () => `(${x}, ${y})   ${valueOf("reference", x, y)}   ${valueOf("graded", x, y)}`;
  $("values").textContent = inside ? values() : "";
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
const swap = () => show(kind === "graded" ? "reference" : pictures.graded ? "graded" : "reference");
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
viewer.addEventListener("close", leave);  // closed by other means than the key
const keys = {
  " ": swap, Enter: swap, b: () => blink(!blinking), "1": () => show("reference"), "2": () => show("graded"),
  "3": () => show("difference"), d: () => show(kind === "difference" ? "graded" : "difference"),
  z: () => scale === closeUp() ? showAll() : showWorst(), "+": () => zoomBy(2), "=": () => zoomBy(2),
  "-": () => zoomBy(0.5), ArrowRight: () => step(1), ArrowLeft: () => step(-1), n: () => step(1),
  p: () => step(-1), Escape: leave,
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

// For a class: a table of submissions. Each row opens its pictures. The address names the opened submission.
const overview = $("overview");
if (overview) {
  const addresses = JSON.parse($("addresses").textContent), body = overview.querySelector("tbody");
  const rows = [...body.rows], heads = [...overview.querySelectorAll("thead th")];
  const opened = [$("opened"), document.querySelector(".back")];
  let last = null;
  const turn = isOpen => {
    overview.hidden = isOpen;
    for (const part of opened) part.hidden = !isOpen;
  };
  const linkOf = row => "#" + encodeURIComponent(row.dataset.name);
  for (const row of rows) row.querySelector("a").href = linkOf(row);
  const openRow = row => {
    last = row;
    main.replaceChildren($(row.dataset.template).content.cloneNode(true));
    for (const image of main.querySelectorAll("img[data-picture]")) image.src = addresses[image.dataset.picture];
    cards = [...main.querySelectorAll("article")];
    $("who").textContent = row.dataset.name;
    $("how").textContent = `mean ${row.cells[1].textContent}, ${row.cells[2].textContent} right`;
    turn(true);
    arrange();
    scrollTo(0, 0);
  };
  const closeRow = () => {
    if (viewer.open) viewer.close();
    main.replaceChildren();
    cards = [];
    turn(false);
    if (last) last.querySelector("a").focus();
  };
  const follow = () => {
    const row = rows.find(one => linkOf(one) === location.hash);
    if (row) openRow(row);
    else closeRow();
  };
  addEventListener("hashchange", follow);
  if (location.hash) follow();
  body.addEventListener("click", event => {
    const row = event.target.closest("tr");
    if (row && !event.target.closest("a")) location.hash = linkOf(row);
  });
  $("back").addEventListener("click", () => { location.hash = ""; });
  $("find").addEventListener("input", () => {
    const wanted = $("find").value.toLowerCase();
    for (const row of rows) row.hidden = !row.textContent.toLowerCase().includes(wanted);
  });
  // Sorts by a column, numbers as numbers. A second click reverses the order.
  const sortBy = head => {
    const column = heads.indexOf(head), order = head.ariaSort === "ascending" ? "descending" : "ascending";
    for (const other of heads) other.ariaSort = other === head ? order : "none";
    const text = row => row.cells[column].textContent, collator = new Intl.Collator(undefined, { numeric: true });
    const sign = order === "ascending" ? 1 : -1;
    rows.sort((a, b) => sign * collator.compare(text(a), text(b)));
    body.append(...rows);
  };
  for (const head of heads) head.querySelector("button").addEventListener("click", () => sortBy(head));
}
