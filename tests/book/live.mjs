// Pages whose lessons run in the browser. node live.mjs FOLDER ISECT; prints what is wrong; exit status 1 if anything is.
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const folder = resolve(process.argv[2]), isect = process.argv[3];
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort();
const wrong = [];
let checks = 0;
function check(holds, what) {
  ++checks;
  if (!holds) wrong.push(what), console.log("wrong: " + what);
}
const address = (page, hash = "") => pathToFileURL(join(folder, page)).href + hash;
const browser = await Browser.start();

/// Opens a page and waits until it can be changed.
async function open(page, hash = "") {
  await browser.open("about:blank");
  await browser.open(address(page, hash));
  const state = await browser.ask(`new Promise(done => {
    const look = () => document.documentElement.dataset.live ? done(document.documentElement.dataset.live) : setTimeout(look, 10);
    document.body.dataset.live ? look() : done("static");
  })`);
  return state;
}
const shown = `(() => {
  const text = s => document.querySelector(".live " + s)?.textContent.trim() ?? "";
  const grips = [...document.querySelectorAll(".live .grip")].map(g => {
    const box = g.querySelector(".ring").getBoundingClientRect();
    return { name: g.dataset.handle, label: g.getAttribute("aria-label"), x: box.x + box.width / 2, y: box.y + box.height / 2 };
  });
  const values = Object.fromEntries([...document.querySelectorAll(".live form [name]")].map(f => [f.name, f.value]));
  return { hash: location.hash, title: text("h3"), heading: text("h2"), verdict: text(".verdict"),
    yes: document.querySelector(".live .verdict.yes") !== null, no: document.querySelector(".live .verdict.no") !== null,
    asks: document.querySelector(".live article").classList.contains("ask"),
    told: document.querySelector(".live article").classList.contains("told"),
    right: [...document.querySelectorAll(".live .choices li")].findIndex(li => "right" in li.dataset),
    picture: document.querySelector(".live .picture").outerHTML.length, wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    message: text(".message"), grips, values, end: document.querySelector(".transport .next").disabled };
})()`;
const look = () => browser.ask(shown);
const rest = ms => new Promise(done => setTimeout(done, ms));
const click = text => browser.ask(`[...document.querySelectorAll(".live button")].find(b => b.textContent === ${JSON.stringify(text)}).click()`);

/// What the exact answer is for the values of a page: of each lesson whether the two meet.
const point = text => text.split(",").map(Number);
const queries = {
  "sphere-sphere.html": v => ({ kind: "sphere_sphere", c1: point(v.a), r1: Number(v.r_a), c2: point(v.b), r2: Number(v.r_b) }),
  "aabb-aabb.html": v => ({ kind: "box_box", alo: point(v.a_min), ahi: point(v.a_max), blo: point(v.b_min), bhi: point(v.b_max) }),
  "sphere-aabb.html": v => ({ kind: "sphere_box", center: point(v.c), radius: Number(v.r), lo: point(v.b_min), hi: point(v.b_max) })
};
function meets(query) {
  const { stdout } = spawnSync(isect, ["query"], { input: JSON.stringify(query) + "\n", encoding: "utf8" });
  return JSON.parse(stdout).result.intersects;
}
async function compare(page, how) {
  await browser.press("End");
  let now = await look();
  while (!now.yes && !now.no && !now.hash.includes("/1?")) {
    await browser.press("ArrowLeft");
    const before = now.hash;
    now = await look();
    if (now.hash === before) break;
  }
  const truth = meets(queries[page](now.values));
  check(now.yes === truth && now.no === !truth, `${page}, ${how}: "${now.verdict}", but they ${truth ? "meet" : "do not meet"}`);
}

