// A lesson's SCORM package in a browser, with a platform around it that is strict: what it tells of a reader who steps,
// answers, leaves and comes back, and that it finds the platform from within a frame. node scorm.mjs FOLDER, the package
// unpacked; prints what is wrong; exit status 1 if anything is.
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { loaded, rest } from "./live_page.mjs";
import { scorm_api } from "./scorm_api.mjs";

const folder = resolve(process.argv[2]), manifest = readFileSync(join(folder, "imsmanifest.xml"), "utf8");
const page = /adlcp:scormtype="sco" href="([^"]*)"/.exec(manifest)?.[1] ?? "";
const empty = join(folder, "..", "no-platform.html"), host = join(folder, "..", "platform.html");
let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}
check(page !== "" && existsSync(join(folder, page)), `the manifest launches “${page}”`);
const browser = await Browser.start(), ask = expression => browser.ask(expression);
const address = pathToFileURL(join(folder, page)).href;

/// As a script: makes the platform, with what it has kept, and writes down all that it hears.
const platform = (data, options) => `${scorm_api}
window.platform = scorm_api(${JSON.stringify(data)}, ${JSON.stringify(options)}), window.API = {};
for (const name of Object.keys(platform.api)) API[name] = (...values) => {
  const said = platform.api[name](...values), { data, calls, wrong } = platform;
  localStorage.setItem("platform", JSON.stringify({ data, calls, wrong, committed: platform.committed(), state: platform.state() }));
  return said;
};`;
let script = "";
async function without_platform() {
  if (script) await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier: script });
  script = "";
}
/// Launches the page. The window that holds it is the platform's.
async function launch(data, options, hash = "") {
  await without_platform();
  ({ identifier: script } = await browser.send("Page.addScriptToEvaluateOnNewDocument",
    { source: `if (location.protocol === "file:") {\n${platform(data, options)}\n}` }));
  await browser.open("about:blank");
  await browser.open(address + hash);
  await ask(loaded);
}
const heard = () => ask(`JSON.parse(localStorage.getItem("platform"))`);
/// Leaves the page, and returns what the platform has heard until then.
async function leave() {
  await without_platform();
  await browser.open(pathToFileURL(empty).href);
  return heard();
}
const article = `(document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown"))`;
const look = () => ask(`(() => {
  const article = ${article};
  return { asks: article.classList.contains("ask") && !article.classList.contains("told"), typing: article.classList.contains("typing"),
    asked: article.dataset.asked ?? "", right: [...article.querySelectorAll(".choices li")].findIndex(li => "right" in li.dataset),
    end: document.querySelector(".transport .next").disabled, hash: location.hash };
})()`);
/// Goes on to the next open question, and answers it; returns its name.
async function answer(right) {
  for (let i = 0; i < 60; ++i) {
    const now = await look();
    if (now.asks) {
      if (now.typing) await ask(`${article}.querySelector(".show-choices").click()`);
      await browser.press("abcdefgh"[right ? now.right : now.right === 0 ? 1 : 0]);
      return now.asked;
    }
    if (now.end) return "";
    await browser.press("ArrowRight");
  }
  return "";
}

try {
  writeFileSync(empty, "<!DOCTYPE html><title>No platform</title>");
  await browser.look({ width: 1280, height: 900 });
  await browser.open(pathToFileURL(empty).href);
  await ask("localStorage.clear()");

  await launch({}, {});
  let told = await heard();
  const questions = await ask(`document.body.dataset.scorm.split(" ").length`), score = right => String(Math.round(10000 * right / questions) / 100);
  check(questions > 3 && told.calls[0] === "LMSInitialize", `of ${questions} questions it begins with ${told.calls[0]}`);
  check(told.data["cmi.core.lesson_status"] === "incomplete" && told.data["cmi.core.score.raw"] === "0", `it begins with ${JSON.stringify(told.data)}`);
  const names = [await answer(true), await answer(false)];
  told = await heard();
  check(names.every(name => name.includes("/")) && names[0] !== names[1], `it asks ${names}`);
  check(told.committed["cmi.core.score.raw"] === score(1), `one right of ${questions} is ${told.committed["cmi.core.score.raw"]}`);
  const place = await look();
  told = await heard();
  check("#" + told.data["cmi.core.lesson_location"] === place.hash, `at ${place.hash} it tells ${told.data["cmi.core.lesson_location"]}`);
  check(told.data["cmi.core.lesson_status"] === "incomplete", "it is completed before its end");
  const first = await leave();
  check(first.state === "ended" && first.calls.filter(call => call === "LMSFinish").length === 1, `when its reader leaves it is ${first.state}`);
  check(first.committed["cmi.core.exit"] === "suspend" && first.committed["cmi.core.session_time"].startsWith("00:0"), `it ends with ${JSON.stringify(first.committed)}`);

  // Back again: at the same place, with the answers; at the end it is completed.
  await ask("localStorage.clear()");  // on another machine
  await launch(first.data, { entry: "resume" });
  const back = await look();
  told = await heard();
  check(back.hash === place.hash, `it goes on at ${back.hash}, and not at ${place.hash}`);
  check(told.data["cmi.core.score.raw"] === score(1), `going on, the score is ${told.data["cmi.core.score.raw"]}`);
  await browser.press("End");
  told = await heard();
  check(told.committed["cmi.core.lesson_status"] === "completed", `at its end it is ${told.committed["cmi.core.lesson_status"]}`);
  const second = await leave();
  for (const visit of [first, second]) check(visit.wrong.length === 0, `the platform refuses ${visit.wrong}`);
  await launch({}, { student: "s-2" });
  check((await heard()).data["cmi.core.score.raw"] === "0", "a reader has another one's answers");
  await leave();

  // In a frame within a frame of the platform's window. The frames' pages are texts, so that they are of its origin.
  const quoted = text => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;");
  const inner = `<!DOCTYPE html><title>Frame</title><iframe title="Lesson" width="1000" height="700" srcdoc="${quoted(readFileSync(join(folder, page), "utf8"))}"></iframe>`;
  writeFileSync(host, `<!DOCTYPE html><meta charset="utf-8"><title>Platform</title><script>${platform({}, {})}</script>
<iframe title="Course" width="1100" height="800" srcdoc="${quoted(inner)}"></iframe>`);
  await browser.open(pathToFileURL(host).href);
  for (let i = 0; i < 50 && await ask("platform.state()") !== "open"; ++i) await rest(100);
  check(await ask("platform.state()") === "open", "from a frame the platform is not found");
  check(await ask(`platform.data["cmi.core.score.raw"]`) === "0", "from a frame no score is told");
  await ask(`document.querySelector("iframe").remove()`);
  await rest(200);
  check(await ask("platform.state()") === "ended", "a frame that is closed does not end");
  const refused = await ask("platform.wrong");
  check(refused.length === 0, `from a frame the platform refuses ${refused}`);

  browser.messages.forEach(message => check(false, "the console says: " + message));
} finally {
  await browser.stop();
  for (const file of [empty, host]) rmSync(file, { force: true });
}
console.log(`${checks} checks of a package's ${basename(page)}, ${wrong} wrong`);
process.exit(wrong === 0 ? 0 : 1);
