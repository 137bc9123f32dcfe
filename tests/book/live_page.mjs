// A live page in a browser: opened, looked at, pressed; and what was found wrong.
import { spawnSync } from "node:child_process";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

export const rest = ms => new Promise(done => setTimeout(done, ms));

/// What a page says of itself once it no longer loads.
export const loaded = `new Promise(done => {
  const look = () => ["ready", "none"].includes(document.documentElement.dataset.live) ? done(document.documentElement.dataset.live) : setTimeout(look, 10);
  document.body.dataset.live ? look() : done("static");
})`;

const shown = `(() => {
  const text = s => document.querySelector(".live " + s)?.textContent.trim() ?? "";
  const grips = [...document.querySelectorAll(".live .grip")].map(g => {
    const box = g.querySelector(".ring").getBoundingClientRect();
    return { name: g.dataset.handle, label: g.getAttribute("aria-label"), x: box.x + box.width / 2, y: box.y + box.height / 2 };
  });
  const values = Object.fromEntries([...document.querySelectorAll(".live form [name]")].map(f => [f.name, f.value]));
  return { hash: location.hash, title: text("h3"), heading: text("h2"), verdict: text(".below .verdict"),
    yes: document.querySelector(".live .below .verdict.yes") !== null, no: document.querySelector(".live .below .verdict.no") !== null,
    outcome: text(".outcome .verdict"),
    asks: document.querySelector(".live article").classList.contains("ask"),
    told: document.querySelector(".live article").classList.contains("told"),
    right: [...document.querySelectorAll(".live .choices li")].findIndex(li => "right" in li.dataset),
    typing: document.querySelector(".live article").classList.contains("typing"),
    ...Object.fromEntries(["number", "pointed", "order"].map(kind =>
      [kind, JSON.parse(document.querySelector(".live .choices")?.dataset[kind] ?? "null")])),
    code: document.querySelectorAll(".live ol.code li").length, tiles: document.querySelectorAll(".live .tiles button").length,
    typed: text(".reply"), help: text(".typed .help"),
    picture: document.querySelector(".live .picture").outerHTML.length, wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    message: text(".message"), scene: document.querySelector(".live .own-scene textarea")?.value ?? "", grips, values,
    end: document.querySelector(".transport .next").disabled };
})()`;

export class LivePages {
  wrong = [];
  checks = 0;
  static async start(folder, isect) {
    return Object.assign(new LivePages(), { folder: resolve(folder), isect, browser: await Browser.start() });
  }
  check(holds, what) {
    ++this.checks;
    if (!holds) this.wrong.push(what), console.log("wrong: " + what);
  }
  address(page, hash = "") { return pathToFileURL(join(this.folder, page)).href + hash; }
  /// Opens a page and waits while it loads: "ready" to be changed, "none" where it can't, "static" where it is not meant to.
  async open(page, hash = "") {
    await this.browser.open("about:blank");
    await this.browser.open(this.address(page, hash));
    return this.browser.ask(loaded);
  }
  look() { return this.browser.ask(shown); }
  /// Presses a choice's letter; where more than a choice is asked for, it shows the choices first.
  async choose(letter) {
    if ((await this.look()).typing) await this.browser.ask(`document.querySelector(".live .show-choices").click()`);
    await this.browser.press(letter);
  }
  /// Types an answer into the field for it, and enters it.
  type(text) {
    return this.browser.ask(`(() => { const form = document.querySelector(".live .typed");
      form.querySelector("input").value = ${JSON.stringify(text)}, form.requestSubmit(); })()`);
  }
  click(text) {
    return this.browser.ask(`[...document.querySelectorAll(".live button")].find(b => b.textContent === ${JSON.stringify(text)}).click()`);
  }
  /// What the native program answers.
  native(args, input = "") { return spawnSync(this.isect, args, { input, encoding: "utf8" }).stdout; }
  /// Drags the first handle by a little, and pushes it by keys: what was before, between and after.
  async move_a_handle(by = { x: 24, y: 14 }) {
    await this.browser.ask(`document.querySelector(".live .grip").scrollIntoView({ block: "center" })`);
    const before = await this.look(), grip = before.grips[0];
    await this.browser.drag(grip, { x: grip.x + by.x, y: grip.y + by.y });
    await rest(50);
    const dragged = await this.look();
    await this.browser.ask(`document.querySelector(".live .grip").focus()`);
    for (const key of ["ArrowLeft", "ArrowUp", "ArrowLeft"]) await this.browser.press(key);
    await rest(600);
    const pushed = await this.look();
    await this.browser.ask(`document.activeElement.blur()`);
    return { before, dragged, pushed, name: grip.name };
  }
  /// What the console has said, and what was asked of the network.
  check_silence() {
    this.browser.messages.forEach(message => this.check(false, "the console says: " + message));
    const far = this.browser.requests.filter(url => !/^(file|data|about|blob):/.test(url));
    this.check(far.length === 0, "asked of the network: " + far[0]);
  }
}
