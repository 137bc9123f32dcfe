"use strict";
// Elements as the scripts of the pages make them.

function isect_element(tag, attributes = {}, ...children) {
  const made = ["svg", "g", "circle"].includes(tag) ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/// An element of a class, with a text in it.
function isect_made(tag, text, type = "") { return isect_element(tag, type ? { class: type } : {}, text); }
function isect_button(name, action, type = "") {
  const made = isect_made("button", name, type);
  made.type = "button", made.addEventListener("click", action);
  return made;
}

/// A text as HTML writes it.
function isect_escaped(text) { return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;"); }

/// Gives a file to the browser to save.
function isect_save(bytes, name) {
  const address = URL.createObjectURL(bytes);
  isect_element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/// The title of a step, or of a lesson's card, without its number.
function isect_title_of(part) {
  return [...part.querySelector("h3").childNodes].slice(1).map(node => node.textContent).join("").trim();
}
