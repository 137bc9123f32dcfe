// Pages whose lessons run in the browser. node live.mjs FOLDER ISECT; prints what is wrong; exit status 1 if anything is.
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { LivePages, rest } from "./live_page.mjs";

const [folder, isect] = process.argv.slice(2);
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort();
const site = await LivePages.start(folder, isect), browser = site.browser;
const check = (holds, what) => site.check(holds, what), look = () => site.look(), click = text => site.click(text);
const open = (page, hash) => site.open(page, hash), same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/// What the exact answer is for the values of a page: of each lesson whether the two meet.
const point = text => text.split(",").map(Number);
const interval = (lo, hi) => [lo, hi].map(text => Math.abs(Number(text)) < Infinity ? Number(text) : text);
const capsule = (v, name) => ({ p: point(v["p_" + name]), q: point(v["q_" + name]), r: Number(v["r_" + name]) });
const queries = {
  "intervals.html": v => ({ kind: "interval_interval", a: interval(v.a_min, v.a_max), b: interval(v.b_min, v.b_max) }),
  "sphere-sphere.html": v => ({ kind: "sphere_sphere", c1: point(v.a), r1: Number(v.r_a), c2: point(v.b), r2: Number(v.r_b) }),
  "aabb-aabb.html": v => ({ kind: "box_box", alo: point(v.a_min), ahi: point(v.a_max), blo: point(v.b_min), bhi: point(v.b_max) }),
  "sphere-aabb.html": v => ({ kind: "sphere_box", center: point(v.c), radius: Number(v.r), lo: point(v.b_min), hi: point(v.b_max) }),
  "capsule-capsule.html": v => ({ kind: "capsule_capsule", a: capsule(v, "a"), b: capsule(v, "b") }),
  "ray-sphere.html": v => ({ kind: "ray_sphere", origin: point(v.origin), dir: point(v.direction), center: point(v.center),
    radius: Number(v.radius), ...(v.extent === "segment" ? { tmax: Number(v.t_max) } : {}) })
};
async function compare(page, how) {
  await browser.press("End");
  let now = await look();
  while (!now.yes && !now.no && !now.hash.includes("/1?")) {
    await browser.press("ArrowLeft");
    const before = now.hash;
    now = await look();
    if (now.hash === before) break;
  }
  const { result } = JSON.parse(site.native(["query"], JSON.stringify(queries[page](now.values)) + "\n"));
  const truth = result.intersects ?? result.ray_hit;
  check(now.yes === truth && now.no === !truth, `${page}, ${how}: "${now.verdict}", but they ${truth ? "meet" : "do not meet"}`);
}
/// Every verdict of the setting that is shown is the native program's.
const letters = text => text.replace(/[\s.,:]/g, "").toLowerCase();
async function compare_native(lesson, how) {
  await browser.press("Home");
  const told = [];
  let now = await look();
  for (let i = 0; i < 80; ++i) {
    if (now.verdict) told.push(now.verdict);
    if (now.end) break;
    await browser.press("ArrowRight");
    now = await look();
  }
  const [path, query] = now.hash.slice(1).split("?");
  const changes = [...new URLSearchParams((query ?? "").replaceAll("+", "%2B"))].filter(([name]) => name !== "camera");
  const native = site.native(["explain", lesson, "--brief", "--preset", path.split("/")[0], ...changes.flatMap(([name, text]) => ["--set", `${name}=${text}`])]);
  const verdicts = native.split(/^(?=Step )/m).slice(1).map(letters).filter(step => step.includes("verdict"));
  // The map of cases shows the verdict again, beside the words of its own.
  check(told.length >= verdicts.length && told.every(verdict => verdicts.some(step => step.includes("verdict" + letters(verdict)))),
    `${lesson}, ${how}, ${now.hash}: ${JSON.stringify(told)}; natively ${JSON.stringify(verdicts)}`);
  return told.length;
}

