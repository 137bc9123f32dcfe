#pragma once
// The walk that finds by three questions how two sets lie, and the map of all its cases.

#include "lessons/relations/picture.h"

namespace isect::lessons::relations_lesson {

Pose pose(const viz::Parameters&);
/// The kind of the setting; null where the walk shows all kinds at once and has no map.
const Kind* kind_of(const viz::Parameters&);

viz::Walk questions(Kind, const Pose&);
const viz::CaseMap& cases();

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::relations_lesson
