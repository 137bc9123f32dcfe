// A page in a SCORM package talks with the platform's API as the standard asks. node scorm_session.mjs app/book/scorm.js
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { scorm_api } from "./scorm_api.mjs";

const [script] = process.argv.slice(2), wrong = [];
let checks = 0;
function check(holds, what) { ++checks, holds || wrong.push(what); }
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const code = ["review.js", "progress.js", "scorm.js"].map(name => readFileSync(join(dirname(script), name), "utf8")).join("\n");

/// A page of a lesson with these questions, as its scripts see it. `kept`: what the browser keeps.
function page_in(window, { scorm = "haines/far haines/near half-b/roots", kept = new Map(), hash = "" } = {}) {
  const heard = {}, gone = [];
  const location = { hash }, of = (name, action) => (heard[name] ??= []).push(action);
  const globals = {
    document: { body: { dataset: { lesson: "ray-sphere", ...(scorm !== null && { scorm }) } }, querySelectorAll: () => ({ length: 5 }),
      getElementById: () => null, visibilityState: "visible", addEventListener: of },
    localStorage: { getItem: name => kept.get(name) ?? null, setItem: (name, value) => kept.set(name, value), removeItem: name => kept.delete(name) },
    location, history: { replaceState: (state, title, url) => { location.hash = url; } },
    addEventListener: (name, action) => name === "pagehide" && gone.push(action), window, parent: window
  };
  const made = new Function(...Object.keys(globals), code + "\nreturn { answers: isect_answers, session: isect_scorm_session, api: isect_scorm_api, time: isect_scorm_time };");
  const of_page = made(...Object.values(globals));
  const tell = (name, detail) => (heard["isect:" + name] ?? []).forEach(action => action({ detail }));
  return {
    ...of_page, kept, location, document: globals.document,
    step: (step, end = false, setting = "two-roots") => tell("step", { setting, at: step, asks: false, asked: "", end, step, of: 12 }),
    /// As questions.js does: it is kept, and then told.
    answer(name, right) {
      of_page.answers.keep("ray-sphere " + name, right);
      tell("answer", { asked: "ray-sphere " + name, right, station: "two-roots/4", choice: 0 });
    },
    hide() { globals.document.visibilityState = "hidden", (heard.visibilitychange ?? []).forEach(action => action()); },
    leave() { gone.forEach(action => action()); }
  };
}
function window_with(api, more = {}) {
  const made = { API: api, ...more };
  made.parent ??= made, made.top ??= made.parent;
  return made;
}

// A whole visit: it begins once, tells what happens, and ends once.
const first = scorm_api(), kept = new Map();
let page = page_in(window_with(first.api), { kept });
check(same(first.calls.slice(0, 1), ["LMSInitialize"]) && first.data["cmi.core.lesson_status"] === "incomplete", `it begins with ${first.calls.slice(0, 3)}`);
page.step(1);
check(first.data["cmi.core.score.raw"] === "0" && first.data["cmi.core.score.min"] === "0" && first.data["cmi.core.score.max"] === "100", `the first score is ${JSON.stringify(first.data)}`);
page.answer("haines/far", true), page.answer("haines/near", false);
check(first.data["cmi.core.score.raw"] === "33.33", `of one right in three the score is ${first.data["cmi.core.score.raw"]}`);
check(first.committed()["cmi.core.score.raw"] === "33.33", "an answer is not committed");
page.answer("haines/near", true), page.answer("rays/other", true);
check(first.data["cmi.core.score.raw"] === "66.67", `a question that is none of the lesson's counts: ${first.data["cmi.core.score.raw"]}`);
page.step(4);
check(first.data["cmi.core.lesson_location"] === "two-roots/4", `the place is ${first.data["cmi.core.lesson_location"]}`);
check(first.data["cmi.core.lesson_status"] === "incomplete", "it is completed before its end");
page.step(12, true);
check(first.committed()["cmi.core.lesson_status"] === "completed", "the end is not told");
page.step(2);
check(first.data["cmi.core.lesson_status"] === "completed", "a step back takes the end back");
page.hide();
check(first.committed()["cmi.core.lesson_location"] === "two-roots/2", "a page that is hidden commits nothing");
page.leave();
const said = first.calls.length;
page.leave(), page.step(3), page.answer("half-b/roots", true), page.hide();
check(first.calls.length === said, `after LMSFinish it calls ${first.calls.slice(said)}`);
check(first.state() === "ended" && first.calls.filter(call => call === "LMSFinish").length === 1, "it ends more than once, or never");
check(first.data["cmi.core.exit"] === "suspend" && /^\d\d:\d\d:\d\d\.\d\d$/.test(first.data["cmi.core.session_time"]), `it ends with ${JSON.stringify(first.data)}`);
check(first.wrong.length === 0, `the platform refuses ${first.wrong}`);

