"use strict";
// The picture at the top of the first page, once the compiled lessons have come: it can be dragged, and its verdict follows.
// They are asked for when the page has nothing else to do, or when somebody reaches for the picture. Until then, and where
// they can't run, the picture stays as it was drawn.
(() => {
  const hero = document.querySelector(".hero[data-code]");
  if (!hero || !window.WebAssembly) return;
  const figure = hero.querySelector("figure"), outcome = hero.querySelector(".outcome"), hint = hero.querySelector(".hint");
  const over = isect_element("svg", { class: "over" });
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let request = null, frame = null, pushed = 0;

  async function begin() {
    request = await isect_code.ready(hero.dataset.code);
    request({ do: "look", dark: dark.matches });
    if (!open()) throw new Error("the picture does not open");
    hint.querySelector("span").textContent = "Drag what has a ring: the verdict follows.";
    figure.append(over), figure.removeAttribute("tabindex");
    outcome.setAttribute("role", "status");
    dark.addEventListener("change", () => show(request({ do: "look", dark: dark.matches })));
    addEventListener("resize", show_grips);
    show_grips();
  }
  function open() {
    const { shows, preset, step } = hero.dataset;
    return show(request({ do: "open", lesson: shows, preset, changes: [], step: Number(step) }));
  }
  /// Shows what the session has answered, at the step that tells the verdict: the last, but for a map of cases.
  function show(answer) {
    if (answer.wrong || answer.picture === undefined) return false;
    const end = answer.count - 1 - Number(answer["has map"]);
    if (answer.at !== end) {
      const there = request({ do: "go", at: end });
      if (there.picture !== undefined) answer = there;
    }
    frame = answer;
    figure.querySelector(".picture").outerHTML = frame.picture;
    if (outcome.told !== frame.outcome) outcome.innerHTML = outcome.told = frame.outcome;
    over.setAttribute("viewBox", `0 0 ${frame.width} ${frame.height}`);
    show_grips();
    return true;
  }
  function show_grips() {
    if (!frame || !figure.clientWidth) return;
    const unit = Math.max(frame.width / figure.clientWidth, frame.height / figure.clientHeight);  // a px
    isect_show_grips(over, frame.handles, 22 * unit, 7 * unit);
  }

  over.addEventListener("pointerdown", event => {
    const grip = event.target.closest(".grip");
    if (!grip || event.button !== 0) return;
    event.preventDefault();
    request({ do: "take", handle: grip.dataset.handle, ...isect_place_in(over, event) });
    isect_follow(figure, event, moved => show(request({ do: "drag", ...isect_place_in(over, moved) })), rest);
  });
  // A finger on a ring drags it, and beside the rings scrolls the page.
  over.addEventListener("touchstart", event => event.target.closest(".grip") && event.preventDefault(), { passive: false });
  over.addEventListener("keydown", event => {
    const way = isect_ways[event.key], grip = event.target.closest(".grip");
    if (!way || !grip || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    show(request({ do: "push", handle: grip.dataset.handle, x: way[0], y: way[1] }));
    clearTimeout(pushed), pushed = setTimeout(rest, 400);
  });
  /// What was moved is drawn as it is to stay, and can be taken back.
  function rest() {
    show(request({ do: "drop" }));
    if (hint.querySelector("button")) return;
    const back = isect_button("As it was", () => (open(), back.remove()));
    hint.append(" ", back);
  }

  let begun = false;
  function once() {
    if (!begun) begun = true, begin().then(() => hero.dataset.state = "ready", () => hero.dataset.state = "none");
  }
  ["pointerenter", "focusin", "touchstart"].forEach(name => hero.addEventListener(name, once, { passive: true }));
  if (navigator.connection?.saveData) return;
  const idle = () => window.requestIdleCallback ? requestIdleCallback(once) : setTimeout(once, 1000);
  if (document.readyState === "complete") idle(); else addEventListener("load", idle);
})();
