#include "scene/texture/registry.h"

namespace ajar {

// Each is defined in a file of this folder. Listed by hand, because a linker drops self-registering
// objects of a library.
TextureModel bilinear_texture();
TextureModel checkerboard_texture();
TextureModel constant_texture();
TextureModel dots_texture();
TextureModel fbm_texture();
TextureModel image_texture();
TextureModel marble_texture();
TextureModel mix_texture();
TextureModel product_texture();
TextureModel solid_checkerboard_texture();
TextureModel threshold_texture();
TextureModel uv_texture();
TextureModel windy_texture();
TextureModel wrinkled_texture();

const std::vector<TextureModel>& texture_models() {
  static const std::vector<TextureModel> kModels{bilinear_texture(),  checkerboard_texture(),
                                                 constant_texture(),  dots_texture(),
                                                 fbm_texture(),       image_texture(),
                                                 marble_texture(),    mix_texture(),
                                                 product_texture(),   solid_checkerboard_texture(),
                                                 threshold_texture(), uv_texture(),
                                                 windy_texture(),     wrinkled_texture()};
  return kModels;
}

}  // namespace ajar
