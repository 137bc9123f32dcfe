"use strict";
// The page of a review: it asks eight of its questions, drawn for this reader, and tells what came of them. Without scripts
// all stand one below the other, and their answers at the end.
(() => {
  const review = document.querySelector(".review");
  if (!review) return;
  if (!document.documentElement.classList.contains("scripted")) return isect_show_all();
  const number = Number(review.dataset.review), asks = [...review.querySelectorAll("noscript")], make = isect_waiting();
  const made = isect_made;
  const bar = made("div", "", "transport"), place = made("p", "", "place"), next = isect_button("Skip", go_on, "next");
  bar.setAttribute("role", "group"), bar.setAttribute("aria-label", "Review"), place.setAttribute("aria-live", "polite");
  bar.append(place, next), review.after(bar);

  const record = isect_answers.read();
  if (isect_answers.told) review.before(made("p", isect_answers.told, "damage")), isect_answers.told = "";
  const drawn = isect_draw_review(asks.map(ask => [...ask.dataset.asked.split(" "), ask.dataset.preset]), record, record.answers)
    .map(index => asks[index]);
  const results = [];  // whether each was right; null: skipped
  let result = null;   // of the one on show
  const { prepare, key } = isect_questions(right => {
    result = right, next.textContent = "Next";
    tell(right ? "Right." : "Not quite.");
  });
  const shown = () => drawn[results.length];
  const right = () => results.filter(Boolean).length;
  function tell(words) { place.textContent = `${words} Question ${results.length + 1} of ${drawn.length}.`.trim(); }
  function show() {
    if (shown().matches("noscript")) drawn[results.length] = make(shown())[0], prepare(shown());
    drawn.forEach(ask => ask.classList.toggle("shown", ask === shown()));
    result = null, next.textContent = "Skip";
    tell(results.length > 0 ? `${right()} of ${results.length} right so far.` : "");
    scrollTo({ top: 0, behavior: "instant" });
  }
  function go_on() {
    results.push(result);
    if (shown()) show(); else end();
  }
  function end() {
    drawn.forEach(ask => ask.classList.remove("shown"));
    bar.remove();
    isect_answers.change(kept => kept.reviews[number] = { right: right(), of: drawn.length });
    isect_tell("review", { review: number, right: right(), of: drawn.length });
    const card = made("section", "", "result"), list = document.createElement("ul");
    card.append(made("h2", `${right()} of ${drawn.length} right`));
    drawn.forEach((ask, i) => {
      if (results[i]) return;
      const item = document.createElement("li"), link = made("a", ask.querySelector("h2 a").textContent);
      link.href = ask.dataset.step;
      item.append(ask.querySelector(".words p").cloneNode(true), link, results[i] === null ? ": skipped" : ": not right");
      list.append(item);
    });
    const words = list.children.length > 0 ? "What was wrong returns first in the next review of these lessons."
      : "The next review of these lessons asks what was asked longest ago.";
    const again = isect_button("Eight more", () => location.reload(), "next"), actions = made("div", again, "transport");
    card.append(made("p", words), list, actions), review.after(card);
    card.tabIndex = -1, card.focus();
  }
  addEventListener("keydown", event => {
    const ask = shown(), on = event.target;
    if (!ask || event.ctrlKey || event.altKey || event.metaKey || on.matches("input, textarea, select")) return;
    const done = key(ask, event.key);
    const goes_on = event.key === "ArrowRight" ||
      (event.key === "Enter" && ask.classList.contains("told") && !on.matches("a, button, summary"));
    if (done === "typed" || (done === "" && !goes_on)) return;
    if (done === "") go_on();
    event.preventDefault();
  });
  if (drawn.length > 0) show(); else bar.remove();
})();
