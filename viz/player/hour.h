#pragma once
// A reader's way through a playlist: on and back, step by step and from stop to stop. The player shows each step;
// between two steps the reader may do with it whatever a lesson allows, and goes on from there.

#include <optional>
#include <string>

#include "viz/player/player.h"
#include "viz/player/playlist.h"

namespace isect::viz {

/// A place in a playlist, kept from one run to the next.
struct HourPlace {
  std::string file;         ///< the playlist's
  int stop = 0, step = -1;  ///< from 0; -1: where the stop begins
  bool operator==(const HourPlace&) const = default;
};

class Hour {
 public:
  /// The list has a stop that can be opened. A place beyond its end is its last.
  explicit Hour(Playlist, const HourPlace& at = {});

  const Playlist& list() const { return list_; }
  int count() const { return static_cast<int>(list_.stops.size()); }
  /// Returns the stop whose turn it is, from 0.
  int at() const { return at_; }
  const Stop& stop() const { return stop(at_); }
  const Stop& stop(int number) const { return list_.stops[static_cast<std::size_t>(number)]; }
  /// Returns "3 of 14".
  std::string told() const;
  HourPlace place() const { return {list_.file, at_, step_}; }

  /// Returns where a player is to start for this hour: where that begins, or was left. If that stop can't be opened, at
  /// the first one that can.
  ReaderState start() const;
  /// Called once, with a player that started there.
  void begin(Player&);
  /// Called in every frame: notes the step on show, draws the stop's timed one at its time when it is come to, and ends
  /// play where the stop does.
  void follow(Player&);

  /// Goes on by a step, to the next stop after the last one: a step's question is asked before it, as in Player::next.
  /// A stop that can't be opened is gone to, too: its fault is on show, and the next press leaves it. Returns false at
  /// the end of the list.
  bool on(Player&);
  /// Goes back by a step, before the first one to the end of the stop before. Returns false at the list's beginning.
  bool back(Player&);
  /// Goes to a stop's beginning.
  void open(Player&, int stop);
  /// Whether on() leaves this stop.
  bool leaves(const Player&) const;
  bool at_start(const Player&) const;
  bool at_end(const Player& player) const { return at_ + 1 == count() && leaves(player); }

  /// Whether the reader has opened another lesson or preset than the stop's; on() and back() then return to the stop.
  bool away(const Player&) const;
  /// Whether the stop's fault is what there is to see: nothing else was opened since it was gone to.
  bool faulty(const Player&) const;
  /// Whether the player stands where the stop begins, or asks the question with which it does.
  bool at_first_step(const Player&) const;
  /// Whether the stop still asks something that was neither answered nor passed over: no words may answer it.
  bool asks_ahead(const Player&) const;

 private:
  void enter(Player&, int number, int step, bool ask);
  std::optional<int> step_after(const Player&) const;
  std::optional<int> step_before(const Player&) const;

  Playlist list_;
  int at_ = 0, step_ = -1;
  std::string origin_;       ///< the preset that the player had loaded when it came to the stop
  unsigned fault_seen_ = 0;  ///< the player's revision when a stop that can't be opened was gone to
};

}  // namespace isect::viz
