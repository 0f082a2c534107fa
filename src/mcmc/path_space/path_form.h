#pragma once
#include <span>

#include "path/path.h"
#include "scene/scene.h"

namespace ajar {

/// The first vertex in the scene, from the camera, that is not specular; 0 if there is none.
int first_rough_from_camera(const Path& path);
/// First rough vertex from the light; k if there is none.
int first_rough_from_light(const Path& path);
/// The vertices between two others.
std::span<const InnerVertex> chain_from_light(const Path& path, int light_end, int camera_end);
/// True if an edge between x − 1 and x could have been made by joining two subpaths.
bool can_join(const Path& path, int x);
/// True if no edge can be joined: only unidirectional hits sample the path.
bool is_hit_only(const Path& path);
/// True if no edge can be joined, and none of the light can be hit either, as its lamp is a point,
/// or shines from one direction: no technique of a path sampler makes the path.
bool no_technique_makes(const Path& path);
/// Log of the probability with which a path that runs into its light takes that, and no other, for
/// it: of lights at infinity it chooses one.
double log_choice_of_hit_light(const Scene& scene, const Path& path);
/// True if both scatter by the same specular events at the vertices `first` to `last`.
bool same_events(const Path& a, const Path& b, int first, int last);

}  // namespace ajar
