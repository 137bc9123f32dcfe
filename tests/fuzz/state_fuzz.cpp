// Any bytes as a reader's place (a preset's file, what is pasted into the window), as what a figure carries of it, as
// the window's settings, or as a number that is typed: a value, or a refusal. What is written and read again is written
// the same.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "lessons/lessons.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/seeds.h"
#include "viz/formats/files.h"
#include "viz/formats/metadata_text.h"
#include "viz/player/reader_state.h"
#include "viz/text/number_text.h"
#include "viz/window/window_session.h"

namespace {

using namespace isect::viz;

/// Which reader an input is for: its first byte.
enum class Reader { place, figure, settings, number };
constexpr int readers = 4;

const std::vector<const Lesson*>& lessons() { return isect::lessons::all_lessons(); }

/// A reader is told their lesson, and goes there: its walk is made, unless the lesson refuses it.
void check_place(const ReaderState& state, const std::string& text) {
  const Lesson& lesson = lesson_named(lessons(), state.lesson);
  require(state.parameters.has_value(), "all parameters", text);
  const std::string once = to_json(state);
  try {
    const std::string twice = to_json(reader_state_from_json(once, lessons()));
    require(to_json(reader_state_from_json(twice, lessons())) == twice, "written and read again it is the same", text);
    reader_state_from_metadata(metadata(state), lessons());
  } catch (const BadInput& e) {
    require(false, e.what(), once);
  }
  try {
    require(!lesson.walk(*state.parameters).steps.empty(), "a step", text);
  } catch (const BadInput&) {
  }
}

/// A file in memory, by a name that can be opened.
class Kept {
 public:
  explicit Kept(const std::string& text) : file_(std::tmpfile()) {
    std::fwrite(text.data(), 1, text.size(), file_);
    std::fflush(file_);
  }
  ~Kept() { std::fclose(file_); }
  Kept(const Kept&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(fileno(file_)); }

 private:
  std::FILE* file_;
};

std::string settings_again(const std::string& text) { return text_of(read_settings(Kept(text).path(), lessons())); }

void check_settings(const std::string& text) {
  const std::string once = settings_again(text), twice = settings_again(once);
  require(settings_again(twice) == twice, "written and read again they are the same", text);
}

void read(Reader reader, const std::string& text) {
  switch (reader) {
    case Reader::place:
      return check_place(reader_state_from_json(text, lessons()), text);
    case Reader::figure:
      return check_place(reader_state_from_metadata(metadata_of_text(text, "text"), lessons()), text);
    case Reader::settings:
      return check_settings(text);
    case Reader::number:
      return require(std::isfinite(number_from(text)), "a finite number", text);
  }
}

void seed(const std::string& name, Reader reader, const std::string& text) {
  write_seed(name, static_cast<int>(reader), text);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (seeds_folder().empty()) return 0;
  for (const Lesson* lesson : lessons())
    for (const Preset& preset : lesson->presets) {
      const std::string name = lesson->id + "-" + preset.id;
      const ReaderState state = {lesson->id, "", 0, preset.parameters, opening(*lesson)};
      seed(name, Reader::place, to_json(state));
      seed(name + "-figure", Reader::figure, metadata_text(metadata(state)));
      seed(lesson->id + "-preset", Reader::place, to_json(ReaderState{lesson->id, preset.id, 1}));
    }
  Settings some;
  some.reader_state = ReaderState{lessons().front()->id, lessons().front()->presets.front().id};
  some.beside = Beside{lessons().front()->id, "", lessons().front()->presets.front().id};
  some.scores[lessons().front()->id] = {{{"a question", true}}, true};
  some.record.keep(lessons().front()->id, "a question", true), some.record.reviews[1] = {6, 8};
  some.recent = {lessons().front()->id}, some.saved = {"/a/file.json"};
  seed("settings", Reader::settings, text_of(some));
  for (const char* text : {"1.5", "1,5", "-2*pi", "1/3", "(1+2)*0.5", "1e-3"}) seed("number", Reader::number, text);
  return 0;
}

/// The first byte selects the reader of the others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    read(static_cast<Reader>(data[0] % readers), std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const BadInput&) {
  } catch (const FileError&) {
  }
  return 0;
}
