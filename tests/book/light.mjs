// A page is light: it opens with few elements; what waits as text becomes the same page when it is opened, in any order; from a
// server a browser takes WebAssembly as it is, from disk the same packed; and its handles are soon there. All pages of a folder:
// node light.mjs FOLDER; prints what is wrong, and what a page takes; exit status 1 if anything is wrong. Every third lesson is
// opened whole; with ISECT_LONG=1, all.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { loaded } from "./live_page.mjs";

const folder = resolve(process.argv[2]), most_elements = 3000, slower = 6, most_seconds = 2;
const text_of = page => readFileSync(join(folder, page), "utf8"), address = page => pathToFileURL(join(folder, page)).href;
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort();
const lessons = pages.filter(page => text_of(page).includes('<section class="walk')), lives = text_of(lessons[0]).includes("data-live=");
const every = process.env.ISECT_LONG === "1";
let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}

/// Ids that stand twice, and pictures that refer to what is not in the page.
const linked = `(() => {
  const seen = new Set(), out = [];
  for (const { id } of document.querySelectorAll("[id]")) (seen.has(id) ? out.push("twice: " + id) : seen.add(id));
  for (const use of document.querySelectorAll("use")) if (!seen.has(use.getAttribute("href").slice(1))) out.push("missing: " + use.getAttribute("href"));
  return out.slice(0, 5);
})()`;
/// All pictures of a page, with what they refer to in its place. What stands in "live" is none of the page's own.
const pictures = `(() => {
  const written = node => [...node.childNodes].map(part => part.nodeName !== "use" && part.nodeType === 1 && part.nodeName !== "g" ? part.outerHTML
    : part.nodeName === "use" ? written(document.getElementById(part.getAttribute("href").slice(1))) : part.nodeName === "g" ? written(part) : "").join("");
  const sum = text => { let h = 0; for (let i = 0; i < text.length; ++i) h = (Math.imul(h, 31) + text.charCodeAt(i)) | 0; return h; };
  return Object.fromEntries([...document.querySelectorAll("article[id]")].map(a => [a.id, a.querySelector(".picture") ? sum(written(a.querySelector(".picture"))) : 0]));
})()`;
const count = `document.querySelectorAll("*").length`;

