// What the pages keep of a reader: answers come back after a reload, the first page tells how far one is and where to go on,
// files of it are saved and read, damaged ones refused; a page around a lesson hears it. And the first page itself: its
// search, its picture, what it is without scripts and on a phone. node progress.mjs FOLDER; prints what is wrong; exit
// status 1 if anything is.
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { loaded, rest } from "./live_page.mjs";

const folder = resolve(process.argv[2]), is_live = existsSync(join(folder, "isect.js"));
const host = join(folder, "..", "host-of-progress.html"), lesson = "ray-sphere", page = lesson + ".html";
let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const browser = await Browser.start();
const ask = expression => browser.ask(expression);
async function open(name, hash = "") {
  await browser.open("about:blank");
  await browser.open(pathToFileURL(join(folder, name)).href + hash);
  await ask(loaded);
}
const stored = () => ask(`["isect progress", "isect answers"].map(name => JSON.parse(localStorage.getItem(name)))`);
const all_stored = () => ask(`JSON.stringify(Object.entries(localStorage).sort())`);

/// The article on show, as its reader sees it.
const shown = `(() => {
  const article = document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown");
  const choices = [...article.querySelectorAll(".choices li")];
  return { asks: article.classList.contains("ask"), told: article.classList.contains("told"), typing: article.classList.contains("typing"),
    right: choices.findIndex(li => "right" in li.dataset), wrong: choices.findIndex(li => li.classList.contains("wrong")), count: choices.length,
    number: article.querySelector("[data-number]") !== null, reply: article.querySelector(".reply")?.textContent ?? "",
    again: [...article.querySelectorAll("button.again")].filter(b => b.getBoundingClientRect().height > 0).length,
    explained: article.querySelector("details")?.open ?? false, hash: location.hash, end: document.querySelector(".transport .next").disabled };
})()`;
const look = () => ask(shown);
/// Goes on to the next question that fits.
async function to_question(fits) {
  for (let i = 0; i < 60; ++i) {
    const now = await look();
    if (now.asks && !now.told && fits(now)) return now;
    if (now.end) return null;
    await browser.press("ArrowRight");
  }
  return null;
}
const type = text => ask(`(() => { const form = (document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown"))
  .querySelector(".typed"); form.querySelector("input").value = ${JSON.stringify(text)}, form.requestSubmit(); })()`);
const first_page = `({ begin: document.querySelector(".begin").textContent, href: document.querySelector(".begin").getAttribute("href"),
  facts: document.querySelector('li[data-of="${lesson}"] .facts').textContent, finished: document.querySelectorAll("li.finished").length,
  sum: document.querySelector(".kept p").textContent, told: document.querySelector("p.told[role=status]:is(.kept *, .go > *)").textContent })`;
const give_file = text => ask(`(async () => {
  const files = new DataTransfer(), chosen = document.querySelector(".kept input");
  files.items.add(new File([${JSON.stringify(text)}], "progress.json")), chosen.files = files.files;
  chosen.dispatchEvent(new Event("change"));
  await new Promise(done => setTimeout(done, 100));
})()`);

