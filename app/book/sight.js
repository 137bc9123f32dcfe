"use strict";
// What comes into sight: the picture, the line that runs, what is asked and what is said to an answer. Scrolls this page, or a
// box of its own, by no more than it must.
// `bar`: what covers the lower edge; `shown`: the article on show; `read`: the one where a reader of the whole page is.
function isect_sight({ bar, shown, read }) {
  const root = document.documentElement;
  function scroll_by(way) { scrollBy({ top: way, behavior: "instant" }); }  // this page, and none around it
  const top_of = element => element.getBoundingClientRect().top;
  /// Scrolls where the picture is not whole on the screen; to its setting's name, if both have room.
  function show_picture() {
    if (root.classList.contains("reading")) return scroll_by(top_of(read().querySelector("h3")) - 8);
    const article = shown(), box = article.querySelector(".picture, .words").getBoundingClientRect();
    const bottom = top_of(bar), head = top_of(article.closest(".walk"));
    if (box.top < 0 || box.bottom > bottom) scroll_by(box.bottom - head <= bottom ? head : box.top - 8);
    show_line();
    const numbers = article.querySelector(".numbers"), fresh = article.querySelectorAll(".numbers .fresh");
    if (fresh.length) bring(numbers, fresh[0], fresh[fresh.length - 1]);
    if (isect_is_open(article)) show_answers(article);
  }
  /// Scrolls until all from one to another part of a question is above the bar, or as much as there is room for.
  function show_between(ask, from, to) {
    const words = ask.querySelector(".words");
    bring(words, from, to);
    const first = from.getBoundingClientRect().top, end = Math.min(to.getBoundingClientRect().bottom, words.getBoundingClientRect().bottom);
    const hidden = end - top_of(bar);
    if (hidden > 0) scroll_by(Math.min(hidden + 6, first - 6));
  }
  /// The picture stays whole where both have room; else the choices, with what is asked.
  function show_answers(ask) {
    const list = ask.classList.contains("typing") ? ask.querySelector(".typed") : ask.querySelector(".choices");
    if (!list) return;
    const first = list.querySelector("li") ?? list;
    bring(ask.querySelector(".words"), first, first), show_between(ask, ask.querySelector("h3"), list);
  }
  /// What is said to an answer, and why it is so.
  function show_reply(ask) {
    const told = ask.querySelector("details"), other = ask.querySelector("button.other");
    show_between(ask, ask.querySelector(".reply") ?? told, other ?? told);
  }
  /// Of what was unfolded below the picture comes up what there is room for; more than half of the picture stays.
  function show_unfolded(part) {
    const hidden = part.getBoundingClientRect().bottom - top_of(bar);
    if (part.open && hidden > 0) scroll_by(Math.min(hidden + 6, 0.35 * innerHeight));
  }
  /// The code stands in a box of its own where it is beside the picture: its lit line is in sight.
  function show_line() {
    const line = shown().closest(".walk").querySelector("ol.code .current"), code = line && line.closest(".steps > *");
    if (!code || code.scrollHeight <= code.clientHeight) return;
    const here = line.getBoundingClientRect(), room = code.getBoundingClientRect();
    code.scrollTop += here.top - room.top - Math.max(0, room.height - here.height) / 2;
  }
  /// Scrolls a box of its own until all from one to another of its parts is in sight, or as much as there is room for.
  function bring(box, from, to) {
    if (box.scrollHeight <= box.clientHeight + 1 || getComputedStyle(box).overflowY !== "auto") return;
    const room = box.getBoundingClientRect(), first = from.getBoundingClientRect().top, end = to.getBoundingClientRect().bottom;
    box.scrollTop += Math.max(0, Math.min(end - room.bottom + 8, first - room.top - 4));
  }
  /// What stands above the walks takes its part of the screen: desk.css asks for it.
  function measure() {
    const walk_top = top_of(document.getElementById("walks")), box = document.querySelector(".about")?.getBoundingClientRect();
    const unfolded = box && box.top < walk_top ? box.height : 0;
    root.style.setProperty("--head", `${Math.min(224, Math.ceil(walk_top + scrollY - unfolded))}px`);
  }
  return { measure, show_line, show_picture, show_answers, show_reply, show_unfolded };
}
