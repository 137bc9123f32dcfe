#pragma once
// Errors in print that a player shows, exercises that are tried with it, and questions asked again.

#include "viz/player/player.h"

namespace isect::viz {

/// Returns an error in the pseudocode as published: at the current line, or else anywhere in this walk; null: none.
const Erratum* erratum(const Player&);
/// Loads the preset on which that line fails, at the step that runs it.
void show_erratum(Player&);

/// Returns the lesson after this one in the course; null after the last one, and for a scene from a file.
const Lesson* next_lesson(const Player&);
/// Whether the next step on opens the next lesson: the closing card is on show, and there is one.
bool leads_to_next_lesson(const Player&);

/// Begins an exercise of the lesson: a setting to be found. It ends when another lesson is opened.
void begin_exercise(Player&, int index);
/// Whether the exercise that was begun is solved.
bool exercise_solved(const Player&);

/// Asks the question that was answered once more, in another setting (viz/walk/other_numbers.h). Returns false if none
/// was answered, or no such setting is found.
bool ask_with_other_numbers(Player&);

}  // namespace isect::viz
