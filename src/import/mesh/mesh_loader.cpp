#include "import/mesh/mesh_loader.h"

#include <new>

#include "core/parallel_for.h"
#include "core/printable_text.h"
#include "import/mesh/validate_mesh.h"

namespace ajar {
namespace {

constexpr WarningKind kUnreadable{Effect::Geometry, "meshes cannot be read: left out"};

}  // namespace

std::shared_ptr<const desc::Mesh> MeshLoader::request(const SourceLocation& where,
                                                      const std::string& name, MeshRecipe recipe) {
  std::string path;
  try {
    path = files_.resolve(name, where);
  } catch (const IoError& error) {
    throw SceneError(where, error.what());
  }
  const auto [place, is_new] = known_.try_emplace({path, recipe.variant}, jobs_.size());
  if (is_new) {
    jobs_.push_back({where, name, path, std::move(recipe), std::make_shared<desc::Mesh>(), {}, {}});
  }
  return jobs_[place->second].mesh;
}

void MeshLoader::load(Job& job) const {
  try {
    const FileBytes bytes = files_.load_text(job.path);
    *job.mesh = job.recipe.read(bytes.view(), job.name);
    validate_mesh(*job.mesh, {std::make_shared<const std::string>(job.name), 0, 0}, job.remarks);
    if (job.recipe.finish) job.recipe.finish(*job.mesh);
  } catch (const Error& error) {
    job.error = error.what();
  } catch (const std::bad_alloc&) {
    job.error = job.name + ": there is not enough memory for this mesh";
  }
}

void MeshLoader::load_all() {
  parallel_for(jobs_.size(), [&](std::size_t i) { load(jobs_[i]); });
  for (const Job& job : jobs_) {
    if (!job.error.empty()) {
      *job.mesh = {};
      warnings_.add(kUnreadable, job.where, "cannot use this mesh: " + job.error + ": left out",
                    printable(job.name));
      continue;
    }
    for (Warning remark : job.remarks) {
      remark.where = job.where;
      remark.subject = printable(job.name);
      remark.message = remark.subject + ": " + remark.message;
      warnings_.add(std::move(remark));
    }
  }
}

bool is_empty_mesh(const desc::Shape& shape) {
  return shape.node.is("mesh") && shape.node.mesh("mesh")->indices.empty();
}

void remove_empty_meshes(desc::SceneDesc& scene) {
  std::erase_if(scene.shapes, is_empty_mesh);
  for (desc::Object& object : scene.objects) std::erase_if(object.shapes, is_empty_mesh);
}

}  // namespace ajar
