"use strict";
// The text of a scene, beside its picture: with the numbers of its lines and the place of an error; files that are opened or
// dropped; and what was written and is not shown yet, which stays with its example as long as the tab does.
// `open`: shows a text at an answer, and returns what is wrong with it, or ""; `request`: asks the session; `save`: gives bytes
// to the browser under a name.
function isect_scene_text({ element, pressed, open, request, save }) {
  const most_megabytes = 32, part = 2 ** 18, most_letters = 400000;
  const area = element("textarea", { "aria-label": "The scene as text", "aria-describedby": "scene-told", spellcheck: "false",
    autocapitalize: "off", autocomplete: "off", wrap: "off" });
  const numbers = element("pre", { class: "line-numbers", "aria-hidden": "true" }), spot = element("span");
  const mark = element("div", { class: "marked-line", "aria-hidden": "true", hidden: "" }, spot);
  const paper = element("div", { class: "paper" }, mark, numbers, area);
  const told = element("p", { class: "help", id: "scene-told", role: "status" });
  const ways = element("div", { class: "tools ways", role: "group", "aria-label": "What to do now" });
  const chosen = element("input", { type: "file", multiple: "", hidden: "" });
  const own_scene = element("details", { class: "own-scene", open: "" }, element("summary", {}, "Change the scene"), paper,
    element("div", { class: "tools" }, pressed("Show this scene", () => show()), pressed("Open a file", () => chosen.click()),
      pressed("Save the scene", () => save(new Blob([area.value], { type: "application/json" }), file_name()))),
    told, ways, chosen);
  own_scene.querySelector(".tools button").title = "Ctrl+Enter in the text, too";

  let example = "", shown = "";  // whose text it is, and what of it is on show
  let place = null;              // of an error: { line, column }, the latter 0 where it is not known
  let showing = false;           // a text of this field is being opened
  let question = null;           // while something is asked: what yes and no do

  // What was written and is not shown: in this tab, or where nothing can be stored, in this page.
  const kept = new Map(), key = id => `isect scene ${location.pathname} ${id}`;
  function keep(id, text) {
    kept.set(id, text);
    try {
      if (text === null) sessionStorage.removeItem(key(id)); else sessionStorage.setItem(key(id), text);
    } catch { /* in the map alone */ }
  }
  function recalled(id) {
    if (kept.has(id)) return kept.get(id);
    try { return sessionStorage.getItem(key(id)); } catch { return null; }
  }
  const is_own = () => example !== "" && area.value !== shown;

  /// `choices`: names and what they do. What is said already is not said again: it would be read out at each letter.
  function say(words, choices = [], refused = false) {
    const names = choices.map(([name]) => name).join();
    question = null;
    told.classList.toggle("refused", refused);
    if (told.textContent !== words) told.textContent = words;
    if (ways.told !== names) ways.replaceChildren(...choices.map(([name, action]) => pressed(name, action)));
    ways.told = names;
  }
  const back = () => is_own() ? [["Back to what is shown", take_back]] : [];
  function tell_state(instead = "") {
    say(is_own() ? instead || "This text is not shown yet." : "", back());
  }
  /// In a way that the field itself can undo.
  function take_back() {
    area.focus({ preventScroll: true }), area.select();
    if (!document.execCommand("insertText", false, shown)) area.value = shown;
    written();
  }
  function write(text) {
    if (area.value !== text) area.value = text;  // else the field forgets what it can undo
    number_lines();
  }
  function written() {
    number_lines(), mark_place(null), keep(example, is_own() ? area.value : null), tell_state();
  }

  /// A scene is on show: an example's, or one that has its link.
  function put(id, text) {
    const other = id !== example, own = showing ? null : other ? recalled(id) : is_own() ? area.value : null;
    const left = other && !showing && is_own();
    if (left) keep(example, area.value);
    example = id, shown = text;
    if (!other && own !== null && own !== text) return;  // a drag: what was written stays, and what is said of it
    write(own ?? text), mark_place(null);
    keep(id, is_own() ? area.value : null);
    tell_state("Your text is here again. It is not shown yet.");
    if (left && !is_own()) say("What you wrote is kept: it is here again once you go back to that example.");
  }
  function show(step = "same answer") {
    const letters = area.value.length;
    if (letters > most_letters) return refuse(`The text has ${letters} letters; a page takes up to ${most_letters}.`);
    showing = true;
    const wrong = open(area.value, step);
    showing = false;
    if (wrong) refuse(wrong);
  }
  function refuse(wrong) {
    const found = wrong.match(/^line (\d+)(?:, column (\d+))?:/) ?? wrong.match(/\(line (\d+): [^()]*\)$/);
    keep(example, is_own() ? area.value : null);
    mark_place(found && { line: Number(found[1]), column: Number(found[2] ?? 0) });
    area.setAttribute("aria-invalid", "true");
    say(wrong, [...(found ? [[`Go to line ${found[1]}`, go_to_place]] : []), ...back()], true);
  }

  // Lines and the place of an error.
  const style = () => getComputedStyle(area), line_height = () => parseFloat(style().lineHeight);
  function number_lines() {
    const count = area.value.split("\n").length;
    if (numbers.count === count) return;
    numbers.count = count, numbers.textContent = Array.from({ length: count }, (_, i) => i + 1).join("\n");
    paper.style.setProperty("--digits", String(Math.max(2, String(count).length)));
  }
  function mark_place(to) {
    place = to, mark.hidden = !to, spot.hidden = !to || !to.column;
    area.removeAttribute("aria-invalid");
    follow_text();
  }
  /// Numbers and the mark go with the text when it is scrolled.
  function follow_text() {
    numbers.style.transform = `translateY(${-area.scrollTop}px)`;
    if (!place) return;
    mark.style.top = `${parseFloat(style().paddingTop) + area.clientTop + (place.line - 1) * line_height() - area.scrollTop}px`;
    spot.style.left = `calc(${parseFloat(style().paddingLeft) + area.clientLeft - area.scrollLeft}px + ${place.column - 1}ch)`;
  }
  function go_to_place() {
    if (!place) return;
    const lines = area.value.split("\n"), letters = [...(lines[place.line - 1] ?? "")];
    const before = lines.slice(0, place.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
    const until = count => before + letters.slice(0, count).join("").length;
    own_scene.open = true;
    area.focus({ preventScroll: true });
    if (place.column) area.setSelectionRange(until(place.column - 1), until(place.column));
    else area.setSelectionRange(before, until(letters.length));
    area.scrollTop = (place.line - 0.5) * line_height() - area.clientHeight / 2;
    area.scrollLeft = place.column * spot.getBoundingClientRect().width - area.clientWidth / 2;
    paper.scrollIntoView({ block: "nearest" });
    follow_text();
  }

  // Files.
  function file_name() {
    const title = area.value.match(/"title"\s*:\s*("(?:[^"\\\n]|\\.)*")/);
    let name = "";
    try { name = title ? JSON.parse(title[1]) : ""; } catch { /* not a title yet */ }
    const words = name.normalize("NFC").toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-+|-+$/g, "");
    return ([...words].slice(0, 60).join("") || "scene") + ".json";
  }
  function in_base64(file) {
    return new Promise((done, failed) => {
      const reader = new FileReader();
      reader.onload = () => done(file.size ? reader.result.slice(reader.result.indexOf(",") + 1) : "");
      reader.onerror = () => failed(new Error(`${file.name} can't be read.`));
      reader.readAsDataURL(file);
    });
  }
  /// The text of a JSON file is a scene, unless it says what else it is: GeoJSON.
  function is_scene(text) {
    try { return typeof JSON.parse(text).type !== "string"; } catch { return true; }
  }
  /// Of a scene its text; else what the session writes about a file that it has taken.
  async function scene_of(file) {
    if (file.size > most_megabytes * 2 ** 20)
      throw new Error(`${file.name} has ${Math.ceil(file.size / 2 ** 20)} MB; a page takes up to ${most_megabytes}, the program isect more.`);
    if (/\.json$/i.test(file.name)) {
      const text = await file.text().catch(() => { throw new Error(`${file.name} can't be read.`); });
      if (is_scene(text)) return { text: text.replaceAll("\r\n", "\n"), is_file: false };
    }
    const whole = await in_base64(file);
    for (let from = 0; ; from += part) {
      const ends = from + part >= whole.length;
      const reply = request({ do: "file", name: file.name, base64: whole.slice(from, from + part), begins: from === 0, ends });
      if (reply.wrong) throw new Error(reply.wrong);
      if (ends) return { text: reply.scene, is_file: true, name: file.name };
    }
  }
  /// What the text names already only completes it.
  const is_named = name => area.value.includes(`"${name}"`) || area.value.includes(`/${name}"`);
  async function take(files) {
    if (files.length === 0) return;
    say(`Reading ${files.length === 1 ? files[0].name : files.length + " files"} …`);
    const taken = [];
    try {
      for (const file of files) taken.push(await scene_of(file));
    } catch (e) {
      return say(e.message, back(), true);
    }
    const scenes = taken.filter(one => !one.is_file), last = (scenes.length ? scenes : taken).at(-1);
    if (scenes.length === 0 && taken.some(one => is_named(one.name))) return show();
    replace(last.text, files.length === 1 ? files[0].name : "the files");
  }
  /// Asks, where something would be lost.
  function replace(text, name) {
    const go_on = () => (write(text), show("answer"));
    if (!is_own() || text === area.value) return go_on();
    say(`Your text is not shown yet, and ${name} would take its place.`,
      [["Replace my text", () => question.yes()], ["Keep my text", () => question.no()]]);
    question = { yes: () => (area.focus(), go_on()), no: () => (area.focus(), tell_state()) };
    ways.querySelector("button:last-child").focus();
  }

  area.addEventListener("input", written);
  area.addEventListener("scroll", follow_text);
  area.addEventListener("keydown", event => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) event.preventDefault(), show();
  });
  own_scene.addEventListener("keydown", event => event.key === "Escape" && question && question.no());
  chosen.addEventListener("change", () => {
    const files = [...chosen.files];
    chosen.value = "", take(files);
  });
  document.addEventListener("isect:files", event => take(event.detail.files));

  return {
    element: own_scene, put,
    /// A link's text that can't be shown.
    try_again(text, wrong) { write(text), refuse(wrong); }
  };
}
