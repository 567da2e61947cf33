"use strict";
const tip = document.getElementById("tip");
// Replaces the browser's own tooltips, which appear late, and on touch screens never.
for (const title of document.querySelectorAll("svg title")) {
  title.parentNode.dataset.tip = title.textContent;
  title.remove();
}
function place(x, y) {
  const box = tip.getBoundingClientRect();
  const right = x + 14 + box.width > innerWidth, low = y + 14 + box.height > innerHeight;
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

// Shows the reference in place of a picture while that is pressed.
for (const picture of document.querySelectorAll("img.swap")) {
  const own = picture.src, truth = picture.closest("section").querySelector("img.reference").src;
  picture.addEventListener("pointerdown", () => picture.src = truth);
  for (const end of ["pointerup", "pointerleave", "pointercancel"])
    picture.addEventListener(end, () => picture.src = own);
  picture.draggable = false;
}
