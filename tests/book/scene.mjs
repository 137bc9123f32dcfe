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
  await browser.ask(`document.activeElement.blur()`);
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
const type = text => browser.ask(`(() => { const f = document.querySelector(".own-scene textarea"); f.value = ${JSON.stringify(text)};
  f.dispatchEvent(new Event("input", { bubbles: true })); })()`);
/// Where the page stands, and what is said beside the text.
const beside = () => browser.ask(`(() => {
  const area = document.querySelector(".own-scene textarea"), mark = document.querySelector(".marked-line"), style = getComputedStyle(area);
  const line = mark.hidden ? 0 : 1 + (mark.getBoundingClientRect().top - area.getBoundingClientRect().top - area.clientTop -
    parseFloat(style.paddingTop) + area.scrollTop) / parseFloat(style.lineHeight);
  return { at: document.querySelector(".transport input").value, told: document.querySelector("#scene-told").textContent, line: Math.round(line * 100) / 100,
    refused: document.querySelector("#scene-told").classList.contains("refused"), invalid: area.getAttribute("aria-invalid") === "true",
    choices: [...document.querySelectorAll(".own-scene .ways button")].map(b => b.textContent), numbers: document.querySelector(".line-numbers").textContent,
    from: area.selectionStart, to: area.selectionEnd, focused: document.activeElement === area, state: document.querySelector(".scene-state").textContent };
})()`);
/// Files are dropped on the page: [name, bytes].
async function drop(...files) {
  const data = files.map(([name, bytes]) => [name, Buffer.from(bytes).toString("base64")]);
  const prevented = await browser.ask(`(() => {
    const data = new DataTransfer();
    for (const [name, text] of ${JSON.stringify(data)})
      data.items.add(new File([Uint8Array.from(atob(text), letter => letter.charCodeAt(0))], name));
    return !document.querySelector("h1").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  })()`);
  check(prevented, `${files[0][0]}: the browser itself opens what is dropped`);
  await rest(400);
}
const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
function binary_stl() {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) => face.forEach((corner, k) => corners[corner].forEach((x, axis) =>
    bytes.writeFloatLE(x, 84 + 50 * i + 12 + 12 * k + 4 * axis))));
  return bytes;
}
const rows = all => all.map(row => row.join(" ") + "\n").join("");
const files = {
  "tetra.stl": binary_stl(),
  "tetra.obj": corners.map(p => `v ${p.join(" ")}\n`).join("") + faces.map(f => `f ${f.map(i => i + 1).join(" ")}\n`).join(""),
  "tetra.ply": "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n" +
    "property list uchar int vertex_indices\nend_header\n" + rows(corners) + rows(faces.map(f => [3, ...f])),
  "some.csv": "x,y\n0,0\n4,0\n1,3\n",
  "field.geojson": '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}'
};

