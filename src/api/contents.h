#pragma once
#include <memory>
#include <string>
#include <utility>

#include "ajar/error.h"
#include "ajar/picture.h"
#include "ajar/scene.h"
#include "core/error.h"
#include "core/warnings.h"
#include "imageio/picture.h"
#include "session/scenes/loaded_scene.h"

/// Implementation of the types of include/ajar, and their errors.
namespace ajar::v0 {

struct Scene::Content {
  std::string name;
  std::shared_ptr<LoadedScene> loaded;
  Warnings warnings;
};

struct Picture::Content {
  std::shared_ptr<const ajar::Picture> picture;
};

inline Picture public_picture(std::shared_ptr<const ajar::Picture> picture) {
  return Picture(std::make_shared<const Picture::Content>(Picture::Content{std::move(picture)}));
}

/// Calls `work`; errors that leave it are those of the interface.
template <class Work>
decltype(auto) with_public_errors(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const UsageError& error) {
    throw Error(Error::Kind::Usage, error.what());
  } catch (const SceneError& error) {
    throw Error(Error::Kind::Scene, error.what());
  } catch (const IoError& error) {
    throw Error(Error::Kind::File, error.what());
  }
}

}  // namespace ajar::v0
