// A check's report in a browser: its views, its keys, and that its ticks give a command and a file which accept just what
// was ticked. node report.mjs FOLDER ISECT; FOLDER has report.html and the presets of figs/, three changed by one cause, one
// by another. Prints what is wrong; exit status 1 if anything is.
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { rest } from "./live_page.mjs";

const folder = resolve(process.argv[2]), isect = process.argv[3], address = pathToFileURL(join(folder, "report.html")).href;
let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const run = (...words) => spawnSync(isect, words, { cwd: folder, encoding: "utf8" });
const browser = await Browser.start();
const ask = expression => browser.ask(expression);
const state = () => ask(`({
  at: [...document.querySelectorAll("article")].indexOf(document.activeElement),
  all: document.querySelectorAll("article").length,
  ticked: [...document.querySelectorAll("article")].map(a => a.querySelector(".tick input")?.checked ?? null),
  groups: [...document.querySelectorAll("section > .tick input")].map(i => i.indeterminate ? "some" : i.checked),
  count: document.querySelector(".count").textContent, view: document.documentElement.dataset.view,
  command: document.querySelector(".bar code").textContent,
  save: !document.querySelectorAll(".bar > .choice button")[0].disabled,
  sheet: document.querySelector("dialog")?.open ?? false })`);
/// What of the first picture is seen.
const seen = () => ask(`(() => {
  const views = document.querySelector(".pair, .views");
  const is = name => { const f = views.querySelector("." + name), s = getComputedStyle(f); return s.display !== "none" && s.visibility !== "hidden"; };
  return ["old", "new", "difference"].filter(is).join();
})()`);
try {
  await browser.look({ width: 1366, height: 768 });
  await browser.open(address);

  // The causes stand in an index, the one with most pictures first, and each has its section.
  const index = await ask(`[...document.querySelectorAll("nav li a")].map(a => [a.textContent, document.querySelector(a.getAttribute("href")).querySelector("h2").textContent])`);
  check(index.length === 2 && index.every(([a, b]) => a === b), "the index is not that of the sections: " + JSON.stringify(index));
  check(index[0][0] === "15 pictures and 3 traces: parameter b_max was 4.0, is 5.0", "the first cause is " + index[0][0]);
  check(index[1][0] === "4 pictures and 1 trace: parameter a_min was 0.5, is 0.25", "the second cause is " + index[1][0]);

  // Keys go through the changes.
  let now = await state();
  check(now.all === 23 && now.view === "side" && now.count === "0 of 23 ticked" && !now.save, "at first: " + JSON.stringify(now));
  for (const [key, to] of [["n", 0], ["ArrowRight", 1], ["n", 2], ["p", 1], ["ArrowLeft", 0], ["p", 0], ["End", 22], ["n", 22], ["Home", 0]]) {
    await browser.press(key);
    check((await state()).at === to, `${key} goes to ${(await state()).at}, and not to ${to}`);
  }
  check(await ask(`document.activeElement.getBoundingClientRect().top >= document.querySelector(".bar").getBoundingClientRect().bottom - 1`), "the bar lies over a change");

  // Ticks, one and all of a cause.
  await browser.press(" ");
  now = await state();
  check(now.ticked[0] && now.count === "1 of 23 ticked" && now.groups[0] === "some" && now.save, "a tick: " + JSON.stringify(now));
  await browser.press(" ");
  check(!(await state()).ticked[0], "a second tick does not take the first away");
  await browser.press("n"), await browser.press(" ");
  check((await state()).count === "1 of 23 ticked; the trace of 1 of these presets is not", "of the trace it tells " + (await state()).count);
  await browser.press("g");
  now = await state();
  check(now.ticked.slice(0, 18).every(on => on) && now.ticked.slice(18).every(on => !on) && same(now.groups, [true, false]), "g ticks " + JSON.stringify(now.ticked));
  check(now.count === "18 of 23 ticked", "g: " + now.count);
  await ask(`document.querySelectorAll("section > .tick input")[1].click()`);
  check((await state()).count === "23 of 23 ticked", "a cause's own box: " + (await state()).count);
  await ask(`document.querySelectorAll("section > .tick input")[1].click()`);
  check((await state()).count === "18 of 23 ticked", "a cause's own box, again: " + (await state()).count);

  // Views.
  check(await seen() === "old,new,difference", "side by side are " + await seen());
  await browser.press("d"), check(await seen() === "difference", "d shows " + await seen());
  await browser.press("d"), check(await seen() === "old,new,difference", "d again shows " + await seen());
  await browser.press("2"), check(await seen() === "old", "2 shows " + await seen());
  await browser.press("3"), check(await seen() === "new", "3 shows " + await seen());
  await browser.press("b");
  const blinked = new Set();
  for (let i = 0; i < 20; ++i) blinked.add(await seen()), await rest(100);
  check(same([...blinked].sort(), ["new", "old"]), "b shows " + [...blinked]);
  await browser.press("s"), check(await seen() === "old,new", "s shows " + await seen());
  await ask(`(() => { const cut = document.querySelector(".cut"); cut.value = 20, cut.dispatchEvent(new Event("input")); })()`);
  check(/20%/.test(await ask(`getComputedStyle(document.querySelector(".pair .new img")).clipPath`)), "the slider does not cut");
  const boxes = await ask(`[".old img", ".new img"].map(s => { const b = document.querySelector(".pair " + s).getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })`);
  check(same(boxes[0], boxes[1]) && boxes[0][2] > 300, "the two pictures do not lie one over the other: " + JSON.stringify(boxes));
  await browser.press("1");

  // The sheet of keys: nothing happens behind it.
  await browser.press("?");
  check((await state()).sheet, "? shows no sheet");
  await browser.press(" ");
  await browser.press("Escape");
  now = await state();
  check(!now.sheet && now.count === "18 of 23 ticked", "behind the sheet: " + JSON.stringify(now));
  // Each control has a name, and the focus is seen.
  check(await ask(`[...document.querySelectorAll("button, input")].every(e => (e.getAttribute("aria-label") ?? e.textContent + (e.labels?.[0]?.textContent ?? "")).trim() !== "")`), "a control has no name");
  await ask(`document.querySelector(".bar button").focus()`), await browser.press("Tab");
  check(await ask(`getComputedStyle(document.activeElement).outlineStyle`) !== "none", "the focus is not seen");

  // Opened again, the ticks are still there.
  await browser.open("about:blank");
  await browser.open(address);
  check((await state()).count === "18 of 23 ticked", "opened again: " + (await state()).count);

  // What is saved accepts just what was ticked.
  await ask(`HTMLAnchorElement.prototype.click = function () { window.saved = fetch(this.href).then(r => r.text()), window.saved_as = this.download; }`);
  await ask(`document.querySelectorAll(".bar > .choice button")[0].click()`);
  const name = await ask("saved_as"), text = await ask("saved"), command = (await state()).command;
  check(name === "accept.json" && command.endsWith(" check --dir figs --accept accept.json"), `the command is ${command}, the file ${name}`);
  check(JSON.parse(text).accept.length === 18, "the file lists " + JSON.parse(text).accept.length);
  writeFileSync(join(folder, name), text);
  const accepted = run(...command.split(" ").slice(1));
  check(accepted.status === 0 && accepted.stdout.endsWith("18 of 18 accepted\n"), "it is accepted so: " + accepted.stdout + accepted.stderr);
  const left = JSON.parse(run("check", "--dir", "figs", "--json").stdout);
  check(left.failures.length === 5 && left.failures.every(f => f.preset === "other"), "left are " + JSON.stringify(left.causes));

  // On a phone, in the dark, calm, without scripts.
  await browser.look({ width: 390, height: 844, dark: true, calm: true });
  await browser.open(address);
  check(await ask(`document.documentElement.scrollWidth`) <= 390, "it is wider than a phone: " + await ask(`document.documentElement.scrollWidth`));
  check(await ask(`document.querySelector(".ways button").getBoundingClientRect().bottom`) <= 844, "on a phone the ways are out of sight");
  const ground = () => ask(`getComputedStyle(document.documentElement).backgroundColor`);
  const dark = await ground();
  await browser.press("b");
  const still = await seen();
  await rest(1000);
  check(await seen() === still, "it blinks though motion is to be reduced");
  await browser.press("b"), check(await seen() !== still, "b does not turn the picture over");
  await browser.look({ scripts: false });
  await browser.open(address);
  check(await ground() !== dark, "light and dark look the same");
  check(await seen() === "old,new,difference", "without scripts one sees " + await seen());
  for (const message of browser.messages) check(false, "the console says: " + message);
  for (const request of browser.requests) check(/^(file|data|blob|about):/.test(request), "it asks the network for " + request);
} finally {
  await browser.stop();
}
console.log(`${checks} checks of a report, ${wrong} wrong`);
process.exit(wrong ? 1 : 0);
