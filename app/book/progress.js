"use strict";
// How far a reader is in each lesson: kept by this browser, told to a page around this one, and written into a file. The
// file's shape, and so that of a lesson's progress, stands in viz/window/progress.h: the window writes the same.

/// The way of somebody who has read nothing; and of one lesson.
function isect_no_way() { return { version: 1, last: null, lessons: {} }; }
function isect_unread() { return { finished: false, seen: 0, of: 0, skipped: [], solved: [], solved_elsewhere: 0, given: {} }; }

/// A lesson's name, as in its page's address.
function isect_check_lesson(name, where) { return /^[a-z0-9][a-z0-9-]*$/.test(name) ? name : isect_checked.fail(`${where}: “${name}” is no lesson`); }
/// Reads a way from text; throws an Error that says what is wrong with it.
///   last: the lesson and the place where the reader was last, such as "two-roots/4"; null: nowhere
///   lessons: by name
///     seen, of: the furthest step that was shown, and the steps of its walk
///     skipped: the names of questions that were passed over and never answered
///     solved: the numbers of exercises; solved_elsewhere: how many a file told that does not name them
///     given: by place, the answer to the question that stands there: the choice, or what was typed
function isect_way_from(text) {
  const is = isect_checked, way = is.object(is.json(text, "progress"), "progress");
  is.version(way, "progress");
  const words = value => typeof value === "string", number = value => Number.isInteger(value) && value >= 0;
  if (way.last !== null) {
    isect_check_lesson(is.object(way.last, "progress last").lesson, "progress last");
    if (!words(way.last.place)) is.fail("progress last: there is no place");
  }
  for (const [lesson, own] of Object.entries(is.object(way.lessons, "progress lessons"))) {
    const where = `progress ${isect_check_lesson(lesson, "progress")}`;
    is.yes_or_no(is.object(own, where), "finished", where);
    ["seen", "of", "solved_elsewhere"].forEach(name => is.count(own, name, where));
    for (const [name, fits] of [["skipped", words], ["solved", number]])
      if (!Array.isArray(own[name]) || !own[name].every(fits)) is.fail(`${where} ${name}: there is no such list`);
    for (const [place, given] of Object.entries(is.object(own.given, `${where} given`))) {
      is.object(given, `${where} ${place}`);
      if (!words(given.asked) || !(words(given.typed) || number(given.choice))) is.fail(`${where} ${place}: there is no answer`);
    }
  }
  return way;
}

/// The way that this browser keeps.
const isect_way = {
  ...isect_answers, place: "isect progress", what: "steps", none: isect_no_way, from: isect_way_from,
  restoring: false,  // while a question is shown as it was answered before
  change_lesson(lesson, action) { this.change(way => action(way.lessons[lesson] ??= isect_unread(), way)); },
  /// Where a question stands: "two-roots/4"; empty where that is none of the page's settings.
  station_of(ask) { return ask.closest(".walk") ? ask.dataset.station ?? ask.id.replace(/\/question$/, "") : ""; },
  /// Answers a question as it was answered before, if it was.
  restore(ask) {
    const [lesson, question] = (ask.dataset.asked ?? "").split(" "), station = this.station_of(ask);
    const given = station && this.read().lessons[lesson]?.given[station];
    if (!given || given.asked !== question) return;
    const form = ask.querySelector(".typed");
    this.restoring = true;
    if (!("typed" in given)) ask.querySelectorAll(".choices button")[given.choice]?.click();
    else if (form) {
      const field = form.querySelector("input");
      field.value = given.typed, field.dispatchEvent(new Event("input")), form.requestSubmit();
      if (!ask.classList.contains("told")) this.open(ask);
    }
    this.restoring = false;
  },
  /// `opened` is called with a question that is open again.
  offer_again(ask, opened) {
    ask.querySelector("details").after(isect_button("Ask again", () => {
      this.change_lesson(ask.dataset.asked.split(" ")[0], own => delete own.given[this.station_of(ask)]);
      this.open(ask), opened(ask);
    }, "other again"));
  },
  /// Takes an answer away.
  open(ask) {
    const form = ask.querySelector(".typed");
    ask.querySelectorAll(".reply, button.other").forEach(told => told.remove());
    ask.querySelectorAll(".choices .wrong").forEach(choice => choice.classList.remove("wrong"));
    ask.querySelector("details").open = false;
    ask.classList.remove("told"), ask.classList.toggle("typing", Boolean(form));
    if (!form) return;
    const field = form.querySelector("input"), help = form.querySelector(".help");
    field.value = "", field.removeAttribute("aria-invalid"), field.dispatchEvent(new Event("input"));
    help.textContent = form.dataset.asks, help.classList.remove("refused");
  }
};

/// A lesson's progress as it stands in the file. `exercises`: how many the lesson has.
function isect_progress_of(lesson, exercises, way, record) {
  const own = way.lessons[lesson] ?? isect_unread(), answers = Object.values(record.lessons[lesson] ?? {});
  return { finished: own.finished, seen: own.seen, of: own.of, right: answers.filter(answer => answer.right).length, answered: answers.length,
    skipped: own.skipped.length, solved: Math.min(exercises, Math.max(own.solved.length, own.solved_elsewhere)), exercises };
}
/// The file. `exercises`: how many each lesson has, as [lesson, number] in the order of the course.
function isect_progress_text(exercises) {
  const way = isect_way.read(), record = isect_answers.read();
  const lessons = Object.fromEntries(exercises.map(([lesson, number]) => [lesson, isect_progress_of(lesson, number, way, record)]));
  return JSON.stringify({ isect: "progress", version: 1, lessons, reviews: record.reviews, record, pages: way }, null, 2) + "\n";
}

