"use strict";
// Time within a step whose shapes move: it is scrubbed under the picture, and runs. How it runs, and what is drawn, the
// session says. `ask`: sends a request, and shows the answer; `begins`: called when time begins to run; `rests`: when it stands
// where it was led to, or has stopped.
function isect_time(element, ask, begins, rests) {
  const calm = matchMedia("(prefers-reduced-motion: reduce)");  // then it goes from still to still
  const icons = { run: "M4 2l10 6-10 6z", stop: "M4 2h3v12H4zM9 2h3v12H9z" };
  const button = element("button", { type: "button" }), told = element("span", { class: "time-told" });
  const slide = element("input", { type: "range", min: 0, max: 1, step: "any", "aria-label": "Time" });
  const contact = element("span", { class: "contact", hidden: "" });
  const bar = element("div", { class: "time", role: "group", "aria-label": "Time", hidden: "" },
    button, element("span", { class: "track" }, slide, contact), told);
  let now = null, running = 0, before = 0;

  function name() {
    const text = running ? "Stop time" : calm.matches ? "The next moment" : "Let time run";
    if (button.title === text) return;
    button.title = text, button.setAttribute("aria-label", text);
    button.innerHTML = `<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="${icons[running ? "stop" : "run"]}"/></svg>`;
  }
  function halt() {
    if (running) cancelAnimationFrame(running);
    running = 0, name();
  }
  function stop() {
    const ran = running;
    halt();
    if (ran) rests();
  }
  function run(at) {
    running = requestAnimationFrame(run);
    const shown = ask({ do: "time", seconds: Math.min(0.1, Math.max(0, (at - before) / 1000)) });
    before = at;
    if (running && (!shown || !now || now.now >= 1)) stop();
  }
  button.addEventListener("click", () => {
    if (running) return stop();
    begins();
    if (calm.matches) return void (ask({ do: "time", still: true }), rests());
    ask({ do: "time", share: now.now < 1 ? now.now : 0 });
    before = performance.now(), running = requestAnimationFrame(run), name();
  });
  slide.addEventListener("input", () => (stop(), ask({ do: "time", share: Number(slide.value) })));
  slide.addEventListener("change", rests);
  calm.addEventListener("change", () => (stop(), name()));

  /// The room for it stays in all steps of a walk in which something moves.
  function show(frame) {
    document.documentElement.classList.toggle("moves", frame.moves);
    now = frame.time, bar.hidden = !frame.moves, bar.classList.toggle("idle", !now);
    if (running && !(now && now.chosen)) halt();  // another step is on show
    if (!now) return;
    slide.value = now.now, slide.setAttribute("aria-valuetext", now.words.replace(/<[^>]*>/g, ""));
    contact.hidden = now.contact === null, contact.style.setProperty("--at", now.contact ?? 0);
    if (told.innerHTML !== now.words) told.innerHTML = now.words;
    name();
  }
  return { bar, show };
}
