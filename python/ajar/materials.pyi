"""All models of materials. Made by python/make_stubs.py from the library's own list."""

from typing import Literal

from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector

def coated_conductor(
    *,
    eta: TexturedColor = (0.200982586, 0.923764288, 1.10221601),
    k: TexturedColor = (3.91325855, 2.45303726, 2.14209414),
    reflectance: TexturedColor | None = None,
    coat_eta: TexturedNumber = 1.5,
    coat_roughness: TexturedNumber = 0.0,
    coat_depth: TexturedColor = 0.0,
    coat_roughness_v: TexturedNumber | None = None,
    coat_distribution: Literal["ggx", "beckmann"] = 'ggx',
    coat_transmission: Literal["whole", "smooth", "single", "lossy", "lossy_sum"] = 'whole',
    bounces: int = 0,
    distribution: Literal["ggx", "beckmann"] = 'ggx',
    masking: Literal["joint", "separable"] = 'joint',
    roughness: TexturedNumber = 0.0,
    roughness_v: TexturedNumber | None = None,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """metal under a transparent coat, smooth or rough."""

def coated_diffuse(
    *,
    diffuse_reflectance: TexturedColor = 0.5,
    coat: Literal["schlick", "dielectric"] = 'schlick',
    glossy_reflectance: TexturedColor = 0.5,
    eta: TexturedNumber = 1.5,
    coat_reflectance: TexturedColor = 1.0,
    coat_depth: TexturedColor = 0.0,
    coat_ways: Literal["refracted", "straight"] = 'refracted',
    coat_transmission: Literal["whole", "smooth", "single", "lossy", "lossy_sum"] = 'whole',
    bounces: int = 0,
    inner_reflections: Literal["base", "white", "windows"] = 'base',
    distribution: Literal["ggx", "beckmann"] = 'ggx',
    masking: Literal["joint", "separable"] = 'joint',
    roughness: TexturedNumber = 0.1,
    roughness_v: TexturedNumber | None = None,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """diffuse base under a glossy coat."""

def composite(
    *,
    diffuse_reflectance: TexturedColor = 0.25,
    glossy_reflectance: TexturedColor = 0.25,
    mirror_reflectance: TexturedColor = 0.0,
    transmittance: TexturedColor = 0.0,
    eta: TexturedNumber = 1.5,
    opacity: TexturedColor = 1.0,
    uncounted: bool = False,
    roughness: TexturedNumber = 0.1,
    roughness_v: TexturedNumber | None = None,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """diffuse, glossy, mirror and transparent parts with opacity."""

def conductor(
    *,
    eta: TexturedColor = (0.200982586, 0.923764288, 1.10221601),
    k: TexturedColor = (3.91325855, 2.45303726, 2.14209414),
    reflectance: TexturedColor | None = None,
    distribution: Literal["ggx", "beckmann", "smooth"] = 'ggx',
    masking: Literal["joint", "separable"] = 'joint',
    roughness: TexturedNumber = 0.01,
    roughness_v: TexturedNumber | None = None,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """rough conductor with a measured or given index of refraction."""

def dielectric(
    *,
    reflectance: TexturedColor = 1.0,
    transmittance: TexturedColor = 1.0,
    eta: TexturedNumber = 1.5,
    thin: bool = False,
    polarised: bool = False,
    along_normal: bool = False,
    uncounted: bool = False,
    distribution: Literal["ggx", "beckmann"] = 'ggx',
    masking: Literal["joint", "separable"] = 'joint',
    roughness: TexturedNumber = 0.0,
    roughness_v: TexturedNumber | None = None,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """smooth or rough dielectric boundary, such as glass or water."""

def diffuse(
    *,
    reflectance: TexturedColor = 0.5,
    sigma: TexturedNumber = 0.0,
    between_facets: bool = False,
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """diffuse (Lambert), or rough diffuse (Oren-Nayar)."""

def interface(
    *,
    counted: bool = False,
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """no surface: only separates media."""

def mirror(
    *,
    reflectance: TexturedColor = 0.9,
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """perfect mirror."""

def mix(
    *,
    amount: TexturedColor = 0.5,
    first: Node | None = None,
    second: Node | None = None,
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """blend of two materials by a texture."""

def plastic(
    *,
    diffuse_reflectance: TexturedColor = 0.25,
    glossy_reflectance: TexturedColor = 0.25,
    roughness: TexturedNumber = 0.1,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """diffuse base with a rough dielectric gloss."""

def principled(
    *,
    base_color: TexturedColor = 0.5,
    blend: Literal["once", "twice", "layered"] = 'once',
    metallic: TexturedNumber = 0.0,
    eta: TexturedNumber = 1.5,
    roughness: TexturedNumber = 0.5,
    specular_strength: TexturedNumber = 1.0,
    specular_tint: TexturedNumber = 0.0,
    anisotropic: TexturedNumber = 0.0,
    sheen: TexturedNumber = 0.0,
    sheen_tint: TexturedNumber = 0.5,
    clearcoat: TexturedNumber = 0.0,
    clearcoat_gloss: TexturedNumber = 1.0,
    coat: TexturedNumber = 0.0,
    coat_roughness: TexturedNumber = 0.0,
    specular_transmission: TexturedNumber = 0.0,
    flatness: TexturedNumber = 0.0,
    diffuse_transmission: TexturedNumber = 1.0,
    thin: bool = False,
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """Disney's principled material."""

def translucent(
    *,
    diffuse: TexturedColor = 0.25,
    glossy: TexturedColor = 0.25,
    reflectance: TexturedColor = 0.5,
    transmittance: TexturedColor = 0.5,
    roughness: TexturedNumber = 0.1,
    roughness_scale: Literal["alpha", "log", "square"] = 'alpha',
    name: str = '',
    bump: Node | None = None,
    normal_map: Node | None = None,
) -> Node:
    """diffuse and glossy reflection and transmission."""
