"use strict";
// Terms of the course in the texts of a page: pointed at, tapped or reached by Tab, each tells what it means. Of a walk a
// term is marked where it stands first. `isect_terms`, which the book adds: the glossary's name of each, its meaning as
// HTML, title and file of the lesson that explains it.

const isect_told_terms = { setting: null, first: new Map(), pattern: null, named: null };

/// Marks the terms in a step, or in any part of a page that `texts` selects.
function isect_mark_terms(part, at = -1, setting = "", texts = ":is(.words, .above) p:not(.formula, .source, .line, .verdict)") {
  const told = isect_told_terms;
  if (!window.isect_terms || !part || part.classList.contains("ask")) return;
  told.named ??= new Map(isect_terms.map(term => [term[0].toLowerCase(), term]));
  told.pattern ??= new RegExp(`\\b(${[...told.named.keys()].sort((a, b) => b.length - a.length).join("|")})(?:e?s)?\\b(?!-)`, "gi");
  if (at >= 0 && told.setting !== setting) told.setting = setting, told.first.clear();
  const marked = new Set([...part.querySelectorAll(".term")].map(mark => mark.dataset.term));
  /// Whether the reader needs it here: not where it was told already.
  function wanted(term) {
    if (marked.has(term)) return false;
    if (at >= 0) told.first.set(term, Math.min(at, told.first.get(term) ?? at));
    return at < 0 || told.first.get(term) === at;
  }
  for (const text of part.querySelectorAll(texts)) {
    const walker = document.createTreeWalker(text, NodeFilter.SHOW_TEXT), nodes = [];
    while (walker.nextNode())
      if (!walker.currentNode.parentElement.closest("a, button, summary, code, .term, .term-told, [data-name]")) nodes.push(walker.currentNode);
    for (let rest of nodes) {
      told.pattern.lastIndex = 0;
      for (let found; (found = told.pattern.exec(rest.data));) {
        const term = found[1].toLowerCase();
        if (!wanted(term)) continue;
        const word = rest.splitText(found.index);
        rest = word.splitText(found[0].length), told.pattern.lastIndex = 0;
        marked.add(term), word.replaceWith(isect_term_mark(word.data, told.named.get(term)));
      }
    }
  }
}

/// Returns a word that tells its meaning.
function isect_term_mark(word, term) {
  const mark = document.createElement("span");
  mark.className = "term", mark.tabIndex = 0, mark.textContent = word, mark.dataset.term = term[0].toLowerCase();
  mark.setAttribute("role", "button");
  mark.addEventListener("pointerenter", event => event.pointerType === "mouse" && isect_tell_term(mark, term));
  mark.addEventListener("pointerleave", event => event.pointerType === "mouse" && isect_hide_term(event.relatedTarget));
  mark.addEventListener("focus", () => isect_tell_term(mark, term));
  mark.addEventListener("blur", event => isect_hide_term(event.relatedTarget));
  mark.addEventListener("click", () => isect_tell_term(mark, term));
  mark.addEventListener("keydown", event => {
    if (event.key === "Escape") isect_hide_term();
    else if (event.key === "Enter" || event.key === " ") isect_tell_term(mark, term);
    else return;
    event.preventDefault(), event.stopPropagation();
  });
  return mark;
}
/// Stands right behind its word, so that Tab leads to its link; below it on the screen, or above where that has no room.
function isect_tell_term(mark, [name, meaning, title, file]) {
  if (mark.nextElementSibling?.className === "term-told") return;
  isect_hide_term();
  const told = document.createElement("span"), link = document.createElement("a");
  told.className = "term-told", told.id = "term-told", told.innerHTML = `<b class="head"></b>: ${meaning} `;
  told.firstChild.textContent = name;
  if (file) link.href = file, link.textContent = title, told.append(link);
  told.addEventListener("pointerleave", event => isect_hide_term(event.relatedTarget));
  told.addEventListener("focusout", event => isect_hide_term(event.relatedTarget));
  mark.setAttribute("aria-describedby", told.id), mark.after(told), isect_place_term(told);
}
function isect_place_term(told) {
  const word = told.previousElementSibling.getBoundingClientRect(), box = told.getBoundingClientRect();
  told.style.left = `${Math.max(8, Math.min(word.left, innerWidth - box.width - 8))}px`;
  told.style.top = `${word.bottom + box.height + 4 < innerHeight ? word.bottom : Math.max(4, word.top - box.height)}px`;
}
/// Unless the pointer or the focus has gone to `to` and that still is the word, or what is told of it.
function isect_hide_term(to = null) {
  const told = document.querySelector(".term-told");
  if (!told || (to instanceof Node && (told.contains(to) || told.previousElementSibling === to))) return;
  told.previousElementSibling.removeAttribute("aria-describedby");
  told.className = "", told.remove();  // its link may lose the focus, and ask for the same once more
}

addEventListener("scroll", () => {  // what is reached by Tab may scroll into sight
  const told = document.querySelector(".term-told");
  if (told) isect_place_term(told);
}, { capture: true, passive: true });
addEventListener("pointerdown", event => isect_hide_term(event.target));
document.addEventListener("isect:step", ({ detail: { setting, at } }) => {
  if (!document.documentElement.classList.contains("lively"))  // live.js marks its own
    isect_mark_terms(document.querySelector(".walk.shown > .steps > .shown"), at, setting);
});
addEventListener("DOMContentLoaded", () => {
  const walk = document.querySelector(".walk.shown"), article = walk?.querySelector(":scope > .steps > .shown");
  if (!article) return;
  [".opening", ".closing"].forEach(part => isect_mark_terms(document.querySelector(part), -1, "", ":is(p, dd)"));
  if (!walk.classList.contains("live")) isect_mark_terms(article, [...article.parentElement.querySelectorAll(":scope > article")].indexOf(article), walk.id);
});
