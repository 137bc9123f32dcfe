"use strict";
// Says whether what a page shows can be dragged, where one would try: below the picture, and at the exercises.
(() => {
  const body = document.body, meant = "live" in body.dataset, scene = body.dataset.lesson === "scene";
  if (!document.querySelector(".walk")) return;
  const words = {
    waits: "Drags come in a moment.",
    none: scene ? "This browser can’t run scenes; the examples can be stepped through."
        : "This browser can’t run the lessons; steps and questions work."
  };
  const told = document.createElement("p"), exercises = document.querySelector(".exercises > h2");
  told.className = "lively-told", told.setAttribute("role", "status");
  /// Below the picture of the setting that is shown.
  function place() {
    const walk = document.querySelector(".walk.shown");
    if (walk && told.parentElement !== walk) walk.append(told);
  }
  function tell(text) { told.textContent = text, place(); }
  function warn(text) {
    if (!exercises) return;
    const warning = document.createElement("p");
    warning.className = "lively-told", warning.textContent = text, exercises.after(warning);
  }
  if (!meant) return warn("Nothing can be dragged on these pages; in the window of isect, all that has a ring can.");
  tell(words.waits);
  document.addEventListener("isect:step", place);
  document.addEventListener("isect:live", ({ detail: { state } }) => {
    if (state !== "none") return document.removeEventListener("isect:step", place), told.remove();
    tell(words.none), warn("Nothing can be dragged here: this browser can’t run the lessons. Steps, questions and solutions work.");
  });
})();