/// Adds what such a file holds to what is kept: of both the more. Throws an Error that says what is wrong with the file,
/// and changes nothing then.
function isect_add_progress(text) {
  const is = isect_checked, file = is.object(is.json(text, "file"), "file");
  if (file.isect !== "progress") is.fail("it holds no progress");
  is.version(file, "file");
  const told = Object.entries(is.object(file.lessons, "file lessons"));
  for (const [lesson, own] of told) {
    const where = `file ${isect_check_lesson(lesson, "file")}`;
    is.yes_or_no(is.object(own, where), "finished", where);
    ["seen", "of", "solved"].forEach(name => is.count(own, name, where));
  }
  const record = isect_record_from(JSON.stringify(file.record ?? null));
  for (const [lesson, questions] of Object.entries(record.lessons)) {
    isect_check_lesson(lesson, "record");
    Object.keys(questions).forEach(name => name.includes("/") || is.fail(`record ${lesson}: “${name}” is no question`));
  }
  const way = file.pages === undefined ? isect_no_way() : isect_way_from(JSON.stringify(file.pages));
  isect_answers.change(mine => isect_merge_record(mine, record));
  isect_way.change(mine => {
    for (const [lesson, theirs] of told) {
      if (!theirs.finished && theirs.of === 0 && theirs.solved === 0) continue;
      const own = mine.lessons[lesson] ??= isect_unread();
      own.finished ||= theirs.finished, own.solved_elsewhere = Math.max(own.solved_elsewhere, theirs.solved);
      if (theirs.seen * own.of >= own.seen * theirs.of && theirs.of > 0) own.seen = theirs.seen, own.of = theirs.of;
    }
    for (const [lesson, theirs] of Object.entries(way.lessons)) {
      const own = mine.lessons[lesson] ??= isect_unread();
      own.solved = [...new Set([...own.solved, ...theirs.solved])], own.given = { ...theirs.given, ...own.given };
      const answered = isect_answers.read().lessons[lesson] ?? {};
      own.skipped = [...new Set([...own.skipped, ...theirs.skipped])].filter(name => !(name in answered));
    }
    mine.last ??= way.last;
  });
}
function isect_merge_record(mine, theirs) {
  for (const [lesson, questions] of Object.entries(theirs.lessons))
    for (const [name, asked] of Object.entries(questions)) {
      const own = (mine.lessons[lesson] ??= {})[name];
      if (!own || asked.times > own.times) mine.lessons[lesson][name] = asked;
    }
  mine.answers = Math.max(mine.answers, theirs.answers), mine.reviews = { ...theirs.reviews, ...mine.reviews };
}

// What happens on a page: kept, and told to the page around it.
(() => {
  const lesson = document.body.dataset.lesson === "scene" ? undefined : document.body.dataset.lesson;
  const exercises = document.querySelectorAll(".exercises > ol > li").length;
  /// README says which messages there are.
  function tell_around(event, told) {
    if (parent === window) return;
    const progress = lesson && { progress: isect_progress_of(lesson, exercises, isect_way.read(), isect_answers.read()) };
    parent.postMessage({ isect: 1, event, ...(lesson && { lesson }), ...told, ...progress }, "*");
  }
  const on = (name, action) => document.addEventListener("isect:" + name, event => action(event.detail));
  let before = null, moved = false, ended = false;
  on("step", now => {
    if (!lesson) return;
    const passed = before && before.asked && before.setting === now.setting && now.at > before.at ? before.asked.split(" ")[1] : "";
    const answered = passed && passed in (isect_answers.read().lessons[lesson] ?? {});
    moved ||= before !== null && (before.at !== now.at || before.setting !== now.setting);
    isect_way.change_lesson(lesson, (own, way) => {
      if (now.step * own.of >= own.seen * now.of) own.seen = now.step, own.of = now.of;
      if (passed && !answered && !own.skipped.includes(passed)) own.skipped.push(passed);
      own.finished ||= now.end;
      // Who opens a lesson anew has not left the place where they were.
      const opens = !moved && now.at === 0 && way.last?.lesson === lesson;
      const here = now.asked ? `${now.setting}/${now.step + 1}/question` : `${now.setting}/${now.step}`;
      const place = now.setting ? here : way.last?.lesson === lesson ? way.last.place : "";
      if (!opens) way.last = { lesson, place };
    });
    before = now;
    if (now.end && !ended) ended = true, tell_around("end", {});
    tell_damage();
  });
  on("answer", ({ asked, right, station, typed, choice }) => {
    const [of, question] = asked.split(" ");
    if (!question) return;
    isect_way.change_lesson(of, own => {
      own.skipped = own.skipped.filter(name => name !== question);
      if (station) own.given[station] = { asked: question, ...(typed === undefined ? { choice } : { typed: typed.slice(0, 200) }) };
    });
    tell_around("answer", { lesson: of, question, right, ...(station && { place: station }) });
  });
  on("solved", ({ exercise }) => {
    isect_way.change_lesson(lesson, own => own.solved.includes(exercise) || own.solved.push(exercise));
    tell_around("solved", { exercise });
  });
  on("review", told => tell_around("review", told));
  /// What could not be read is told once, below the walk.
  function tell_damage() {
    const walks = document.getElementById("walks");
    if (isect_way.told && walks) walks.after(isect_way.damage());
  }
})();
