"use strict";
// Steps through the walks of a page. All that is shown stands in the page; nothing is fetched.
(() => {
  const root = document.documentElement;
  const walks = [...document.querySelectorAll(".walk")];
  if (walks.length === 0) return;
  const articles = walk => [...walk.querySelectorAll(".steps > article")];
  const links = [...document.querySelectorAll("nav.settings a")];
  const seconds_a_step = 1.6;
  let walk = walks[0], at = 0, playing = 0;

  const icons = {
    first: "M3 3h2v10H3zM14 3v10L6 8z", back: "M12 3v10L4 8z", play: "M2 3l6 5-6 5zM8 3l6 5-6 5z",
    pause: "M4 3h3v10H4zM9 3h3v10H9z", next: "M4 3l8 5-8 5z", last: "M11 3h2v10h-2zM2 3l8 5-8 5z"
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
    return made;
  }
  const bar = document.createElement("div");
  bar.className = "transport", bar.setAttribute("role", "group"), bar.setAttribute("aria-label", "Steps");
  const first = button("first", () => go(walk, 0)), back = button("back", () => step(-1));
  const play = button("play", toggle_play), next = button("next", () => step(1));
  next.className = "next";
  const last = button("last", () => go(walk, articles(walk).length - 1));
  const all = button("All steps", () => read(!root.classList.contains("reading")));
  const slider = document.createElement("input");
  slider.type = "range", slider.min = 1, slider.setAttribute("aria-label", "Step");
  slider.addEventListener("input", () => go(walk, Number(slider.value) - 1));
  const place = document.createElement("p");
  place.className = "place", place.setAttribute("aria-live", "polite");
  bar.append(first, back, play, next, last, slider, all, place);
  document.getElementById("walks").append(bar);

  const is_open = article => article.classList.contains("ask") && !article.classList.contains("told");
  /// Where the reader is. A title may be the answer, so it waits.
  function told(article, list) {
    const steps = list.filter(a => a.classList.contains("step")), before = steps.indexOf(article);
    if (before < 0) return article.querySelector("h3").textContent;
    return `Step ${before + 1} of ${steps.length}: ${article.querySelector("h3").lastChild.textContent.trim()}`;
  }

  /// Shows one article: the address, the code and the controls follow.
  function go(to, position, keep_address) {
    const list = articles(to);
    walk = to, at = Math.max(0, Math.min(list.length - 1, position));
    walks.forEach(w => w.classList.toggle("shown", w === walk));
    list.forEach((article, i) => article.classList.toggle("shown", i === at));
    const article = list[at];
    walk.classList.toggle("over", at === list.length - 1);
    const stepped = article.classList.contains("ask") ? list[at - 1] ?? article : article;  // the code waits, too
    const numbers = name => (stepped.dataset[name] ?? "").split(" ").filter(Boolean).map(Number);
    const refused = numbers("refused"), untaken = numbers("untaken");
    [...walk.querySelectorAll("ol.code li")].forEach((line, i) => {
      line.classList.toggle("current", stepped.dataset.line === String(i));
      line.classList.toggle("no", refused.includes(i));
      line.classList.toggle("untaken", untaken.includes(i));
      if (stepped.dataset.line === String(i)) line.setAttribute("aria-current", "step");
      else line.removeAttribute("aria-current");
    });
    links.forEach(link => {
      if (link.hash === "#" + walk.id) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    });
    first.disabled = back.disabled = at === 0;
    next.disabled = last.disabled = at === list.length - 1;
    slider.max = list.length, slider.value = at + 1;
    place.textContent = told(article, list);
    slider.setAttribute("aria-valuetext", place.textContent);
    if (!keep_address) try { history.replaceState(null, "", "#" + article.id); } catch { /* nowhere to keep it */ }
    if (playing && (at === list.length - 1 || is_open(article))) toggle_play();
  }
  function step(by) { go(walk, at + by); }
  function toggle_play() {
    if (playing) clearInterval(playing), playing = 0;
    else {
      if (at === articles(walk).length - 1) go(walk, 0);
      playing = setInterval(() => step(1), 1000 * seconds_a_step);
    }
    name_button(play, playing ? "pause" : "play");
  }
  /// All steps one below the other, or one at a time.
  function read(whole) {
    root.classList.toggle("reading", whole);
    all.setAttribute("aria-pressed", String(whole));
    articles(walk)[at].scrollIntoView({ block: "nearest" });
  }

  /// A choice is a button; the first that is pressed is the answer.
  document.querySelectorAll(".ask").forEach(ask => {
    const choices = [...ask.querySelectorAll(".choices li")];
    choices.forEach((choice, i) => {
      const pressed = document.createElement("button");
      pressed.type = "button";
      const letter = document.createElement("span");
      letter.textContent = String.fromCharCode(97 + i), letter.className = "letter";
      pressed.append(letter, ...choice.childNodes);
      pressed.addEventListener("click", () => answer(ask, i));
      choice.append(pressed);
    });
  });
  function answer(ask, chosen) {
    if (ask.classList.contains("told")) return;
    ask.classList.add("told");
    const choices = [...ask.querySelectorAll(".choices li")], right = choices[chosen].hasAttribute("data-right");
    if (!right) choices[chosen].classList.add("wrong");
    ask.querySelector("details").open = true;
    place.textContent = right ? "Right." : "Not quite.";
  }

  function from_address() {
    const id = decodeURIComponent(location.hash.slice(1)), found = id && document.getElementById(id);
    const owner = found && found.closest(".walk");
    if (!owner) return false;
    go(owner, Math.max(0, articles(owner).indexOf(found)), true);
    owner.scrollIntoView({ block: "start" });
    return true;
  }
  const keys = {
    ArrowRight: () => step(1), ArrowLeft: () => step(-1), Home: () => go(walk, 0),
    End: () => go(walk, articles(walk).length - 1), " ": toggle_play
  };
  addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || root.classList.contains("reading")) return;
    const on = event.target;
    if (on.matches("input, textarea, select") || (on.matches("button, a, summary") && event.key === " ")) return;
    const shown = articles(walk)[at];
    const choice = is_open(shown) && /^[a-h]$/.test(event.key)
        ? shown.querySelectorAll(".choices button")[event.key.charCodeAt(0) - 97] : null;
    if (choice) choice.click();
    else if (/^[1-9]$/.test(event.key) && walks[event.key - 1]) go(walks[event.key - 1], 0);
    else if (keys[event.key]) keys[event.key]();
    else return;
    event.preventDefault();
  });
  addEventListener("hashchange", from_address);
  if (!from_address()) go(walk, 0, true);
})();
