"use strict";
// A report of `isect check`: five views of its pictures, keys to step through them, and ticks, from which come a command
// and the file that `isect check --accept` takes.

/// Returns the file for the lists of what was ticked.
function isect_accept_text(lists) {
  return JSON.stringify({ accept: lists.flat() }, null, 1) + "\n";
}

/// Returns "12 of 60 ticked", and what the ticks leave open: traces that go on failing.
function isect_ticked_text(ticked, all, traces) {
  const rest = traces === 0 ? "" : traces === 1 ? "; the trace of 1 of these presets is not" : `; the traces of ${traces} of these presets are not`;
  return `${ticked} of ${all} ticked${rest}`;
}

const isect_report_keys = {
  "Changes": [["n, →", "the next"], ["p, ←", "the one before"], ["Home, End", "the first, the last"]],
  "Ticks": [["Space", "tick this one, or not"], ["g", "tick all of its cause, or none"]],
  "Views": [["b", "blink, and back"], ["s", "slider, and back"], ["d", "difference, and back"], ["1 … 6", "a view of the list"]],
  "Help": [["?", "this sheet"]]
};

(() => {
  const main = document.querySelector("main"), root = document.documentElement;
  const changes = [...main.querySelectorAll("article")];
  const make = isect_element;
  if (changes.length === 0) return;

  // ---- ticks

  const ticks = new Map();  // change -> its box, for those that may be accepted
  const groups = [];        // a section's box, and its changes
  const listed = change => JSON.parse(change.dataset.accept);
  /// A box and its label; `act` is called once it was turned.
  function box(words, act = () => {}) {
    const input = make("input", { type: "checkbox" });
    input.addEventListener("change", () => { act(input.checked); tell(); });
    return [input, make("label", { class: "tick" }, input, " " + words)];
  }
  for (const section of main.querySelectorAll("section")) {
    const own = [...section.querySelectorAll("article[data-accept]")];
    for (const change of own) {
      const [input, label] = box("Accept");
      input.setAttribute("aria-describedby", change.querySelector("h3").id = change.id + "-name");
      ticks.set(change, input);
      change.querySelector("h3").after(label);
    }
    if (own.length === 0) continue;
    const [input, label] = box(`Accept all ${own.length} of this cause`, on => own.forEach(change => ticks.get(change).checked = on));
    groups.push({ input, own });
    section.querySelector("h2").after(label);
  }
  /// Where the ticks are kept until the page is opened again: a name of what is listed.
  const place = "isect check " + [...ticks.keys()].map(change => change.dataset.accept).join()
    .split("").reduce((sum, letter) => (Math.imul(sum, 31) + letter.charCodeAt(0)) >>> 0, 7).toString(16);
  const ticked = () => [...ticks].filter(([, input]) => input.checked).map(([change]) => change);

  // ---- the bar: views, ways, and what the ticks give

  const views = { side: "Side by side", old: "Accepted", new: "New", blink: "Blink", slider: "Slider", difference: "Difference" };
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let beat = 0;
  const flip = () => root.classList.toggle("flipped");
  function show(view) {
    clearInterval(beat);
    root.classList.remove("flipped");
    root.dataset.view = view;
    for (const [name, button] of Object.entries(buttons)) button.setAttribute("aria-pressed", String(name === view));
    if (view === "blink" && !calm.matches) beat = setInterval(flip, 700);
  }
  const buttons = {};
  for (const [name, words] of Object.entries(views)) buttons[name] = isect_button(words, () => show(name));
  const count = make("output", { class: "count" });
  const command = make("code", {}, main.dataset.command + " accept.json");
  const save = isect_button("Save accept.json", () =>
    isect_save(new Blob([isect_accept_text(ticked().map(listed))], { type: "application/json" }), "accept.json"));
  const copy = isect_button("Copy the command", async () => {
    try {
      await navigator.clipboard.writeText(command.textContent);
      copy.textContent = "Copied";
    } catch {  // a page from disk may have no clipboard
      getSelection().selectAllChildren(command);
      copy.textContent = "Press Ctrl+C";
    }
    setTimeout(() => copy.textContent = "Copy the command", 3000);
  });
  const bar = make("div", { class: "bar", role: "region", "aria-label": "Views and ticks" },
    make("div", { class: "ways" },
      make("div", { role: "group", "aria-label": "Changes", class: "choice" },
        isect_button("Before", () => go(at - 1)), isect_button("Next", () => go(at + 1)), isect_key_button(sheet)),
      make("div", { role: "group", "aria-label": "View", class: "choice" }, ...Object.values(buttons))),
    make("div", { class: "choice" }, count, save, copy, command));
  function tell() {
    for (const { input, own } of groups) {
      const some = own.filter(change => ticks.get(change).checked).length;
      input.checked = some === own.length, input.indeterminate = some > 0 && some < own.length;
    }
    const now = ticked(), presets = new Set(now.map(change => change.dataset.preset));
    const left = [...ticks].filter(([change, input]) => !input.checked && presets.has(change.dataset.preset)
      && listed(change).some(entry => entry.file.endsWith("/trace.json")));
    count.textContent = isect_ticked_text(now.length, ticks.size, left.length);
    save.disabled = copy.disabled = now.length === 0;
    for (const [change, input] of ticks) change.classList.toggle("ticked", input.checked);
    try { localStorage.setItem(place, JSON.stringify(now.map(change => change.id))); } catch { /* a page from disk may keep nothing */ }
  }
  function sheet() { isect_show_sheet(isect_report_keys); }

  // ---- ways

  let at = -1;
  main.addEventListener("focusin", event => {
    const here = changes.indexOf(event.target.closest("article"));
    if (here >= 0) at = here;
  });
  function go(to) {
    at = Math.max(0, Math.min(changes.length - 1, to));
    changes[at].focus({ preventScroll: true });
    changes[at].scrollIntoView({ block: "start" });
  }
  function turn(input) {
    if (!input) return;
    input.checked = !input.checked;
    input.dispatchEvent(new Event("change"));
  }
  const turn_view = view => {
    if (view === "blink" && root.dataset.view === view && calm.matches) return flip();
    show(root.dataset.view === view ? "side" : view);
  };
  const keys = {
    n: () => go(at + 1), ArrowRight: () => go(at + 1), p: () => go(at - 1), ArrowLeft: () => go(at - 1),
    Home: () => go(0), End: () => go(changes.length - 1),
    " ": () => turn(ticks.get(changes[at] ?? (go(0), changes[0]))),
    g: () => turn(groups.find(group => group.own.includes(changes[at]))?.input),
    b: () => turn_view("blink"), s: () => turn_view("slider"), d: () => turn_view("difference"), "?": sheet
  };
  Object.keys(views).forEach((view, i) => keys[i + 1] = () => show(view));
  addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key] || document.querySelector("dialog[open]")) return;
    const on = event.target;
    if (event.key === " " && on.closest?.("button, input, summary, a")) return;
    if (event.key.length > 1 && on.matches?.("input[type=range]")) return;
    event.preventDefault();
    keys[event.key]();
  });

  // ---- pictures one over the other

  for (const pair of main.querySelectorAll(".views")) {
    if (!pair.querySelector(".old img") || !pair.querySelector(".new img")) continue;
    pair.classList.add("pair");
    const cut = make("input", { type: "range", min: 0, max: 100, value: 50, class: "cut", "aria-label": "Accepted to the left, new to the right of here" });
    cut.addEventListener("input", () => pair.style.setProperty("--cut", cut.value + "%"));
    pair.before(cut);
  }

  /// Keeps a change that is gone to below the bar.
  function below_bar() {
    root.style.setProperty("--bar", (getComputedStyle(bar).position === "sticky" ? bar.offsetHeight + 8 : 8) + "px");
  }
  main.before(bar);
  show("side");
  below_bar();
  addEventListener("resize", below_bar);
  try {
    for (const id of JSON.parse(localStorage.getItem(place) ?? "[]")) {
      const input = ticks.get(document.getElementById(id));
      if (input) input.checked = true;
    }
  } catch { /* nothing was kept */ }
  tell();
})();