const browser = await Browser.start(), beginning = Date.now(), elements = {};
const open = async at => (await browser.open("about:blank"), await browser.open(at), await browser.ask(loaded));
/// Of the main thread, in s; a page of its own begins at 0.
const processor = async () => {
  const metrics = Object.fromEntries((await browser.send("Performance.getMetrics")).metrics.map(m => [m.name, m.value]));
  return metrics.ThreadTime ?? metrics.TaskDuration;
};
try {
  await browser.look({ width: 1280, height: 900 });
  for (const page of pages) {
    await open(address(page));
    elements[page] = await browser.ask(count);
    check(elements[page] < most_elements, `${page} opens with ${elements[page]} elements`);
    for (const fault of await browser.ask(linked)) check(false, `${page}, opened: ${fault}`);
  }

  // Without scripts all stands there; opened from the last setting to the first it is the same, and so are all pictures.
  for (const page of lives ? [] : lessons.filter((_, i) => every || i % 3 === 0)) {
    await browser.look({ scripts: false });
    await browser.open(address(page));
    const whole = await browser.ask(pictures);
    await browser.look({ scripts: true });
    await open(address(page));
    for (const setting of (await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`)).reverse()) {
      await browser.ask(`location.hash = ${JSON.stringify(setting)}, new Promise(done => setTimeout(done, 20))`);
      check(await browser.ask(`"#" + document.querySelector(".walk.shown").id`) === setting, `${page}${setting} is not opened`);
    }
    await browser.ask(`document.querySelector(".transport .whole").click()`);
    const made = await browser.ask(pictures), ids = Object.keys(whole);
    check(ids.length > 3 && ids.length === Object.keys(made).length, `${page}: ${Object.keys(made).length} stations of ${ids.length}`);
    const other = ids.find(id => made[id] !== whole[id]);
    check(!other, `${page}: another picture at ${other}`);
    for (const fault of await browser.ask(linked)) check(false, `${page}, all opened: ${fault}`);
    check(await browser.ask(`document.querySelector("#main noscript") === null`), `${page}: something still waits`);
  }

  if (lives) {
    // Handles are soon there. Other programs run beside a test: what counts is the processor time of the page's own thread, of
    // two openings the shorter; the time on a slower processor is told.
    await browser.send("Performance.enable");
    let most = 0, longest = 0;
    for (const page of lessons) {
      const times = [];
      for (let i = 0; i < 2; ++i) {
        await browser.open(address("glossary.html"));
        const before = await processor();
        await browser.open(address(page));
        await browser.ask(loaded);
        const after = await processor();
        times.push(after < before ? after : after - before);
      }
      const seconds = slower * Math.min(...times);
      check(seconds < most_seconds, `${page}: its handles take ${seconds.toFixed(2)} s of a processor ${slower} times slower`);
      most = Math.max(most, seconds);
    }
    await browser.send("Emulation.setCPUThrottlingRate", { rate: slower });
    for (const page of lessons.filter((_, i) => i % 6 === 0)) {
      await browser.open("about:blank");
      await browser.open(address(page));
      await browser.ask(loaded);
      longest = Math.max(longest, await browser.ask("performance.now()"));
    }
    await browser.send("Emulation.setCPUThrottlingRate", { rate: 1 });
    console.log(`handles after ${most.toFixed(2)} s of a processor ${slower} times slower or less; by the clock, with all else here, ${(longest / 1000).toFixed(2)} s`);

    // From a server, which is told here: no port is opened. Where it has no such file, or calls it by another type, the packed one does.
    let served = {};
    const types = { html: "text/html", js: "text/javascript", css: "text/css", wasm: "application/wasm" };
    browser.listeners.push((method, params) => {
      if (method !== "Fetch.requestPaused") return false;
      const name = new URL(params.request.url).pathname.slice(1), ending = name.split(".").pop(), found = !served.lacks?.includes(name) && existsSync(join(folder, name));
      browser.send("Fetch.fulfillRequest", { requestId: params.requestId, responseCode: found ? 200 : 404,
        responseHeaders: [{ name: "Content-Type", value: served.types?.[ending] ?? types[ending] ?? "text/plain" }],
        body: found ? readFileSync(join(folder, name)).toString("base64") : "" }).catch(() => {});
      return false;
    });
    await browser.send("Network.setCacheDisabled", { cacheDisabled: true });
    await browser.send("Fetch.enable", { patterns: [{ urlPattern: "http://isect.test/*" }] });
    const asked = async (how, page) => {
      served = how, browser.requests.length = 0;
      const state = await open("http://isect.test/" + page);
      return { state, files: browser.requests.map(url => url.split("/").pop()) };
    };
    const script = { [lessons[0]]: "isect", ...(existsSync(join(folder, "scene.html")) ? { "scene.html": "scenes" } : {}) };
    for (const [page, name] of Object.entries(script)) {
      const plain = await asked({}, page);
      check(plain.state === "ready" && plain.files.includes(name + ".wasm") && !plain.files.includes(name + "-packed.js"),
        `${page} from a server: ${plain.state}, ${plain.files}`);
    }
    for (const how of [{ types: { wasm: "application/octet-stream" } }, { lacks: ["isect.wasm"] }]) {
      const other = await asked(how, lessons[0]);
      check(other.state === "ready" && other.files.includes("isect-packed.js") === Boolean(how.lacks), `from a server with ${JSON.stringify(how)}: ${other.state}, ${other.files}`);
    }
    check((await asked({ lacks: ["isect.wasm", "isect-packed.js"] }, lessons[0])).state === "none", "without any WebAssembly a page calls itself live");
    await browser.send("Fetch.disable");

    // A page tells that it loads, and where it can't: it stays what it was.
    const states = async source => {
      const { identifier } = await browser.send("Page.addScriptToEvaluateOnNewDocument", { source: source +
        `; window.heard = [], document.addEventListener("isect:live", event => heard.push("told " + event.detail.state));
        new MutationObserver(() => { const state = document.documentElement?.dataset.live; if (state && heard.at(-1) !== state) heard.push(state); })
          .observe(document, { attributes: true, subtree: true, attributeFilter: ["data-live"] });` });
      await open(address(lessons[0]));
      await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });
      return (await browser.ask("heard")).join(", ");
    };
    const told = await states(""), blocked = await states("delete window.WebAssembly");
    check(told === "loading, told ready, ready", `a page tells ${told}`);
    check(blocked.endsWith("told none, none"), `without WebAssembly a page tells ${blocked}`);
    await browser.press("ArrowRight");
    check(/\/2(\/question)?$/.test(await browser.ask(`document.querySelector(".walk.shown > .steps > article.shown").id`)), "without WebAssembly a page is not stepped");

    // Paper and reading show where a live page stands, though its own walks wait.
    await open(address(lessons[0]));
    const last = await browser.ask(`[...document.querySelectorAll("nav.settings a")].at(-1).hash`);
    await browser.ask(`document.querySelector('nav.settings a[href="${last}"]').click(), new Promise(done => setTimeout(done, 50))`);
    await browser.press("ArrowRight");
    check(await browser.ask(`document.getElementById(${JSON.stringify(last.slice(1))}) === null`), "a live page makes what it does not show");
    await browser.ask(`dispatchEvent(new Event("beforeprint"))`);
    check(await browser.ask(`document.querySelector(".walk.shown:not(.live)")?.id`) === last.slice(1), "paper shows another setting");
    await browser.ask(`document.querySelector(".transport .whole").click()`);
    check(await browser.ask(`document.querySelector("#main noscript") === null`), "read as a whole, something still waits");
  }
} finally {
  await browser.stop();
}
const [page, largest] = Object.entries(elements).sort((a, b) => b[1] - a[1])[0];
console.log(`${checks} checks of ${pages.length} pages in ${((Date.now() - beginning) / 1000).toFixed(0)} s, ${wrong} wrong; at most ${largest} elements, ${page}`);
process.exit(wrong === 0 && lessons.length > 0 ? 0 : 1);