let compared = 0;
try {
  await browser.look({ width: 1280, height: 900 });
  check(await site.open(page) === "ready", "the page does not come alive");
  const opened = await beside();
  check(opened.at === "2" && opened.state.startsWith("Drag"), `it opens at step ${opened.at} and says "${opened.state}"`);
  check(opened.numbers.split("\n").length === (await look()).scene.split("\n").length, "lines have other numbers than the text");
  const examples = await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`);
  for (const example of examples) {
    await browser.ask(`document.querySelector('nav.settings a[href="${example}"]').click()`);
    await rest(150);
    const now = await look();
    check((await beside()).at === "2", `${example} opens at step ${(await beside()).at}`);
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

  // Text of one's own is shown at its first answer; or where one stands, as long as that is asked.
  await type('{"title": "Mine", "objects": [{"point": "p", "at": [1, 1]}, {"circle": "c", "center": [0, 0], "radius": 1.5}],\n "ask": [["p", "c"]]}');
  check((await beside()).told.includes("not shown yet"), "nothing says that a text is not shown yet");
  await site.click("Show this scene");
  check((await look()).heading.startsWith("Mine"), "a text is not shown: " + (await look()).heading);
  check((await beside()).at === "2" && (await look()).yes, `it is shown at step ${(await beside()).at}`);
  check((await beside()).told === "" && (await beside()).choices.length === 0, "something is still said of a text that is shown");
  compared += await compare("typed");
  // A double click on a corner's ring removes it, and keys there do the same.
  await type('{"objects": [{"polygon": "P", "points": [[0, 0], [4, 0], [4, 4], [0, 4]]}, {"point": "q", "at": [2, 1]}], "ask": [["q", "P"]]}');
  await site.click("Show this scene");
  const at_ring = event => browser.ask(`document.querySelector('.live .grip[data-handle^="P.2/"]').dispatchEvent(new ${event})`);
  await at_ring(`KeyboardEvent("keydown", { key: "Insert", bubbles: true })`);
  check((await look()).scene.includes("[4, 0], [4, 2], [4, 4]"), "Insert adds no corner: " + (await look()).scene);
  await at_ring(`MouseEvent("dblclick", { bubbles: true })`);
  check((await look()).scene.includes("[0, 0], [4, 2], [4, 4]"), "a double click removes no corner: " + (await look()).scene);

  // Where one stands at an answer that is still asked, one stays there.
  const three = radius => `{"title": "Mine", "objects": [{"point": "p", "at": [1, 1]}, {"circle": "c", "center": [0, 0], "radius": ${radius}},\n` +
    ` {"point": "q", "at": [2, 0]}], "ask": [["p", "c"], ["q", "c"]]}`;
  await type(three(1.5));
  await site.click("Show this scene");
  await browser.press("Home"), await browser.press("ArrowRight"), await browser.press("ArrowRight");
  check((await look()).no, "q and c are not told apart");
  await type(three(2.5));
  await browser.ask(`document.querySelector(".own-scene textarea").focus()`);
  await browser.press("Enter", 2);
  check((await beside()).at === "3" && (await look()).yes && (await beside()).focused, `Ctrl+Enter shows step ${(await beside()).at}`);
  await browser.ask(`document.activeElement.blur()`);
  const mine = await look();

  // An error is marked, and a button leads to it.
  await type('{"objects": [\n {"point": "p", "at": [1, 1]},\n {"circle": "c", "center": [0, 0], "radius": -1}]}');
  await site.click("Show this scene");
  const refused = await beside();
  check(refused.refused && refused.invalid && refused.told.startsWith("line 3"), `a wrong text is not refused by its line: "${refused.told}"`);
  check(refused.line === 3 && refused.choices[0] === "Go to line 3", `line ${refused.line} is marked, and offered: ${refused.choices}`);
  check((await look()).hash === mine.hash, "a wrong text is shown");
  await site.click("Go to line 3");
  const gone = await beside(), lines = (await look()).scene.split("\n");
  check(gone.focused && (await look()).scene.slice(gone.from, gone.to) === lines[2], `the button selects ${gone.from} to ${gone.to}`);
  await type('{"objects": [\n {"point": "p" "at": [1, 1]}]}');
  check((await beside()).line === 0 && !(await beside()).invalid, "a mark stays in a text that has changed");
  await site.click("Show this scene");
  const [, line, column] = (await beside()).told.match(/^line (\d+), column (\d+)/) ?? [];
  await site.click(`Go to line ${line}`);
  const letter = await beside();
  check(line === "2" && letter.from === "{\"objects\": [\n".length + Number(column) - 1 && letter.to === letter.from + 1,
    `column ${column} of line ${line} is selected from ${letter.from} to ${letter.to}`);
  await site.click("Back to what is shown");
  check((await look()).scene === mine.scene && (await beside()).told === "", "what is shown does not come back");
  await browser.ask(`history.back()`);
  await rest(300);
  check((await look()).heading.startsWith("Mine") && (await look()).scene !== mine.scene, "back does not bring the scene before");

  // What the field has taken it can undo, and nothing else is undone.
  const key = (letter, more) => browser.send("Input.dispatchKeyEvent", { type: "rawKeyDown", key: letter, code: "Key" + letter.toUpperCase(),
    windowsVirtualKeyCode: letter.toUpperCase().charCodeAt(0), modifiers: 2, ...more });
  const whole = await look();
  await browser.ask(`(() => { const area = document.querySelector(".own-scene textarea"); area.focus(), area.setSelectionRange(0, 0); })()`);
  await browser.send("Input.insertText", { text: "// mine\n" });
  check((await look()).scene === "// mine\n" + whole.scene, "nothing can be typed");
  await key("z", { commands: ["undo"] });
  check((await look()).scene === whole.scene && (await look()).hash === whole.hash, `Ctrl+Z in the text leaves ${JSON.stringify((await look()).scene.slice(0, 20))}`);

  // What is not shown yet stays with its example, over others and over a reload.
  const [first, second] = examples, click = async example => {
    await browser.ask(`document.activeElement.blur(), document.querySelector('nav.settings a[href="${example}"]').click()`);
    await rest(200);
  };
  await click(first);
  const written = "// not shown\n" + (await look()).scene;
  await type(written);
  await click(second);
  check(!(await look()).scene.includes("not shown") && (await beside()).told.includes("kept"), "nothing is said of the text that was left");
  await click(first);
  check((await look()).scene === written && (await beside()).told.includes("again"), "a text is lost on the way to another example");
  const dragged_under = await site.move_a_handle();
  check(dragged_under.pushed.scene === written && dragged_under.pushed.hash !== dragged_under.before.hash, "a drag takes the place of a text");
  await site.open(page);
  check((await look()).scene === written, "a text is lost by a reload");

  // Files take its place only when that is answered; then they are shown.
  for (const [name, bytes] of Object.entries(files)) writeFileSync(join(scratch, name), bytes);
  await drop(["tetra.stl", files["tetra.stl"]]);
  check((await look()).scene === written && (await beside()).choices.join() === "Replace my text,Keep my text", `no question: ${(await beside()).choices}`);
  await browser.press("Escape");
  check((await look()).scene === written && (await beside()).choices.join() === "Back to what is shown", "Escape does not keep a text");
  await drop(["tetra.stl", files["tetra.stl"]]);
  await site.click("Replace my text");
  await rest(100);
  for (const name of Object.keys(files)) {
    if (name !== "tetra.stl") await drop([name, files[name]]);
    const now = await look(), aside = await beside();
    check(now.scene.includes(`"file": "${name}"`) && aside.at === "2" && aside.told === "", `${name} at step ${aside.at}: ${aside.told}`);
    compared += await compare(name);
  }
  // A scene and the file that it names, in any order; what a link can't bring along is asked for.
  const naming = `{"title": "Named: a *mesh*!", "objects": [{"mesh": "T", "file": "part.obj"},\n {"point": "p", "at": [0.25, 0.25, 0.25]}], "ask": [["p", "T"]]}`;
  writeFileSync(join(scratch, "part.obj"), files["tetra.obj"]);
  await drop(["named.json", naming]);
  check((await beside()).told.includes("part.obj") && (await beside()).line === 1, `a file that is not here: ${(await beside()).told}`);
  await drop(["part.obj", files["tetra.obj"]]);
  check((await look()).heading.startsWith("Named") && (await look()).scene === naming, "a file does not complete the scene that names it");
  compared += await compare("named.json");
  const link = (await look()).hash;
  await site.open(page, link);
  check((await look()).scene === naming && (await beside()).told.includes("drop the file"), `a link to a scene with a file says: ${(await beside()).told}`);
  await drop(["named.json", naming.replace("Named", "Both")], ["part.obj", files["tetra.obj"]]);
  if ((await beside()).choices.includes("Replace my text")) await site.click("Replace my text");
  check((await look()).heading.startsWith("Both"), "a scene dropped with its file is not shown");

  // What is too large or can't be read is refused with a word, and changes nothing.
  const before_large = await look();
  await drop(["points.csv", "1,2\n".repeat(20001)]);
  check((await beside()).told.includes("a page takes up to 20000") && (await beside()).refused, `20,001 points: ${(await beside()).told}`);
  await browser.ask(`(() => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array(33 * 2 ** 20)], "large.stl"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, cancelable: true }));
  })()`);
  await rest(300);
  check((await beside()).told.includes("33 MB"), `33 MB: ${(await beside()).told}`);
  await drop(["letter.docx", "PK"]);
  check((await beside()).told.includes(".stl"), `a letter: ${(await beside()).told}`);
  check((await look()).hash === before_large.hash && (await look()).scene === before_large.scene, "what is refused changes something");

  // A file that is opened, and one that is saved under its title.
  const file = join(scratch, "opened.json");
  writeFileSync(file, '{"title": "Two things, opened", "objects": [{"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]}, {"sphere": "s", "center": [2, 2, 2], "radius": 1}], "ask": "all pairs"}');
  const { root } = await browser.send("DOM.getDocument", { depth: -1 });
  const { nodeId } = await browser.send("DOM.querySelector", { nodeId: root.nodeId, selector: ".own-scene input" });
  await browser.send("DOM.setFileInputFiles", { nodeId, files: [file] });
  await rest(300);
  check((await look()).heading.startsWith("Two things") && (await beside()).at === "2", "a file is not opened: " + (await look()).heading);
  compared += await compare("opened");
  await browser.ask(`HTMLAnchorElement.prototype.click = function () { window.saved = fetch(this.href).then(r => r.text()), window.saved_as = this.download; }`);
  await site.click("Save the scene");
  check(await browser.ask("saved") === (await look()).scene, "what is saved is not the scene");
  check(await browser.ask("saved_as") === "two-things-opened.json", `it is saved as ${await browser.ask("saved_as")}`);

  // The text is beside the picture where there is room, all of it in sight; and everything has a name.
  for (const [width, height] of [[1440, 900], [1920, 1080], [1366, 768]]) {
    await browser.look({ width, height });
    await site.open(page);
    const now = await browser.ask(`(() => {
      const box = s => { const r = document.querySelector(s).getBoundingClientRect(); return { left: r.left, right: r.right, top: r.top, bottom: r.bottom }; };
      return { area: box(".own-scene textarea"), show: box(".own-scene .tools"), picture: box(".live .picture"), bar: box(".transport"),
        nameless: [...document.querySelectorAll(".own-scene :is(button, textarea, summary)")].filter(e => !(e.getAttribute("aria-label") || e.textContent.trim())).length };
    })()`);
    const is_beside = now.area.left >= now.picture.right && now.area.top >= 0 && now.show.bottom <= now.bar.top;
    check(is_beside === (width >= 1440), `${width} wide: the text lies at ${JSON.stringify(now.area)}, the picture at ${JSON.stringify(now.picture)}`);
    check(now.nameless === 0, `${now.nameless} things have no name`);
  }

  // Where the lessons can't run, the page says so, and keeps what is dropped from taking its place.
  const { identifier } = await browser.send("Page.addScriptToEvaluateOnNewDocument", { source: "delete window.WebAssembly" });
  await browser.open("about:blank");
  await browser.open(site.address(page));
  const dead = await browser.ask(`({ state: document.querySelector(".scene-state").textContent, at: document.querySelector(".transport input").value })`);
  check(dead.state.includes("can't run") && dead.at === "2", `without the lessons it says "${dead.state}" at step ${dead.at}`);
  await drop(["tetra.stl", files["tetra.stl"]]);
  await browser.send("Page.removeScriptToEvaluateOnNewDocument", { identifier });

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
