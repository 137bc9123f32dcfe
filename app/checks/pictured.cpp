#include "app/checks/pictured.h"

#include <filesystem>

#include "app/checks/causes.h"

namespace isect::program {

viz::Metadata kept_metadata(const Pictured& p) {
  viz::Metadata data = metadata_of(*p.excerpt, p.step);
  data.erase("scene"), data.erase("version");
  data["file"] = folder_of(*p.excerpt) + "/" + std::filesystem::path(p.baseline).stem().string();
  if (!p.style.empty()) data["style"] = p.style;
  return data;
}

Failure failure(Failure::Kind kind, const std::string& what, const std::string& baseline) {
  Failure f;
  f.kind = kind;
  f.what = what;
  f.cause = cause_of(kind);
  f.baseline = baseline;
  return f;
}

Failure lfs_pointer(const std::string& baseline) {
  Failure f =
      failure(Failure::Kind::unreadable, "a Git LFS pointer, not the file itself; git lfs pull fetches that", baseline);
  f.cause = "a Git LFS pointer stands in place of the baseline";
  f.pointer = true;
  return f;
}

Failure about(const Excerpt& e, int step, Failure f) {
  f.lesson = e.lesson->id;
  f.preset = e.folder;
  f.step = step;
  if (step >= 0 && step < static_cast<int>(e.walk.steps.size())) f.slug = e.walk.steps[step].slug;
  return f;
}

Failure about(const Pictured& p, Failure f) {
  f = about(*p.excerpt, p.step, std::move(f));
  if (p.guard) f.look = p.guard->file({}).substr(1);
  return f;
}

}  // namespace isect::program