// The next visit goes on, on another machine, too; another reader of this browser begins anew, and so does a new attempt.
const second = scorm_api({ ...first.data }, { entry: "resume" });
page = page_in(window_with(second.api));
check(page.location.hash === "#two-roots/2", `it goes on at ${page.location.hash}`);
page.step(2);
check(second.data["cmi.core.score.raw"] === "66.67", `going on, the score is ${second.data["cmi.core.score.raw"]}`);
page.answer("haines/far", false);
check(second.data["cmi.core.score.raw"] === "33.33" && second.data["cmi.core.lesson_status"] === "completed", "an answer after going on is not told");
check(page_in(window_with(scorm_api({ ...first.data }, { entry: "resume" }).api), { hash: "#miss/3" }).location.hash === "#miss/3", "the place that an address names is left");
check(page_in(window_with(scorm_api({ "cmi.core.lesson_location": "\"><b>" }).api)).location.hash === "", "a place that is none is gone to");
for (const [student, score] of [["s-2", "0"], ["s-1", "100"]]) {  // of a platform that keeps no text
  const forgetful = scorm_api({}, { student, entry: "resume" });
  page = page_in(window_with(forgetful.api), { kept }), page.step(1);
  check(forgetful.data["cmi.core.score.raw"] === score, `the answers of s-1 make the score ${forgetful.data["cmi.core.score.raw"]} of ${student}`);
}
const again = scorm_api();
page = page_in(window_with(again.api), { kept });
page.step(1);
check(again.data["cmi.core.score.raw"] === "0" && again.data["cmi.core.lesson_status"] === "incomplete", "a new attempt begins with old answers");
const damaged = scorm_api({ "cmi.suspend_data": "{\"version\":1,\"lessons\":7" }, { entry: "resume" });
page = page_in(window_with(damaged.api)), page.step(1);
check(damaged.data["cmi.core.score.raw"] === "0" && damaged.wrong.length === 0, "what is kept and damaged stops it");
const hostile = scorm_api({ "cmi.suspend_data": JSON.stringify({ version: 1, answers: 1, lessons: { "ray-sphere": JSON.parse('{"__proto__":{"right":true,"times":1,"wrong":0,"last":1}}') }, reviews: {} }) }, { entry: "resume" });
page = page_in(window_with(hostile.api)), page.step(1);
check(hostile.data["cmi.core.score.raw"] === "0" && Object.keys(Object.prototype).length === 0, "what is kept changes all objects");
for (const status of ["passed", "completed", "failed", "browsed"]) {
  const before = scorm_api({ "cmi.core.lesson_status": status }, { entry: "resume" });
  page = page_in(window_with(before.api)), page.step(1);
  check(before.data["cmi.core.lesson_status"] === status, `${status} becomes ${before.data["cmi.core.lesson_status"]} at a first step`);
  page.step(12, true), page.leave();
  const wanted = status === "passed" ? "passed" : "completed";
  check(before.data["cmi.core.lesson_status"] === wanted, `${status} becomes ${before.data["cmi.core.lesson_status"]} at the end`);
}

// The API may be far above, or with the window that opened this one; windows of other origins are passed over.
const deep = scorm_api(), closed = () => { throw new Error("another origin"); };
const top = window_with(deep.api), strange = { parent: top, get API() { return closed(); } }, inner = { parent: strange, top };
page_in(inner);
check(deep.state() === "open", "an API above a window of another origin is not found");
const opened = scorm_api(), alone = { opener: window_with(opened.api) };
alone.parent = alone.top = alone;
page_in(alone);
check(opened.state() === "open", "the API of the window that opened this one is not found");
const of_top = scorm_api(), frame = { top: { opener: window_with(of_top.api) } };
frame.parent = frame.top, frame.top.parent = frame.top;
page_in(frame);
check(of_top.state() === "open", "the API of the window that opened the topmost one is not found");
const ring = {};
ring.parent = { parent: ring }, ring.top = ring;
page_in(ring).step(1);  // it ends

// No API, one that refuses, one that throws, a page that is in no package: nothing else is different.
const none = page_in(window_with(undefined), { kept: new Map() });
none.step(1), none.answer("haines/far", true), none.leave();
check(none.kept.has("isect answers") && none.kept.has("isect progress"), "without an API nothing is kept");
const refusing = scorm_api();
refusing.api.LMSInitialize = () => "false";
page = page_in(window_with(refusing.api)), page.step(1), page.answer("haines/far", true), page.leave();
check(same(refusing.calls, []), `a platform that refuses hears ${refusing.calls}`);
const throwing = scorm_api();
throwing.api.LMSSetValue = () => { throw new Error("gone"); };
page = page_in(window_with(throwing.api)), page.step(1), page.answer("haines/far", true), page.leave();
check(throwing.state() === "ended", "what the platform throws stops the page");
const silent = scorm_api();
page_in(window_with(silent.api), { scorm: null }).step(1);
check(same(silent.calls, []), "a page that is in no package talks");
const empty = scorm_api();
page = page_in(window_with(empty.api), { scorm: "" }), page.step(1), page.leave();
check(!("cmi.core.score.raw" in empty.data) && empty.wrong.length === 0, "a lesson without questions has a score");

// Limits: a time of days, more text than may be kept.
const { time, session } = none;
for (const [milliseconds, wanted] of [[0, "00:00:00.00"], [59999, "00:00:59.99"], [3600000, "01:00:00.00"], [90061010, "25:01:01.01"], [-5, "00:00:00.00"], [1e15, "9999:59:59.99"]])
  check(time(milliseconds) === wanted, `${milliseconds} ms is ${time(milliseconds)}`);
const full = scorm_api();
let clock = 1000;
const talk = session(full.api, () => clock);
talk.tell({ right: 1, of: 2, finished: true, place: "x", kept: "" }), talk.commit(), talk.end();
check(same(full.calls, []), "before LMSInitialize it calls " + full.calls);
talk.begin(), talk.tell({ right: 1, of: 3, finished: false, place: "p".repeat(256), kept: "k".repeat(4097) });
clock += 61000, talk.end();
check(!("cmi.suspend_data" in full.data) && !("cmi.core.lesson_location" in full.data) && full.wrong.length === 0, "more is told than may be kept");
check(full.data["cmi.core.session_time"] === "00:01:01.00", `a minute and a second is ${full.data["cmi.core.session_time"]}`);

console.log([...wrong, `${checks} checks of SCORM, ${wrong.length} wrong`].join("\n"));
process.exit(wrong.length > 0 || checks < 40 ? 1 : 0);
