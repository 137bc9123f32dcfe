"use strict";
// Exercises of a live page: what is asked and whether a setting is found are told at the exercise and in `task`, which stands
// below the picture, where one drags. Returns what tells them of each frame.
function isect_exercises(task) {
  const all = [...document.querySelectorAll(".exercises > ol > li")];
  let begun = null;  // the number from 0 of the exercise that was begun, and the setting it starts from
  let shown = "";    // in the task
  all.forEach((exercise, i) => {
    const start = exercise.querySelector(".start a");
    exercise.id ||= "exercise-" + (i + 1);
    start?.addEventListener("click", () => begun = { exercise: i, start: start.hash.slice(1).split("/")[0] });
  });
  const link = (i, name = `Exercise ${i + 1}`) => `<a href="#${all[i].id}">${name}</a>`;

  /// At the exercises. A setting in which a program errs tells enough: its correction unfolds.
  function mark(solved) {
    all.forEach((exercise, i) => {
      const found = solved.find(one => one.exercise === i);
      let note = exercise.querySelector(".solved");
      if (!found) return note && note.remove();
      if (!note) {
        exercise.append(note = document.createElement("p")), note.className = "solved";
        isect_tell("solved", { exercise: i + 1 });
        if (found.told) exercise.querySelector("details").open = true;
      }
      note.textContent = `✓ The setting above is one. ${found.told}`.trim();
    });
  }
  /// Below the picture. `solved`: by this setting; while something moves, nothing is known to be.
  function show(solved, origin) {
    if (begun && origin !== begun.start) begun = null;
    const own = begun && solved.find(one => one.exercise === begun.exercise), asked = begun && all[begun.exercise];
    document.documentElement.classList.toggle("has-task", Boolean(begun)), task.classList.toggle("found", Boolean(own || !begun));
    const told = own ? `✓ ${link(own.exercise)}: this setting is one. ${isect_escaped(own.told)}`
        : begun ? `${link(begun.exercise)}: ${asked.querySelector("p").innerHTML}` +
          (asked.querySelector("ol.code") ? ` ${link(begun.exercise, "Its lines")}` : "")
        : solved.length ? `✓ ${solved.map(one => link(one.exercise)).join(", ")}: this setting is one.` : "";
    if (told !== shown) task.innerHTML = shown = told;
  }
  return { mark, show };
}
