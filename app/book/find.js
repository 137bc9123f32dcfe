"use strict";
// A search over the lessons and the terms of the course, on the first page: all that is found stands in the page.
(() => {
  const start = document.querySelector(".cover .go"), listed = document.getElementById("terms");
  if (!start || !listed) return;
  const most = 8;
  const plain = text => text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
  const lessons = [...document.querySelectorAll(".lessons li[data-of]")].map(card => ({
    name: isect_title_of(card), told: card.querySelector("p").textContent, href: card.querySelector("a").getAttribute("href"), kind: "Lesson"
  }));
  const terms = JSON.parse(listed.textContent)
    .map(([name, told, id]) => ({ name, told, href: "glossary.html#" + encodeURIComponent(id), kind: "Term" }));
  const all = [...lessons, ...terms].map(one => ({ ...one, title: plain(one.name), words: plain(one.name + " " + one.told) }));

  /// What holds all the words: those whose name it is or begins so come first, then those that name them, then lessons.
  function found(asked) {
    const words = plain(asked).split(/\s+/).filter(Boolean), whole = words.join(" ");
    if (words.length === 0) return [];
    const rank = one => one.title === whole ? 0 : one.title.startsWith(whole) ? 1 : words.every(word => one.title.includes(word)) ? 2 : 3;
    return all.filter(one => words.every(word => one.words.includes(word))).map(one => [rank(one), one])
      .sort(([a], [b]) => a - b).slice(0, most).map(([, one]) => one);
  }
  const element = isect_element;
  const field = element("input"), list = element("ul", { class: "found" }), told = element("p", { class: "told", role: "status" });
  field.type = "search", field.autocomplete = "off", field.spellcheck = false, field.placeholder = "a lesson or a term";
  list.hidden = true;
  const form = element("form", { class: "find", role: "search" }, element("label", {}, "Find ", field), told, list);
  start.append(form);
  function show() {
    const some = found(field.value), empty = field.value.trim() === "";
    list.replaceChildren(...some.map(one => {
      const link = element("a", { href: one.href }, element("b", { class: "head" }, one.name), ` ${one.told}`);
      return element("li", {}, element("small", {}, one.kind), link);
    }));
    list.hidden = some.length === 0;
    told.textContent = empty ? "" : some.length === 0 ? "Nothing has this name." : some.length === most ? `The first ${most}.` : `${some.length} found.`;
  }
  function close() { field.value = "", show(); }
  field.addEventListener("input", show);
  form.addEventListener("submit", event => {
    event.preventDefault();
    list.querySelector("a")?.click();
  });
  form.addEventListener("keydown", event => {
    const links = [...list.querySelectorAll("a")], at = links.indexOf(document.activeElement);
    if (event.key === "Escape") return close(), field.focus();
    const way = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!way || links.length === 0) return;
    event.preventDefault();
    if (at + way < 0) field.focus(); else links[Math.min(links.length - 1, at + way)].focus();
  });
  addEventListener("pointerdown", event => { if (!form.contains(event.target)) list.hidden = true; });
  field.addEventListener("focus", show);
  addEventListener("keydown", event => {
    if (event.key !== "/" || event.ctrlKey || event.altKey || event.metaKey || event.target.matches("input, textarea, select")) return;
    event.preventDefault(), field.focus();
  });
})();
