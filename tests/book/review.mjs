// A page draws a review and reads a record as the program does: review.mjs app/book/review.js tests/review_cases.json
import { readFileSync } from "node:fs";
const [script, table] = process.argv.slice(2).map(file => readFileSync(file, "utf8"));
const { draw, read, keep, none } = new Function(script +
  "\nreturn { draw: isect_draw_review, read: isect_record_from, keep: isect_keep_answer, none: isect_no_answers };")();
const wrong = [], same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const cases = JSON.parse(table);
for (const { told, seed, prompts, record, drawn } of cases) {
  const got = draw(prompts, read(JSON.stringify(record)), seed);
  if (!same(got, drawn)) wrong.push(`${told}: ${got}, and not ${drawn}`);
}
const record = none();
keep(record, "rays", "/foot", false), keep(record, "rays", "/foot", true), keep(record, "points", "/far", false);
const kept = { version: 1, answers: 3, lessons: { rays: { "/foot": { right: true, times: 2, wrong: 1, last: 2 } },
  points: { "/far": { right: false, times: 1, wrong: 1, last: 3 } } }, reviews: {} };
if (!same(read(JSON.stringify(record)), kept)) wrong.push(`kept: ${JSON.stringify(record)}`);
const spoilt = ["", "{", "[]", "null", "{}", { ...kept, version: 2 }, { ...kept, version: "1" }, { ...kept, answers: -1 },
  { ...kept, lessons: [] }, { ...kept, lessons: { rays: 7 } }, { ...kept, reviews: { x: { right: 1, of: 8 } } },
  { ...kept, lessons: { rays: { "/foot": { right: 1, times: 1, wrong: 1, last: 1 } } } }, { ...kept, reviews: { 1: {} } }];
for (const text of spoilt.map(it => typeof it === "string" ? it : JSON.stringify(it))) {
  let refused = "";
  try { read(text); } catch (why) { refused = why.message; }
  if (!refused.startsWith("record")) wrong.push(`read without a word: ${text}`);
}
console.log([...wrong, `${cases.length} drawings, ${spoilt.length} spoilt records, ${wrong.length} wrong`].join("\n"));
process.exit(wrong.length > 0 || cases.length < 10 ? 1 : 0);
