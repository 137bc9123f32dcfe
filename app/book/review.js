"use strict";
// A reader's answers, and which questions a review asks: as viz/walk/review.cpp keeps and draws them.
// tests/review_cases.json holds both to each other.

/// Returns a number that each letter of the text changes.
function isect_shuffled(text) {
  let h = 2166136261;
  for (const byte of new TextEncoder().encode(text)) h = Math.imul(h ^ byte, 16777619);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/// Draws from [lesson, question, preset]; returns indices in the order of asking: what was answered wrong the last time,
/// what was never answered, the rest.
function isect_draw_review(prompts, record, seed, most = 8) {
  const all = prompts.map(([lesson, question, preset], index) => {
    const before = record.lessons[lesson]?.[question], step = question.slice(question.lastIndexOf("/") + 1);
    return { index, lesson, step: `${lesson}/${step}`, turn: !before ? 1 : before.right ? 2 : 0, last: before?.last ?? 0,
      chance: isect_shuffled(`${seed}/${lesson}/${question}/${preset}`) };
  });
  const drawn = [], steps = new Set(), of_lesson = new Map();
  const rank = p => p.turn === 0 ? [0, -p.last, 0, p.chance] : [p.turn, of_lesson.get(p.lesson) ?? 0, p.last, p.chance];
  const before = (a, b) => {
    const differs = a.findIndex((x, i) => x !== b[i]);
    return differs >= 0 && a[differs] < b[differs];
  };
  while (drawn.length < most) {
    let next = null;
    for (const p of all) if (!steps.has(p.step) && (!next || before(rank(p), rank(next)))) next = p;
    if (!next) break;
    drawn.push(next.index), steps.add(next.step);
    of_lesson.set(next.lesson, (of_lesson.get(next.lesson) ?? 0) + 1);
  }
  return drawn;
}

/// The record of no answers; and one that is read from text, or an Error that says what is wrong with it.
function isect_no_answers() { return { version: 1, answers: 0, lessons: {}, reviews: {} }; }
function isect_record_from(text) {
  const fail = why => { throw new Error(why); };
  const object = (value, where) => value && typeof value === "object" && !Array.isArray(value) ? value : fail(`${where}: there is no such object`);
  const count = (from, name, where) => Number.isInteger(from[name]) && from[name] >= 0 && from[name] <= 1e9
      ? from[name] : fail(`${where} ${name}: there is no such count`);
  let record;
  try { record = JSON.parse(text); } catch { fail("record: it is not JSON"); }
  object(record, "record");
  if (count(record, "version", "record") !== 1) fail(`record version: ${record.version} is unknown; this page reads 1`);
  count(record, "answers", "record");
  for (const [lesson, questions] of Object.entries(object(record.lessons, "record lessons")))
    for (const [question, asked] of Object.entries(object(questions, `record ${lesson}`))) {
      const where = `record ${lesson} ${question}`;
      if (typeof object(asked, where).right !== "boolean") fail(`${where} right: it is neither true nor false`);
      ["times", "wrong", "last"].forEach(name => count(asked, name, where));
    }
  for (const [number, result] of Object.entries(object(record.reviews, "record reviews"))) {
    if (!/^\d{1,4}$/.test(number)) fail(`record reviews: “${number}” is no review's number`);
    ["right", "of"].forEach(name => count(object(result, `record review ${number}`), name, `record review ${number}`));
  }
  return record;
}
function isect_keep_answer(record, lesson, question, right) {
  const asked = (record.lessons[lesson] ??= {})[question] ??= { right, times: 0, wrong: 0, last: 0 };
  asked.right = right, asked.times += 1, asked.wrong += right ? 0 : 1, asked.last = record.answers += 1;
}

/// The record that this browser keeps. A damaged one is set aside under a name of its own, and told.
const isect_answers = {
  place: "isect answers",
  told: "",
  read() {
    let text = null;
    try { text = localStorage.getItem(this.place); } catch { /* nothing is kept here */ }
    if (text === null) return isect_no_answers();
    try { return isect_record_from(text); } catch (damage) {
      this.set_aside(text, damage.message);
      return isect_no_answers();
    }
  },
  set_aside(text, why) {
    try {
      let aside = `${this.place}, damaged`;
      for (let i = 2; localStorage.getItem(aside) !== null; ++i) aside = `${this.place}, damaged ${i}`;
      localStorage.setItem(aside, text), localStorage.removeItem(this.place);
      this.told = `The answers that this browser kept can't be read (${why}), and start afresh. They are kept as “${aside}”.`;
    } catch { this.told = `The answers that this browser kept can't be read: ${why}.`; }
  },
  change(action) {
    const record = this.read();
    action(record);
    try { localStorage.setItem(this.place, JSON.stringify(record)); } catch { /* nowhere to keep it */ }
  },
  /// `asked`: what a question's data-asked says: its lesson, a space, its name.
  keep(asked, right) {
    if (!asked) return;
    const [lesson, question] = asked.split(" ");
    this.change(record => isect_keep_answer(record, lesson, question, right));
  }
};