try {
  await browser.look({ width: 1280, height: 900 });
  await open("index.html");
  await ask("localStorage.clear()");
  await open("index.html");
  const fresh = await ask(first_page);
  check(fresh.begin.startsWith("Begin with") && fresh.finished === 0 && /^About \d+ minutes?$/.test(fresh.facts), `to a new reader it says ${JSON.stringify(fresh)}`);

  // A wrong choice and a number that was typed come back with what is said to them, and can be asked again.
  await open(page, "#two-roots");
  const choice = await to_question(now => !now.typing);
  check(choice !== null, "no question has choices");
  const missed = choice.right === 0 ? 1 : 0;
  await browser.press("abcdefgh"[missed]);
  await open(page, choice.hash);
  let now = await look();
  check(now.hash === choice.hash && now.told && now.wrong === missed && now.explained && now.again === 1, `an answer does not come back: ${JSON.stringify(now)}`);
  const [way, record] = await stored();
  check(record.answers === 1, `an answer that came back is counted again: ${record.answers}`);
  check(way.last.lesson === lesson && "#" + way.last.place === choice.hash, `the place is kept as ${JSON.stringify(way.last)}`);
  await browser.press("ArrowRight"), await browser.press("ArrowLeft");
  check((await look()).told, "a step on and back, the question is open again");
  await ask(`[...document.querySelectorAll("button.again")].find(b => b.getBoundingClientRect().height > 0).click()`);
  now = await look();
  check(!now.told && now.wrong === -1 && !now.explained && now.reply === "", `asked again, it tells ${JSON.stringify(now)}`);
  check(await ask(`document.documentElement.classList.contains("asking")`), "asked again, its setting's name is told");
  await open(page, choice.hash);
  check(!(await look()).told, "asked again and loaded again, it is answered");
  await browser.press("abcdefgh"[choice.right]);
  const typed = await to_question(one => one.number);
  check(typed !== null, "no question asks for a number");
  if (typed) {
    await type("123.25");
    const said = (await look()).reply;
    await open(page, typed.hash);
    now = await look();
    check(now.told && said.startsWith("You typed 123.25") && now.reply === said, `what was typed comes back as “${now.reply}”`);
  }

  // The first page: what was done, and where to go on. A lesson is read when its last step was shown.
  await open("index.html");
  let first = await ask(first_page);
  check(first.facts.includes("1 of 2 right") && first.facts.includes("step "), `its card says “${first.facts}”`);
  check(first.begin.startsWith("Go on with") && first.href === page + (typed ?? choice).hash, `it goes on to ${first.href}`);
  await open(page), await open("index.html");
  check((await ask(first_page)).href === first.href, "a lesson that is opened anew loses the place where its reader was");
  await open(...first.href.split(/(?=#)/));
  check((await look()).hash === (typed ?? choice).hash, "its link leads elsewhere");
  await browser.press("End");
  await open("index.html");
  first = await ask(first_page);
  check(first.finished === 1 && first.facts.includes("read to its end") && first.begin.startsWith("Go on with") && !first.href.startsWith(page),
    `after a lesson's end it says ${JSON.stringify(first)}`);
  check(first.sum.startsWith("1 of "), `in all: “${first.sum}”`);

  // The file: as the window writes it (viz/window/progress.h), and read again as it was.
  await ask(`window.saved = "", HTMLAnchorElement.prototype.click = function () { saved = { name: this.download, text: fetch(this.href).then(r => r.text()) }; }`);
  await ask(`[...document.querySelectorAll(".kept button")].find(b => b.textContent === "Save as JSON").click()`);
  const name = await ask("saved.name"), text = await ask("saved.text"), file = JSON.parse(text), own = file.lessons[lesson];
  check(name === "progress.json" && same(Object.keys(file), ["isect", "version", "lessons", "reviews", "record", "pages"]), `${name} holds ${Object.keys(file)}`);
  check(same(Object.keys(own), ["finished", "seen", "of", "right", "answered", "skipped", "solved", "exercises"]), `of a lesson it tells ${Object.keys(own)}`);
  check(own.finished && own.seen === own.of && own.right === 1 && own.answered === 2 && own.exercises > 2, `it tells ${JSON.stringify(own)}`);
  check(same(Object.keys(file.lessons), await ask(`[...document.querySelectorAll("li[data-of]")].map(li => li.dataset.of)`)), "the file has other lessons, or another order");
  const before = await stored();
  await ask("localStorage.clear()");
  await open("index.html");
  await give_file(text);
  const after = await stored();
  check(same(after[1], before[1]) && same(after[0].lessons[lesson].given, before[0].lessons[lesson].given) && same(after[0].last, before[0].last),
    `the file is read as ${JSON.stringify(after)}`);
  first = await ask(first_page);
  check(first.told.startsWith("The file is read") && first.finished === 1, `it tells ${JSON.stringify(first)}`);
  // The window's file has no "pages", and may tell more of a lesson, or less: of both the more is kept.
  const windows = { ...file, pages: undefined, lessons: { ...file.lessons, [lesson]: { ...own, finished: false, seen: 1, solved: 2 },
    rays: { ...file.lessons.rays, finished: true, seen: 9, of: 9 } }, reviews: {}, record: { ...file.record, reviews: { 1: { right: 7, of: 8 } } } };
  await give_file(JSON.stringify(windows));
  first = await ask(first_page);
  check(first.finished === 2 && first.facts.includes("read to its end") && /2 of \d+ exercises/.test(first.facts), `with the window's it tells ${JSON.stringify(first)}`);
  check(await ask(`document.querySelector('[data-review="1"] .facts')?.textContent ?? ""`) === "7 of 8 right", "a review's result is not told");

  // A damaged file is refused with a word, and nothing is lost or changed.
  const kept = await all_stored(), damaged = ["", "{", "[]", "null", "{}", JSON.stringify({ ...file, version: 2 }), JSON.stringify({ ...file, isect: "scene" }),
    JSON.stringify({ ...file, record: undefined }), JSON.stringify({ ...file, record: { ...file.record, answers: -1 } }), JSON.stringify({ ...file, lessons: { rays: 7 } }),
    JSON.stringify({ ...file, lessons: { rays: { ...own, seen: "9" } } }), JSON.stringify({ ...file, pages: { ...file.pages, lessons: { rays: {} } } }),
    text.replace(`"${lesson}": {`, `"__proto__": {`), text.replaceAll(`"${lesson}": {`, `"__proto__": {`), text.slice(0, text.length / 2)];
  for (const bad of damaged) {
    await give_file(bad);
    const { told } = await ask(first_page);
    check(told.startsWith("This file is not read: ") && told.length > 40, `“${bad.slice(0, 60)}”: ${told}`);
    check(await all_stored() === kept, `“${bad.slice(0, 60)}” has changed what was kept`);
  }
  check(await ask(`Object.keys(Object.prototype).length === 0`), "a file has changed all objects");

  // What this browser kept and can't be read is told and set aside. A record from before there was a way is read.
  await ask(`localStorage.setItem("isect progress", "{")`);
  await open("index.html");
  first = await ask(first_page);
  check(first.told.includes("can't be read") && await ask(`localStorage.getItem("isect progress, damaged")`) === "{", `damaged, it tells “${first.told}”`);
  check(first.facts.includes("1 of 2 right"), "what is damaged takes the answers along");
  await ask(`localStorage.setItem("isect progress", "[")`);
  await open(page);
  check(await ask(`document.querySelectorAll(".damage").length`) === 1, "a lesson's page does not tell what is damaged");
  await ask(`localStorage.clear(), localStorage.setItem("isect answers", JSON.stringify({ version: 1, answers: 3, lessons: { "${lesson}": {
    "haines/a": { right: true, times: 2, wrong: 1, last: 3 }, "haines/b": { right: false, times: 1, wrong: 1, last: 1 } } }, reviews: {} }))`);
  await open("index.html");
  check((await ask(first_page)).facts.includes("1 of 2 right"), "an old record is not read");

  // A page around a lesson hears answers and the end, also where the lesson may keep nothing. From disk such a frame may load
  // no script, so there its own stands in it.
  const alone = join(folder, "..", "alone-in-progress.html");
  writeFileSync(alone, readFileSync(join(folder, page), "utf8").replace(/ data-live="[^"]*"/, "").replace(
    /<script src="book.js"[^>]*><\/script>/, () => `<script>${readFileSync(join(folder, "book.js"), "utf8")}</script>`));
  for (const [sandbox, inside] of [["", `${basename(folder)}/${page}`], [` sandbox="allow-scripts"`, basename(alone)]]) {
    writeFileSync(host, `<!DOCTYPE html><title>Host</title><script>window.heard = [], addEventListener("message", event => heard.push(event.data))</script>
<iframe src="${inside}" title="Lesson" width="1000" height="800"${sandbox}></iframe>`);
    await browser.open("about:blank");
    await browser.open(pathToFileURL(host).href);
    await rest(is_live ? 4000 : 500);
    await browser.drag({ x: 12, y: 400 }, { x: 12, y: 400 }, 1);  // beside the text: the keys are the frame's
    for (let i = 0; i < 40 && await ask(`!heard.some(told => told.event === "answer")`); ++i)
      for (const key of ["a", "a", "ArrowRight"]) await browser.press(key);
    await browser.press("End");
    await rest(100);
    const heard = await ask("heard"), answer = heard.find(told => told.event === "answer"), end = heard.find(told => told.event === "end");
    check(heard.length > 1 && heard.every(told => told.isect === 1 && told.lesson === lesson), `a frame${sandbox} tells ${JSON.stringify(heard).slice(0, 300)}`);
    check(answer && answer.question.includes("/") && typeof answer.right === "boolean" && /^[a-z0-9-]+\/\d+$/.test(answer.place), `of an answer${sandbox}: ${JSON.stringify(answer)}`);
    check(end && end.progress.finished && end.progress.answered >= 1 && same(Object.keys(end.progress), Object.keys(own)), `of the end${sandbox}: ${JSON.stringify(end)}`);
  }

  // The search.
  await open("index.html");
  await ask("localStorage.clear()");
  const find = async words => {
    await ask(`(() => { const field = document.querySelector(".find input"); field.value = ${JSON.stringify(words)}, field.dispatchEvent(new Event("input")); })()`);
    return ask(`[...document.querySelectorAll(".found li")].map(li => [li.querySelector("small").textContent, li.querySelector("b").textContent, li.querySelector("a").getAttribute("href")])`);
  };
  check((await find("ray and sphere"))[0]?.[2] === page, `“ray and sphere” finds ${JSON.stringify(await find("ray and sphere"))}`);
  const [term] = await find("back face");
  check(term?.[0] === "Term" && term[2].startsWith("glossary.html#term-"), `“back face” finds ${JSON.stringify(term)}`);
  check((await find("no such thing")).length === 0 && (await find("")).length === 0, "nothing finds something");
  if (term) {
    await open(...term[2].split(/(?=#)/));
    check(await ask(`document.querySelector(":target")?.textContent`) === "back face", "a term's link leads elsewhere");
  }

  // The picture: it is there from the beginning, and where the lessons are compiled, its rings move it once all else is done.
  await browser.look({ width: 390, height: 844 });
  await browser.open("about:blank");
  let asked = Infinity, came = 0;
  browser.listeners.push((method, { request, timestamp } = {}) => method === "Network.requestWillBeSent" && request.url.endsWith("isect.js") && Boolean(asked = timestamp));
  browser.listeners.push((method, { timestamp } = {}) => method === "Page.loadEventFired" && Boolean(came = timestamp));
  await browser.open(pathToFileURL(join(folder, "index.html")).href);
  const place = `JSON.stringify([".begin", ".hero figure", "ol.lessons li"].map(one => Math.round(document.querySelector(one).getBoundingClientRect().top)))`;
  const places = await ask(place), verdict = `document.querySelector(".hero .outcome").textContent.trim()`, static_verdict = await ask(verdict);
  check(static_verdict !== "", "the picture has no verdict");
  check(await ask(`document.querySelector(".begin").getBoundingClientRect().bottom`) <= 844, "on a phone, Begin is not on the first screen");
  check(await ask(`document.documentElement.scrollWidth - document.documentElement.clientWidth`) <= 0, "on a phone the first page is too wide");
  check(await ask(`[...document.querySelectorAll(".review-link")].every(link => link.getBoundingClientRect().height < 200)`), "a review is an empty tile");
  if (is_live) {
    const state = await ask(`new Promise(done => { const look = () => document.querySelector(".hero").dataset.state ? done(document.querySelector(".hero").dataset.state) : setTimeout(look, 20); look(); })`);
    check(state === "ready", `the picture is ${state}`);
    check(came > 0 && asked > came && asked < Infinity, "the lessons are asked for before the page has come");
    check(await ask(verdict) === static_verdict, `its verdict becomes “${await ask(verdict)}”, and was “${static_verdict}”`);
    check(await ask(place) === places, `the page jumps from ${places} to ${await ask(place)}`);
    const grips = await ask(`[...document.querySelectorAll(".hero .ring")].map(ring => { const box = ring.getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 }; })`);
    check(grips.length > 2, `it has ${grips.length} rings`);
    const verdicts = new Set([static_verdict]);
    for (const grip of grips) {
      await browser.drag(grip, { x: grip.x + 20, y: grip.y - 70 });
      await rest(100);
      verdicts.add(await ask(verdict));
    }
    check(verdicts.size > 1, `dragged, its verdict stays ${[...verdicts]}`);
    check(await ask(place) === places, "dragged, the page jumps");
    await ask(`document.querySelector(".hero .hint button").click()`);
    check(await ask(verdict) === static_verdict, "as it was, its verdict is another");
    await ask(`document.querySelector(".hero .grip").focus()`);
    const picture = await ask(`document.querySelector(".hero .picture").outerHTML`);
    await browser.press("ArrowUp"), await rest(600);
    check(await ask(`document.querySelector(".hero .picture").outerHTML`) !== picture && await ask(`document.activeElement.matches(".grip")`), "keys do not move it");
  }

  // Without scripts: picture, verdict and where to begin; nothing that can't be used.
  await browser.look({ width: 390, height: 844, scripts: false });
  await open_plain("index.html");
  await browser.look({ width: 390, height: 844, scripts: true });  // to ask; none of the page's own has run
  const plain = await ask(`({ verdict: ${verdict}, begin: document.querySelector(".begin").getAttribute("href"), buttons: document.querySelectorAll("button, input").length,
    kept: document.querySelectorAll(".kept").length, wide: document.documentElement.scrollWidth - document.documentElement.clientWidth })`);
  check(plain.verdict === static_verdict && plain.begin.endsWith(".html") && plain.buttons === 0 && plain.kept === 0 && plain.wide <= 0,
    `without scripts it is ${JSON.stringify(plain)}`);
  browser.messages.forEach(message => check(false, "the console says: " + message));
} finally {
  rmSync(host, { force: true }), rmSync(join(folder, "..", "alone-in-progress.html"), { force: true });
  await browser.stop();
}
async function open_plain(name) {
  await browser.open("about:blank");
  await browser.open(pathToFileURL(join(folder, name)).href);
}
console.log(`${checks} checks of progress and the first page, ${wrong} wrong`);
process.exit(wrong === 0 ? 0 : 1);
