// A page reads the file of progress that the window saves, and saves one of the same shape. What is damaged is refused, and
// changes nothing. node progress_file.mjs app/book/progress.js tests/progress_file.json
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";

const [script, sample] = process.argv.slice(2), text = readFileSync(sample, "utf8"), file = JSON.parse(text);
const kept = new Map(), heard = {}, told = [];
const page = {
  document: { body: { dataset: { lesson: "ray-sphere" } }, querySelectorAll: () => ({ length: 5 }), getElementById: () => null,
    addEventListener: (name, action) => heard[name.slice("isect:".length)] = detail => action({ detail }) },
  localStorage: { getItem: name => kept.get(name) ?? null, setItem: (name, value) => kept.set(name, value), removeItem: name => kept.delete(name) },
  window: {}, parent: { postMessage: message => told.push(message) }
};
const code = ["review.js", "progress.js"].map(name => readFileSync(join(dirname(script), name), "utf8")).join("\n");
const { write, add, answers } = new Function(...Object.keys(page),
  code + "\nreturn { write: isect_progress_text, add: isect_add_progress, answers: isect_answers };")(...Object.values(page));
const exercises = Object.entries(file.lessons).map(([lesson, own]) => [lesson, own.exercises]);
const wrong = [];
function check(holds, what) { if (!holds) wrong.push(what); }
/// A value with the names in it in order.
const sorted = value => Array.isArray(value) || typeof value !== "object" || value === null ? value
  : Object.fromEntries(Object.keys(value).sort().map(name => [name, sorted(value[name])]));
const same = (a, b) => JSON.stringify(sorted(a)) === JSON.stringify(sorted(b));

// What the window tells, a page tells on, but for the names of what was skipped.
add(text);
const { pages, ...first } = JSON.parse(write(exercises)), skipped = { ...file, lessons: { ...file.lessons, "ray-sphere": { ...file.lessons["ray-sphere"], skipped: 0 } } };
check(same(first, skipped), `of the window's file it saves ${JSON.stringify(first)}`);
check(same(Object.keys(first), Object.keys(file)) && same(Object.keys(first.lessons), Object.keys(file.lessons)), "its file has another order");
add(text), check(same(JSON.parse(write(exercises)), { ...first, pages }), "read twice, a file counts twice");

// What happens is kept, and told to the page around.
heard.step({ setting: "two-roots", at: 3, asks: true, asked: "ray-sphere haines/far", end: false, step: 3, of: 12 });
heard.step({ setting: "two-roots", at: 4, asks: false, asked: "", end: false, step: 4, of: 12 });
check(JSON.parse(write(exercises)).lessons["ray-sphere"].skipped === 1, "a question that was passed over is not skipped");
answers.keep("ray-sphere haines/far", true), heard.answer({ asked: "ray-sphere haines/far", right: true, station: "two-roots/4", typed: "1/3" });
heard.solved({ exercise: 2 }), heard.solved({ exercise: 2 }), heard.solved({ exercise: 4 });
heard.step({ setting: "two-roots", at: 16, asks: false, asked: "", end: true, step: 12, of: 12 });
const own = { finished: true, seen: 12, of: 12, right: 3, answered: 4, skipped: 0, solved: 2, exercises: 5 };
check(same(JSON.parse(write(exercises)).lessons["ray-sphere"], own), `of a lesson it tells ${JSON.stringify(JSON.parse(write(exercises)).lessons["ray-sphere"])}`);
check(same(told.map(message => message.event), ["answer", "solved", "solved", "solved", "end"]) && told.every(message => message.isect === 1 && message.lesson === "ray-sphere"),
  `around is told ${JSON.stringify(told)}`);
check(told[0]?.question === "haines/far" && told[0]?.place === "two-roots/4" && told[0]?.right === true && same(told.at(-1)?.progress, own), `around is told ${JSON.stringify(told)}`);
const whole = write(exercises), other = JSON.parse(whole);
kept.clear(), add(whole);
check(same(JSON.parse(write(exercises)), { ...other, pages: JSON.parse(write(exercises)).pages }), "its own file is read as another");
check(same(JSON.parse(write(exercises)).pages.lessons["ray-sphere"].given, { "two-roots/4": { asked: "haines/far", typed: "1/3" } }), "an answer that was typed is lost in the file");

const before = JSON.stringify([...kept]), lesson = file.lessons["ray-sphere"];
const spoilt = ["", "{", "[]", "null", "{}", { ...file, version: 2 }, { ...file, isect: "scene" }, { ...file, record: undefined }, { ...file, lessons: [] },
  { ...file, record: { ...file.record, answers: -1 } }, { ...file, lessons: { rays: 7 } }, { ...file, lessons: { rays: { ...lesson, seen: "9" } } },
  { ...file, lessons: { rays: { ...lesson, finished: 1 } } }, { ...file, lessons: { "a b": lesson } }, { ...file, pages: { ...pages, version: 2 } },
  { ...file, pages: { ...pages, lessons: { rays: {} } } }, { ...file, pages: { ...pages, last: {} } }, text.replaceAll(`"ray-sphere"`, `"__proto__"`), text.replaceAll(`"/a"`, `"__proto__"`),
  whole.replace(`"typed": "1/3"`, `"typed": 3`), text.slice(0, text.length / 2)];
for (const bad of spoilt.map(it => typeof it === "string" ? it : JSON.stringify(it))) {
  let refused = "";
  try { add(bad); } catch (why) { refused = why.message; }
  check(refused !== "", `read without a word: ${bad.slice(0, 80)}`);
  check(JSON.stringify([...kept]) === before, `refused, and yet kept: ${bad.slice(0, 80)}`);
}
console.log([...wrong, `${spoilt.length} spoilt files, ${wrong.length} wrong`].join("\n"));
process.exit(wrong.length > 0 ? 1 : 0);
