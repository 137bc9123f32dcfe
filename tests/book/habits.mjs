// What people expect of a live page: a question stays one, keys step, Back goes back, a drag tells its verdict at once, a
// frame leaves the page around it alone. node habits.mjs FOLDER ISECT; prints what is wrong; exit status 1 if anything is.
import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { LivePages, rest } from "./live_page.mjs";

const [folder, isect] = process.argv.slice(2);
const site = await LivePages.start(folder, isect), browser = site.browser;
const check = (holds, what) => site.check(holds, what), same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const lessons = readdirSync(folder).filter(name => name.endsWith(".html") && name !== "scene.html").sort()
  .filter(name => readFileSync(join(folder, name), "utf8").includes("data-live="));

/// What can be seen that may tell the answer of a question.
const seen = `(() => {
  const visible = e => Boolean(e) && e.getBoundingClientRect().height > 0 && getComputedStyle(e).visibility !== "hidden" && e.textContent.trim() !== "";
  return { heading: visible(document.querySelector(".live > h2")), opinions: visible(document.querySelector(".live .opinions")),
    outcome: visible(document.querySelector(".outcome .verdict")), marked: document.querySelectorAll("nav.settings [aria-current]").length,
    names: [...document.querySelectorAll("nav.settings a > span")].filter(visible).length,
    has_opinions: document.querySelector(".live .opinions") !== null, lit: document.querySelectorAll(".live ol.code .current").length };
})()`;
/// Of the map beside the picture: the size of most of its letters, in px.
const letters_of_map = `(() => {
  const map = document.querySelector(".map svg:not(.over)"), scale = map.getScreenCTM().a;
  const all = [...map.querySelectorAll("text")].map(text => parseFloat(getComputedStyle(text).fontSize) * scale).sort((a, b) => a - b);
  return all[Math.floor(all.length / 2)] ?? 0;
})()`;
let questions = 0, verdicts = 0, maps = 0;
try {
  await browser.look({ width: 1280, height: 900 });
  for (const page of lessons) {
    await site.open(page);
    await browser.ask(`window.heard = [], document.addEventListener("isect:step", event => heard.push(event.detail))`);
    // Another setting is heard, also where the step stays. No answer stands beside a question, in any setting; where it is
    // over, the methods are told.
    const settings = await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`);
    if (settings.length > 1) {
      await browser.ask(`document.querySelector('nav.settings a[href="${settings[1]}"]').click()`);
      await rest(30);
      check(await browser.ask(`"#" + heard.at(-1)?.setting`) === settings[1], `${page}: at the same step, another setting is not heard`);
    }
    for (const setting of settings) {
      await browser.ask(`document.querySelector('nav.settings a[href="${setting}"]').click()`);
      await rest(30);
      for (let i = 0; i < 80; ++i) {
        const now = await site.look(), told = await browser.ask(seen), at = page + now.hash;
        if (now.asks) {
          ++questions;
          check(!told.heading && !told.marked && !told.names, `${at}: its setting's name is told`);
          check(!told.opinions && !told.outcome, `${at}: the methods' answers are told`);
          await site.choose("a");
          check((await browser.ask(seen)).heading, `${at}: answered, it hides its setting's name`);
        }
        if (now.end) check(told.opinions === told.has_opinions, `${at}: the methods are not told at the end`);
        if (now.end) break;
        await browser.press("ArrowRight");
      }
    }

    check(await browser.ask(`heard.filter(({ setting, at }) => setting !== "" && at > 0).length`) > 2, `${page}: its steps are not heard`);

    // A map of cases can be read beside the picture.
    await site.open(page);
    if (await browser.ask(`(() => { const map = [...document.querySelectorAll(".tools button:not([hidden])")].find(b => b.textContent === "Map of cases");
      if (map) map.click(); return Boolean(map); })()`)) {
      const px = await browser.ask(letters_of_map);
      ++maps;
      check(px >= 9, `${page}: the letters of its map are ${px.toFixed(1)} px high`);
    }

    // A drag tells the verdict at the step where it is made; the keys step on; Back brings what was before.
    await site.open(page);
    let now = await site.look();
    for (let i = 0; i < 12 && (now.grips.length === 0 || now.asks) && !now.end; ++i) await browser.press("ArrowRight"), now = await site.look();
    if (now.grips.length === 0 || now.asks) continue;
    await browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
    now = await site.look();
    const grip = now.grips[0];
    await browser.drag(grip, { x: grip.x + 40, y: grip.y + 25 });
    await rest(50);
    const dragged = await site.look();
    if (same(dragged.values, now.values)) continue;
    ++verdicts;
    check(dragged.heading.startsWith("Changed from"), `${page}: dragged, its heading is “${dragged.heading}”`);
    check(dragged.outcome !== "", `${page}: dragged, no verdict is told`);
    await browser.press("ArrowRight");
    const stepped = await site.look();
    check(same(stepped.values, dragged.values) && stepped.hash.split("?")[0] !== dragged.hash.split("?")[0], `${page}: after a drag a key moves the handle`);
    await browser.press("End");
    const end = await site.look();
    check(end.verdict === "" || dragged.outcome.startsWith(end.verdict), `${page}: dragged, “${dragged.outcome}” is told, at the end “${end.verdict}”`);
    await browser.ask("history.back()");
    await rest(150);
    const back = await site.look();
    check(same(back.values, now.values) && back.hash === now.hash, `${page}: Back leads to ${back.hash}, not to ${now.hash}`);
    await browser.ask("history.forward()");
    await rest(150);
    check(same((await site.look()).values, dragged.values), `${page}: Forward does not lead to what was dragged`);
  }

  // A jump within the page is an entry, too, that keeps its setting.
  await site.open(lessons[0]);
  const first = await site.look();
  await browser.ask(`location.hash = "#main"`);
  await rest(100);
  await browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
  const [{ x, y }] = (await site.look()).grips;
  await browser.drag({ x, y }, { x: x + 40, y: y + 25 });
  await rest(50);
  await browser.ask("history.back()");
  await rest(150);
  check(same((await site.look()).values, first.values), "Back to a jump within the page keeps what was dragged after it");

  // In a frame: the page around stays where it is, and nothing is called saved that a browser may refuse.
  const host = join(folder, "host-of-a-frame.html");
  for (const sandbox of ["", ` sandbox="allow-scripts"`]) {
    writeFileSync(host, `<!DOCTYPE html><title>Host</title><p style="height: 1500px">Text</p>
<iframe src="${lessons[0]}${first.hash.replace(/\/\d+/, "/2")}" title="Lesson" width="100%" height="800"${sandbox}></iframe><p style="height: 1500px">Text</p>`);
    await browser.open(site.address("host-of-a-frame.html"));
    await rest(3000);
    check(await browser.ask("scrollY") === 0, `a frame${sandbox} scrolls the page around it by ${await browser.ask("scrollY")}`);
  }
  rmSync(host);
  await site.open(lessons[0]);
  await browser.ask(`URL.createObjectURL = () => "#", HTMLAnchorElement.prototype.click = () => {}`);
  await site.click("Save SVG");
  await rest(600);
  check((await site.look()).message.endsWith("is saved."), "what is saved is not told");
  site.check_silence();
} finally {
  await browser.stop();
}
check(questions > 100, `${questions} questions`);
check(verdicts > 15, `${verdicts} lessons dragged`);
check(maps > 10, `${maps} maps of cases`);
console.log(`${site.checks} checks of ${lessons.length} live pages, ${questions} questions, ${site.wrong.length} wrong`);
process.exit(site.wrong.length === 0 ? 0 : 1);
