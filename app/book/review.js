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

/// Checks of what was kept, or stands in a file: each returns its value, or throws an Error that says where it is wrong.
const isect_checked = {
  fail(why) { throw new Error(why); },
  json(text, where) { try { return JSON.parse(text); } catch { return this.fail(`${where}: it is not JSON`); } },
  object(value, where) {
    return value && typeof value === "object" && !Array.isArray(value) ? value : this.fail(`${where}: there is no such object`);
  },
  count(from, name, where) {
    return Number.isInteger(from[name]) && from[name] >= 0 && from[name] <= 1e9 ? from[name] : this.fail(`${where} ${name}: there is no such count`);
  },
  version(from, where) {
    if (this.count(from, "version", where) !== 1) this.fail(`${where} version: ${from.version} is unknown; this page reads 1`);
  },
  yes_or_no(from, name, where) {
    return typeof from[name] === "boolean" ? from[name] : this.fail(`${where} ${name}: it is neither true nor false`);
  }
};

/// The record of no answers; and one that is read from text, or an Error that says what is wrong with it.
function isect_no_answers() { return { version: 1, answers: 0, lessons: {}, reviews: {} }; }
function isect_record_from(text) {
  const is = isect_checked, record = is.object(is.json(text, "record"), "record");
  is.version(record, "record");
  is.count(record, "answers", "record");
  for (const [lesson, questions] of Object.entries(is.object(record.lessons, "record lessons")))
    for (const [question, asked] of Object.entries(is.object(questions, `record ${lesson}`))) {
      const where = `record ${lesson} ${question}`;
      is.yes_or_no(is.object(asked, where), "right", where);
      ["times", "wrong", "last"].forEach(name => is.count(asked, name, where));
    }
  for (const [number, result] of Object.entries(is.object(record.reviews, "record reviews"))) {
    if (!/^\d{1,4}$/.test(number)) is.fail(`record reviews: “${number}” is no review's number`);
    ["right", "of"].forEach(name => is.count(is.object(result, `record review ${number}`), name, `record review ${number}`));
  }
  return record;
}
function isect_keep_answer(record, lesson, question, right) {
  const asked = (record.lessons[lesson] ??= {})[question] ??= { right, times: 0, wrong: 0, last: 0 };
  asked.right = right, asked.times += 1, asked.wrong += right ? 0 : 1, asked.last = record.answers += 1;
}

/// What this browser keeps: the record. What is damaged is set aside under a name of its own, and told. Where nothing can
/// be kept, the page has it for as long as it is open.
const isect_answers = {
  place: "isect answers", what: "answers", none: isect_no_answers, from: isect_record_from,
  told: "",
  held: null,            // what could not be kept
  text: null, kept: null,  // the text that was read last, and what it says
  read() {
    let text = null;
    try { text = localStorage.getItem(this.place); } catch { /* nothing is kept here */ }
    if (text === null || this.held) return this.held ?? this.none();
    if (text === this.text) return this.kept;
    try { return this.kept = this.from(text), this.text = text, this.kept; } catch (damage) {
      this.set_aside(text, damage.message);
      return this.none();
    }
  },
  set_aside(text, why) {
    try {
      let aside = `${this.place}, damaged`;
      for (let i = 2; localStorage.getItem(aside) !== null; ++i) aside = `${this.place}, damaged ${i}`;
      localStorage.setItem(aside, text), localStorage.removeItem(this.place);
      this.told = `The ${this.what} that this browser kept can't be read (${why}), and start afresh. They are kept as “${aside}”.`;
    } catch { this.told = `The ${this.what} that this browser kept can't be read: ${why}.`; }
  },
  /// Returns a paragraph that tells the damage, and then no more.
  damage() {
    const text = this.told;
    this.told = "";
    return isect_element("p", { class: "damage", role: "status" }, text);
  },
  change(action) {
    const record = this.read();
    action(record);
    this.text = JSON.stringify(record), this.kept = record;
    try { localStorage.setItem(this.place, this.text), this.held = null; } catch { this.held = record; }
  },
  /// `asked`: what a question's data-asked says: its lesson, a space, its name.
  keep(asked, right) {
    if (!asked) return;
    const [lesson, question] = asked.split(" ");
    this.change(record => isect_keep_answer(record, lesson, question, right));
  }
};
