// The page of a scene of one's own. node scene.mjs FOLDER ISECT; prints what is wrong; exit status 1 if anything is.
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { LivePages, rest } from "./live_page.mjs";

const [folder, isect] = process.argv.slice(2), page = "scene.html";
const site = await LivePages.start(folder, isect), browser = site.browser, scratch = mkdtempSync(join(tmpdir(), "isect-scene-"));
const check = (holds, what) => site.check(holds, what), look = () => site.look();
const letters = text => text.replace(/[\s.]/g, "").toLowerCase();
/// What the page shows of its scene is what the native program says of the same text.
async function compare(how) {
  const { scene } = await look(), file = join(scratch, "scene.json"), told = [];
  writeFileSync(file, scene);
  const verdicts = JSON.parse(site.native(["scene", file, "--json"])).map(answer => letters(answer.verdict ?? ""));
  await browser.press("Home");
  for (let i = 0; i < 60; ++i) {
    const now = await look();
    told.push(letters(await browser.ask(`document.querySelector(".live article").textContent`)));
    if (now.end) break;
    await browser.press("ArrowRight");
  }
  check(verdicts.length > 0 && verdicts.every(verdict => told.some(text => text.includes(verdict))), `${how}: ${JSON.stringify(verdicts)} of ${scene}`);
  return verdicts.length;
}
const type = text => browser.ask(`(() => { const f = document.querySelector(".own-scene textarea"); f.value = ${JSON.stringify(text)}; })()`);

let compared = 0;
try {
  await browser.look({ width: 1280, height: 900 });
  check(await site.open(page) === "ready", "the page does not come alive");
  const examples = await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`);
  for (const example of examples) {
    await browser.ask(`document.querySelector('nav.settings a[href="${example}"]').click()`);
    await rest(150);
    const now = await look();
    check(now.hash.startsWith(example) && !now.hash.includes("?") && now.wide <= 0 && now.scene.includes("objects"),
      `${example}: ${now.hash}, ${now.wide} px too wide`);
    // A lesson's walk says it in words of its own: it numbers the boxes that the scene names.
    if (!/^#(step-by-step|crates-and-a-ray)/.test(now.hash)) compared += await compare(example);
  }

  // What is dragged is written into the text; a link opens that very scene.
  await site.open(page, "#three-spheres-and-an-obb");
  const { before, dragged, pushed, name } = await site.move_a_handle({ x: 60, y: 0 });
  check(dragged.scene !== before.scene, `${name} moves nothing in the text`);
  check(pushed.scene !== dragged.scene, `${name} moves nothing in the text by keys`);
  check(pushed.scene.includes("// A and B touch"), "a comment is lost");
  compared += await compare("after a drag");
  const kept = await look();
  await site.open(page, kept.hash);
  const again = await look();
  check(again.scene === kept.scene && again.title === kept.title && again.hash === kept.hash, "its link opens something else");

  // Text of one's own.
  await type('{"title": "Mine", "objects": [{"point": "p", "at": [1, 1]}, {"circle": "c", "center": [0, 0], "radius": 1.5}],\n "ask": [["p", "c"]]}');
  await site.click("Show this scene");
  check((await look()).heading.startsWith("Mine"), "a text is not shown: " + (await look()).heading);
  compared += await compare("typed");
  const mine = await look();
  await type('{"objects": [\n {"point": "p", "at": [1, 1]},\n {"circle": "c", "center": [0, 0], "radius": -1}]}');
  await site.click("Show this scene");
  const refused = await browser.ask(`document.querySelector(".own-scene .refused")?.textContent ?? ""`);
  check(refused.includes("line 3"), `a wrong text is not refused by its line: "${refused}"`);
  check((await look()).hash === mine.hash, "a wrong text is shown");
  await browser.ask(`history.back()`);
  await rest(300);
  check((await look()).heading !== mine.heading && (await look()).scene !== mine.scene, "back does not bring the scene before");

  // A file that is opened, and one that is saved.
  const file = join(scratch, "opened.json");
  writeFileSync(file, '{"title": "Opened", "objects": [{"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]}, {"sphere": "s", "center": [2, 2, 2], "radius": 1}], "ask": "all pairs"}');
  const { root } = await browser.send("DOM.getDocument", { depth: -1 });
  const { nodeId } = await browser.send("DOM.querySelector", { nodeId: root.nodeId, selector: ".own-scene input" });
  await browser.send("DOM.setFileInputFiles", { nodeId, files: [file] });
  await rest(300);
  check((await look()).heading.startsWith("Opened"), "a file is not opened: " + (await look()).heading);
  compared += await compare("opened");
  await browser.ask(`HTMLAnchorElement.prototype.click = function () { window.saved = fetch(this.href).then(r => r.text()); }`);
  await site.click("Save the scene");
  check(await browser.ask("saved") === (await look()).scene, "what is saved is not the scene");

  for (const width of [360, 768, 1440]) {
    await browser.look({ width, height: 900 });
    await site.open(page);
    check((await look()).wide <= 0, `${width} wide: the page sticks out by ${(await look()).wide} px`);
  }
  site.check_silence();
} finally {
  await browser.stop();
  rmSync(scratch, { recursive: true });
}
console.log(`${site.checks} checks of scenes, ${compared} answers as native, ${site.wrong.length} wrong`);
process.exit(site.wrong.length === 0 ? 0 : 1);
