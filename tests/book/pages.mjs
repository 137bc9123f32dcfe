// The pages of a book in a real browser. node pages.mjs FOLDER; prints what is wrong; exit status 1 if anything is.
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const folder = resolve(process.argv[2]);
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort();
const wrong = [];
let checks = 0;
function check(holds, what) {
  ++checks;
  if (!holds) wrong.push(what), console.log("wrong: " + what);
}
const address = (page, hash = "") => pathToFileURL(join(folder, page)).href + hash;

/// What of the page can be seen beyond its sides, or lies on something else it should not.
const overflow = `(() => {
  const wide = document.documentElement.clientWidth, out = [];
  if (document.documentElement.scrollWidth > wide) out.push("the page is " + document.documentElement.scrollWidth + " wide");
  for (const element of document.querySelectorAll("h1, h2, h3, p, li, button, td, th, code, svg.picture")) {
    const box = element.getBoundingClientRect();
    if (box.width === 0 || element.closest(".transport, nav.settings, figure[tabindex], .formula, .skip, .shared")) continue;
    if (box.right > wide + 1 || box.left < -1) out.push(element.tagName + ": " + element.textContent.slice(0, 40));
  }
  return out;
})()`;

/// Contrast of texts to the ground below them, as WCAG 2.1 asks; names of what is pressed; order of headings.
const accessible = `(() => {
  const out = [], seen = element => element.getBoundingClientRect().width > 0;
  const light = ([r, g, b]) => [r, g, b].map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const numbers = colour => colour.match(/[\\d.]+/g).map(Number);
  const ground = element => {
    for (let e = element; e; e = e.parentElement) {
      const colour = numbers(getComputedStyle(e).backgroundColor);
      if (colour.length === 3 || colour[3] === 1) return colour;
    }
    return [255, 255, 255];
  };
  for (const element of document.querySelectorAll("h1, h2, h3, p, li, td, th, a, button, code, summary, caption, dt, dd, small")) {
    if (!seen(element) || !element.textContent.trim() || element.disabled) continue;
    const a = light(numbers(getComputedStyle(element).color)), b = light(ground(element));
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) out.push("contrast " + contrast.toFixed(2) + ": " + element.textContent.slice(0, 40));
  }
  for (const element of document.querySelectorAll("a, button, input, summary, [tabindex='0']")) {
    const name = element.getAttribute("aria-label") || element.textContent.trim() ||
      element.labels?.[0]?.textContent.trim() || element.querySelector("[aria-label]")?.getAttribute("aria-label");
    if (!name) out.push("no name: " + element.outerHTML.slice(0, 80));
    const box = element.getBoundingClientRect();
    if (seen(element) && element.matches("button, nav.settings a") && box.height < 24) out.push("small: " + name);
  }
  let level = 0;
  for (const head of document.querySelectorAll("h1, h2, h3")) {
    const now = Number(head.tagName[1]);
    if (now > level + 1) out.push("a heading leaves out a level: " + head.textContent);
    level = now;
  }
  if (document.querySelectorAll("h1").length !== 1) out.push("not one h1");
  for (const landmark of ["main", "title"]) if (!document.querySelector(landmark)) out.push("no " + landmark);
  for (const list of document.querySelectorAll("ul, ol"))
    if ([...list.children].some(child => child.tagName !== "LI")) out.push("a list with what is no item");
  return out;
})()`;

const shown = `(() => {
  const all = [...document.querySelectorAll(".walk.shown > .steps > .shown")].filter(a => a.querySelector("svg").getBoundingClientRect().width > 0
    || getComputedStyle(a.querySelector("figure")).display !== "none");
  return { count: all.length, id: all.at(-1)?.id ?? "", hash: location.hash,
    line: document.querySelectorAll(".walk.shown ol.code .current").length,
    wanted: all.at(-1)?.dataset.line ?? null,
    said: getComputedStyle(document.querySelector(".walk.shown ol.code .current") ?? document.body, "::after").content.replace(/[" ]/g, "").replace(/^(none|normal)$/, ""),
    to_say: all.at(-1)?.dataset.said ?? "",
    end: document.querySelector(".transport .next").disabled };
})()`;

