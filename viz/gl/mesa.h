#pragma once
// Mesa crashes in some environments. Those that can be detected beforehand are refused with a message.

namespace isect::viz {

/// Call it before a context is made. Where memory or threads are short, it limits Mesa to one thread. Throws NoBackend
/// where a variable is set to a value on which Mesa crashes, or where there is too little memory.
void prepare_mesa();

}  // namespace isect::viz
