#include "import/pbrt/mesh_loader.h"

#include <new>
#include <utility>

#include "core/parallel_for.h"
#include "import/mesh/ply.h"
#include "import/mesh/validate_mesh.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {

std::shared_ptr<const desc::Mesh> MeshLoader::request(const SourceLocation& where,
                                                      const std::string& name) {
  std::string path;
  try {
    path = context_.files.resolve(name);
  } catch (const IoError& error) {
    throw SceneError(where, error.what());
  }
  const auto [place, is_new] = by_path_.try_emplace(path, jobs_.size());
  if (is_new) jobs_.push_back({where, name, path, std::make_shared<desc::Mesh>(), {}, {}});
  return jobs_[place->second].mesh;
}

void MeshLoader::load(Job& job) const {
  try {
    const FileBytes bytes = context_.files.load(job.path);
    *job.mesh = read_ply(bytes.view(), job.name);
    validate_mesh(*job.mesh, {std::make_shared<const std::string>(job.name), 0, 0}, job.remarks);
  } catch (const Error& error) {
    job.error = error.what();
  } catch (const std::bad_alloc&) {
    job.error = job.name + ": there is not enough memory for this mesh";
  }
}

void MeshLoader::load_all() {
  parallel_for(jobs_.size(), [&](std::size_t i) { load(jobs_[i]); });
  for (const Job& job : jobs_) {
    if (!job.error.empty()) throw SceneError(job.where, "cannot use this mesh: " + job.error);
    for (Warning remark : job.remarks) {
      remark.where = job.where;
      remark.subject = printable(job.name);
      remark.message = remark.subject + ": " + remark.message;
      context_.warnings.add(std::move(remark));
    }
  }
}

}  // namespace ajar::pbrt
