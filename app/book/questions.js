"use strict";
// The questions of a page: a choice is a button; the first that is pressed is the answer. A number is typed, unless its
// choices are wanted.
/// Returns what makes an article of a question answerable; `told` is called with each answer: whether it is right.
function isect_questions(told) {
  function prepare(ask) {
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
    ask.querySelectorAll(".typed, .reply, .other").forEach(old => old.remove());
    const list = ask.querySelector(".choices[data-number]");
    ask.classList.toggle("typing", Boolean(list));
    if (list) list.before(field_for(ask, JSON.parse(list.dataset.number)));
  }
  function field_for(ask, number) {
    const form = document.createElement("form"), label = document.createElement("label"), field = document.createElement("input");
    const give = document.createElement("button"), hint = document.createElement("button"), help = document.createElement("p");
    field.type = "text", field.autocomplete = "off", field.spellcheck = false, field.setAttribute("autocapitalize", "off");
    label.append("Your answer ", field);
    give.type = "submit", give.textContent = "Answer";
    hint.type = "button", hint.textContent = "Show the choices";
    hint.addEventListener("click", () => ask.classList.remove("typing"));
    help.className = "help", help.textContent = number.asks, help.setAttribute("role", "status");
    form.className = "typed", form.append(label, give, hint, help);
    form.addEventListener("submit", event => {
      event.preventDefault();
      let value;
      try { value = isect_number(field.value); } catch (refused) {
        help.textContent = `That is not read: ${refused.message}.`, help.classList.add("refused");
        return void field.setAttribute("aria-invalid", "true");
      }
      field.blur();  // the arrow keys step again
      const is = ([at, off]) => Math.abs(value - at) <= off;
      const right = is(number.right), found = right ? null : number.wrong.find(is);
      const text = field.value.trim(), read = String(Number(value.toPrecision(5))).replace("-", "−");
      answer(ask, right ? number.choice : found?.[3] ?? -1, found?.[2] ?? "",
        `You typed ${text}${text.replace("-", "−") === read ? "" : ` = ${read}`}. `);
    });
    return form;
  }
  /// `chosen`: the choice, -1 where none says the number that was typed. `reply`: what is said to it, as HTML.
  function answer(ask, chosen, reply, typed = "") {
    if (ask.classList.contains("told")) return;
    ask.classList.add("told"), ask.classList.remove("typing");
    const choices = [...ask.querySelectorAll(".choices li")], choice = choices[chosen];
    const right = Boolean(choice && choice.hasAttribute("data-right"));
    if (choice && !right) choice.classList.add("wrong");
    reply ??= choice?.dataset.reply ?? "";
    if (reply || typed) {
      const said = document.createElement("p"), mistake = document.createElement("span");
      said.className = "reply", mistake.innerHTML = reply, said.append(typed, mistake);
      ask.querySelector(".choices").before(said);
    }
    ask.querySelector("details").open = true;
    isect_answers.keep(ask.dataset.asked, right);
    told(right, ask);
  }
  return prepare;
}
