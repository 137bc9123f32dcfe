#pragma once
// Mesa crashes in surroundings that it does not expect. What can be known beforehand is refused in words.

namespace isect::viz {

/// Before a context is made; where memory or threads are short, Mesa is told to do with one thread. Throws NoBackend
/// where a variable is set to what Mesa does not survive, or where there is too little room for it.
void prepare_mesa();

}  // namespace isect::viz