const ready = {};
let compared = 0, typed = 0;
try {
  await browser.look({ width: 1280, height: 900 });
  for (const page of pages) {
    if (page === "scene.html") continue;  // scene.mjs
    const begun = Date.now(), state = await open(page);
    if (state === "static") continue;
    ready[page] = Date.now() - begun;
    check(state === "ready", `${page}: the lessons do not run`);
    if (state !== "ready") continue;

    // Stepped to its end, the questions answered; never wider than the page.
    let last = "";
    for (let i = 0; i < 80; ++i) {
      const now = await look();
      check(now.wide <= 0, `${page} ${now.hash}: ${now.wide} px too wide`);
      check(now.picture > 300, `${page} ${now.hash}: there is no picture`);
      check(now.hash !== last || i === 0, `${page} ${now.hash}: the address stays`);
      if (now.asks) {
        check(now.right >= 0, `${page} ${now.hash}: no choice is right`);
        if (now.typing) {
          await site.type("not a number");
          check((await look()).asks && !(await look()).told && (await look()).help.includes("not read"), `${page} ${now.hash}: words are an answer`);
          ++typed;
          if (now.pointed) {  // every other line is clicked
            const line = now.pointed.offered[typed % 2 ? now.pointed.choice : 0];
            check(now.pointed.replies.length === now.code, `${page} ${now.hash}: ${now.code} lines of code`);
            if (typed % 2) await site.type(String(line + 1));
            else await browser.ask(`document.querySelectorAll(".live ol.code li")[${line}].click()`);
          } else if (now.order) {
            check(now.order.tiles.length === now.tiles, `${page} ${now.hash}: ${now.tiles} tiles`);
            const order = now.order.offered[typed % 2 ? now.order.choice : 0];
            if (typed % 2) await site.type(order);
            else await browser.ask(`(() => { const form = document.querySelector(".live .typed"), tiles = document.querySelectorAll(".live .tiles button");
              form.querySelector("input").value = "", [...${JSON.stringify(order)}].forEach(letter => tiles[letter.charCodeAt(0) - 97].click()), form.requestSubmit(); })()`);
          } else await site.type(typed % 2 && now.number.wrong.length ? String(now.number.wrong[0][0]) : String(now.number.right[0]));
          check(/You (typed|pointed)|Your order/.test((await look()).typed), `${page} ${now.hash}: what was given is not told`);
        } else await browser.press("abcdefgh"[now.right]);
        check((await look()).told, `${page} ${now.hash}: the answer is not told`);
      }
      if (now.end) break;
      last = now.hash;
      await browser.press("ArrowRight");
    }
    check((await look()).end, `${page}: its end is not reached`);

    // An exercise that begins at a step has something to take hold of there.
    for (const start of await browser.ask(`[...document.querySelectorAll(".exercises .start a")].map(a => a.hash)`)) {
      await browser.ask(`location.hash = ${JSON.stringify(start)}`);
      await rest(30);
      const now = await look();
      check(now.hash.startsWith(start) && (now.grips.length > 0 || !start.includes("/")), `${page}: its exercise at ${start} has no handle`);
    }

    // A handle, dragged by mouse and by keys; the verdicts are the native ones; the link opens that very setting.
    await browser.press("Home");
    let now = await look();
    for (let i = 0; i < 12 && now.grips.length === 0 && !now.end; ++i) await browser.press("ArrowRight"), now = await look();
    if (now.grips.length === 0) continue;
    const { before, dragged, pushed, name } = await site.move_a_handle();
    check(!same(dragged.values, before.values) || dragged.message !== "", `${page}: ${name} does not follow the mouse`);
    const moved = pushed.grips.find(grip => grip.name === name)?.label ?? "";  // told, and then why it stays where it does
    check(pushed.message.startsWith(moved), `${page}: ${moved} is told as “${pushed.message}”`);
    check(!same(pushed.values, dragged.values) || pushed.message !== moved, `${page}: ${name} does not follow the keys`);
    if (queries[page]) await compare(page, "after a drag");
    compared += await compare_native(page.replace(".html", ""), "after a drag");
    if (pushed.hash.includes("?")) {
      const kept = await look();
      check(await open(page, kept.hash) === "ready", `${page}: its link does not open`);
      const again = await look();
      check(same(again.values, kept.values) && again.title === kept.title && again.hash === kept.hash,
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
    await type("b", "(1/2, 0, 4)");
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
  check(same((await look()).values, changed.values), "forward does not bring the values back");
  await click("Undo");
  check(!same((await look()).values, changed.values), "nothing is undone");
  await browser.ask(`document.querySelector('nav.settings li:last-child a').click()`);
  await rest(200);
  check(!(await look()).hash.includes("?"), "a setting of the list is not opened");
  await browser.press("p");
  await rest(50);
  check((await look()).hash.startsWith("#" + await browser.ask(`document.querySelector('nav.settings li:nth-last-child(2) a').hash.slice(1)`) + "/"),
    "the key p does not open the setting before: " + (await look()).hash);

  // A link that is no longer good says which part of it.
  if (lesson === "sphere-sphere.html") {
    await open(lesson, "#disjoint/1?r_a=round");
    const told = () => browser.ask(`document.querySelector(".message").textContent`);
    check((await told()).startsWith("r_a: "), "a bad link does not say what is wrong");
    for (const hash of ["#nopreset?r_a=1", "#%zz"]) {
      await open(lesson, hash);
      check((await told()).includes(hash.slice(1, 4)) && (await look()).grips.length > 0, `${hash} is not refused: ${await told()}`);
    }
  }

  // A program with one wrong line: its correction unfolds where the program errs, not before.
  // That is told to other scripts, as is that the page can be changed.
  if (lesson === "sphere-sphere.html") {
    const { identifier } = await browser.send("Page.addScriptToEvaluateOnNewDocument", { source: `window.heard = { live: [], solved: [] };
      for (const name in heard) document.addEventListener("isect:" + name, event => heard[name].push(event.detail));` });
    await open(lesson, "#disjoint");
    await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
    const correction = () => browser.ask(`[...document.querySelectorAll(".exercises details")].find(d => d.textContent.startsWith("Correction"))?.open`);
    check(await correction() === false, "a correction is not there, or open before it is asked for");
    await type("b", "1.015625,0,-0.76171875");
    await rest(50);
    const said = await browser.ask(`document.querySelector(".exercises .solved")?.textContent`);
    check(await correction() === true && said?.includes("The program says DISJOINT, the exact test OVERLAP."), "a program errs, and its correction stays hidden: " + said);
    const heard = await browser.ask("heard"), solved = await browser.ask(`[...document.querySelectorAll(".exercises > ol > li")]
      .flatMap((li, i) => li.querySelector(".solved") ? [{ exercise: i + 1 }] : [])`);
    check(same(heard.live, [{ state: "ready" }]), `of a live page is heard ${JSON.stringify(heard.live)}`);
    check(solved.length > 0 && same(heard.solved, solved), `of solved exercises is heard ${JSON.stringify(heard.solved)}, not ${JSON.stringify(solved)}`);
  }

  // Snap: a drag stops where the case changes, by button as by Shift.
  const ends = [];
  for (const [button, keys] of [[false, 0], [true, 0], [false, 8]]) {
    await open(lesson);
    await browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
    if (button) await click("Snap");
    const { grips: [, b] } = await look();
    await browser.drag(b, { x: b.x + 150, y: b.y }, 8, keys);
    await rest(1000);
    ends.push((await look()).values);
  }
  check(!same(ends[0], ends[1]), "Snap does not hold a handle");
  check(same(ends[1], ends[2]), "Shift holds a handle elsewhere than Snap");

  // Time within a step: scrubbed below the picture, run by its button, from still to still where less motion is wanted.
  if (pages.includes("moving-bodies.html")) {
    const time = () => browser.ask(`(() => {
      const bar = document.querySelector(".live .time"), box = bar.getBoundingClientRect(), picture = document.querySelector(".live .picture");
      const slide = bar.querySelector("input"), mark = bar.querySelector(".contact"), line = slide.getBoundingClientRect();
      return { seen: box.height > 0 && getComputedStyle(bar).visibility === "visible", under: box.top - picture.getBoundingClientRect().bottom,
        low: document.querySelector(".transport").getBoundingClientRect().top - box.bottom, told: bar.querySelector(".time-told").textContent,
        share: Number(slide.value), name: bar.querySelector("button").title, picture: picture.outerHTML,
        mark: mark.hidden ? -1 : (mark.getBoundingClientRect().left - line.left) / line.width };
    })()`);
    const scrub = share => browser.ask(`(() => { const slide = document.querySelector(".live .time input");
      slide.value = ${share}, slide.dispatchEvent(new Event("input")); })()`);
    const push = () => browser.ask(`document.querySelector(".live .time button").click()`);
    for (const size of [{ width: 1366, height: 768 }, { width: 390, height: 844 }]) {
      const at = `time, ${size.width} wide: `;
      await browser.look(size);
      await open("moving-bodies.html", "#boxes-meet/8");
      const still = await time();
      check(still.seen && still.under >= -1 && still.low >= -1, at + `it stands ${still.under} px below the picture, ${still.low} px above the bar`);
      check(Math.abs(still.mark - 0.8125) < 0.06, at + `the contact is marked at ${still.mark}`);
      check(still.told === "t = 0 (contact at t = 1.625)" && still.share === 0, at + `it opens with "${still.told}"`);
      await scrub(0.5);
      const half = await time();
      check(half.told === "t = 1 (contact at t = 1.625)" && half.picture !== still.picture, at + `half of it is "${half.told}"`);
      check((await look()).hash === "#boxes-meet/8", at + "it changes the address before it rests");
      await browser.ask(`document.querySelector(".live .time input").dispatchEvent(new Event("change"))`);
      check((await look()).hash === "#boxes-meet/8?time=1", at + `at rest its address is ${(await look()).hash}`);
      await scrub(0.811);
      check((await time()).told === "t = 1.625 (contact)", at + `next to the contact it says "${(await time()).told}"`);
      await scrub(1);
      check((await time()).told.startsWith("t = 2 "), at + `its end is "${(await time()).told}"`);
      await push();
      await rest(400);
      const runs = await time();
      check(runs.share > 0 && runs.share < 0.6 && runs.name === "Stop time", at + `after 0.4 s it is at ${runs.share}, and can be told: ${runs.name}`);
      await push();
      const stopped = await time();
      await rest(150);
      check((await time()).share === stopped.share, at + "it does not stop");
      await push();
      await browser.press("ArrowLeft");
      await rest(150);
      check(!(await time()).seen || (await time()).share === 0, at + "it runs on in another step");
      await open("moving-bodies.html", "#boxes-meet/7/question");
      check(!(await time()).seen, at + "it is seen while a question is open");
    }
    await browser.look({ width: 1366, height: 768, calm: true });
    await open("moving-bodies.html", "#boxes-meet/8");
    const stills = [];
    for (let i = 0; i < 6; ++i) {
      await push();
      stills.push((await time()).share);
      await rest(100);
    }
    check(same(stills, [0.25, 0.5, 0.75, 0.8125, 1, 0]) && (await time()).share === 0, `where less motion is wanted, the stills are ${stills}`);
    await browser.look({ width: 1280, height: 900 });
    await open("moving-bodies.html", "#boxes-meet/8?time=1.25");
    check((await time()).told === "t = 1.25 (contact at t = 1.625)", `a link with a time opens "${(await time()).told}"`);
    await open("moving-bodies.html", "#boxes-meet/8?time=7");
    const refused = await browser.ask(`document.querySelector(".live .message").textContent`);
    check(refused.includes("from 0 to 2") && (await time()).share === 0, `a link beyond the motion is told "${refused}"`);
    await open(lesson);
    if (lesson !== "moving-bodies.html") check(!(await time()).seen, `${lesson} has a time`);
  }

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
    check(!same((await look()).values, first.values), "a drag on the map moves nothing");
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
  const scrolled = await browser.ask("window.taken = 0, addEventListener('pointercancel', () => ++taken, true), scrollY");
  await browser.swipe(finger, { x: finger.x, y: finger.y + 60 });
  await rest(100);
  const dragged = await look();
  check(!same(dragged.values, before.values), "a handle does not follow a finger");
  check(await browser.ask("taken") === 0 && await browser.ask("scrollY") === scrolled, "the page scrolls where a finger drags a handle");

  // Keys move a handle for as long as they are pressed: it keeps the focus, and the step stays.
  await browser.ask(`document.querySelector(".live .grip").focus()`);
  for (let i = 0; i < 3; ++i) await browser.press("ArrowRight"), await rest(30);
  await rest(600);
  check(await browser.ask(`document.activeElement.matches(".grip")`) && (await look()).hash.split("?")[0] === dragged.hash.split("?")[0],
    "a handle moved by keys loses the focus");
  await browser.send("Emulation.setTouchEmulationEnabled", { enabled: false });

  // Play goes on by itself, and stops at a question.
  await browser.look({ width: 1280, height: 900 });
  await open(lesson);
  await browser.press(" ");
  await rest(2200);
  check((await look()).hash !== first.hash, "play does not go on");
  const stops = Date.now() + 40000;
  while (!(await look()).asks && !(await look()).end && Date.now() < stops) await rest(200);
  const stopped = await look();
  await rest(2200);
  check((await look()).hash === stopped.hash, "play does not stop at " + stopped.hash);

  // At rest nothing runs.
  await browser.send("Performance.enable");
  const metrics = async () => Object.fromEntries((await browser.send("Performance.getMetrics")).metrics.map(m => [m.name, m.value]));
  const then = await metrics();
  await rest(2000);
  const later = await metrics();
  check(later.LayoutCount === then.LayoutCount && later.RecalcStyleCount === then.RecalcStyleCount && later.ScriptDuration - then.ScriptDuration < 0.002,
    `at rest something runs: ${later.LayoutCount - then.LayoutCount} layouts, ${later.ScriptDuration - then.ScriptDuration} s of scripts`);

  // What is saved.
  await browser.ask(`window.saved = [], HTMLAnchorElement.prototype.click = function () {
    const name = this.download; saved.push(fetch(this.href).then(r => r.arrayBuffer()).then(b => ({ name, bytes: [...new Uint8Array(b)] }))); }`);
  for (const button of ["Save SVG", "Save PNG"]) {
    await click(button);
    for (let i = 0; i < 50 && await browser.ask("saved.length") === 0; ++i) await rest(100);
    const { name, bytes } = await browser.ask("saved.pop()");
    const text = Buffer.from(bytes).toString("latin1"), png = button === "Save PNG";
    check(name.endsWith(png ? ".png" : ".svg") && (png ? text.startsWith("\x89PNG") && bytes.length > 20000
      : text.startsWith("<svg xmlns=") && text.includes("@font-face") && !text.includes("var(")), `${button}: ${name}, ${bytes.length} bytes`);
    if (process.env.PICTURES) writeFileSync(join(process.env.PICTURES, name), Buffer.from(bytes));
  }

  // What is copied.
  for (const [name, holds] of [["Copy LaTeX", "\\includegraphics"], ["Copy Markdown", "!["], ["Copy alt text", "ball"], ["Copy iframe", "<iframe src="], ["Copy link", "#"]]) {
    await click(name);
    await rest(30);
    const text = await browser.ask(`document.querySelector(".share textarea").value`);
    check(text.includes(holds), `${name}: ${text.slice(0, 60)}`);
  }
  // On paper: a setting of one's own with all of its steps.
  for (const [paper, width, height] of [["A4", 8.27, 11.69], ["Letter", 8.5, 11]]) {
    await open(lesson, changed.hash);
    const { data } = await browser.send("Page.printToPDF", { paperWidth: width, paperHeight: height });
    const pdf = Buffer.from(data, "base64").toString("latin1"), sheets = (pdf.match(/\/Type\s*\/Page\b/g) ?? []).length;
    check(pdf.startsWith("%PDF") && sheets >= 3 && sheets <= 12, `${paper}: ${sheets} sheets`);
    if (process.env.PICTURES) writeFileSync(join(process.env.PICTURES, paper + ".pdf"), Buffer.from(data, "base64"));
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
      for (const [width, dark] of [[1280, false], [1280, true], [390, false]]) {
        await browser.look({ width, height: 900, dark });
        await open(page);
        await browser.ask(`document.querySelectorAll(".live details").forEach(d => d.open = true)`);
        await browser.ask(axe + ";0");
        const found = await browser.ask(`axe.run({ preload: false }).then(r => r.violations.map(v => v.id + ": " + v.nodes.slice(0, 3).map(n => n.target.join(" ")).join(", ")))`);
        found.forEach(fault => check(false, `${page}, ${width} wide, ${dark ? "dark" : "light"}, axe: ${fault}`));
        check(true, page);
      }
  } else {
    console.log("axe is not at hand (AXE=.../axe.min.js)");
  }
  site.check_silence();
} finally {
  await browser.stop();
}
check(Object.keys(ready).length > 0, "no page comes alive");
check(compared > 20, `${compared} verdicts compared`);
const times = Object.values(ready).sort((a, b) => a - b);
console.log(`${site.checks} checks of ${times.length} live pages, ${compared} verdicts as native, ${site.wrong.length} wrong; ready after ${times[0]} to ${times.at(-1)} ms`);
process.exit(site.wrong.length === 0 ? 0 : 1);
