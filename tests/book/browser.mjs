// A headless Chromium, driven over a pipe: no package is needed, and no port is opened.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  /// Opens a page of its own.
  static async start(program = process.env.CHROMIUM ?? "chromium") {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), "isect-browser-"));
    browser.process = spawn(program,
      ["--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
        "--disable-dev-shm-usage", "--no-first-run", "--disable-ipc-flooding-protection", `--user-data-dir=${browser.profile}`, "about:blank"],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    browser.process.on("exit", () => browser.waiting.forEach(w => w.reject(new Error("the browser ended"))));
    browser.process.on("error", e => browser.waiting.forEach(w => w.reject(e)));
    let text = "";
    browser.process.stdio[4].on("data", data => {
      const parts = (text + data).split("\0");
      text = parts.pop();
      parts.forEach(part => browser.take(JSON.parse(part)));
    });
    const { targetInfos } = await browser.send("Target.getTargets");
    const target = targetInfos.find(t => t.type === "page");
    ({ sessionId: browser.session } = await browser.send("Target.attachToTarget", { targetId: target.targetId, flatten: true }));
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await browser.send(domain + ".enable");
    return browser;
  }

  waiting = new Map();
  messages = [];   ///< of the console, and what could not be loaded
  requests = [];   ///< addresses
  listeners = [];
  count = 0;

  send(method, params = {}) {
    const id = ++this.count;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + "\0");
    });
  }
  take(message) {
    if (message.id) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message)); else resolve(message.result);
      return;
    }
    const { method, params } = message;
    if (method === "Runtime.consoleAPICalled") this.messages.push(params.args.map(a => a.value ?? a.description).join(" "));
    if (method === "Runtime.exceptionThrown")
      this.messages.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Log.entryAdded") this.messages.push(params.entry.text);
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    this.listeners = this.listeners.filter(l => !l(method, params));
  }
  event(name) {
    return new Promise(resolve => this.listeners.push((method, params) => method === name && (resolve(params), true)));
  }
  async open(address) {
    const loaded = this.event("Page.loadEventFired");
    await this.send("Page.navigate", { url: address });
    await loaded;
  }
  /// The value of an expression, which may be a promise.
  async ask(expression) {
    const { result, exceptionDetails } =
      await this.send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  async look({ width = 1440, height = 900, dark = false, scripts = true, print = false, calm = false } = {}) {
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
    await this.send("Emulation.setEmulatedMedia", {
      media: print ? "print" : "",
      features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" },
        { name: "prefers-reduced-motion", value: calm ? "reduce" : "no-preference" }]
    });
    await this.send("Emulation.setScriptExecutionDisabled", { value: !scripts });
  }
  async press(key, modifiers = 0) {
    const text = key.length === 1 ? key : undefined;
    await this.send("Input.dispatchKeyEvent", { type: text ? "keyDown" : "rawKeyDown", key, code: key, text, modifiers });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, code: key, modifiers });
  }
  /// A press and release of the mouse with moves between; `modifiers`: 8 is Shift.
  async drag(from, to, steps = 8, modifiers = 0) {
    const send = (type, at, buttons) => this.send("Input.dispatchMouseEvent",
      { type, x: at.x, y: at.y, button: type === "mouseMoved" ? "none" : "left", buttons, clickCount: 1, modifiers });
    await send("mouseMoved", from, 0);
    await send("mousePressed", from, 1);
    for (let i = 1; i <= steps; ++i)
      await send("mouseMoved", { x: from.x + (to.x - from.x) * i / steps, y: from.y + (to.y - from.y) * i / steps }, 1);
    await send("mouseReleased", to, 0);
  }
  /// The same with a finger, or with as many as there are places.
  async swipe(from, to, steps = 8) {
    const begin = [from].flat(), end = [to].flat(), send = (type, points) => this.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    const at = share => begin.map((a, id) => ({ x: a.x + (end[id].x - a.x) * share, y: a.y + (end[id].y - a.y) * share, id }));
    await send("touchStart", at(0));
    for (let i = 1; i <= steps; ++i) await send("touchMove", at(i / steps));
    await send("touchEnd", []);
  }
  async screenshot(whole = false) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: whole });
    return Buffer.from(data, "base64");
  }
  async stop() {
    const ended = new Promise(resolve => this.process.on("exit", resolve));
    this.send("Browser.close").catch(() => {});
    await ended;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
