"use strict";
// The questions of a page: a choice is a button; the first that is pressed is the answer. What is asked for besides a
// choice is typed, pointed at or taken tile by tile, unless the choices are wanted.

/// Tells the page's other scripts, and those of a page around it that listen, what has happened: "isect:" and the name.
function isect_tell(name, detail) { document.dispatchEvent(new CustomEvent("isect:" + name, { detail })); }

/// Whether an article is a question that is not answered yet.
function isect_is_open(article) { return article.classList.contains("ask") && !article.classList.contains("told"); }

/// What is asked for besides a choice, by the attribute that tells it. Each reads what was typed, and throws where that is
/// refused: the choice that says it, -1 for none, what is said to it, as HTML, and how it is told.
const isect_kinds = {
  number: number => typed => {
    const value = isect_number(typed), is = ([at, off]) => Math.abs(value - at) <= off;
    const right = is(number.right), found = right ? null : number.wrong.find(is);
    const text = typed.trim(), read = String(Number(value.toPrecision(5))).replace("-", "−");
    return [right ? number.choice : found?.[3] ?? -1, found?.[2] ?? "",
      `You typed ${text}${text.replace("-", "−") === read ? "" : ` = ${read}`}. `];
  },
  pointed: lines => typed => {
    const line = isect_line(typed, lines.replies.length);
    return [lines.offered.indexOf(line), lines.replies[line], `You pointed at line ${line + 1}. `];
  },
  order: asked => typed => {
    const order = isect_order(typed, asked.tiles.length), said = isect_said_to_order(order, asked), told = document.createElement("span");
    told.innerHTML = `Your order was: ${[...order].map(letter => asked.tiles[letter.charCodeAt(0) - 97]).join(", ")}. `;
    return [said === "" ? asked.choice : asked.offered.indexOf(order), said, told];
  }
};

/// Makes the articles of questions answerable. `told` is called with each answer: whether it is right; `changed` where
/// its choices are shown. Returns what prepares an article, and what a key does to one.
function isect_questions(told, changed = () => {}) {
  const letter_of = i => String.fromCharCode(97 + i);
  function as_button(item, i, action) {
    const pressed = document.createElement("button"), letter = document.createElement("span");
    pressed.type = "button";
    letter.textContent = letter_of(i), letter.className = "letter";
    pressed.append(letter, " ", ...item.childNodes);
    pressed.addEventListener("click", action);
    item.append(pressed);
    return pressed;
  }
  function prepare(ask) {
    ask.querySelectorAll(".choices li").forEach((choice, i) => as_button(choice, i, () => answer(ask, i)));
    ask.querySelectorAll(".typed, .reply, .other").forEach(old => old.remove());
    const list = ask.querySelector(".choices"), asked_for = list && Object.keys(isect_kinds).find(name => name in list.dataset);
    const kind = asked_for === "pointed" && !ask.closest(".walk") ? null : asked_for;  // there is no code to point at
    ask.classList.toggle("typing", Boolean(kind)), ask.classList.toggle("pointing", kind === "pointed");
    if (kind) {
      const asked = JSON.parse(list.dataset[kind]);
      list.before(field_for(ask, asked.asks, isect_kinds[kind](asked)));
      if (kind === "order") prepare_tiles(ask);
    }
    isect_way.restore(ask);
  }
  function show_choices(ask) { ask.classList.remove("typing"), changed(ask); }
  /// `read`: one of isect_kinds.
  function field_for(ask, asks, read) {
    const form = document.createElement("form"), label = document.createElement("label"), field = document.createElement("input");
    const give = document.createElement("button"), hint = document.createElement("button"), help = document.createElement("p");
    field.type = "text", field.autocomplete = "off", field.spellcheck = false, field.setAttribute("autocapitalize", "off");
    label.append("Your answer ", field);
    give.type = "submit", give.textContent = "Answer";
    hint.type = "button", hint.textContent = "Show the choices", hint.className = "show-choices";
    hint.addEventListener("click", () => show_choices(ask));
    help.className = "help", help.textContent = asks, help.setAttribute("role", "status");
    form.className = "typed", form.dataset.asks = asks, form.append(label, give, hint, help);
    form.addEventListener("submit", event => {
      event.preventDefault();
      let given;
      try { given = read(field.value); } catch (refused) {
        help.textContent = `That is not read: ${refused.message}.`, help.classList.add("refused");
        return void field.setAttribute("aria-invalid", "true");
      }
      field.blur();  // the arrow keys step again
      answer(ask, ...given);
    });
    return form;
  }
  /// What the field holds is the order: a tile that is pressed is added to it, or taken back.
  function prepare_tiles(ask) {
    const field = ask.querySelector(".typed input");
    const tiles = [...ask.querySelectorAll(".tiles li")].map((tile, i) => {
      const pressed = as_button(tile, i, () => {
        if (!isect_is_open(ask)) return;
        const kept = field.value.replace(new RegExp(letter_of(i), "i"), "");
        field.value = kept === field.value ? kept + letter_of(i) : kept, show_places();
      }), place = document.createElement("span");
      place.className = "place-of-tile", pressed.append(place);
      return pressed;
    });
    function show_places() {
      const order = field.value.toLowerCase().replace(/[^a-z]/g, "");
      tiles.forEach((tile, i) => {
        const place = order.indexOf(letter_of(i)) + 1;
        tile.lastChild.textContent = place || "", tile.setAttribute("aria-pressed", String(place > 0));
      });
    }
    field.addEventListener("input", show_places), show_places();
  }
  /// `chosen`: the choice, -1 where none says what was given. `reply`: what is said to it, as HTML. `given`: how it is told.
  function answer(ask, chosen, reply, given = "") {
    if (ask.classList.contains("told")) return;
    ask.classList.add("told"), ask.classList.remove("typing");
    const choices = [...ask.querySelectorAll(".choices li")], choice = choices[chosen];
    const right = Boolean(choice && choice.hasAttribute("data-right"));
    if (choice && !right) choice.classList.add("wrong");
    reply ??= choice?.dataset.reply ?? "";
    if (reply || given) {
      const said = document.createElement("p"), mistake = document.createElement("span");
      said.className = "reply", mistake.innerHTML = reply, said.append(given, mistake);
      ask.querySelector(".choices").before(said);
    }
    ask.querySelector("details").open = true;
    if (isect_way.restoring) return isect_way.offer_again(ask, changed);
    const how = given ? { typed: ask.querySelector(".typed input").value } : { choice: chosen };
    isect_answers.keep(ask.dataset.asked, right);
    tell_damage(ask);
    told(right, ask);
    isect_tell("answer", { asked: ask.dataset.asked ?? "", right, station: isect_way.station_of(ask), ...how });
  }
  /// A record that could not be read is told once, where the first answer after it is given.
  function tell_damage(ask) {
    if (isect_answers.told) ask.querySelector(".words").append(isect_answers.damage());
  }
  /// Returns what a key does to a question: "typed", as it goes into the field, "taken", or nothing.
  function key(ask, pressed) {
    if (!isect_is_open(ask)) return "";
    const typing = ask.classList.contains("typing");
    const begins = typing && ask.querySelector(".tiles") ? /^[a-h]$/i : /^[0-9.,(√−-]$/;
    if (typing && begins.test(pressed)) return ask.querySelector(".typed input").focus(), "typed";
    const choice = /^[a-h]$/.test(pressed) && ask.querySelectorAll(".choices button")[pressed.charCodeAt(0) - 97];
    if (!choice) return "";
    if (typing) show_choices(ask); else choice.click();
    return "taken";
  }
  return { prepare, key };
}