const ready = {};
try {
  await browser.look({ width: 1280, height: 900 });
  for (const page of pages) {
    const begun = Date.now(), state = await open(page);
    if (state === "static") continue;
    ready[page] = Date.now() - begun;
    check(state === "ready", `${page}: the lessons do not run`);
    if (state !== "ready") continue;

    // Stepped to its end, the questions answered; never wider than the page.
    let answered = 0, last = "";
    for (let i = 0; i < 80; ++i) {
      const now = await look();
      check(now.wide <= 0, `${page} ${now.hash}: ${now.wide} px too wide`);
      check(now.picture > 300, `${page} ${now.hash}: there is no picture`);
      check(now.hash !== last || i === 0, `${page} ${now.hash}: the address stays`);
      if (now.asks) {
        check(now.right >= 0, `${page} ${now.hash}: no choice is right`);
        await browser.press("abcdefgh"[now.right]);
        check((await look()).told, `${page} ${now.hash}: the answer is not told`);
        ++answered;
      }
      if (now.end) break;
      last = now.hash;
      await browser.press("ArrowRight");
    }
    const end = await look();
    check(end.end, `${page}: its end is not reached`);

    // A handle, dragged by mouse and by keys; the link opens that very setting; back and forth.
    await browser.press("Home");
    let now = await look();
    for (let i = 0; i < 12 && now.grips.length === 0 && !now.end; ++i) await browser.press("ArrowRight"), now = await look();
    if (now.grips.length === 0) continue;
    await browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
    now = await look();
    const grip = now.grips[0];
    await browser.drag(grip, { x: grip.x + 24, y: grip.y + 14 });
    await rest(50);
    const dragged = await look();
    check(JSON.stringify(dragged.values) !== JSON.stringify(now.values) || dragged.message !== "",
      `${page}: ${grip.name} does not follow the mouse`);
    await browser.ask(`document.querySelector(".live .grip").focus()`);
    for (const key of ["ArrowLeft", "ArrowUp", "ArrowLeft"]) await browser.press(key);
    await rest(600);
    const pushed = await look();
    check(JSON.stringify(pushed.values) !== JSON.stringify(dragged.values) || pushed.message !== "",
      `${page}: ${grip.name} does not follow the keys`);
    await browser.ask(`document.activeElement.blur()`);
    if (queries[page]) await compare(page, "after a drag");
    if (pushed.hash.includes("?")) {
      const kept = await look();
      check(await open(page, kept.hash) === "ready", `${page}: its link does not open`);
      const again = await look();
      check(JSON.stringify(again.values) === JSON.stringify(kept.values) && again.title === kept.title && again.hash === kept.hash,
        `${page}: its link opens something else: ${kept.hash}`);
    }
  }

  // One lesson in depth.
  const lesson = pages.includes("sphere-sphere.html") ? "sphere-sphere.html" : pages.find(p => p in ready);
  await open(lesson);
  const first = await look();
  await browser.ask(`document.querySelector(".live details.changes").open = true`);
  const type = (name, text) => browser.ask(`(() => { const f = document.getElementById("value-${name}");
    f.focus(), f.value = ${JSON.stringify(text)}, f.dispatchEvent(new Event("change")), f.blur(); })()`);
  if (lesson === "sphere-sphere.html") {
    await type("r_a", "2,5");
    check((await look()).values.r_a === "2.5", "a number with a comma is not taken");
    await type("b", "1/2, 0, 4");
    check((await look()).values.b === "0.5,0,4", "a point is not taken: " + (await look()).values.b);
    await compare(lesson, "typed");
    await type("r_a", "round");
    check(await browser.ask(`document.querySelector(".help.refused")?.textContent.length > 10`), "a word for a number is not refused");
    check((await look()).hash.includes("r_a=2.5"), "a word was taken for a number");
    await type("r_a", "2.25");
  }
  const changed = await look();
  check(changed.hash.includes("?"), "the address does not hold the values");
  await browser.ask(`history.back()`);
  await rest(300);
  check((await look()).hash !== changed.hash, "back goes nowhere");
  await browser.ask(`history.forward()`);
  await rest(300);
  check(JSON.stringify((await look()).values) === JSON.stringify(changed.values), "forward does not bring the values back");
  await click("Undo");
  check(JSON.stringify((await look()).values) !== JSON.stringify(changed.values), "nothing is undone");
  await browser.ask(`document.querySelector('nav.settings li:last-child a').click()`);
  await rest(200);
  check(!(await look()).hash.includes("?"), "a setting of the list is not opened");
  await browser.press("p");
  await rest(50);
  check(new URL((await look()).hash, "file:///").hash !== changed.hash, "the key before goes nowhere");

  // The map of cases, lights, a finger.
  await open(lesson);
  await click("Map of cases");
  const map = await browser.ask(`(() => { const b = document.querySelector(".map .holder svg")?.getBoundingClientRect();
    return b && { x: b.x + b.width / 2, y: b.y + b.height / 2, wide: b.width }; })()`);
  check(map && map.wide > 100, "there is no map");
  if (map) {
    await browser.ask(`document.querySelector(".map").scrollIntoView({ block: "center" })`);
    const at = await browser.ask(`(() => { const b = document.querySelector(".map .holder svg").getBoundingClientRect();
      return { x: b.x + b.width / 2, y: b.y + b.height / 2 }; })()`);
    await browser.drag(at, { x: at.x + 30, y: at.y - 20 });
    await rest(50);
    check(JSON.stringify((await look()).values) !== JSON.stringify(first.values), "a drag on the map moves nothing");
    await compare(lesson, "after a drag on the map");
  }
  const lit = await browser.ask(`(() => { const name = document.querySelector(".live [data-name]");
    name.dispatchEvent(new PointerEvent("pointerover", { bubbles: true }));
    return { lit: document.querySelectorAll(".live .lit").length, sum: document.querySelector(".message").textContent }; })()`);
  check(lit.lit > 0, "no name is lit");
  await browser.send("Emulation.setTouchEmulationEnabled", { enabled: true });
  await browser.look({ width: 360, height: 740 });
  await open(lesson);
  await browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
  const before = await look(), finger = before.grips[0];
  await browser.swipe(finger, { x: finger.x - 30, y: finger.y + 20 });
  await rest(100);
  check(JSON.stringify((await look()).values) !== JSON.stringify(before.values), "a handle does not follow a finger");
  await browser.send("Emulation.setTouchEmulationEnabled", { enabled: false });

  // What is copied; paper shows a setting of one's own.
  for (const [name, holds] of [["Copy LaTeX", "\\includegraphics"], ["Copy Markdown", "!["], ["Copy alt text", "ball"], ["Copy iframe", "<iframe src="], ["Copy link", "#"]]) {
    await click(name);
    await rest(30);
    const text = await browser.ask(`document.querySelector(".share textarea").value`);
    check(text.includes(holds), `${name}: ${text.slice(0, 60)}`);
  }
  for (const width of [360, 768, 1440])
    for (const dark of [false, true]) {
      await browser.look({ width, height: 900, dark });
      await open(lesson, changed.hash.replace(/\/\d+/, "/1"));
      await browser.ask(`document.querySelectorAll(".live details").forEach(d => d.open = true)`);
      check((await look()).wide <= 0, `${width} wide: the page sticks out`);
      const ink = await browser.ask(`document.querySelector(".live .picture").outerHTML.includes("#0b60c8")`);
      check(ink !== dark, `${width} wide, ${dark ? "dark" : "light"}: the picture has the other theme`);
    }

  // No violation that axe finds, where it is at hand: AXE names its script.
  if (process.env.AXE && existsSync(process.env.AXE)) {
    const axe = readFileSync(process.env.AXE, "utf8");
    for (const page of pages)
      for (const dark of [false, true]) {
        await browser.look({ width: 1280, height: 900, dark });
        await open(page);
        await browser.ask(axe + ";0");
        const found = await browser.ask(`axe.run({ preload: false }).then(r => r.violations.map(v => v.id + ": " + v.nodes.slice(0, 3).map(n => n.target.join(" ")).join(", ")))`);
        found.forEach(fault => check(false, `${page}, ${dark ? "dark" : "light"}, axe: ${fault}`));
        check(true, page);
      }
  } else {
    console.log("axe is not at hand (AXE=.../axe.min.js)");
  }
  browser.messages.forEach(message => check(false, "the console says: " + message));
  const far = browser.requests.filter(url => !/^(file|data|about|blob):/.test(url));
  check(far.length === 0, "asked of the network: " + far[0]);
} finally {
  await browser.stop();
}
check(Object.keys(ready).length > 0, "no page comes alive");
const times = Object.values(ready).sort((a, b) => a - b);
console.log(`${checks} checks of ${times.length} live pages, ${wrong.length} wrong; ready after ${times[0]} to ${times.at(-1)} ms`);
process.exit(wrong.length === 0 ? 0 : 1);
