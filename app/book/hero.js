"use strict";
// The picture at the top of the first page, once the compiled lessons have come: it can be dragged, and its verdict follows.
// They are asked for when the page has nothing else to do, or when somebody reaches for the picture. Until then, and where
// they can't run, the picture stays as it was drawn.
(() => {
  const hero = document.querySelector(".hero[data-code]");
  if (!hero || !window.WebAssembly) return;
  const figure = hero.querySelector("figure"), outcome = hero.querySelector(".outcome"), hint = hero.querySelector(".hint");
  const svg = (name, attributes = {}, ...children) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  };
  const over = svg("svg", { class: "over" });
  const dark = matchMedia("(prefers-color-scheme: dark)"), held = { timer: 0 };
  let request = null, frame = null;

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
  /// Rings stay the elements they were: what is moved in a page loses the focus.
  function show_grips() {
    if (!frame || !figure.clientWidth) return;
    const unit = Math.max(frame.width / figure.clientWidth, frame.height / figure.clientHeight);  // a px
    const known = new Map([...over.children].map(grip => [grip.dataset.handle, grip]));
    frame.handles.forEach(handle => {
      const grip = known.get(handle.name) ?? over.appendChild(svg("g", { class: "grip", tabindex: "0", role: "button",
        "aria-roledescription": "handle", "data-handle": handle.name }, svg("circle", { class: "reach" }), svg("circle", { class: "ring" })));
      known.delete(handle.name);
      grip.setAttribute("transform", `translate(${handle.x} ${handle.y})`), grip.setAttribute("aria-label", handle.label);
      grip.dataset.role = handle.role;
      grip.firstChild.setAttribute("r", 22 * unit), grip.lastChild.setAttribute("r", 7 * unit);
    });
    known.forEach(grip => grip.remove());
  }

  const place_of = event => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(over.getScreenCTM().inverse());
    return { x: at.x, y: at.y };
  };
  over.addEventListener("pointerdown", event => {
    const grip = event.target.closest(".grip");
    if (!grip || event.button !== 0) return;
    event.preventDefault();
    request({ do: "take", handle: grip.dataset.handle, ...place_of(event) });
    let last = null, asked = 0;
    const run = () => { asked = 0, last && show(request({ do: "drag", ...place_of(last) })), last = null; };
    const move = moved => { last = moved, asked ||= requestAnimationFrame(run); };
    const stop = () => {
      if (asked) cancelAnimationFrame(asked), run();
      figure.removeEventListener("pointermove", move);
      ["pointerup", "pointercancel"].forEach(name => figure.removeEventListener(name, stop));
      rest();
    };
    figure.setPointerCapture(event.pointerId);
    figure.addEventListener("pointermove", move);
    ["pointerup", "pointercancel"].forEach(name => figure.addEventListener(name, stop));
  });
  // A finger on a ring drags it, and beside the rings scrolls the page.
  over.addEventListener("touchstart", event => event.target.closest(".grip") && event.preventDefault(), { passive: false });
  over.addEventListener("keydown", event => {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const grip = event.target.closest(".grip");
    if (!way || !grip || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    show(request({ do: "push", handle: grip.dataset.handle, x: way[0], y: way[1] }));
    clearTimeout(held.timer), held.timer = setTimeout(rest, 400);
  });
  /// What was moved is drawn as it is to stay, and can be taken back.
  function rest() {
    show(request({ do: "drop" }));
    if (hint.querySelector("button")) return;
    const back = document.createElement("button");
    back.type = "button", back.textContent = "As it was";
    back.addEventListener("click", () => (open(), back.remove()));
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
