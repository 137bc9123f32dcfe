#pragma once
// How isect knows its own files: a picture by the metadata inside, a trace by the lesson and preset it names. Others
// are a user's, and are neither changed nor removed; nor are those that someone has edited, as their digests show.

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "app/shell/options.h"
#include "viz/formats/files.h"

namespace isect::program {

/// Returns "ray-sphere/two-roots": the folder of a setting's files, below that of all figures or baselines. Of a
/// playlist's stop it is a folder of its own.
std::string folder_of(const Excerpt&);
/// Returns "ray-sphere/two-roots/03-foot": a step's file, without its ending.
std::string file_of(const Excerpt&, int step);
/// Returns what a picture of this step carries inside: where it was made, and its file's name.
viz::Metadata metadata_of(const Excerpt&, int step);

/// Returns a figure's metadata; empty if it is not isect's, or no picture at all.
viz::Metadata metadata_in(const std::filesystem::path& picture);

/// A trace of isect's, as far as it says what it is for.
struct OwnTrace {
  std::string folder;           ///< as folder_of
  std::string parameters;       ///< as in a picture's metadata
  std::set<std::string> stems;  ///< of its steps' files: "03-foot"
};
/// Returns the trace; nothing if the file is no such trace.
std::optional<OwnTrace> own_trace(const std::filesystem::path& file);

/// Whether a file of isect's may be written here: there is nothing, no regular file, an empty one, or one that isect
/// wrote, as `ours` says of its first 512 bytes.
bool may_be_replaced(const std::filesystem::path& file, const std::function<bool(const std::string& begin)>& ours);

/// Whether the file is what Git LFS leaves in its place until it is fetched.
bool is_lfs_pointer(const std::string& bytes);

/// Whether isect made this picture for this folder. One from before pictures named their file is known by its preset,
/// or by the parameters it shares with the trace beside it.
bool made_for(const viz::Metadata&, const std::string& folder, const std::optional<OwnTrace>& beside);
/// Whether it also made it for this very file: a copy under another name is not isect's.
bool made_as(const viz::Metadata&, const std::string& file, const std::optional<OwnTrace>& beside);

/// Says on stderr that someone has edited a file of isect's, so that it is neither written nor removed.
void say_left_alone(const std::string& file);

/// Returns a trace of isect's in a preset's folder below that of a lesson.
std::optional<std::filesystem::path> trace_below(const std::filesystem::path& lesson);
/// Returns a trace which shows that figures written below `folder` would lie among baselines.
std::optional<std::filesystem::path> baseline_below(const std::filesystem::path& folder, const Program&);

}  // namespace isect::program
