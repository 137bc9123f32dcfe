"use strict";
// Two fingers on the picture turn it, or shift it where it is flat, and bring it closer; one finger scrolls the page.
// `place`: of a touch, in the picture; `may_turn`: whether it can be; `act`: asks the session.
function isect_two_fingers({ stage, place, may_turn, act }) {
  const least_zoom = 0.02;  // fingers never keep their distance
  let pair = null, next = null, waits = 0;
  function pair_of([a, b]) {
    const p = place(a), q = place(b);
    return { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2, far: Math.max(1, Math.hypot(p.x - q.x, p.y - q.y)) };
  }
  /// A finger on a handle drags that.
  const is_free = touch => stage.contains(touch.target) && !touch.target.closest(".grip");
  /// At most once a frame.
  function turn() {
    waits = 0;
    if (!pair || !next) return;
    const factor = next.far / pair.far, zooms = Math.abs(factor - 1) > least_zoom;
    act({ do: "turn", x: next.x - pair.x, y: next.y - pair.y }, "keep");
    if (zooms) act({ do: "zoom", factor, moving: true }, "keep");
    pair = { ...next, far: zooms ? next.far : pair.far }, next = null;
  }
  function end() {
    if (!pair) return;
    if (waits) cancelAnimationFrame(waits), turn();
    pair = null, act({ do: "drop" }, "replace");
  }
  stage.addEventListener("touchstart", event => {
    end();
    if (event.touches.length !== 2 || !event.cancelable || !may_turn() || ![...event.touches].every(is_free)) return;
    event.preventDefault(), pair = pair_of(event.touches), next = null;
  }, { passive: false });
  stage.addEventListener("touchmove", event => {
    if (!pair || event.touches.length !== 2) return;
    if (event.cancelable) event.preventDefault();
    next = pair_of(event.touches), waits ||= requestAnimationFrame(turn);
  }, { passive: false });
  ["touchend", "touchcancel"].forEach(name => stage.addEventListener(name, end));
}
