"use strict";
// Steps through the walks of a page. All that is shown stands in the page, as elements or as text (waiting.js); nothing is
// fetched. Where the lessons' own code is beside the page, live.js takes over what is shown.
(() => {
  const root = document.documentElement;
  if (!document.querySelector(".walk")) return;
  if (!root.classList.contains("scripted")) return isect_show_all();
  const settings = isect_settings((section, fresh) => {
    fresh.filter(article => article.matches(".ask")).forEach(prepare);
    isect_tell("made", { setting: section.id });
  });
  const { ids, articles } = settings;
  const links = [...document.querySelectorAll("nav.settings a")];
  const seconds_a_step = 1.6;
  const opens_at = Number(document.getElementById("walks").dataset.opensAt ?? 0);  // a scene, at its first answer
  let walk = settings.section(ids[0], false), at = 0, playing = 0;
  let live = null;      // what live.js has made of the page
  let place_of = null;  // where that stands in the page's own walks

  const icons = {
    first: "M3 2h2v12H3zM14.5 3.5L13 2 7 8l6 6 1.5-1.5L10 8z", back: "M11.5 3.5L10 2 4 8l6 6 1.5-1.5L7 8z", play: "M4 2l10 6-10 6z",
    pause: "M4 2h3v12H4zM9 2h3v12H9z", next: "M4.5 3.5L6 2l6 6-6 6-1.5-1.5L9 8z", last: "M11 2h2v12h-2zM1.5 3.5L3 2l6 6-6 6-1.5-1.5L6 8z",
    "Whole page": "M2 3h12v2H2zM2 7h12v2H2zM2 11h12v2H2z"
  };
  /// The name is its icon where there is one, or else its text.
  function name_button(button, name) {
    button.setAttribute("aria-label", name), button.title = name;
    if (icons[name])
      button.innerHTML = `<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="${icons[name]}"/></svg>`;
    else button.textContent = name;
  }
  function button(name, action) {
    const made = document.createElement("button");
    made.type = "button", name_button(made, name), made.addEventListener("click", action);
    if (icons[name]) made.className = name.split(" ")[0].toLowerCase();
    return made;
  }
  const bar = document.createElement("div");
  bar.className = "transport", bar.setAttribute("role", "group"), bar.setAttribute("aria-label", "Steps");
  const first = button("first", () => stand(0)), back = button("back", () => step(-1));
  const play = button("play", toggle_play), next = button("next", () => step(1));
  const last = button("last", () => stand(count() - 1));
  const all = button("Whole page", () => read(!root.classList.contains("reading"))), all_name = document.createElement("span");
  all_name.textContent = "Whole page", all.append(all_name), all.setAttribute("aria-pressed", "false");
  const slider = document.createElement("input");
  slider.type = "range", slider.min = 1, slider.setAttribute("aria-label", "Step");
  slider.addEventListener("input", () => stand(Number(slider.value) - 1));
  const place = document.createElement("p");
  place.className = "place", place.setAttribute("aria-live", "polite");
  bar.append(first, back, play, next, last, slider, all, isect_key_button(), place);
  document.getElementById("walks").append(bar);

  // What a lesson is about, and its settings, each in a line: the picture begins on the first screen.
  const about = document.querySelector(".about"), summary = document.querySelector(".opening .summary");
  if (about && summary) {
    const more = document.createElement("button");
    const unfold = open => {
      about.classList.toggle("open", open);
      more.textContent = open ? "Less" : "More", more.setAttribute("aria-expanded", String(open));
    };
    more.type = "button", more.className = "more", more.addEventListener("click", () => unfold(!about.classList.contains("open")));
    about.id = "about", more.setAttribute("aria-controls", about.id);
    const line = document.createElement("span");  // of a wide window: what is too long for it is told when unfolded
    line.className = "told-in-short", line.append(...summary.childNodes);
    unfold(false), summary.append(line, " ", more);
  }
  // While a question is open, settings are told by their numbers, which take the place of the names.
  links.forEach((link, i) => {
    const name = document.createElement("span");
    name.append(...link.childNodes), link.append(name), link.dataset.number = i + 1;
  });
  const lists = [...document.querySelectorAll("nav.settings ul")], methods = document.createElement("select");
  const links_of = list => [...list.querySelectorAll("a")];
  if (lists.length > 1) {
    methods.className = "methods", methods.setAttribute("aria-label", "Kind of setting");
    document.querySelectorAll("nav.settings h2").forEach(head => methods.append(new Option(head.textContent)));
    /// The setting of the same name, or the first.
    methods.addEventListener("change", () => {
      const now = links.find(link => link.hash === "#" + opened), others = links_of(lists[methods.selectedIndex]);
      const to = others.find(link => now && link.textContent === now.textContent) ?? others[0];
      open_walk(to.hash.slice(1));
    });
    document.querySelector("nav.settings").prepend(methods);
  }

  /// Where the reader is. A title may be the answer, so it waits.
  function told(article, list) {
    const before = list.filter(a => a.classList.contains("step")).indexOf(article);
    if (before < 0) return article.querySelector("h3").textContent;
    return `Step ${before + 1} of ${settings.counts(walk).steps}: ${isect_title_of(article)}`;
  }

  const count = () => live ? live.count : settings.counts(walk).stations;
  const position = () => live ? live.at : at;
  function stand(to) {
    if (live) live.go(Math.max(0, Math.min(to, count() - 1))); else go(walk.id, to);
    show_picture();
  }
  function open_walk(id) {
    if (live) live.load(id); else go(id, opens_at);
    show_picture();
  }

  /// The code and the links, for a station of a walk: `lines` are what data-line, data-said, data-refused and
  /// data-untaken say.
  function light_code(section, lines) {
    [...section.querySelectorAll("ol.code li")].forEach((line, i) => {
      line.classList.toggle("current", lines.line === i);
      line.classList.toggle("yes", lines.line === i && lines.said === "yes");
      line.classList.toggle("no", lines.line === i ? lines.said === "no" : lines.refused.includes(i));
      line.classList.toggle("untaken", lines.untaken.includes(i));
      if (lines.line === i) line.setAttribute("aria-current", "step");
      else line.removeAttribute("aria-current");
    });
    if (lit !== lines.line) lit = lines.line, show_line();
  }
  const shown = () => live ? live.article : articles(walk)[at];
  const { measure, show_line, show_picture, show_answers, show_reply, show_unfolded } =
    isect_sight({ bar, shown, read: () => articles(walk)[at] });
  let lit = -1;     // the line that runs
  let opened = "";  // the setting that is shown; "": none of the page's
  function mark_link(id) { opened = id, mark(); }
  /// A setting's name may be the answer: while a question is open, it is not told.
  function mark() {
    const asks = isect_is_open(shown());
    root.classList.toggle("asking", asks);
    root.classList.toggle("pointing", asks && shown().matches(".pointing.typing") && !root.classList.contains("reading"));
    links.forEach(link => {
      if (link.hash === "#" + opened && !asks) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
    const link = links.find(link => link.hash === "#" + opened), list = link && link.closest("ul");
    if (!link) return;
    lists.forEach((other, i) => {
      other.classList.toggle("other", other !== list);
      if (other === list && methods.options.length) methods.selectedIndex = i;
    });
    const here = link.getBoundingClientRect(), room = list.getBoundingClientRect();
    if (here.left < room.left || here.right > room.right) list.scrollLeft += here.left - room.left - 40;
  }
  function show_controls(told) {
    const here = position(), end = count() - 1;
    first.disabled = back.disabled = here === 0;
    next.disabled = last.disabled = here === end;
    slider.max = end + 1, slider.value = here + 1;
    const [where, ...title] = told.split(": "), rest = document.createElement("span");
    rest.textContent = title.length ? ": " + title.join(": ") : "", place.replaceChildren(where, rest);
    slider.setAttribute("aria-valuetext", told);
  }

  /// Shows one article: the address, the code and the controls follow.
  function go(id, position, keep_address) {
    walk.classList.remove("shown");
    walk = settings.section(id, position > 0);
    const list = articles(walk), end = settings.counts(walk).stations - 1;
    at = Math.max(0, Math.min(end, position));
    walk.classList.add("shown");
    list.forEach((article, i) => article.classList.toggle("shown", i === at));
    const article = list[at];
    walk.classList.toggle("over", at === end);
    if (!live) root.classList.toggle("moves", walk.classList.contains("moves"));
    const numbers = name => (article.dataset[name] ?? "").split(" ").filter(Boolean).map(Number);
    light_code(walk, {
      line: numbers("line")[0] ?? -1, said: article.dataset.said ?? "", refused: numbers("refused"), untaken: numbers("untaken")
    });
    if (live) return;
    mark_link(walk.id);
    show_controls(told(article, list));
    isect_tell("step", { setting: walk.id, at, asks: isect_is_open(article), asked: article.dataset.asked ?? "", end: at === end,
      step: list.slice(0, at + 1).filter(a => a.classList.contains("step")).length, of: settings.counts(walk).steps });
    if (!keep_address) keep("#" + article.id);
    if (playing && (at === end || isect_is_open(article))) toggle_play();
  }
  function step(by) { stand(position() + by); }
  function toggle_play() {
    if (playing) clearInterval(playing), playing = 0;
    else {
      if (position() === count() - 1) stand(0);
      playing = setInterval(() => step(1), 1000 * seconds_a_step);
    }
    name_button(play, playing ? "pause" : "play");
  }
  /// The page's own walks stand at the same place, for paper and for reading.
  function follow_live() {
    if (live && place_of) go(place_of.id, place_of.at, true);
  }
  addEventListener("beforeprint", () => (follow_live(), settings.section(walk.id)));
  /// All presets and steps one below the other, or one step at a time.
  function read(whole) {
    if (whole) settings.all(), follow_live();
    root.classList.toggle("reading", whole);
    all.setAttribute("aria-pressed", String(whole));
    mark(), show_picture();
  }

  const { prepare, key: key_for } = isect_questions((right, ask) => {
    place.textContent = right ? "Right." : "Not quite.";
    offer_other(ask);
    mark();
    show_reply(ask);
  }, ask => (mark(), show_answers(ask)));
  /// All that tells a question from the same one in another setting; a choice's letter is none of it.
  function numbers_of(ask) {
    const right = [...ask.querySelectorAll(".choices li")].findIndex(choice => "right" in choice.dataset);
    const text = part => part.textContent.slice(part.querySelector(".letter") ? 2 : 0);
    return [...ask.querySelectorAll(".words > p:not(.reply), .choices li, .values td")].map(text).join("|") + right;
  }
  /// Offers the same question with other numbers, in the next setting that asks it so and where it is still open.
  function offer_other(ask) {
    const asked = ask.dataset.asked, own = numbers_of(ask), from = ids.indexOf(opened);
    if (!asked) return;
    for (const id of [...ids.slice(from + 1), ...ids.slice(0, Math.max(0, from))]) {
      const other = settings.find(id, `[data-asked="${CSS.escape(asked)}"]`, asked);
      if (!other || !isect_is_open(other) || numbers_of(other) === own) continue;
      const again = button("Again, with other numbers", () => { location.hash = other.id; });
      again.className = "other", ask.querySelector("details").after(again);
      return;
    }
  }
  document.querySelectorAll(".ask").forEach(prepare);
  measure();
  addEventListener("resize", () => (measure(), show_line()));
  /// A line of the code that is shown is pointed at, where one is asked for.
  addEventListener("click", event => {
    const line = event.target.closest && event.target.closest(".algorithm ol.code li"), ask = shown();
    if (!line || !root.classList.contains("pointing") || line.closest(".walk") !== ask.closest(".walk")) return;
    const form = ask.querySelector(".typed");
    form.querySelector("input").value = 1 + [...line.parentElement.children].indexOf(line);
    form.requestSubmit();
  });

  /// Of an address; as it stands there where it is none that a browser has written.
  function decoded(text) {
    try { return decodeURIComponent(text); } catch { return text; }
  }
  const setting_in = hash => decoded(hash.slice(1).split(/[/?]/)[0]), names_a_walk = hash => ids.includes(setting_in(hash));
  /// What this entry of the browser's history shows, also where its address names another part of the page.
  const address = () => names_a_walk(location.hash) ? location.hash : history.state?.shown ?? "";
  function keep(shown, push = false, url = shown) {
    try { history[push ? "pushState" : "replaceState"]({ shown }, "", url); } catch { /* nowhere to keep it */ }
  }
  function from_address() {
    if (live) return live.from_address();
    const asked = address(), id = decoded(asked.slice(1).split("?")[0]);
    if (!names_a_walk(asked)) return false;
    const owner = settings.section(setting_in(asked), !document.getElementById(id)), found = document.getElementById(id);
    if (!found) return false;
    go(owner.id, found === owner ? opens_at : Math.max(0, articles(owner).indexOf(found)), true);
    if (location.hash === "" || asked === location.hash) show_picture();
    return true;
  }
  /// The browser's own jump has scrolled, unless what it leads to is shown by us.
  function follow_address() {
    if (!from_address()) keep("#" + (live ? live.place : articles(walk)[at].id), false, location.href);
  }
  const keys = {
    ArrowRight: () => step(1), ArrowLeft: () => step(-1), Home: () => stand(0), End: () => stand(count() - 1),
    " ": toggle_play, n: () => next_walk(1), p: () => next_walk(-1), "?": isect_show_keys
  };
  /// Presets beyond the ninth have no number.
  function next_walk(by) {
    const to = ids[ids.indexOf(live && place_of ? place_of.id : walk.id) + by];
    if (to) open_walk(to);
  }
  addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || root.classList.contains("reading")) return;
    const on = event.target;
    if (on.matches("input, textarea, select") || (on.matches("button, a, summary") && event.key === " ")) return;
    const done = key_for(shown(), event.key);
    if (done === "typed") return;
    if (done === "") {
      if (/^[1-9]$/.test(event.key) && ids[event.key - 1]) open_walk(ids[event.key - 1]);
      else if (keys[event.key]) keys[event.key]();
      else return;
    }
    event.preventDefault();
  });
  addEventListener("hashchange", follow_address);
  // A link to where one is already goes there, too: the exercise that it stands in lies far below.
  addEventListener("click", event => {
    const link = event.target.closest && event.target.closest('a[href^="#"]');
    if (link && link.hash === location.hash && from_address()) event.preventDefault();
  });
  // A browser scrolls to what an address names, and with it the page around this one: until it has, it is asked for nothing.
  if (names_a_walk(location.hash)) keep(location.hash, false, location.pathname + location.search);
  if (!from_address()) go(walk.id, opens_at, true);
  function keep_first() {
    const here = "#" + (live ? live.place : articles(walk)[at].id);
    if (location.hash === "") keep(history.state?.shown ?? here);
  }
  if (document.readyState === "complete") keep_first(); else addEventListener("load", () => setTimeout(keep_first));

  /// The lessons' own code (load.js). Without it all stays as it is.
  async function come_alive(script) {
    const request = await isect_code.ready(script), find = settings.find;
    live = isect_live({
      request, settings: ids, find, prepare, light_code, mark_link, show_controls, show_picture,
      show_unfolded, decoded, address, keep, stop: () => playing && toggle_play(), playing: () => playing !== 0,
      follow(id, at) {
        place_of = { id, at };
        if (root.classList.contains("reading")) follow_live();
      }
    });
    if (live) live.begin(articles(walk)[at].id);
    tell_live(live ? "ready" : "none");
  }
  /// "loading", then "ready", or "none" where the lessons can't run.
  function mark_live(state) {
    root.dataset.live = state, root.classList.toggle("can-live", state !== "none");  // the room for what can be changed
  }
  function tell_live(state) { mark_live(state), isect_tell("live", { state }); }
  const script = document.body.dataset.live;
  if (script) {
    mark_live("loading");
    (window.WebAssembly ? come_alive(script) : Promise.reject()).catch(() => { live = null, tell_live("none"); });
  }
})();
