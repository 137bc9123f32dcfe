"use strict";
// The page of scenes: what it says while nothing can be changed yet, and where nothing ever can; and the files that are
// dropped on it, which else would take its place. Once there is somebody to take them, isect:files tells which they are.
(() => {
  const told = document.querySelector(".scene-state"), root = document.documentElement;
  if (!told) return;
  const words = {
    static: "This copy of the page has the examples alone: they are stepped through, not changed.",
    loading: "One moment: then you can drag, change the text, or drop a file.",
    ready: "Drag what has a ring, change the text, or drop a file.",
    none: "This browser can't run the lessons: the examples are stepped through, not changed."
  };
  const script = document.body.dataset.live;
  let state = !script ? "static" : window.WebAssembly && window.DecompressionStream ? "loading" : "none", waiting = [];
  const takes = () => state === "loading" || state === "ready";
  function tell() {
    told.textContent = words[state] + (state === "loading" && waiting.length ? " What you dropped waits." : "");
    if (state === "ready" && waiting.length) isect_tell("files", { files: waiting.splice(0) });
  }
  document.addEventListener("isect:live", event => { state = event.detail.state, tell(); });

  const brings_files = event => Boolean(event.dataTransfer) && [...event.dataTransfer.types].includes("Files");
  const mark = dropping => root.classList.toggle("dropping", dropping);
  addEventListener("dragover", event => {
    if (!brings_files(event)) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = takes() ? "copy" : "none";
    mark(takes());
  });
  addEventListener("dragleave", event => event.relatedTarget || mark(false));
  addEventListener("drop", event => {
    if (!brings_files(event)) return;
    event.preventDefault(), mark(false);
    if (takes()) waiting.push(...event.dataTransfer.files);
    tell();
  });
  tell();
})();
