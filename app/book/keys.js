"use strict";
// What keys and fingers do, on a sheet that the key "?" and a button open.

/// The rows of the sheet: what is pressed, what it does. `live`: what is shown can be moved.
function isect_key_rows(live) {
  const rows = {
    "Steps": [["←, →", "a step back, a step on"], ["Home, End", "the first step, the last"], ["Space", "play, pause"],
      ["1 … 9", "a setting of the list"], ["N, P", "the next setting, the one before"]],
    "Questions": [["A, B, C …", "take this answer"], ["digits", "type a number, where one is asked for; Enter gives it"]]
  };
  if (document.documentElement.classList.contains("in-hour")) {
    rows["Steps"] = [["Home, End", "the first step, the last"], ["Space", "play, pause"], ["1 … 9", "a setting of the list"]];
    rows["The playlist"] = [["N, →, Page Down", "on, to the next stop, too"], ["P, ←, Page Up", "back"]];
  }
  if (live) rows["What has a ring"] = [["a drag", "moves it; so does a finger"], ["M", "goes to the first ring, Tab to the next"],
    ["arrow keys on a ring", "move it"], ["Shift with either", "stops where the case changes"],
    ["Escape", "leaves the ring: the arrow keys step again"], ["Ctrl+Z, Ctrl+Y", "undo, redo"]];
  if (live) rows["The picture"] = [["a drag beside the rings, two fingers", "turns it, or shifts it where it is flat"],
    ["two fingers apart", "bring it closer"], ["Tab to it, then arrows, +, −", "the same by keys"], ["a double click", "shows all of it"]];
  if (live && document.body.dataset.lesson === "scene") {
    rows["A polygon’s corners"] = [["a double click on a side, Insert on a ring", "adds one"],
      ["a double click on its ring, Delete there", "removes it"]];
    rows["The scene as text"] = [["Ctrl+Enter", "shows it"]];
  }
  rows["Help"] = [["?", "this sheet"]];
  return rows;
}

let isect_sheet = null;
/// Shows a sheet of such rows.
function isect_show_sheet(all) {
  const make = isect_element;
  if (!isect_sheet) {
    document.body.append(isect_sheet = make("dialog", { class: "keys", "aria-labelledby": "keys-head" }));
    isect_sheet.addEventListener("keydown", event => {
      event.stopPropagation();  // nothing steps behind it
      if (event.key === "Escape") event.preventDefault(), isect_sheet.close();
    });
    isect_sheet.addEventListener("click", event => event.target === isect_sheet && isect_sheet.close());
  }
  const box = make("div", {}, make("h2", { id: "keys-head" }, "Keys and fingers"));
  for (const [title, rows] of Object.entries(all)) {
    const body = make("tbody", {}, ...rows.map(([pressed, does]) => make("tr", {}, make("th", { scope: "row" }, pressed), make("td", {}, does))));
    box.append(make("table", {}, make("caption", {}, title), body));
  }
  box.append(isect_button("Close", () => isect_sheet.close()));
  isect_sheet.replaceChildren(box);
  if (!isect_sheet.open) isect_sheet.showModal();
}

function isect_show_keys() { isect_show_sheet(isect_key_rows(document.documentElement.dataset.live === "ready")); }

/// Returns a button that opens the sheet.
function isect_key_button(show = isect_show_keys) {
  const made = isect_button("?", () => show(), "show-keys");
  made.title = "Keys and fingers", made.setAttribute("aria-label", made.title), made.setAttribute("aria-haspopup", "dialog");
  return made;
}
