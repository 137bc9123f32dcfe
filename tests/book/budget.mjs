// What the pages of a live book weigh, and how long they take. node budget.mjs FOLDER [LESSON...]; prints tables.
// On a machine that does other things, too: nice -n -10 node budget.mjs FOLDER
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { Browser } from "./browser.mjs";

const folder = resolve(process.argv[2]), wanted = process.argv.slice(3);
const read = name => readFileSync(join(folder, name));
const address = page => pathToFileURL(join(folder, page)).href;
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort();
const lessons = pages.filter(page => read(page).includes("data-lesson=")).map(page => page.replace(".html", ""))
  .filter(lesson => wanted.length === 0 || wanted.includes(lesson));
const kB = bytes => (bytes / 1000).toFixed(0).padStart(6) + " kB";
const ms = time => time.toFixed(1).padStart(8);
const percentile = (list, part) => list.length ? [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(part * list.length))] : 0;

// Sizes: what a server sends, compressed by gzip.
const code = { "book.js": gzipSync(read("book.js"), { level: 9 }).length };
const packed = read("isect-packed.js").toString().match(/isect_module\.packed = "([^"]*)"/)[1];
code["live.js and emscripten's script"] = gzipSync(read("isect.js"), { level: 9 }).length;
code["WebAssembly"] = Buffer.from(packed, "base64").length;
if (existsSync(join(folder, "isect.wasm"))) console.log(kB(brotliCompressSync(read("isect.wasm")).length), "WebAssembly by brotli, of", kB(read("isect.wasm").length));
const fonts = [...read("fonts.css").toString().matchAll(/base64,([^)]*)\)/g)].map(m => Buffer.from(m[1], "base64").length);
const sum = list => list.reduce((a, b) => a + b, 0);
console.log("Sizes, compressed");
for (const [name, bytes] of Object.entries(code)) console.log(kB(bytes), name);
console.log(kB(sum(Object.values(code))), "all code");
console.log(kB(sum(fonts)), `${fonts.length} fonts, not compressed`);
console.log(kB(gzipSync(read("book.css"), { level: 9 }).length), "book.css");
const weights = pages.map(page => gzipSync(read(page), { level: 9 }).length);
console.log(kB(sum(weights)), `${pages.length} pages, the largest ${kB(Math.max(...weights)).trim()}`);

const browser = await Browser.start();
/// When a page was first painted and when it could be changed; a drag's moves run when they are told to.
await browser.send("Page.addScriptToEvaluateOnNewDocument", { source: `
  window.when = {};
  new MutationObserver(() => { if (["ready", "none"].includes(document.documentElement.dataset.live)) when.live ??= performance.now(); })
    .observe(document, { attributes: true, subtree: true, attributeFilter: ["data-live"] });` });
try {
  await browser.look({ width: 1280, height: 900 });
  const times = {};
  for (const page of ["index.html", ...lessons.map(lesson => lesson + ".html")]) {
    await browser.open("about:blank");
    await browser.open(address(page));
    times[page] = await browser.ask(`new Promise(done => {
      const look = () => {
        const painted = performance.getEntriesByName("first-contentful-paint")[0];
        if (painted && (!document.body.dataset.live || when.live)) done({ painted: painted.startTime, live: when.live ?? 0 });
        else setTimeout(look, 20);
      };
      look();
    })`);
  }
  console.log("\nms from disk until painted, until it can be changed");
  for (const [page, t] of Object.entries(times)) console.log(ms(t.painted), ms(t.live), page);

  // Each handle of each station of each preset, moved: the time until the page shows it, layout included.
  console.log("\nms a move of a handle: median, 95th percentile, most; moves; the slowest place; most of a release");
  for (const lesson of lessons) {
    await browser.open("about:blank");
    await browser.open(address(lesson + ".html"));
    await browser.ask(`new Promise(done => { const look = () => when.live ? done() : setTimeout(look, 20); look(); })`);
    const found = await browser.ask(`(async () => {
      const waiting = [], moves = [], releases = [];
      Element.prototype.setPointerCapture = () => {};
      window.requestAnimationFrame = run => waiting.push(run), window.cancelAnimationFrame = () => { waiting.length = 0; };
      const stage = document.querySelector(".live .stage"), rest = () => new Promise(done => setTimeout(done));
      const key = key => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
      const send = (to, type, x, y) => to.dispatchEvent(new PointerEvent(type,
        { clientX: x, clientY: y, button: 0, buttons: 1, pointerId: 1, pointerType: "mouse", bubbles: true, cancelable: true }));
      const timed = (list, action) => {
        const place = location.hash.split("?")[0], begin = performance.now();
        action(), stage.getBoundingClientRect();
        list.push({ time: performance.now() - begin, place });
      };
      for (const link of document.querySelectorAll("nav.settings a")) {
        location.hash = link.hash;
        await rest(), await rest();
        const end = document.querySelector(".transport .next");
        for (let station = 0; station < 80; ++station) {
          const names = [...document.querySelectorAll(".live .grip")].map(grip => grip.dataset.handle);
          for (const name of names) {
            const grip = [...document.querySelectorAll(".live .grip")].find(g => g.dataset.handle === name);
            if (!grip) continue;
            const box = grip.getBoundingClientRect(), x = box.x + box.width / 2, y = box.y + box.height / 2;
            send(grip, "pointerdown", x, y);
            for (let i = 1; i <= 4; ++i) {
              send(stage, "pointermove", x + 9 * i, y + 14 * Math.sin(i));
              timed(moves, () => waiting.splice(0).forEach(run => run()));
            }
            timed(releases, () => send(stage, "pointerup", x, y));
            [...document.querySelectorAll(".live .tools button")].find(b => b.textContent === "Undo").click();
          }
          if (end.disabled) break;
          key("ArrowRight");
        }
        await rest();
      }
      return { moves, releases };
    })()`);
    const all = found.moves.map(m => m.time), slowest = found.moves.sort((a, b) => b.time - a.time)[0];
    console.log(ms(percentile(all, 0.5)), ms(percentile(all, 0.95)), ms(percentile(all, 1)), String(all.length).padStart(6), lesson,
      slowest?.place ?? "", ms(percentile(found.releases.map(r => r.time), 1)));
  }

  // At rest nothing runs.
  const metrics = async () => Object.fromEntries((await browser.send("Performance.getMetrics")).metrics.map(m => [m.name, m.value]));
  await browser.send("Performance.enable");
  await new Promise(done => setTimeout(done, 1000));
  const before = await metrics();
  await new Promise(done => setTimeout(done, 3000));
  const after = await metrics();
  console.log("\nms in 3 s at rest: script " + ms(1000 * (after.ScriptDuration - before.ScriptDuration)) + ", all " +
    ms(1000 * (after.TaskDuration - before.TaskDuration)) + `, layouts ${after.LayoutCount - before.LayoutCount}`);
} finally {
  await browser.stop();
}
