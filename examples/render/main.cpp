// Renders a scene with Ajar's library, shows how far it is, and writes the picture:
//   render_with_ajar SCENE|builtin:NAME PICTURE SECONDS
#include <ajar/ajar.h>

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: render_with_ajar SCENE PICTURE SECONDS\n");
    return 2;
  }
  try {
    const ajar::Scene scene = ajar::Scene::load(argv[1]);
    for (const std::string& warning : scene.warnings()) {
      std::fprintf(stderr, "%s\n", warning.c_str());
    }

    ajar::Settings settings;
    settings.seconds = std::stod(argv[3]);
    settings.resolution = {160, 120};

    ajar::Callbacks callbacks;
    callbacks.progress = [](const ajar::Progress& progress) {
      std::fprintf(stderr, "\r%.0f samples per pixel, %.0f %%", progress.samples_per_pixel,
                   100.0 * progress.fraction.value_or(0.0));
    };

    ajar::Render render(scene, settings, callbacks);
    const ajar::Picture picture = render.run();
    picture.save(argv[2]);
    std::printf("\nAjar %s: %d x %d pixels in %s\n", ajar::version().c_str(), picture.width(),
                picture.height(), argv[2]);
    return 0;
  } catch (const ajar::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
