#include "import/tungsten/mesh_files.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "import/mesh/creased_normals.h"
#include "import/mesh/obj.h"
#include "import/mesh/ply.h"
#include "import/mesh/validate_mesh.h"
#include "import/tungsten/object_reader.h"
#include "import/tungsten/wo3.h"
#include "os/file_extension.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnreadableMesh{Effect::Geometry, "meshes cannot be read and are left out"};

/// Triangles that meet at less than this angle are smooth: Tungsten's 27 degrees.
constexpr float kCosOfEdges = 0.891006524F;

Wo3Mesh read_mesh(std::string_view bytes, const std::string& name) {
  const std::string extension = file_extension(name);
  if (extension == ".obj") return {read_obj(bytes, name), {}};
  if (extension == ".ply") return {read_ply(bytes, name), {}};
  if (extension == ".wo3") return read_wo3(bytes, name);
  throw SceneError(name + ": unknown kind of mesh file. Valid: .wo3, .obj, .ply");
}

void treat(desc::Mesh& mesh, const MeshTreatment& treatment) {
  if (!treatment.smooth) {
    mesh.normals.clear();
  } else if (treatment.recompute_normals) {
    mesh = with_creased_normals(mesh, kCosOfEdges);
  }
}

/// The vertices that some triangles use, and these.
desc::Mesh part_of(const desc::Mesh& mesh, const std::vector<std::size_t>& triangles) {
  constexpr unsigned kUnused = static_cast<unsigned>(-1);
  std::vector<unsigned> place(mesh.positions.size(), kUnused);
  desc::Mesh part;
  const auto vertex = [&](unsigned i) {
    if (place[i] == kUnused) {
      place[i] = static_cast<unsigned>(part.positions.size());
      part.positions.push_back(mesh.positions[i]);
      if (!mesh.normals.empty()) part.normals.push_back(mesh.normals[i]);
      if (!mesh.uvs.empty()) part.uvs.push_back(mesh.uvs[i]);
    }
    return place[i];
  };
  for (const std::size_t t : triangles) {
    const Imath::Vec3<unsigned>& of = mesh.indices[t];
    const unsigned first = vertex(of.x);
    const unsigned second = vertex(of.y);
    part.indices.emplace_back(first, second, vertex(of.z));
  }
  return part;
}

std::vector<MeshPart> split(Wo3Mesh source, int count) {
  std::map<int, std::vector<std::size_t>> by_bsdf;
  for (std::size_t t = 0; t < source.materials.size(); ++t) {
    by_bsdf[std::clamp<int>(source.materials[t], 0, count - 1)].push_back(t);
  }
  std::vector<MeshPart> parts;
  if (by_bsdf.size() <= 1) {
    const int bsdf = by_bsdf.empty() ? 0 : by_bsdf.begin()->first;
    parts.push_back({bsdf, std::make_shared<const desc::Mesh>(std::move(source.mesh))});
    return parts;
  }
  for (const auto& [bsdf, triangles] : by_bsdf) {
    parts.push_back({bsdf, std::make_shared<const desc::Mesh>(part_of(source.mesh, triangles))});
  }
  return parts;
}

}  // namespace

std::vector<MeshPart> MeshFiles::read(const LocatedJson& name, const std::string& path,
                                      const MeshTreatment& treatment, int count) const {
  const std::string subject = printable(name.text());
  const auto unreadable = [&](const std::string& reason) {
    context_.warnings.add(kUnreadableMesh, name.where(), "cannot use this mesh: " + reason,
                          subject);
  };
  try {
    Wo3Mesh source = read_mesh(context_.files.load_text(path).view(), path);
    // Split first: triangles that are left out later have materials, too.
    std::vector<MeshPart> parts;
    for (MeshPart& part : split(std::move(source), count)) {
      desc::Mesh mesh = *part.mesh;
      std::vector<Warning> remarks;
      validate_mesh(mesh, name.where(), remarks);
      for (Warning& remark : remarks) {
        remark.subject = subject;
        remark.message = subject + ": " + remark.message;
        context_.warnings.add(std::move(remark));
      }
      if (mesh.indices.empty()) continue;
      treat(mesh, treatment);
      parts.push_back({part.bsdf, std::make_shared<const desc::Mesh>(std::move(mesh))});
    }
    return parts;
  } catch (const Error& error) {
    unreadable(error.what());
  } catch (const std::bad_alloc&) {
    unreadable("there is not enough memory for it");
  }
  return {};
}

const std::vector<MeshPart>& MeshFiles::load(const LocatedJson& name,
                                             const MeshTreatment& treatment, int count) {
  std::string path;
  try {
    path = context_.files.resolve(name.text(), name.where());
  } catch (const IoError& error) {
    throw SceneError(name.where(), error.what());
  }
  const auto [place, is_new] = loaded_.try_emplace(Key{path, treatment, count});
  if (is_new) place->second = read(name, path, treatment, count);
  return place->second;
}

}  // namespace ajar::tungsten
