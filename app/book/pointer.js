"use strict";
// What is dragged in a drawing: handles, and the pointer that moves them.

/// The way that a key moves things, in a drawing: right and down.
const isect_ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/// Where a pointer or a touch is, in units of a drawing.
function isect_place_in(svg, event) {
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  return { x: at.x, y: at.y };
}

/// Follows a pointer that was pressed, at most once a frame: `step` gets the last event, `end` ends it.
function isect_follow(target, event, step, end) {
  let last = null, asked = 0;
  const run = () => { asked = 0; if (last) step(last); last = null; };
  const move = moved => { last = moved; asked ||= requestAnimationFrame(run); };
  const stop = () => {
    if (asked) cancelAnimationFrame(asked), run();
    target.removeEventListener("pointermove", move);
    ["pointerup", "pointercancel"].forEach(name => target.removeEventListener(name, stop));
    end();
  };
  target.setPointerCapture(event.pointerId);
  target.addEventListener("pointermove", move);
  ["pointerup", "pointercancel"].forEach(name => target.addEventListener(name, stop));
}

/// Shows handles as rings of radius `ring`, each within `reach` of a pointer. They stay the elements they were: what is moved
/// in a page loses the focus.
function isect_show_grips(parent, handles, reach, ring) {
  const known = new Map([...parent.children].map(grip => [grip.dataset.handle, grip]));
  handles.forEach(handle => {
    let grip = known.get(handle.name);
    known.delete(handle.name);
    if (!grip) {
      grip = isect_element("g", { class: "grip", tabindex: "0", role: "button", "aria-roledescription": "handle",
        "data-handle": handle.name }, isect_element("circle", { class: "reach" }), isect_element("circle", { class: "ring" }));
      parent.append(grip);
    }
    grip.setAttribute("transform", `translate(${handle.x} ${handle.y})`);
    grip.setAttribute("aria-label", handle.label);
    grip.dataset.role = handle.role;
    grip.firstChild.setAttribute("r", reach), grip.lastChild.setAttribute("r", ring);
  });
  known.forEach(grip => grip.remove());
}