const browser = await Browser.start();
const beginning = Date.now();
try {
  // Each page in each look: nothing sticks out, nothing is hard to see, nothing is said on the console.
  for (const page of pages) {
    await browser.look({ width: 1440, height: 900 });
    await browser.open(address(page));
    for (const width of [1440, 768, 360])
      for (const dark of [false, true]) {
        // In smaller windows with all settings: the first look is at what a reader opens.
        if (width === 768 && !dark) await browser.ask(`document.querySelectorAll(".transport .whole").forEach(whole => (whole.click(), whole.click()))`);
        await browser.look({ width, height: 900, dark });
        const at = `${page}, ${width} wide, ${dark ? "dark" : "light"}`;
        for (const fault of [...await browser.ask(overflow), ...await browser.ask(accessible)]) check(false, `${at}: ${fault}`);
        check(true, at);
      }
  }

  // Each lesson stepped by keys to its end in its first settings and in the last that has a key, each question answered
  // on the way, right and wrong.
  await browser.look({ width: 768, height: 1000 });
  for (const page of pages) {
    await browser.open(address(page));
    if (!await browser.ask(`document.querySelector(".walk") !== null`)) continue;
    const walks = await browser.ask(`document.querySelectorAll("nav.settings a").length`);
    for (const w of new Set([0, 1, Math.min(walks, 9) - 1].filter(w => w < walks))) {
      await browser.press(String(w + 1));
      await browser.press("Home");  // a scene opens at its first answer
      const articles = Number(await browser.ask(`document.querySelector(".transport input").max`));
      const ids = new Set();
      for (let i = 0; i < articles; ++i) {
        const now = await browser.ask(shown);
        const at = `${page}, walk ${w + 1}, ${i + 1} of ${articles}`;
        ids.add(now.id);
        check(now.count === 1 && now.id !== "", `${at}: ${now.count} are shown`);
        check(decodeURIComponent(now.hash) === "#" + now.id, `${at}: the address is ${now.hash}`);
        if (now.id && !now.id.endsWith("/question"))
          check(now.line === (now.wanted === null ? 0 : 1), `${at}: ${now.line} lines are lit`);
        check(now.said === now.to_say, `${at}: the lit line says "${now.said}", and not "${now.to_say}"`);
        check(now.end === (i + 1 === articles), `${at}: the end is ${now.end}`);
        if (now.id.endsWith("/question")) {
          const told = await browser.ask(`({ named: getComputedStyle(document.querySelector(".walk.shown > h2")).visibility === "visible",
            marked: document.querySelectorAll("nav.settings [aria-current]").length,
            names: [...document.querySelectorAll("nav.settings a > span")].filter(name => getComputedStyle(name).visibility === "visible").length,
            letters: [...document.querySelectorAll(".walk.shown .steps > .shown .choices button")].map(choice => choice.textContent.slice(0, 2)).join("") })`);
          check(now.line === 0, `${at}: a line of code is lit beside a question`);
          check(!told.named && told.marked === 0 && told.names === 0, `${at}: the setting's name is told beside a question`);
          check(told.letters !== "" && "a b c d e f g h i j k l ".startsWith(told.letters), `${at}: choices read “${told.letters}”`);
          const right = await browser.ask(`[...document.querySelectorAll(".walk.shown .steps > .shown .choices li")].findIndex(li => "right" in li.dataset)`);
          const typing = await browser.ask(`document.querySelector(".walk.shown .steps > .shown").classList.contains("typing")`);
          const open = await browser.ask(`document.querySelector(".walk.shown .steps > .shown .choices").getBoundingClientRect().height > 0`);
          check(typing !== open, `${at}: choices and a field for a number are ${open ? "both" : "neither"} shown`);
          if (typing) await browser.ask(`document.querySelector(".walk.shown .steps > .shown .show-choices").click()`);
          await browser.press("abcdefgh"[w % 2 ? right : 0]);
          const answer = await browser.ask(`({ told: document.querySelector(".walk.shown .steps > .shown").classList.contains("told"),
            wrong: document.querySelectorAll(".walk.shown .steps > .shown .wrong").length, answer: document.querySelector(".walk.shown .steps > .shown details").open })`);
          check(answer.told && answer.answer, `${at}: the answer is not told`);
          check(answer.wrong === (w % 2 || right === 0 ? 0 : 1), `${at}: ${answer.wrong} choices are wrong`);
        }
        for (const fault of i % 4 === 0 ? await browser.ask(overflow) : []) check(false, `${at}: ${fault}`);
        await browser.press("ArrowRight");
      }
      check(ids.size === articles, `${page}, walk ${w + 1}: ${ids.size} of ${articles} were seen`);
    }
  }

  // A link opens that very step; the buttons do what the keys do; all steps at once; without scripts; on paper.
  const [lesson] = pages.includes("ray-sphere.html") ? ["ray-sphere.html"] : pages.filter(p => p !== "index.html");
  await browser.open(address(lesson));
  await browser.ask("localStorage.clear()");  // its questions are open again
  await browser.open("about:blank");
  const step = "tangent/3";
  await browser.open(address(lesson, "#" + step));
  check((await browser.ask(shown)).id === step, "a link opens another step");
  const whole = `(() => { const box = document.querySelector(".walk.shown > .steps > .shown .picture").getBoundingClientRect();
    return box.top >= 0 && box.bottom <= document.querySelector(".transport").getBoundingClientRect().top; })()`;
  check(await browser.ask(whole), "a link does not go to the step");
  await browser.ask(`window.heard = [], ["step", "answer"].forEach(name => document.addEventListener("isect:" + name, event =>
    heard.push([name, event.detail.setting ?? event.detail.asked, event.detail.at ?? event.detail.right])))`);
  await browser.ask(`document.querySelector(".transport .next").click()`);
  check((await browser.ask(shown)).id.startsWith("tangent/4"), "the button does not go on");
  const heard = await browser.ask(`heard`), asked = await browser.ask(`(() => { const ask = document.querySelector(".ask[data-asked]:not(.told)");
    ask.querySelector("[data-right] button").click();
    return [ask.dataset.asked, heard.at(-1)]; })()`);
  check(heard.length === 1 && heard[0][0] === "step" && heard[0][1] === "tangent", `of a step is heard ${JSON.stringify(heard)}`);
  check(JSON.stringify(asked[1]) === JSON.stringify(["answer", asked[0], true]), `of an answer is heard ${JSON.stringify(asked)}`);
  await browser.ask(`document.querySelector('nav.settings a[href="#miss"]').click()`);
  await browser.ask(`new Promise(resolve => setTimeout(resolve, 100))`);
  check((await browser.ask(shown)).id.startsWith("miss/1"), "a setting is not opened by its link");
  await browser.ask(`history.back()`);
  await browser.ask(`new Promise(resolve => setTimeout(resolve, 100))`);
  check((await browser.ask(shown)).id.startsWith("tangent/4"), "Back does not bring the setting before");
  await browser.ask(`scrollTo(0, 0), document.querySelector(".more").click()`);
  check(await browser.ask(`document.querySelector(".about").getBoundingClientRect().height > 0`), "what a lesson is about is not unfolded");
  await browser.press("ArrowRight");
  check(await browser.ask(whole), "a step does not bring the picture back");
  await browser.press("?");
  const keys = await browser.ask(`({ open: document.querySelector("dialog.keys")?.open, text: document.querySelector("dialog.keys")?.textContent ?? "" })`);
  check(keys.open && keys.text.includes("Home, End") && !keys.text.includes("ring"), `the key ? shows ${keys.text}`);
  await browser.press("Escape");
  check(await browser.ask(`!document.querySelector("dialog.keys").open && document.querySelector(".term") !== null`), "the sheet of keys stays, or no term is marked");
  check(await browser.ask(`document.querySelector(".exercises > .lively-told")?.textContent.startsWith("Nothing can be dragged")`), "its exercises ask for drags");
  await browser.ask(`document.querySelector(".transport .whole").click()`);
  check(await browser.ask(`document.querySelector(".transport .whole").getAttribute("aria-pressed") === "true"
    && document.querySelector(".transport .next").getBoundingClientRect().height === 0`), "where all is shown, Next steps out of sight");
  const every = `[...document.querySelectorAll(".step")].filter(s => s.getBoundingClientRect().height > 0).length`;
  const steps = readFileSync(join(folder, lesson), "utf8").split('<article class="step').length - 1;
  check(await browser.ask(every) === steps, "not all steps are shown at once");
  await browser.look({ width: 360, scripts: false });  // asked from here, as a <noscript> shows nothing where scripts run
  await browser.open(address(lesson));
  check(await browser.ask(every) === steps, "without scripts not all steps are shown");
  check(await browser.ask(`document.querySelector(".transport") === null`), "a script has run");
  check((await browser.ask(overflow)).length === 0, "without scripts something sticks out");
  for (const [paper, width, height] of [["A4", 8.27, 11.69], ["Letter", 8.5, 11]]) {
    await browser.look({ width: 1000, dark: true });
    await browser.open(address(lesson));
    const { data } = await browser.send("Page.printToPDF", { paperWidth: width, paperHeight: height });
    const pdf = Buffer.from(data, "base64").toString("latin1");
    const sheets = (pdf.match(/\/Type\s*\/Page\b/g) ?? []).length;
    check(pdf.startsWith("%PDF") && sheets >= 3 && sheets <= 12, `${paper}: ${sheets} sheets`);
  }
  await browser.look({ width: 794, print: true, dark: true });
  await browser.open(address(lesson));
  check(await browser.ask(`getComputedStyle(document.body.parentElement).backgroundColor`) === "rgb(255, 255, 255)", "paper is dark");
  check((await browser.ask(overflow)).length === 0, "on paper something sticks out");

  // A review asks eight questions, one at a time, tells what was not right, and asks that first the next time. A record
  // that is damaged is told and kept. Without scripts all questions stand there, and their answers at the end.
  if (pages.includes("review-1.html")) {
    const page = address("review-1.html"), again = async () => (await browser.open("about:blank"), await browser.open(page));
    const open = `[...document.querySelectorAll(".review > .ask")].filter(a => a.getBoundingClientRect().height > 0)`;
    const asked = () => browser.ask(`${open}.map(a => ({ name: a.dataset.asked, typing: a.classList.contains("typing"),
      right: [...a.querySelectorAll(".choices li")].findIndex(li => "right" in li.dataset) }))`);
    await browser.look({ width: 1280, height: 900 });
    await browser.open(page);
    await browser.ask(`localStorage.clear()`);
    await again();
    let missed = "";
    const names = new Set();
    for (let i = 0; i < 8; ++i) {
      const [now, ...others] = await asked();
      check(now && others.length === 0, `review, question ${i + 1}: ${others.length + 1} are shown`);
      if (!now) break;
      names.add(now.name);
      if (now.typing) await browser.press("a");
      await browser.press("abcdefgh"[i !== 3 ? now.right : now.right === 0 ? 1 : 0]);
      if (i === 3) missed = now.name;
      await browser.press("ArrowRight");
    }
    check(names.size === 8, `review: ${names.size} different questions`);
    const end = await browser.ask(`({ head: document.querySelector(".result h2")?.textContent ?? "",
      links: document.querySelectorAll(".result li a").length, kept: JSON.parse(localStorage.getItem("isect answers")) })`);
    check(end.head === "7 of 8 right" && end.links === 1, `review: at the end “${end.head}”, ${end.links} links`);
    check(end.kept.answers === 8 && end.kept.reviews[1].right === 7, `review: kept ${JSON.stringify(end.kept.reviews)}`);
    await again();
    check((await asked())[0]?.name === missed, "review: what was wrong does not return first");
    await browser.ask(`localStorage.setItem("isect answers", "{")`);
    await again();
    const damage = await browser.ask(`[document.querySelector(".damage")?.textContent ?? "", localStorage.getItem("isect answers, damaged")]`);
    check(damage[0].includes("damaged") && damage[1] === "{", `review: a damaged record is lost: ${damage}`);
    const [shown_first] = await asked();
    if (shown_first.typing) await browser.press("a");
    await browser.press("abcdefgh"[shown_first.right]);
    const times = await browser.ask(`[document.querySelectorAll(".ask.told").length, document.querySelectorAll(".damage").length]`);
    check(times[0] === 1 && times[1] === 1, `review: ${times[0]} answered, and a damaged record is told ${times[1]} times`);
    await browser.ask(`localStorage.setItem("isect answers", "[")`);
    await browser.open(address(lesson));
    await browser.ask(`document.querySelector(".transport .whole").click()`);
    await browser.ask(`document.querySelectorAll(".ask").forEach(ask => ask.querySelector(".choices button").click())`);
    const told = await browser.ask(`[[...document.querySelectorAll(".damage")].map(p => p.textContent), localStorage.getItem("isect answers, damaged 2")]`);
    check(told[0].length === 1 && told[0][0].includes("damaged 2") && told[1] === "[", `a lesson's page loses a damaged record: ${told}`);
    await browser.ask(`localStorage.clear()`);
    await browser.look({ width: 360, scripts: false });
    await browser.open(page);
    const all = `[...document.querySelectorAll(".review .ask")]`, asks = readFileSync(join(folder, "review-1.html"), "utf8").split('<article class="ask"').length - 1;
    check(await browser.ask(`${all}.filter(a => a.getBoundingClientRect().height > 0).length`) === asks, "review: without scripts not all is asked");
    check(await browser.ask(`document.querySelector(".answers").getBoundingClientRect().top > ${all}.at(-1).getBoundingClientRect().bottom`),
      "review: without scripts the answers do not stand at the end");
    check((await browser.ask(overflow)).length === 0, "review: without scripts something sticks out");
  }

  browser.messages.forEach(message => check(false, "the console says: " + message));
  const far = browser.requests.filter(url => !/^(file|data|about|blob):/.test(url));
  check(far.length === 0, "asked of the network: " + far[0]);
} finally {
  await browser.stop();
}
console.log(`${checks} checks of ${pages.length} pages in ${((Date.now() - beginning) / 1000).toFixed(0)} s, ${wrong.length} wrong`);
process.exit(wrong.length === 0 ? 0 : 1);
