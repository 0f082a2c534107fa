#include "import/mitsuba/scene_builder.h"

#include "core/printable_text.h"
#include "import/common/left_out_media.h"
#include "import/mitsuba/lights.h"
#include "import/mitsuba/sensor.h"
#include "import/mitsuba/shapes.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kNoSensor{Effect::Light, "scenes have no sensor"};
constexpr WarningKind kNotReferred{Effect::Slight, "things are in nothing and have no id: ignored"};
constexpr WarningKind kNoShapes{Effect::Geometry, "scenes have no shapes"};
constexpr WarningKind kMoreIntegrators{Effect::None,
                                       "integrators are ignored: the first one is used"};
constexpr WarningKind kMoreSensors{Effect::None, "sensors are ignored: the first one is used"};

void read_sensors(Context& context, MediumTable& media, Arguments& scene) {
  const std::vector<const Element*> sensors = scene.children("sensor");
  for (std::size_t i = 1; i < sensors.size(); ++i) {
    context.warnings.add(kMoreSensors, sensors[i]->where,
                         "there is more than one sensor: this one is ignored");
  }
  if (!sensors.empty()) return read_sensor(context, media, *sensors.front());
  context.warnings.add(kNoSensor, context.document.end,
                       "there is no sensor: a perspective one that looks along z at all is used");
}

/// Warns if the integrator, in Mitsuba, leaves out media that the scene has.
void check_media(Context& context, const Element& integrator) {
  if (integrator.type != "path" && integrator.type != "direct") return;
  warn_of_left_out_media(context.scene, integrator.where, integrator.type, "Mitsuba",
                         context.warnings);
}

}  // namespace

desc::SceneDesc build_scene(const Document& document, SearchPath& files, Warnings& warnings) {
  desc::SceneDesc scene;
  Context context{scene, document, files, warnings};
  Arguments arguments(context, document.scene);
  TextureTable textures(context);
  MaterialTable materials(context, textures);
  MediumTable media(context);
  MeshLoader meshes(files.files(), warnings);
  ShapeBuilder shapes(context, textures, materials, media, meshes);

  read_sensors(context, media, arguments);
  const std::vector<const Element*> integrators = arguments.children("integrator");
  const Element* integrator = nullptr;
  for (const Element* element : integrators) {
    if (integrator != nullptr) {
      warnings.add(kMoreIntegrators, element->where,
                   "there is more than one integrator: this one is ignored");
    } else {
      integrator = &read_integrator(context, *element);
    }
  }
  for (const Element* shape : arguments.children("shape")) shapes.add(*shape);
  for (const Element* emitter : arguments.children("emitter")) {
    add_lights(context, media, *emitter);
  }
  // Things that are only referred to are read where they are used.
  for (const char* tag : {"bsdf", "texture", "medium", "volume", "phase", "film", "sampler",
                          "rfilter", "subsurface"}) {
    for (const Element* element : arguments.children(tag)) {
      if (!element->id.empty()) continue;
      warnings.add(
          kNotReferred, element->where,
          "this <" + element->tag + "> is in nothing, and nothing can refer to it: ignored",
          printable(element->type));
    }
  }

  meshes.load_all();
  remove_empty_meshes(scene);
  if (arguments.children("sensor").empty()) look_at_everything(context);
  if (integrator != nullptr) check_media(context, *integrator);
  if (scene.shapes.empty() && scene.instances.empty()) {
    warnings.add(kNoShapes, document.end, "there are no shapes in this scene");
  }
  return scene;
}

}  // namespace ajar::mitsuba
