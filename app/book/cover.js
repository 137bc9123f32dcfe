"use strict";
// The first page: what its reader has done so far, where to go on, and the file of it. All that is added stands there before
// the page is painted first, so nothing jumps.
(() => {
  const start = document.querySelector(".cover .go");
  if (!start) return;
  const made = isect_made;
  const cards = [...document.querySelectorAll(".lessons li[data-of]")];
  const title_of = card => isect_title_of(card).split(":")[0];
  const exercises = cards.map(card => [card.dataset.of, Number(card.dataset.exercises)]);
  const begin = start.querySelector(".begin"), first = { text: begin.textContent, href: begin.getAttribute("href") };
  const share = (part, whole) => `${part} of ${whole}`;

  /// What has been done in a lesson, in words.
  function words_of(p) {
    const words = [];
    if (p.finished) words.push("✓ read to its end");
    else if (p.of > 0) words.push(`step ${share(p.seen, p.of)}`);
    if (p.answered > 0) words.push(`${share(p.right, p.answered)} right`);
    if (p.skipped > 0) words.push(`${p.skipped} skipped`);
    if (p.solved > 0) words.push(`${share(p.solved, p.exercises)} exercises`);
    return words;
  }
  function show_cards(way, record) {
    cards.forEach((card, i) => {
      const facts = card.querySelector(".facts"), done = words_of(isect_progress_of(...exercises[i], way, record));
      card.classList.toggle("finished", Boolean(way.lessons[card.dataset.of]?.finished));
      facts.querySelector(".done")?.remove();
      if (done.length) facts.append(made("span", " · " + done.join(" · "), "done"));
    });
    document.querySelectorAll(".review-link").forEach(link => {
      const result = record.reviews[link.dataset.review];
      link.querySelector(".facts").textContent = result ? `${share(result.right, result.of)} right` : "";
    });
  }
  /// The lesson where its reader was last, if it has more to tell; else the next that has not been read to its end.
  function show_begin(way) {
    const at = way.last ? cards.findIndex(card => card.dataset.of === way.last.lesson) : -1;
    const from = Math.max(0, at), unread = card => !way.lessons[card.dataset.of]?.finished;
    const next = Object.keys(way.lessons).length ? [...cards.slice(from), ...cards.slice(0, from)].find(unread) : null;
    begin.textContent = next ? `Go on with “${title_of(next)}”` : first.text;
    const place = next && next === cards[at] && way.last.place ? "#" + way.last.place : "";
    begin.setAttribute("href", next ? next.querySelector("a").getAttribute("href") + place : first.href);
  }

  const sum = made("p", ""), told = made("p", "", "told"), chosen = made("input", "");
  told.setAttribute("role", "status");
  function show() {
    const way = isect_way.read(), record = isect_answers.read();
    const all = exercises.map(lesson => isect_progress_of(...lesson, way, record)), of = name => all.reduce((total, p) => total + p[name], 0);
    show_cards(way, record), show_begin(way);
    sum.textContent = [`${share(all.filter(p => p.finished).length, all.length)} lessons read to the end`,
      `${share(of("right"), of("answered"))} answers right`, `${share(of("solved"), of("exercises"))} exercises solved`].join(" · ");
    const damage = [isect_way, isect_answers].map(kept => kept.told).filter(Boolean);
    isect_way.told = isect_answers.told = "";
    if (damage.length) told.textContent = damage.join(" "), told.classList.add("damage");
  }
  function save() {
    isect_save(new Blob([isect_progress_text(exercises)], { type: "application/json" }), "progress.json");
  }
  function read(text) {
    try { isect_add_progress(text); } catch (wrong) {
      told.classList.add("damage");
      return void (told.textContent = `This file is not read: ${wrong.message}. All is as it was.`);
    }
    told.classList.remove("damage"), told.textContent = "The file is read: what it tells is added to what was kept here.";
    show();
  }
  chosen.type = "file", chosen.accept = ".json,application/json", chosen.hidden = true, chosen.setAttribute("aria-label", "A file of progress");
  chosen.addEventListener("change", async () => {
    if (chosen.files.length) read(await chosen.files[0].text());
    chosen.value = "";
  });
  const tools = made("div", "", "tools"), kept = made("section", made("h2", "Your progress"), "kept");
  tools.append(isect_button("Save as JSON", save), isect_button("Open a saved one", () => chosen.click()), chosen);
  kept.append(sum, made("p", "It stays in this browser. Where a course shows these pages inside a page of its own, that page is told, too."), tools, told);
  document.querySelector("main").append(kept);
  show();
  if (told.textContent) start.append(told);
  // Back from a lesson, a browser may show the page as it was left.
  addEventListener("pageshow", event => event.persisted && show());
})();
