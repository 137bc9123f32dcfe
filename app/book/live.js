"use strict";
// What a page does once the lessons' own code runs beside it: each walk can be changed, and what is shown is computed anew.
// `book`: what book.js has to offer. All state but what is on the screen is the session's, behind book.request.
function isect_live(book) {
  const root = document.documentElement;
  const element = isect_element, pressed = isect_button;
  const scene_drag = 4;  // px before a press on the scene turns it
  const html = (made, text) => { if (made.told !== text) made.innerHTML = made.told = text; };

  // The parts of the section, in reading order.
  const heading = element("h2"), given = element("div", { class: "given-holder" });
  const algorithm = element("div", { class: "algorithm-holder" }), opinions = element("div", { class: "opinions-holder" });
  const above = element("div", { class: "above" }), below = element("div", { class: "below" });
  const lights = element("g", { class: "lights" }), grips = element("g", { role: "group", "aria-label": "Handles" });
  const over = element("svg", { class: "over" }, lights, grips);
  const holder = element("div", { class: "holder" }, over);
  const stage = element("figure", { class: "stage" }, holder);
  const map_over = element("svg", { class: "over", tabindex: "0", role: "application",
    "aria-label": "Map of cases; the arrow keys move the setting" });
  const map_holder = element("div", { class: "holder" }), map_told = element("figcaption");
  const map = element("figure", { class: "map", hidden: "" }, map_holder, map_told);
  const message = element("p", { class: "message", role: "status" });
  const outcome = element("div", { class: "outcome", role: "status" });  // of a setting of the reader's own, at every step
  const task = element("p", { class: "task", role: "status" });          // the exercise that was begun, or is solved
  const wants_map = pressed("Map of cases", () => look({ map: wants_map.getAttribute("aria-pressed") !== "true" }));
  const undo = pressed("Undo", () => act({ do: "undo" })), redo = pressed("Redo", () => act({ do: "redo" }));
  const snap = pressed("Snap", () => snap.setAttribute("aria-pressed", String(!snaps())));
  const snaps = event => snap.getAttribute("aria-pressed") === "true" || Boolean(event && event.shiftKey);
  const frame_all = pressed("Whole scene", () => act({ do: "frame all" }));
  const form = element("form"), saved = element("textarea", { readonly: "", "aria-label": "Text to copy", hidden: "" });
  const values = element("details", { class: "changes" }, element("summary", {}, "Change the values"), form);
  const lesson = document.body.dataset.lesson, is_scene = lesson === "scene";
  const editor = is_scene ? isect_scene_text({ element, pressed, save, request: book.request, open: open_scene }) : null;
  const share = element("details", { class: "share" }, element("summary", {}, "Save or share"));
  const tools = element("div", { class: "tools", role: "group", "aria-label": "Tools" }, wants_map, snap, undo, redo, frame_all,
    isect_key_button());
  const time = isect_time(element, request => act(request, "keep"), () => book.stop(), () => now && keep_address("replace"));
  const pictures = element("div", { class: "pictures" }, stage, map, time.bar,
    element("div", { class: "told-below" }, task, outcome, message));
  const article = element("article", { class: "step shown" }, above, pictures, below);
  const workshop = element("div", { class: "workshop" }, values, share);
  const section = element("section", { class: "walk live shown", id: "live" }, heading, given,
    element("div", { class: "steps" }, algorithm, article), tools, ...(editor ? [editor.element] : []), workshop, opinions);

  let now = null;            // the last frame
  let heard = "";            // the station that was told last
  let said = "";             // of the last change; what is pointed at is told in its place for as long
  let rested = null;         // the setting that was drawn last to stay, and how many steps it has
  let flat = false;          // the scene lies in a plane: it is shifted and not turned
  let example = "";          // the scene of the page that was opened last
  const exercises = isect_exercises(task);
  const live = { count: 0, at: 0, article, go: at => act({ do: "go", at }), load, from_address, begin };

  // Asking the session, and showing what it answers.
  function act(request, address = "replace") {
    const reply = book.request(request);
    if (reply.wrong) return tell(reply.wrong), null;
    if (request.example) example = request.example;
    if (reply.parameters) opened(reply);
    if (reply.picture !== undefined) show(reply, address, request.do === "drop" ? said : "");
    return reply;
  }
  function tell(text) { said = message.textContent = text; }
  function opened(reply) {
    if (is_scene || form.children.length === 0) make_form(reply.parameters);
    frame_all.hidden = flat = reply.flat;
  }
  function load(preset) { act(is_scene ? { ...scene_request(preset), step: "answer" } : { do: "load", preset }, "push"); }
  function look(wanted) { act({ do: "look", ...wanted }, "keep"); }

  /// `kept`: what was said of the change that this ends.
  function show(frame, address, kept = "") {
    const fresh = !now || now.step !== frame.step || now.asks !== frame.asks;
    const place = frame.place;
    if (is_scene) place_scene(frame);
    const changed = place.preset === "";
    now = frame;
    live.at = frame.at, live.count = frame.count;
    section.classList.toggle("changed", changed), section.classList.toggle("over", frame.at === frame.count - 1);
    article.dataset.asked = frame.asked, article.dataset.station = changed ? "" : `${place.preset}/${frame.step + 1}`;
    article.classList.toggle("ask", frame.asks), article.classList.toggle("step", !frame.asks);
    if (fresh) article.classList.remove("told");
    const name = place["preset title"], own = is_scene ? name + ", changed" : `Changed from “${name}”`;
    html(heading, (changed ? own : name) +
      (place.method && place.method !== place["preset title"] ? ` <small>${place.method}</small>` : ""));
    time.show(frame);
    exercises.show(changed ? frame.solved ?? [] : [], place.origin);
    draw(frame);
    html(given, frame.given), html(opinions, frame.opinions), html(above, frame.above);
    if (frame.algorithm !== undefined) html(algorithm, frame.algorithm);
    if (below.told !== frame.below || fresh) {
      html(below, frame.below);
      if (frame.asks) article.classList.remove("told"), book.prepare(article);
    }
    book.light_code(section, frame);
    if (frame.algorithm !== undefined) isect_mark_terms(article, frame.at, place.origin);
    if (frame.solved) exercises.mark(changed ? frame.solved : []);
    show_values(frame.values, frame.idle);
    wants_map.hidden = !frame["has map"];
    snap.hidden = !frame["has handles"] && !frame["has map"];
    snap.classList.toggle("idle", frame.handles.length === 0 && !frame.map);
    undo.setAttribute("aria-disabled", !frame.undo), redo.setAttribute("aria-disabled", !frame.redo);
    html(outcome, changed ? frame.outcome : "");
    tell([frame.told || frame.refuses || kept, other_steps(frame, changed)].filter(Boolean).join(" "));
    book.mark_link(changed ? "" : place.origin);
    book.show_controls(frame.asks ? below.querySelector("h3").textContent
        : `Step ${frame.step + 1} of ${frame.steps}: ${isect_title_of(above)}`);
    if (!changed) book.follow(place.preset, frame.at);
    keep_address(address);
    const station = { setting: changed ? "" : place.preset, at: frame.at, asks: frame.asks }, told = JSON.stringify(station);
    if (heard !== told) heard = told, isect_tell("step", { ...station, asked: frame.asked, end: frame.at === frame.count - 1,
      step: frame.step + Number(!frame.asks), of: frame.steps });
    if (book.playing() && (frame.at === frame.count - 1 || frame.asks)) book.stop();
  }
  /// A change may end the walk earlier or later: the bar's numbers jump, and this says why.
  function other_steps({ algorithm, place, steps }, changed) {
    if (algorithm === undefined) return "";  // still in motion
    const before = rested && rested.origin === place.origin ? rested.steps : steps;
    rested = { origin: place.origin, steps };
    return changed && before !== steps ? `The walk has ${steps} steps now, and had ${before}.` : "";
  }
  /// The picture under the handles, which stay where they are: what is moved in a page loses the focus.
  function put_first(holder, over, picture) {
    if (holder.lastChild !== over) holder.append(over);
    if (holder.firstChild !== over) holder.firstElementChild.outerHTML = picture;
    else over.insertAdjacentHTML("beforebegin", picture);
  }
  /// Of the picture, a px: it is as wide as its holder, if that is not too high.
  function unit_of(frame) {
    const high = parseFloat(getComputedStyle(holder.firstChild).maxHeight);
    return Math.max(frame.width / (holder.clientWidth || frame.width), frame.height / (high || Infinity));
  }
  function draw(frame) {
    const box = `0 0 ${frame.width} ${frame.height}`, unit = unit_of(frame);  // while the page is laid out
    put_first(holder, over, frame.picture);
    over.setAttribute("viewBox", box);
    stage.style.setProperty("--least", frame.width > 330 ? `${Math.round(frame.width)}px` : "0");
    lights.replaceChildren();
    name_picture(frame);
    show_grips(frame.handles, unit);
    const beside = frame.map && !frame.map.own;
    map.hidden = !beside, pictures.classList.toggle("with-map", Boolean(beside));
    stage.classList.toggle("is-map", Boolean(frame.map && frame.map.own));
    if (!beside) return;
    put_first(map_holder, map_over, frame.map.svg);
    map_over.setAttribute("viewBox", `0 0 ${frame.map.width} ${frame.map.height}`);
    html(map_told, frame.map.here);
  }

  /// What the arrow keys do to the picture itself; nothing where it is a chart.
  function name_picture({ map, chart }) {
    const does = map?.own ? "Map of cases; the arrow keys move the setting" : chart ? ""
        : `Picture; the arrow keys ${flat ? "shift" : "turn"} it, + and − zoom`;
    over.setAttribute("role", does ? "application" : "group"), over.setAttribute("aria-label", does || "Picture");
    if (does) over.setAttribute("tabindex", "0"); else over.removeAttribute("tabindex");
  }

  // Handles: what can be dragged, also by keys.
  function show_grips(handles, unit) {
    const ring = Math.min(6 * unit, 3);  // on a small screen, too, names beside it can be read
    isect_show_grips(grips, handles, 18 * unit, ring);
  }
  const drag = svg => event => act({ do: "drag", ...isect_place_in(svg, event), snap: snaps(event) }, "keep");
  /// Of a handle, the picture or the map: the arrow keys step again.
  function leave() {
    const on = document.activeElement;
    if (on && section.contains(on.closest(".over"))) on.blur();
  }
  /// What a pointer has moved keeps no focus.
  function drop() { act({ do: "drop" }, "push"), leave(); }
  let pressed_at = ["", ""];  // the values when the button was pressed last, and before
  stage.addEventListener("pointerdown", event => {
    if (event.button !== 0) return;
    pressed_at = [JSON.stringify(now.values), pressed_at[0]];
    const grip = event.target.closest(".grip"), at = isect_place_in(over, event);
    if (grip || stage.classList.contains("is-map")) {
      event.preventDefault();
      if (grip) light({ do: "light", handle: grip.dataset.handle });
      act({ do: "take", ...(grip ? { handle: grip.dataset.handle } : {}), ...at }, "keep");
      isect_follow(stage, event, drag(over), drop);
    } else if (event.pointerType === "mouse" && !now.chart && event.target.closest(".holder")) {
      let from = null;
      isect_follow(stage, event, moved => {
        if (!from && Math.hypot(moved.clientX - event.clientX, moved.clientY - event.clientY) < scene_drag) return;
        const to = isect_place_in(over, moved);
        if (from) act({ do: "turn", x: to.x - from.x, y: to.y - from.y }, "keep");
        from = to;
      }, () => (from && act({ do: "drop" }, "replace"), leave()));
    }
  });
  stage.addEventListener("click", event => event.detail > 0 && leave());
  stage.addEventListener("dblclick", event => {
    const grip = event.target.closest(".grip"), dragged = grip && pressed_at[0] !== pressed_at[1];
    if (dragged || change_corner(grip ? { handle: grip.dataset.handle } : isect_place_in(over, event)) || grip) return;
    act({ do: "frame all" });
  });
  /// Of a scene's polygon: a corner more or less. Returns false where there is no such corner and no side.
  function change_corner(where) {
    const reply = is_scene ? book.request({ do: "corner", ...where }) : {};
    if (reply.wrong) tell(reply.wrong);
    else if (reply.scene !== undefined) act({ ...scene_request(example, reply.scene), step: "same answer" }, "push");
    return reply.wrong !== undefined || reply.scene !== undefined;
  }
  map.addEventListener("pointerdown", event => {
    if (event.button !== 0 || !event.target.closest(".holder")) return;
    event.preventDefault();
    act({ do: "take", ...isect_place_in(map_over, event) }, "keep");
    isect_follow(map, event, drag(map_over), drop);
  });
  const closer = { "+": 1.15, "=": 1.15, "-": 1 / 1.15, "−": 1 / 1.15 };
  const turn_by = 4;  // a press of an arrow key, in units of the picture
  let pushed = 0;
  section.addEventListener("keydown", event => {
    const on = event.target.closest(".over"), grip = event.target.closest(".grip"), way = isect_ways[event.key];
    if (!on || event.ctrlKey || event.altKey || event.metaKey) return;
    if (grip && (event.key === "Delete" || event.key === "Insert")) {
      if (change_corner({ handle: grip.dataset.handle, behind: event.key === "Insert" })) event.preventDefault();
      return;
    }
    const moves = grip || on === map_over || now.map?.own, factor = moves ? 0 : closer[event.key];
    if (event.key !== "Escape" && !way && !factor) return;
    event.preventDefault(), event.stopPropagation();
    if (event.key === "Escape") return leave();
    if (moves) act({ do: "push", ...(grip ? { handle: grip.dataset.handle } : {}), x: way[0], y: way[1], snap: snaps(event) }, "keep");
    else if (way) act({ do: "turn", x: turn_by * way[0], y: turn_by * way[1] }, "keep");
    else act({ do: "zoom", factor, moving: true }, "keep");
    clearTimeout(pushed), pushed = setTimeout(() => rest(moves && on, grip?.dataset.handle), 400);
  });
  /// What was moved by keys is drawn as it is to stay, once they rest, and told: in words for those who don't see it.
  function rest(moved, name) {
    act({ do: "drop" }, moved ? "push" : "replace");
    if (!moved) return;
    const is = name ? now.handles.find(handle => handle.name === name)?.label : now.map?.own ? "" : map_told.textContent;
    tell([is, said].filter(Boolean).join("; "));
  }
  addEventListener("keydown", event => {
    if (event.altKey || root.classList.contains("reading") || event.target.matches("input:not([type=range]), textarea")) return;
    const key = event.key.toLowerCase(), with_ctrl = event.ctrlKey || event.metaKey;
    if (with_ctrl && (key === "z" || key === "y")) act({ do: key === "z" && !event.shiftKey ? "undo" : "redo" }, "push");
    else if (key === "m" && !with_ctrl && !event.target.matches("select")) take_first();
    else return;
    event.preventDefault();
  });
  function take_first() {
    const first = grips.firstChild ?? (over.hasAttribute("tabindex") ? over : null);
    if (first) first.focus(); else tell("Nothing can be moved at this step.");
  }

  isect_two_fingers({ stage, place: touch => isect_place_in(over, touch), may_turn: () => now && !now.chart, act });

  // One name, one light.
  let lit = "";
  function light(request) {
    const reply = request ? book.request(request) : { names: [], marks: "", sum: "" };
    const names = reply.names ?? [];
    if (names.join() === lit) return;
    lit = names.join();
    lights.innerHTML = reply.marks;
    section.querySelectorAll("[data-name]").forEach(e => e.classList.toggle("lit", names.includes(e.dataset.name)));
    message.textContent = reply.sum || said;
  }
  let pointed = 0;
  stage.addEventListener("pointermove", event => {
    if (event.buttons || event.pointerType !== "mouse" || pointed || !now) return;
    const grip = event.target.closest(".grip"), at = isect_place_in(over, event);
    pointed = requestAnimationFrame(() => {
      pointed = 0;
      light(grip ? { do: "light", handle: grip.dataset.handle } : { do: "point", ...at });
    });
  });
  stage.addEventListener("pointerleave", () => light(null));
  section.addEventListener("pointerover", event => {
    const name = event.target.closest("[data-name]");
    if (name) light({ do: "light", names: [name.dataset.name] });
    else if (!stage.contains(event.target) && lit) light(null);
  });
  section.addEventListener("focusin", event => {
    const grip = event.target.closest(".grip");
    if (grip) light({ do: "light", handle: grip.dataset.handle });
  });
  // A finger on a handle drags it and never the page: touch-action counts for the whole drawing only, which may be scrolled.
  grips.addEventListener("touchstart", event => event.preventDefault(), { passive: false });

  [values, share].forEach(part => part.addEventListener("toggle", () => book.show_unfolded(part)));

  // The values, typed.
  function make_form(parameters) {
    form.replaceChildren(...parameters.map(p => {
      const id = "value-" + p.name, label = element("label", { for: id });
      label.innerHTML = p.label;
      const field = p.kind === "choice" ? element("select", { id }, ...p.choices.map((c, i) => element("option", { value: c }, p.titles[i])))
          : element("input", { id, type: "text", autocomplete: "off", spellcheck: "false" });
      field.title = p.help, field.name = p.name;
      field.addEventListener("change", () => set(p.name, field.value, field));
      const row = element("div", { class: "value" }, label, field);
      if (p.kind === "number") {
        const slide = element("input", { type: "range", min: p.from, max: p.to, step: "any", "data-slides": p.name });
        slide.setAttribute("aria-label", label.textContent);
        slide.addEventListener("input", () => set(p.name, slide.value, field, "keep"));
        slide.addEventListener("change", () => set(p.name, slide.value, field));
        row.append(slide);
      }
      row.append(element("p", { class: "help" }, p.help));
      if (p.where) row.append(element("p", { class: "help where" }, p.where + "."));
      return row;
    }));
    form.addEventListener("submit", event => event.preventDefault());
  }
  function set(name, text, field, address = "push") {
    const done = act({ do: "set", name, text }, address);
    if (done && field.type === "text") field.value = now.values[name];
    field.setAttribute("aria-invalid", String(!done));
    const help = field.parentElement.querySelector(".help");
    help.classList.toggle("refused", !done);
    help.textContent = done ? field.title : message.textContent;
  }
  function show_values(all, idle) {
    for (const field of form.elements) {
      field.parentElement.classList.toggle("idle", idle.includes(field.name || field.dataset.slides));
      const name = field.name || field.dataset.slides;
      field.parentElement.hidden = !(name in all) && field.matches("select") === false && !field.name;
      if (name in all && field !== document.activeElement) field.value = all[name];
      else if (name in all && field.matches("[type=text]") === false) field.value = all[name];
    }
  }
  // A scene of one's own: its text is the state, with what was dragged written into it.
  const texts = new Map();
  function text_of(id) {
    if (!texts.has(id)) texts.set(id, book.find(id, ".written pre").textContent);
    return texts.get(id);
  }
  const scene_request = (id, text = text_of(id)) => ({ do: "open", example: id, scene: text });
  function place_scene(frame) {
    const kept = frame.scene !== undefined;
    if (!kept) frame.scene = now.scene;
    frame.place.origin = example;
    frame.place.preset = kept && frame.scene === text_of(example) ? example : "";
    if (kept) editor.put(example, frame.scene);
  }
  /// Returns what is wrong with a text.
  function open_scene(written, step) {
    if (act({ ...scene_request(example, written), step }, "push")) return book.show_picture(), "";
    const wrong = message.textContent;
    message.textContent = "";  // it is said beside the text
    return wrong;
  }

  // The address holds the state.
  function address_of({ place, step, asks }) {
    const parts = is_scene ? place.preset ? [] : ["scene=" + encodeURIComponent(now.scene)] : place.changes.map(([name, text]) => encodeURIComponent(name) + "=" + encodeURIComponent(text).replaceAll("%2C", ","));
    if (place.time) parts.push("time=" + place.time);
    if (place.camera) parts.push("camera=" + place.camera);
    return `#${place.origin}/${step + 1}${asks ? "/question" : ""}${parts.length ? "?" + parts.join("&") : ""}`;
  }
  function keep_address(how) {
    const address = address_of(now);
    live.place = address.slice(1);
    if (how !== "keep" && address !== location.hash) book.keep(address, how === "push");
  }
  function request_from(hash) {
    const [path, query] = hash.slice(1).split("?"), [preset, step, question] = book.decoded(path).split("/");
    if (!book.settings.includes(preset)) return null;
    const request = { ...(is_scene ? scene_request(preset) : { do: "open", lesson, preset, changes: [] }),
      step: is_scene && !step ? "answer" : Math.max(0, Number(step || 1) - 1 || 0), asks: question === "question" };
    for (const [name, text] of new URLSearchParams((query ?? "").replaceAll("+", "%2B")))
      if (name === "camera" || name === "time" || (is_scene && name === "scene")) request[name] = text;
      else if (!is_scene) request.changes.push([name, text]);
    return request;
  }
  function from_address() {
    const asked = book.address(), request = request_from(asked);
    if (!request || !act(request, "keep")) return false;
    if (location.hash === "" || asked === location.hash) book.show_picture();
    return true;
  }

  // Save and copy.
  function letters() {
    const inside = document.getElementById("letters");
    if (inside) return Promise.resolve(inside.textContent);
    return (window.isect_letters ? Promise.resolve() : isect_code.script("letters.js")).then(() => isect_letters, () => "");
  }
  async function figure() {
    const made = book.request({ do: "copy" }), style = await letters();
    const head = `<svg xmlns="http://www.w3.org/2000/svg" width="${made.width}pt" height="${made.height}pt" ` +
      `font-family="'Isect Letters', 'STIX Two Text', serif" fill="none" stroke-linecap="round" stroke-linejoin="round" ` +
      `style="background: ${made.background}; white-space: pre"`;
    made.svg = made.svg.replace('<svg class="picture"', head).replace(/>\n/, `>\n<style>${style.replace(/\/\*[^]*?\*\//g, "")}</style>\n` +
      `<rect width="100%" height="100%" fill="${made.background}"/>`);
    return made;
  }
  function save(bytes, name) {
    isect_save(bytes, name);
    // A browser tells no script that it has refused.
    tell(window === top ? `${name} is saved.`
        : `${name} was given to the browser to save. Where the page around this one forbids that, open this one by itself.`);
  }
  async function save_svg() {
    const made = await figure();
    save(new Blob([made.svg], { type: "image/svg+xml" }), made.file + ".svg");
  }
  async function save_png() {
    const made = await figure(), image = new Image(), scale = 4;
    image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(made.svg);
    await image.decode();
    const canvas = element("canvas", { width: Math.round(scale * made.width), height: Math.round(scale * made.height) });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(bytes => save(bytes, made.file + ".png"), "image/png");
  }
  async function copy(text, what) {
    saved.hidden = false, saved.value = text;
    try { await navigator.clipboard.writeText(text); tell(`${what} is copied.`); } catch {
      saved.select();
      tell(document.execCommand("copy") ? `${what} is copied.` : "Copy it from the field below.");
    }
  }
  const copied = name => () => copy(book.request({ do: "copy" })[name], { latex: "LaTeX", markdown: "Markdown", alt: "The alt text" }[name]);
  const named_file = () => is_scene && /"file"\s*:/.test(now.scene);
  share.append(element("div", { class: "tools" }, pressed("Save SVG", save_svg), pressed("Save PNG", save_png),
    pressed("Copy link", () => copy(location.href, named_file() ? "The link, without the file that it names," : "The link")),
    pressed("Copy LaTeX", copied("latex")), pressed("Copy Markdown", copied("markdown")),
    pressed("Copy alt text", copied("alt")),
    pressed("Copy iframe", () => copy(`<iframe src="${isect_escaped(location.href)}" title="${isect_escaped(document.title)}" width="100%" ` +
      `height="800" style="border: 0" loading="lazy"></iframe>`, "The line for a page of your own"))), saved);

  // Light and dark, paper, and the beginning.
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", () => look({ dark: dark.matches }));
  const resized = () => now && show_grips(now.handles, unit_of(now));
  addEventListener("resize", resized);
  addEventListener("beforeprint", () => {
    if (!section.classList.contains("changed")) return;
    section.insertAdjacentHTML("beforeend", `<div class="printed">${book.request({ do: "whole" }).html}</div>`);
  });
  addEventListener("afterprint", () => section.querySelectorAll(".printed").forEach(e => e.remove()));

  /// `station`: the one on show, as an address names it.
  function begin(station) {
    book.request({ do: "look", dark: dark.matches });
    document.getElementById("walks").prepend(section);
    const skip = element("a", { class: "skip", href: "#live" }, "Skip to what can be moved");
    skip.addEventListener("click", event => (event.preventDefault(), take_first()));
    document.querySelector(".skip")?.after(skip);
    root.classList.add("lively");
    const asked = request_from(book.address()), name = book.decoded(location.hash.slice(1).split(/[/?]/)[0]);
    const nowhere = name !== "" && !asked && !document.getElementById(name);
    if (act(asked ?? request_from("#" + station), "keep")) {
      resized();
      if (asked) book.show_picture();
      if (nowhere) tell(`This page has no setting “${name}”.`);
      return;
    }
    const wrong = message.textContent;  // a link that is no longer good
    act(request_from("#" + station.split("/")[0]), "keep");
    tell(wrong);
    if (editor && asked && asked.scene !== text_of(asked.example)) editor.try_again(asked.scene, wrong);
  }
  snap.title = "Handles stop where the case changes; Shift does that, too";
  snap.setAttribute("aria-pressed", "false");
  wants_map.addEventListener("click", () => wants_map.setAttribute("aria-pressed", String(!map.hidden)));
  return live;
}
