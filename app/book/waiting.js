"use strict";
// What of a page waits as text: a lesson's settings but the first, and of that one all behind the station where it begins; a
// review's questions. It stands in <noscript>: a browser without scripts shows it, one with scripts reads a mere text, which
// becomes elements when it is opened, read with all the rest, or printed.

/// As without scripts.
function isect_show_all() {
  for (const waits of document.querySelectorAll("noscript")) waits.outerHTML = waits.textContent;
}

/// Returns what makes elements of a <noscript>, in its place, and returns those.
function isect_waiting() {
  const group = /<g id="(g\d+)">[^]*?<\/g>/g, use = /<use href="#(g\d+)"/g;
  let groups = null;  // what pictures draw alike, by its id, of all that waited when one was missed
  const stands = id => document.getElementById(id) !== null;
  /// Each group stands in the page once. A picture that refers to one which still waits has it from there.
  function linked(text) {
    const own = new Set();
    const made = text.replace(group, (all, id) => stands(id) ? `<use href="#${id}"/>` : (own.add(id), all));
    for (const [, id] of made.matchAll(use)) if (!own.has(id) && !stands(id)) take(id);
    return made;
  }
  function take(id) {
    groups ??= new Map([...document.querySelectorAll("noscript")]
      .flatMap(waits => [...waits.textContent.matchAll(group)].map(found => [found[1], found[0]])));
    shared().insertAdjacentHTML("beforeend", groups.get(id) ?? "");
  }
  function shared() {
    if (!document.querySelector(".shared defs"))
      document.getElementById("main").insertAdjacentHTML("afterbegin",
        `<svg class="shared" width="0" height="0" aria-hidden="true" focusable="false"><defs></defs></svg>`);
    return document.querySelector(".shared defs");
  }
  return waits => {
    const before = waits.previousElementSibling, made = [], text = linked(waits.textContent);
    waits.insertAdjacentHTML("beforebegin", text);
    for (let one = waits.previousElementSibling; one !== before; one = one.previousElementSibling) made.unshift(one);
    waits.remove();
    return made;
  };
}

/// The settings of a lesson's page, by their ids. `made` is called with a section and its articles that have become elements.
function isect_settings(made) {
  const parts = [...document.querySelectorAll("#walks > .walk, #walks > noscript")], make = isect_waiting();
  const ids = parts.map(part => part.id || part.dataset.setting), part_of = id => parts[ids.indexOf(id)];
  const waits_in = part => part.matches("noscript") ? part : part.querySelector(".steps > noscript");
  const articles = section => [...section.querySelectorAll(".steps > article")];
  /// The section of a setting. `whole`: with all its stations; of the first setting one stands there from the beginning.
  function section(id, whole = true) {
    const at = ids.indexOf(id), waits = waits_in(parts[at]);
    if (!waits || (!whole && waits !== parts[at])) return parts[at];
    const known = waits === parts[at] ? [] : articles(parts[at]), fresh = make(waits);
    if (waits === parts[at]) parts[at] = fresh[0];
    made(parts[at], articles(parts[at]).filter(article => !known.includes(article)));
    return parts[at];
  }
  /// How many stations it has, and how many of them are steps.
  function counts(walk) {
    const waits = waits_in(walk), all = articles(walk);
    if (waits) return { stations: Number(waits.dataset.stations), steps: Number(waits.dataset.steps) };
    return { stations: all.length, steps: all.filter(article => article.classList.contains("step")).length };
  }
  /// An element of a setting; where that waits, it is none of the page. `text`: what it must hold to be looked for.
  function find(id, selector, text = "") {
    const part = part_of(id), waits = waits_in(part), here = part.querySelector(selector);
    if (here || !waits || !waits.textContent.includes(text)) return here;
    const aside = document.createElement("template");
    aside.innerHTML = waits.textContent;
    return aside.content.querySelector(selector);
  }
  return { ids, section, articles, counts, find, all: () => ids.forEach(id => section(id)) };
}
