#!/usr/bin/env python3
"""Where the time of a render goes: `profile.py PROGRAM [SCENE...] [-- INTEGRATOR...]`.

Samples the processor's clock with Linux `perf` while PROGRAM renders on one thread, sorts functions into phases by their
names, and prints a line of a Markdown table for each scene and integrator: shares of the render's time, in percent. What
the compiler has put into another function counts where that one does. The rays themselves are "rays"; over their share, 100 %
is what the limit ratio says in another way.
"""
import re
import subprocess
import sys
import tempfile

SCENES = ["builtin:cornell", "builtin:torus-in-glass", "builtin:door-ajar", "builtin:floor-lamps", "builtin:bathroom"]
INTEGRATORS = ["pt", "ibpt", "bdpt", "mmlt", "selective"]
SECONDS = 10

# The first that matches decides.
PHASES = [
    ("rays", r"libembree|^rtc|Geometry::(intersect|occluded)|Geometry::make_context|can_trace|_filter$|Quadric::intersect|"
             r"first_root|quadric_(bounds|intersect|occluded)|occlusion_filter|callback"),
    ("numbers", r"sobol|SobolSource|IndependentSource|PrimarySource|SampleSource|mix_bits|hash_numbers|Primary.*(get|Vector)"),
    ("chains", r"Mutation|Chain|Primary|Kernel|Metropolis|Recruit|StrongPath|Division|kept_directions|KeptDirections"),
    ("film", r"Film|SampleSink|splat|Filter::|filter_|TechniqueTally|FixedPoint|add_at"),
    ("lights", r"Light|light|SphereSampler|MeshSampler|SurfaceSampler|QuadricSampler|Distribution|LatLong|DirectionMap|sample_toward"),
    ("camera", r"Camera|camera_ray"),
    ("hit", r"find_point|plain_point|surface_point|Placement|place_point|exact_point|instance_space|sphere_plain|Quadric|"
            r"Scene::intersect|TriangleMesh|Curve"),
    ("texture", r"[Tt]exture|[Nn]oise|Mapping|texel|bump|ImageCache"),
    ("lobes", r"Bsdf|[Ll]obe|Material|microfacet|[Ff]resnel|Dielectric|Conductor|Diffuse|Principled|Plastic|Mix|OrenNayar|"
              r"Disney|sincos|atan2|acos|_powf|_expf|_logf|_cosf|_sinf"),
    ("walk, MIS", r"PathSampler|scatter|arrive|mis_|Mis|trace_segment|connect|is_blocked|unobstructed|hit_light|PathVertex|"
                  r"PathIntegrator|run_item|PathTarget|ray_to_endpoint"),
]
REST = "rest"


def phase_of(library, function):
    for name, pattern in PHASES:
        if re.search(pattern, library if name == "rays" and "embree" in library else function):
            return name
    return REST


def profile(program, scene, integrator):
    """Shares of the time by phase, and the functions of most time that have none."""
    with tempfile.TemporaryDirectory() as folder:
        data = f"{folder}/perf.data"
        subprocess.run(
            ["perf", "record", "-q", "-e", "cpu-clock", "-F", "499", "-o", data, program, "render", scene, "--integrator",
             integrator, "--time", f"{SECONDS}s", "--threads", "1", "--resolution", "240x180", "--denoise", "none",
             "--progress", "none", "-o", f"{folder}/picture.exr"],
            check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        report = subprocess.run(
            ["perf", "report", "-i", data, "--no-children", "--stdio", "-F", "overhead,dso,sym", "-t", ";", "--percent-limit", "0"],
            check=True, capture_output=True, text=True).stdout
    shares = {name: 0.0 for name, _ in PHASES} | {REST: 0.0}
    unnamed = {}
    for line in report.split("\n"):
        fields = [field.strip() for field in line.split(";", 2)]
        if line.startswith("#") or len(fields) < 3:
            continue
        share = float(fields[0].rstrip("%"))
        function = re.sub(r"^\[.\] ", "", fields[2])
        phase = phase_of(fields[1], function)
        shares[phase] += share
        if phase == REST:
            unnamed[function] = unnamed.get(function, 0.0) + share
    return shares, unnamed


def main():
    program, *arguments = sys.argv[1:]
    split = arguments.index("--") if "--" in arguments else len(arguments)
    scenes = arguments[:split] or SCENES
    integrators = arguments[split + 1:] or INTEGRATORS
    names = [name for name, _ in PHASES] + [REST]
    print(f"| scene | integrator | {' | '.join(names)} |")
    print("|---" * (len(names) + 2) + "|", flush=True)
    for scene in scenes:
        for integrator in integrators:
            shares, unnamed = profile(program, scene, integrator)
            figures = " | ".join(f"{shares[name]:.0f}" for name in names)
            print(f"| {scene.removeprefix('builtin:')} | {integrator} | {figures} |", flush=True)
            for function, share in sorted(unnamed.items(), key=lambda pair: -pair[1])[:3]:
                if share >= 2.0:
                    print(f"  {share:.1f} % without a phase: {function[:100]}", file=sys.stderr)


main()
