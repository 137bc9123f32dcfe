// Fingers, keys and words of live pages. node hands.mjs FOLDER ISECT; prints what is wrong; exit status 1 if anything is.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { LivePages, rest } from "./live_page.mjs";

const [folder, isect] = process.argv.slice(2);
const site = await LivePages.start(folder, isect), browser = site.browser;
const check = (holds, what) => site.check(holds, what), same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const look = () => site.look(), ask = text => browser.ask(text);
const lessons = readdirSync(folder).filter(name => name.endsWith(".html") && name !== "scene.html").sort()
  .filter(name => readFileSync(join(folder, name), "utf8").includes("data-live="));
const focused = `document.activeElement.closest(".grip, .over, .skip, .term")?.getAttribute("class") ?? ""`;
const step_of = now => now.hash.slice(1).split("?")[0], camera_of = now => new URLSearchParams(now.hash.split("?")[1] ?? "").get("camera");
const middle = selector => ask(`(() => { const b = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
  return { x: b.x + b.width / 2, y: b.y + b.height / 2, top: b.top, bottom: b.bottom, high: b.height }; })()`);
const bar = () => ask(`document.querySelector(".transport").getBoundingClientRect().top`);
const text = selector => ask(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`);
const type = (name, value) => ask(`(() => { const f = document.getElementById("value-${name}");
  f.focus(), f.value = ${JSON.stringify(value)}, f.dispatchEvent(new Event("change")), f.blur(); })()`);
async function tab_until(wanted, most) {
  for (let i = 0; i < most; ++i) {
    if (await ask(focused) === wanted) return i;
    await browser.press("Tab");
  }
  return -1;
}

/// What a page's selects offer, and what it shows of what can be moved.
const offered = `(() => {
  const titles = [...document.querySelectorAll("nav.settings h2")].map(h => h.textContent);
  const selects = [...document.querySelectorAll(".live form select")].map(s => [...s.options].map(o => o.textContent));
  const snap = [...document.querySelectorAll(".live .tools button")].find(b => b.textContent === "Snap");
  const group = document.querySelector(".live .stage .over > g[role=group]");
  group.focus();
  return { titles, selects, snap: !snap.hidden && getComputedStyle(snap).visibility === "visible", grips: group.querySelectorAll(".grip").length,
    nameless: document.activeElement === group || !group.getAttribute("aria-label") };
})()`;
let handled = 0, titled = 0, unhandled = 0;
try {
  await browser.look({ width: 1280, height: 900 });
  for (const page of lessons) {
    check(await site.open(page) === "ready", `${page}: the lessons do not run`);
    const now = await ask(offered);
    check(!now.nameless, `${page}: what surrounds the handles takes the focus, or has no name`);
    check(now.grips === 0 || now.snap, `${page}: there are handles, and no Snap`);
    if (now.grips > 0) ++handled; else if (!now.snap) ++unhandled;
    if (now.titles.length < 2) continue;
    const as_titled = now.selects.filter(options => options.every(option => now.titles.includes(option)));
    check(as_titled.length > 0, `${page}: no list offers ${now.titles.join(", ")}: ${JSON.stringify(now.selects)}`);
    titled += as_titled.length > 0;
  }
  check(handled > 20 && unhandled > 0 && titled > 5, `${handled} pages with handles, ${unhandled} without, ${titled} with methods`);

  // By keys: two Tabs to what can be moved, arrows move it, Escape lets the arrows step again; what was moved is told.
  const page = "sphere-sphere.html";
  await site.open(page);
  const first = await look();
  await browser.press("Tab"), await browser.press("Tab");
  check(await text(":focus") === "Skip to what can be moved", "the second Tab does not reach the link to what can be moved: " + await text(":focus"));
  await ask(`document.activeElement.click()`);
  check(await ask(focused) === "grip", "the link to what can be moved leads to " + await ask(focused));
  const label = await ask(`document.activeElement.getAttribute("aria-label")`);
  await browser.press("ArrowRight"), await rest(600);
  const pushed = await look(), moved = await ask(`document.activeElement.getAttribute("aria-label")`);
  check(step_of(pushed) === step_of(first) && moved !== label, "an arrow key does not move what has the focus");
  check(pushed.message.startsWith(moved), `moved by keys, ${moved} is told as “${pushed.message}”`);
  await browser.press("Escape");
  check(await ask(focused) === "", "Escape does not leave a handle");
  await browser.press("ArrowRight");
  const stepped = await look();
  check(step_of(stepped) !== step_of(first) && same(stepped.values, pushed.values), "after Escape an arrow key does not step");
  await browser.press("m");
  check(await ask(focused) === "grip", "M does not go to the first handle");
  await browser.press("Escape");
  await browser.press("z", 2);
  check(same((await look()).values, first.values), "Ctrl+Z undoes nothing where nothing has the focus");
  await browser.press("y", 2);
  check(same((await look()).values, pushed.values), "Ctrl+Y does nothing again");

  // The picture that has the focus turns. One that was clicked has not: the arrows step.
  await site.open(page);
  check(await tab_until("over", 60) >= 0, "Tab does not reach the picture");
  await browser.press("ArrowRight"), await rest(600);
  const turned = await look();
  check(step_of(turned) === step_of(first) && camera_of(turned) !== null && same(turned.values, first.values), "an arrow key does not turn the picture: " + turned.hash);
  await browser.press("+"), await rest(600);
  check(camera_of(await look()) !== camera_of(turned), "+ does not bring the picture closer");
  await browser.press("Escape"), await browser.press("ArrowRight");
  check(step_of(await look()) !== step_of(first), "after Escape an arrow key does not step on from the picture");
  await site.open(page);
  const stage = await middle(".live .stage");
  await browser.drag({ x: stage.x, y: stage.top + 6 }, { x: stage.x + 60, y: stage.top + 30 });
  await rest(50);
  const dragged = await look();
  check(camera_of(dragged) !== null && await ask(focused) === "", "a drag of the picture does not turn it, or leaves it the focus");
  await browser.press("ArrowRight");
  check(step_of(await look()) !== step_of(dragged), "after a drag of the picture an arrow key does not step");

  // What Snap has found stays until the next change, wherever the mouse goes.
  await site.open(page);
  await ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
  const { grips: [, b] } = await look();
  await browser.drag(b, { x: b.x + 150, y: b.y }, 8, 8);
  await rest(1000);
  const found = (await look()).message;
  for (const at of [{ x: b.x - 90, y: b.y + 40 }, { x: 5, y: 5 }]) {
    await browser.send("Input.dispatchMouseEvent", { type: "mouseMoved", ...at, button: "none", buttons: 0 });
    await rest(80);
  }
  check(found !== "" && (await look()).message === found, `of “${found}” is left “${(await look()).message}”`);
  await browser.press("ArrowRight");
  check((await look()).message !== found, "what Snap has found is told at the next step, too");

  // A change that ends a walk earlier says so.
  const count = () => ask(`Number(document.querySelector(".transport .place").textContent.match(/of (\\d+)/)[1])`);
  await site.open("ray-sphere.html", "#two-roots");
  const before = await count();
  await type("direction", "0,1,0");
  const after = await count();
  check(after < before && (await look()).message.includes(`The walk has ${after} steps now, and had ${before}.`),
    `from ${before} to ${after} steps: “${(await look()).message}”`);

  // An exercise that was begun stands below the picture, and whether it is solved. Both are in sight.
  for (const size of [{ width: 1280, height: 900 }, { width: 390, height: 844 }]) {
    const at = `${size.width} wide`;
    await browser.look(size);
    await site.open(page);
    const solved = `document.querySelectorAll(".exercises .solved").length`;
    await ask(`[...document.querySelectorAll(".exercises > ol > li")].find(li => li.querySelector("summary").textContent.startsWith("Correction")).querySelector(".start a").click()`);
    await rest(200);
    const begun = await middle(".task"), picture = await middle(".live .picture");
    check((await text(".task")).startsWith("Exercise "), `${at}: the exercise that was begun is not told: ${await text(".task")}`);
    check(begun.high > 0 && begun.top >= 0 && begun.bottom <= await bar() + 1, `${at}: the exercise lies from ${begun.top} to ${begun.bottom}`);
    check(picture.top >= 0 && picture.bottom <= await bar() + 1, `${at}: beside it the picture lies from ${picture.top} to ${picture.bottom}`);
    check(await ask(solved) === 0, `${at}: it is solved from the beginning`);
    await type("b", "1.015625,0,-0.76171875");
    check(/^✓ Exercise \d: this setting is one\. The program says DISJOINT/.test(await text(".task")), `${at}: it is solved, and told is ${await text(".task")}`);
    await ask(`document.querySelector('nav.settings a[href="#overlapping"]').click()`);
    await rest(100);
    check(await text(".task") === "", `${at}: in another setting is told ${await text(".task")}`);
  }
  await browser.look({ width: 1280, height: 900 });

  // The sheet of keys: by its key and by its buttons. Behind it nothing steps.
  await site.open(page);
  const shown = `document.querySelector("dialog.keys")?.open === true`;
  await browser.press("?");
  check(await ask(shown) && (await text("dialog.keys")).includes("Escape"), "the key ? shows no keys");
  await browser.press("ArrowRight");
  check((await look()).hash === first.hash, "behind the sheet of keys something steps");
  await browser.press("Escape");
  check(!await ask(shown), "Escape does not close the sheet of keys");
  for (const width of [1280, 390]) {
    await browser.look({ width, height: 844 });
    const pressed = await ask(`(() => { const seen = [...document.querySelectorAll(".show-keys")].filter(b => b.getBoundingClientRect().width > 0);
      seen[0]?.click(); return seen.length; })()`);
    check(pressed === 1 && await ask(shown), `${width} wide: ${pressed} buttons for the sheet of keys`);
    check(await ask(`(() => { const b = document.querySelector("dialog.keys").getBoundingClientRect(); return b.left >= 0 && b.right <= innerWidth; })()`), `${width} wide: the sheet of keys sticks out`);
    await browser.press("Escape");
  }

  // A term tells what it means, and goes again.
  await browser.look({ width: 1280, height: 900 });
  await site.open("ray-sphere.html");
  for (let i = 0; i < 12 && !await ask(`document.querySelector(".live .term") !== null`); ++i) await browser.press("ArrowRight");
  const term = `document.querySelector(".live .term")`;
  check(await ask(`${term} !== null`), "no step marks a term");
  if (await ask(`${term} !== null`)) {
    const words = await ask(`${term}.closest("p").textContent`);
    await ask(`${term}.focus()`);
    const told = await ask(`(() => { const t = document.querySelector(".term-told"), b = t?.getBoundingClientRect();
      return t && { text: t.textContent, link: t.querySelector("a")?.getAttribute("href") ?? "", sees: b.left >= 0 && b.right <= innerWidth && b.top >= 0 && b.bottom <= innerHeight }; })()`);
    check(told && told.text.length > 20 && told.sees && told.link.endsWith(".html"), `a term tells ${JSON.stringify(told)}`);
    await browser.press("Escape");
    check(await ask(`document.querySelector(".term-told") === null && ${term}.closest("p").textContent`) === words, "Escape does not close what a term tells");
  }

  // On a phone: two fingers turn the picture, and the page stays; an explanation stands above the bar.
  await browser.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 2 });
  await browser.look({ width: 390, height: 844 });
  await site.open(page);
  const rect = await middle(".live .stage"), start = await look(), y = rect.top + 14;
  await ask("scrollTo(0, 0)");
  const scrolled = await ask("scrollY"), scale = await ask("visualViewport.scale");
  await browser.swipe([{ x: rect.x - 40, y }, { x: rect.x + 40, y }], [{ x: rect.x - 10, y: y + 30 }, { x: rect.x + 90, y: y + 30 }]);
  await rest(150);
  const by_fingers = await look();
  check(camera_of(by_fingers) !== null && same(by_fingers.values, start.values), "two fingers do not turn the picture: " + by_fingers.hash);
  check(await ask("scrollY") === scrolled && await ask("visualViewport.scale") === scale, "two fingers scroll or scale the page");
  await site.open(page);
  for (let i = 0; i < 12 && !(await look()).asks; ++i) await browser.press("ArrowRight");
  await site.choose("a");
  await rest(50);
  const explained = await middle(".live .ask.told .words details");
  check(explained.high > 0 && explained.top >= 0 && explained.bottom <= await bar() + 1, `an explanation lies from ${explained.top} to ${explained.bottom}, the bar begins at ${await bar()}`);
  await browser.send("Emulation.setTouchEmulationEnabled", { enabled: false });

  // While the lessons are not there yet, and where they can't run, that is said; the steps work.
  await browser.look({ width: 1280, height: 900 });
  const in_new = async source => (await browser.send("Page.addScriptToEvaluateOnNewDocument", { source })).identifier;
  const waits = await in_new(`addEventListener("DOMContentLoaded", () => window.waited = document.querySelector(".walk.shown > .lively-told")?.textContent ?? "")`);
  await site.open(page);
  check(await ask("waited") === "Drags come in a moment.", "while the lessons are not there yet is told: " + await ask("waited"));
  check(await ask(`document.querySelector(".walk .lively-told") === null`), "that drags come is told where they are there");
  const blocked = await in_new(`Object.defineProperty(window, "WebAssembly", { value: undefined })`);
  for (const name of [page, "scene.html"])
    for (const size of [{ width: 1280, height: 900 }, { width: 390, height: 844 }]) {
      await browser.look(size);
      check(await site.open(name) === "none", `${name}: without WebAssembly it runs`);
      check((await text(".walk.shown > .lively-told")).startsWith("This browser can’t run"), `${name}: that it can’t be dragged is not told`);
      const told = await middle(".walk.shown > .lively-told");
      check(told.high > 0 && told.bottom <= await bar() + 1, `${name}, ${size.width} wide: that it can’t be dragged is told at ${told.bottom}, the bar begins at ${await bar()}`);
      const hash = await ask("location.hash");
      await browser.press("ArrowRight");
      check(await ask("location.hash") !== hash, `${name}: without WebAssembly it does not step`);
      check(name === "scene.html" || (await text(".exercises > .lively-told")).startsWith("Nothing can be dragged here"), `${name}: its exercises ask for drags`);
      check(await ask(`document.querySelector(".walk.shown > .steps > .shown .term, .opening .term") !== null`) || name === "scene.html", `${name}: no term is marked`);
    }
  for (const identifier of [waits, blocked]) await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
  site.check_silence();
} finally {
  await browser.stop();
}
console.log(`${site.checks} checks of ${lessons.length} live pages' keys, fingers and words, ${site.wrong.length} wrong`);
process.exit(site.wrong.length === 0 ? 0 : 1);
